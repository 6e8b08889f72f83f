// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSphereProxyFilter.h"

#include "vtkProxyBinding.h"
#include "vtkProxyCover.h"
#include "vtkProxyMeasures.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkVersion.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

// Newer VTK declares methods const that are not const in 9.1.
#ifndef VTK_FUTURE_CONST
#define VTK_FUTURE_CONST
#endif

vtkStandardNewMacro(vtkSphereProxyFilter);

namespace
{
// Samples of the surface are about half an error apart; their number is within these limits.
constexpr int LeastSamples = 6000;
constexpr int MostSamples = 60000;
constexpr int SamplesPerSphere = 48;
constexpr double LeastError = 0.001;

vtkDoubleArray* AddArray(vtkPointData* data, const char* name, int components, vtkIdType count)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  data->AddArray(array);
  return array;
}

// Makes the filter by its name, for users such as vtkProxyAccumulationPass that are not linked to
// this module.
class Factory : public vtkObjectFactory
{
public:
  static Factory* New();
  vtkTypeMacro(Factory, vtkObjectFactory);
  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override { return "Spheres that stand for meshes"; }

protected:
  Factory()
  {
    this->RegisterOverride("vtkSphereProxyFilter", "vtkSphereProxyFilter", "spheres of a mesh", 1,
      []() -> vtkObject* { return vtkSphereProxyFilter::New(); });
  }
};
vtkStandardNewMacro(Factory);

const bool IsRegistered = []()
{
  vtkNew<Factory> factory;
  vtkObjectFactory::RegisterFactory(factory);
  return true;
}();
}

struct vtkSphereProxyFilter::Fitted
{
  vtkPolyData* Input = nullptr; // only compared
  vtkMTimeType InputTime = 0;
  std::vector<double> Properties; // the filter's own time also changes with the moved points
  vtkIdType NumberOfPoints = 0;
  vtkNew<vtkPolyData> Spheres;
};

//------------------------------------------------------------------------------
vtkSphereProxyFilter::vtkSphereProxyFilter()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkSphereProxyFilter::~vtkSphereProxyFilter() = default;

//------------------------------------------------------------------------------
int vtkSphereProxyFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    return 1;
  }
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
void vtkSphereProxyFilter::SetMovedConnection(vtkAlgorithmOutput* port)
{
  this->SetInputConnection(1, port);
}

//------------------------------------------------------------------------------
void vtkSphereProxyFilter::SetMovedData(vtkPointSet* points)
{
  this->SetInputDataInternal(1, points);
}

//------------------------------------------------------------------------------
int vtkSphereProxyFilter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPointSet* moved = vtkPointSet::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const std::vector<double> properties{ static_cast<double>(this->Target),
    static_cast<double>(this->NumberOfSpheres), this->MaximumError,
    static_cast<double>(this->ErrorUnit), static_cast<double>(this->Resolution),
    this->MaximumOpening, static_cast<double>(this->RefinementSteps) };
  const bool kept = this->Kept && this->Kept->Input == input &&
    this->Kept->InputTime == input->GetMTime() && this->Kept->Properties == properties;
  if (!kept)
  {
    if (!this->Fit(input))
    {
      return 1;
    }
    this->Kept->Properties = properties;
  }
  if (!moved)
  {
    output->ShallowCopy(this->Kept->Spheres);
    return 1;
  }
  if (moved->GetNumberOfPoints() != this->Kept->NumberOfPoints)
  {
    vtkErrorMacro("the moved points must be those of the input: they are "
      << moved->GetNumberOfPoints() << ", the input has " << this->Kept->NumberOfPoints);
    return 1;
  }
  MoveSpheres(this->Kept->Spheres, moved, output);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkSphereProxyFilter::Fit(vtkPolyData* input)
{
  this->Kept.reset();
  vtkProxySurface surface;
  std::string wrong;
  if (!surface.Build(input, wrong))
  {
    vtkErrorMacro("no spheres were made: " << wrong);
    return false;
  }
  ++this->NumberOfFits;
  auto made = std::make_unique<Fitted>();
  made->Input = input;
  made->InputTime = input->GetMTime();
  made->NumberOfPoints = input->GetNumberOfPoints();

  std::vector<vtkProxySphere> spheres;
  vtkProxyMeasures measures;
  double error = 0.0;
  if (!surface.Empty())
  {
    vtkProxySolid solid;
    solid.Build(surface, this->Resolution, this->MaximumOpening);
    this->UpdateProgress(0.2);
    if (this->Target == MAXIMUM_ERROR)
    {
      error = std::max(LeastError,
        this->ErrorUnit == WORLD_UNITS ? this->MaximumError / surface.GetDiagonal()
                                       : this->MaximumError);
      const double wanted = 4.0 * surface.GetArea() / (error * error);
      const int samples =
        static_cast<int>(std::min<double>(std::max<double>(wanted, LeastSamples), MostSamples));
      const vtkProxyCover cover(surface, solid, samples);
      this->UpdateProgress(0.4);
      spheres = cover.CoverWithin(error, VTK_INT_MAX);
      this->UpdateProgress(0.7);
      cover.Refine(spheres, error, this->RefinementSteps);
      cover.Repair(spheres, error, std::min(4 * samples, 2 * MostSamples));
    }
    else
    {
      const int samples =
        std::min(std::max(SamplesPerSphere * this->NumberOfSpheres, LeastSamples), MostSamples);
      const vtkProxyCover cover(surface, solid, samples);
      this->UpdateProgress(0.4);
      error = cover.CoverWith(this->NumberOfSpheres, spheres);
      this->UpdateProgress(0.7);
      cover.Refine(spheres, error, this->RefinementSteps);
    }
    this->UpdateProgress(0.8);
    measures.Measure(surface, solid, spheres, error);
  }

  const auto count = static_cast<vtkIdType>(spheres.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkCellArray> vertices;
  vtkPolyData* output = made->Spheres;
  output->SetPoints(points);
  output->SetVerts(vertices);
  vtkPointData* data = output->GetPointData();
  vtkDoubleArray* radii = AddArray(data, "Radius", 1, count);
  vtkDoubleArray* weights = AddArray(data, "ParentWeights", vtkProxyBinding::Count, count);
  vtkDoubleArray* spreads = AddArray(data, "ParentSpread", 1, count);
  vtkDoubleArray* offsets = AddArray(data, "ParentOffset", 3, count);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ParentIds");
  ids->SetNumberOfComponents(vtkProxyBinding::Count);
  ids->SetNumberOfTuples(count);
  data->AddArray(ids);
  data->SetActiveScalars("Radius");
  const std::vector<vtkProxyBinding> bindings = vtkProxyBinding::Bind(surface, spheres);
  const double length = surface.GetDiagonal();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkProxySphere& sphere = spheres[static_cast<size_t>(i)];
    const vtkProxyBinding& binding = bindings[static_cast<size_t>(i)];
    const glm::dvec3 center = surface.ToWorld(sphere.Center);
    points->SetPoint(i, center.x, center.y, center.z);
    vertices->InsertNextCell(1, &i);
    radii->SetValue(i, sphere.Radius * length);
    spreads->SetValue(i, binding.Spread);
    offsets->SetTuple3(i, binding.Offset.x, binding.Offset.y, binding.Offset.z);
    for (int c = 0; c < vtkProxyBinding::Count; ++c)
    {
      ids->SetComponent(i, c, static_cast<double>(binding.Ids[c]));
      weights->SetComponent(i, c, binding.Weights[c]);
    }
  }
  const double volume = length * length * length;
  const std::pair<const char*, double> fields[] = { { "Error", error * length },
    { "CoveredArea", measures.CoveredArea }, { "MaximumGap", measures.MaximumGap * length },
    { "RootMeanSquareError", measures.RootMeanSquareError * length },
    { "MaximumProtrusion", measures.MaximumProtrusion * length },
    { "SolidVolume", measures.SolidVolume * volume }, { "CoveredVolume", measures.CoveredVolume },
    { "ProtrudingVolume", measures.ProtrudingVolume * volume } };
  for (const auto& field : fields)
  {
    vtkNew<vtkDoubleArray> value;
    value->SetName(field.first);
    value->InsertNextValue(field.second);
    output->GetFieldData()->AddArray(value);
  }
  this->Kept = std::move(made);
  return true;
}

//------------------------------------------------------------------------------
bool vtkSphereProxyFilter::MoveSpheres(
  vtkPolyData* spheres, vtkPointSet* points, vtkPolyData* moved)
{
  if (!spheres || !points || !moved)
  {
    vtkErrorWithObjectMacro(spheres, "MoveSpheres needs spheres, points and an output");
    return false;
  }
  vtkPointData* data = spheres->GetPointData();
  auto* ids = vtkIdTypeArray::SafeDownCast(data->GetArray("ParentIds"));
  vtkDataArray* weights = data->GetArray("ParentWeights");
  vtkDataArray* spreads = data->GetArray("ParentSpread");
  vtkDataArray* offsets = data->GetArray("ParentOffset");
  vtkDataArray* radii = data->GetArray("Radius");
  constexpr int parents = vtkProxyBinding::Count;
  if (!ids || !weights || !spreads || !offsets || !radii ||
    ids->GetNumberOfComponents() != parents || weights->GetNumberOfComponents() != parents ||
    offsets->GetNumberOfComponents() != 3)
  {
    vtkErrorWithObjectMacro(
      spheres, "the spheres have no parents: they are no output of vtkSphereProxyFilter");
    return false;
  }
  const vtkIdType count = spheres->GetNumberOfPoints();
  vtkNew<vtkPoints> centers;
  centers->SetDataTypeToDouble();
  centers->SetNumberOfPoints(count);
  vtkNew<vtkDoubleArray> sizes;
  sizes->SetName("Radius");
  sizes->SetNumberOfTuples(count);
  vtkIdType wrong = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    glm::dvec3 places[parents];
    glm::dvec3 center(0.0);
    int used = 0;
    for (int c = 0; c < parents; ++c)
    {
      const double weight = weights->GetComponent(i, c);
      const vtkIdType id = ids->GetTypedComponent(i, c);
      if (id < 0 || id >= points->GetNumberOfPoints())
      {
        vtkErrorWithObjectMacro(spheres,
          "a sphere's parent is point " << id << ", but there are " << points->GetNumberOfPoints());
        return false;
      }
      double p[3];
      points->GetPoint(id, p);
      places[used] = { p[0], p[1], p[2] };
      center += weight * places[used];
      // Unused parents repeat the first one.
      used += c == 0 || id != ids->GetTypedComponent(i, 0) ? 1 : 0;
    }
    double offset[3];
    offsets->GetTuple(i, offset);
    const double spread = spreads->GetComponent(i, 0);
    const double scale = spread > 0.0 ? vtkProxyBinding::GetSpread(places, used) / spread : 1.0;
    const double size = radii->GetComponent(i, 0) * scale;
    center += scale * glm::dvec3(offset[0], offset[1], offset[2]);
    if (!std::isfinite(center.x + center.y + center.z + size))
    {
      ++wrong;
      centers->SetPoint(i, spheres->GetPoint(i));
      sizes->SetValue(i, 0.0);
      continue;
    }
    centers->SetPoint(i, center.x, center.y, center.z);
    sizes->SetValue(i, size);
  }
  if (wrong > 0)
  {
    vtkErrorWithObjectMacro(spheres, << wrong
                                     << " spheres move with points that are not finite; they stay, "
                                        "with radius 0");
  }
  moved->ShallowCopy(spheres);
  moved->SetPoints(centers);
  moved->GetPointData()->AddArray(sizes);
  moved->GetPointData()->SetActiveScalars("Radius");
  return true;
}

//------------------------------------------------------------------------------
double vtkSphereProxyFilter::GetMeasure(const char* name)
{
  auto* value = this->Kept
    ? vtkDoubleArray::SafeDownCast(this->Kept->Spheres->GetFieldData()->GetArray(name))
    : nullptr;
  return value ? value->GetValue(0) : 0.0;
}

//------------------------------------------------------------------------------
void vtkSphereProxyFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent
     << "Target: " << (this->Target == MAXIMUM_ERROR ? "MAXIMUM_ERROR" : "NUMBER_OF_SPHERES")
     << "\n";
  os << indent << "NumberOfSpheres: " << this->NumberOfSpheres << "\n";
  os << indent << "MaximumError: " << this->MaximumError << "\n";
  os << indent
     << "ErrorUnit: " << (this->ErrorUnit == WORLD_UNITS ? "WORLD_UNITS" : "SHARE_OF_DIAGONAL")
     << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "MaximumOpening: " << this->MaximumOpening << "\n";
  os << indent << "RefinementSteps: " << this->RefinementSteps << "\n";
  os << indent << "NumberOfFits: " << this->NumberOfFits << "\n";
}
