// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectPointSpheres.h"

#include "Scene/vtkIndirectActors.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataSetMapper.h"
#include "vtkFloatArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace
{
const char* const Radii = "vtkIndirectRadii";

// Sizes in pixels become radii in space at the depths of the points. While the view moves, radii
// stay as they are as long as all are at least this share of the radii that the view draws, and not
// larger: spheres in maps must not cover the surfaces that the eye sees.
constexpr double LeastShare = 0.8;
constexpr double ShareInMotion = 0.9;
constexpr double Rounding = 1e-6;

// Gives access to members of an actor, whose setters have events and change its time.
struct ActorAccess : public vtkActor
{
  static vtkMapper*& GetMapper(vtkActor* actor) { return actor->*(&ActorAccess::Mapper); }
  static vtkProperty*& GetProperty(vtkActor* actor) { return actor->*(&ActorAccess::Property); }
};

// Returns true if an actor is drawn by its mapper alone.
bool IsDrawnByMapper(vtkActor* actor)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  return std::strcmp(actor->GetClassName(), "vtkOpenGLActor") == 0 && !actor->GetTexture() &&
    actor->GetProperty()->GetOpacity() >= 1.0 && shaders->GetNumberOfShaderReplacements() == 0 &&
    !shaders->HasVertexShaderCode() && !shaders->HasFragmentShaderCode() &&
    !shaders->HasGeometryShaderCode();
}

// Returns true if an actor draws opaque splats that shader code cuts off by `discard`, with one
// radius in space each. Other splats fade out and are translucent, or add light.
bool IsOfCutSplats(vtkActor* actor, vtkPointGaussianMapper* mapper)
{
  const char* code = mapper->GetSplatShaderCode();
  return code && std::strstr(code, "discard") && mapper->GetScaleFactor() > 0.0 &&
    !mapper->GetEmissive() && !mapper->GetOpacityArray() && IsDrawnByMapper(actor);
}

// Returns true if an actor draws points alone, each as a sphere.
bool IsOfPointsAsSpheres(vtkActor* actor, vtkMapper* mapper)
{
  return actor->GetProperty()->GetRenderPointsAsSpheres() &&
    (std::strcmp(mapper->GetClassName(), "vtkOpenGLPolyDataMapper") == 0 ||
      mapper->IsA("vtkDataSetMapper")) &&
    IsDrawnByMapper(actor);
}

// Returns vertices at all points of data.
vtkSmartPointer<vtkPolyData> MakeVertices(vtkPointSet* data)
{
  auto vertices = vtkSmartPointer<vtkPolyData>::New();
  vertices->SetPoints(data->GetPoints());
  vertices->GetPointData()->ShallowCopy(data->GetPointData());
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    cells->InsertNextCell(1, &i);
  }
  vertices->SetVerts(cells);
  return vertices;
}

// Returns the polygons or vertices that a mapper draws; null for composite data. Before VTK's first
// draw, which extracts polygons from other data, all points of these count.
vtkSmartPointer<vtkPolyData> FindInput(vtkMapper* mapper)
{
  if (mapper->GetNumberOfInputPorts() < 1 || mapper->GetNumberOfInputConnections(0) < 1)
  {
    return nullptr;
  }
  if (vtkIndirectActors::RunsPipeline(mapper))
  {
    mapper->GetInputAlgorithm(0, 0)->Update();
  }
  vtkDataObject* object = mapper->GetInputDataObject(0, 0);
  auto* data = vtkPolyData::SafeDownCast(object);
  auto* dataSetMapper = vtkDataSetMapper::SafeDownCast(mapper);
  vtkPolyDataMapper* inner = dataSetMapper ? dataSetMapper->GetPolyDataMapper() : nullptr;
  if (data || inner)
  {
    return data ? data : inner->GetInput();
  }
  auto* points = vtkPointSet::SafeDownCast(object);
  return points && points->GetPoints() ? MakeVertices(points) : nullptr;
}

// Calls the function with each point of each cell, and with the number of its cell.
template <typename F>
void ForEachDrawn(vtkPolyData* data, const F& call)
{
  vtkIdType cell = 0;
  for (vtkCellArray* cells :
    { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
  {
    auto it = vtk::TakeSmartPointer(cells->NewIterator());
    for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
    {
      vtkIdType count = 0;
      const vtkIdType* points = nullptr;
      it->GetCurrentCell(count, points);
      for (vtkIdType i = 0; i < count; ++i)
      {
        call(points[i], cell);
      }
    }
  }
}

// Returns a splat's size, as VTK takes it from the array.
double FindSize(vtkDataArray* sizes, int component, vtkPiecewiseFunction* function, vtkIdType i)
{
  if (!sizes)
  {
    return 1.0;
  }
  const int count = sizes->GetNumberOfComponents();
  double size = 0.0;
  if (count == 1 || (component >= 0 && component < count))
  {
    size = sizes->GetComponent(i, count == 1 ? 0 : component);
  }
  else
  {
    for (int k = 0; k < count; ++k)
    {
      size += sizes->GetComponent(i, k) * sizes->GetComponent(i, k);
    }
    size = std::sqrt(size);
  }
  if (function)
  {
    const double* range = function->GetRange();
    size = function->GetValue(std::min(std::max(size, range[0]), range[1]));
  }
  return size;
}

// Gives each point the colour of its cell, where a mapper colours cells: mappers of spheres know
// colours of points alone.
void CopyCellColors(vtkPolyData* data, vtkMapper* mapper, vtkPolyData* spheres)
{
  int byCell = 0;
  const bool colored = mapper->GetScalarVisibility() &&
    vtkAbstractMapper::GetAbstractScalars(data, mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), byCell);
  vtkUnsignedCharArray* colors = colored && byCell == 1 ? mapper->MapScalars(data, 1.0) : nullptr;
  if (!colors)
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> ofPoints;
  ofPoints->SetName("vtkIndirectColors");
  ofPoints->SetNumberOfComponents(colors->GetNumberOfComponents());
  ofPoints->SetNumberOfTuples(data->GetNumberOfPoints());
  ofPoints->Fill(255.0);
  ForEachDrawn(data,
    [&](vtkIdType point, vtkIdType cell)
    {
      if (cell < colors->GetNumberOfTuples())
      {
        ofPoints->SetTuple(point, cell, colors);
      }
    });
  spheres->GetPointData()->SetScalars(ofPoints);
  mapper->SetScalarModeToUsePointData();
  mapper->SetColorModeToDefault();
}

// Returns what a splat's size is multiplied with: VTK from 9.4 on scales splats with their actor.
double FindScale([[maybe_unused]] vtkMatrix4x4* matrix)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  return std::cbrt(std::abs(glm::determinant(glm::dmat3(vtkIndirectFrame::ToGLM(matrix)))));
#else
  return 1.0;
#endif
}
}

//------------------------------------------------------------------------------
struct vtkIndirectPointSpheres::StandIn
{
  vtkIndirectKey Key; // what it was made from
  vtkSmartPointer<vtkOpenGLSphereMapper> Mapper;
  vtkSmartPointer<vtkProperty> Property;
  vtkSmartPointer<vtkPolyData> Spheres;
  std::vector<char> Drawn; // for each point; empty if all are
  bool PixelSized = false;
  double Pixels = 0.0; // diameter

  // The actor does not hold this pair: the stand-ins, and while a Scope lives the actor's own.
  vtkMapper* OtherMapper = nullptr;
  vtkProperty* OtherProperty = nullptr;

  bool IsDrawn(size_t point) const { return this->Drawn.empty() || this->Drawn[point]; }
};

//------------------------------------------------------------------------------
vtkIndirectPointSpheres::vtkIndirectPointSpheres() = default;
vtkIndirectPointSpheres::~vtkIndirectPointSpheres() = default;

//------------------------------------------------------------------------------
void vtkIndirectPointSpheres::Forget()
{
  this->StandIns.clear();
  this->Seen.Clear();
}

//------------------------------------------------------------------------------
int vtkIndirectPointSpheres::CountPixelSized() const
{
  return static_cast<int>(std::count_if(this->StandIns.begin(), this->StandIns.end(),
    [](const auto& entry) { return entry.second.PixelSized; }));
}

//------------------------------------------------------------------------------
void vtkIndirectPointSpheres::Update(vtkRenderer* renderer, bool mayRest)
{
  std::unordered_map<vtkActor*, StandIn> before = std::move(this->StandIns);
  this->StandIns.clear();
  bool eye = false; // it is set up
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    if (!prop->GetVisibility() || prop->IsA("vtkActor2D") || prop->IsA("vtkVolume"))
    {
      continue;
    }
    const auto look = [&](vtkActor* actor, vtkMatrix4x4* matrix)
    {
      vtkMapper* mapper = actor->GetMapper();
      auto* splats = vtkPointGaussianMapper::SafeDownCast(mapper);
      if (splats ? !IsOfCutSplats(actor, splats) : !IsOfPointsAsSpheres(actor, mapper))
      {
        return;
      }
      if (!eye)
      {
        this->SetUpEye(renderer, mayRest);
        eye = true;
      }
      const auto known = before.find(actor);
      this->Take(actor, matrix, known == before.end() ? StandIn() : std::move(known->second));
    };
    // A path for each actor of the renderer would take time in scenes without points.
    auto* actor = vtkActor::SafeDownCast(prop);
    if (actor && !actor->IsA("vtkAssembly"))
    {
      if (actor->GetMapper())
      {
        look(actor, actor->GetMatrix());
      }
    }
    else
    {
      vtkIndirectActors::ForEach(prop, look);
    }
  }
}

//------------------------------------------------------------------------------
// Reads the view: VTK draws a point with a diameter in pixels, of a sphere whose radius grows with
// depth.
void vtkIndirectPointSpheres::SetUpEye(vtkRenderer* renderer, bool mayRest)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const glm::dmat4 toView = vtkIndirectFrame::ToGLM(camera->GetModelViewTransformMatrix());
  const glm::dmat4 projection = vtkIndirectFrame::ToGLM(
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1, 1));
  const glm::dmat4 rows = glm::transpose(toView);
  this->Eye.ToDepth = -rows[2];
  this->Eye.RadiusOfPixel = 1.0 / (std::max(renderer->GetSize()[0], 1) * projection[0][0]);
  this->Eye.Nearest = camera->GetClippingRange()[0];
  this->Eye.Parallel = camera->GetParallelProjection() != 0;
  vtkIndirectKey seen;
  seen.Add("eye", toView).Add("eye", this->Eye.RadiusOfPixel).Add("eye", this->Eye.Parallel);
  const bool changed = this->Seen.Take(std::move(seen));
  this->FitsExactly = mayRest && !changed;
}

//------------------------------------------------------------------------------
// Keeps the stand-in of an actor, or makes one.
void vtkIndirectPointSpheres::Take(vtkActor* actor, vtkMatrix4x4* matrix, StandIn known)
{
  vtkMapper* mapper = actor->GetMapper();
  auto* splats = vtkPointGaussianMapper::SafeDownCast(mapper);
  vtkProperty* property = actor->GetProperty();
  const vtkSmartPointer<vtkPolyData> data = FindInput(mapper);
  if (!data || !data->GetPoints() || data->GetNumberOfPoints() == 0)
  {
    return;
  }
  // Surfaces cast their own shadows, with points drawn onto them.
  if (!splats && property->GetRepresentation() != VTK_POINTS &&
    (data->GetNumberOfVerts() == 0 ||
      data->GetNumberOfLines() + data->GetNumberOfPolys() + data->GetNumberOfStrips() > 0))
  {
    return;
  }
  mapper->GetLookupTable(); // VTK makes one in its first draw, which modifies the mapper
  vtkIndirectKey key("mapper", mapper);
  key.Add("data", data);
  key.Add("property", property);
  key.Add("sizes", splats ? splats->GetScaleFunction() : nullptr);
  key.Add("scale", splats ? FindScale(matrix) : 1.0);
  StandIn standIn = std::move(known);
  if (standIn.Key.Take(std::move(key)))
  {
    const auto points = static_cast<size_t>(data->GetNumberOfPoints());
    standIn.Mapper = vtkSmartPointer<vtkOpenGLSphereMapper>::New();
    standIn.Spheres = vtkSmartPointer<vtkPolyData>::New();
    standIn.Spheres->SetPoints(data->GetPoints());
    standIn.Spheres->GetPointData()->ShallowCopy(data->GetPointData());
    standIn.Spheres->GetFieldData()->ShallowCopy(data->GetFieldData());
    standIn.Drawn.clear();
    if (!splats || data->GetNumberOfVerts() > 0)
    {
      standIn.Drawn.assign(points, 0);
      ForEachDrawn(data,
        [&standIn](vtkIdType point, vtkIdType) { standIn.Drawn[static_cast<size_t>(point)] = 1; });
    }
    // Bounds of polygonal data are those of cells.
    vtkNew<vtkCellArray> vertices;
    for (size_t i = 0; i < points; ++i)
    {
      const auto point = static_cast<vtkIdType>(i);
      if (standIn.IsDrawn(i))
      {
        vertices->InsertNextCell(1, &point);
      }
    }
    standIn.Spheres->SetVerts(vertices);
    standIn.Mapper->vtkMapper::ShallowCopy(mapper); // without the input
    standIn.Mapper->SetStatic(0);
    standIn.Mapper->SetInputData(standIn.Spheres);
    standIn.Mapper->SetScaleArray(Radii);
    standIn.Mapper->InterpolateScalarsBeforeMappingOff();
    CopyCellColors(data, standIn.Mapper, standIn.Spheres);
    vtkNew<vtkFloatArray> radii;
    radii->SetName(Radii);
    radii->SetNumberOfTuples(data->GetNumberOfPoints());
    radii->Fill(0.0);
    standIn.Spheres->GetPointData()->AddArray(radii);
    standIn.Property = vtkSmartPointer<vtkProperty>::New();
    standIn.Property->DeepCopy(property);
    standIn.Property->SetRepresentationToSurface();
    standIn.Property->RenderPointsAsSpheresOff();
    standIn.Property->EdgeVisibilityOff();
    standIn.PixelSized = !splats;
    standIn.Pixels = property->GetPointSize();
    if (splats)
    {
      const char* const name = splats->GetScaleArray();
      vtkDataArray* sizes = name ? data->GetPointData()->GetArray(name) : nullptr;
      const double scale = splats->GetScaleFactor() * FindScale(matrix);
      for (size_t i = 0; i < points; ++i)
      {
        const auto point = static_cast<vtkIdType>(i);
        const double size =
          FindSize(sizes, splats->GetScaleArrayComponent(), splats->GetScaleFunction(), point);
        radii->SetValue(point, standIn.IsDrawn(i) ? static_cast<float>(scale * size) : 0.0f);
      }
    }
  }
  if (standIn.PixelSized)
  {
    this->FitRadii(standIn, vtkIndirectFrame::ToGLM(matrix));
  }
  standIn.OtherMapper = standIn.Mapper;
  standIn.OtherProperty = standIn.Property;
  this->StandIns[actor] = std::move(standIn);
}

//------------------------------------------------------------------------------
// Gives points the radii of their sizes in pixels, unless the radii that they have will do.
void vtkIndirectPointSpheres::FitRadii(StandIn& standIn, const glm::dmat4& toWorld)
{
  auto* radii = vtkFloatArray::SafeDownCast(standIn.Spheres->GetPointData()->GetArray(Radii));
  const auto count = static_cast<size_t>(radii->GetNumberOfTuples());
  const glm::dvec4 toDepth = this->Eye.ToDepth * toWorld;
  std::vector<double> drawn(count, 0.0);
  double least = 1e30;
  double most = 0.0;
  for (size_t i = 0; i < count; ++i)
  {
    if (standIn.IsDrawn(i))
    {
      const auto point = static_cast<vtkIdType>(i);
      double p[3];
      standIn.Spheres->GetPoint(point, p);
      const double depth =
        std::max(glm::dot(toDepth, glm::dvec4(p[0], p[1], p[2], 1.0)), this->Eye.Nearest);
      drawn[i] = standIn.Pixels * this->Eye.RadiusOfPixel * (this->Eye.Parallel ? 1.0 : depth);
      const double share = static_cast<double>(radii->GetValue(point)) / drawn[i];
      least = std::min(least, share);
      most = std::max(most, share);
    }
  }
  const bool fits = most <= 1.0 + Rounding && least >= LeastShare;
  const bool exact = this->FitsExactly || most == 0.0;
  if (fits && (!exact || least >= 1.0 - Rounding))
  {
    return;
  }
  for (size_t i = 0; i < count; ++i)
  {
    radii->SetValue(
      static_cast<vtkIdType>(i), static_cast<float>((exact ? 1.0 : ShareInMotion) * drawn[i]));
  }
  radii->Modified();
}

//------------------------------------------------------------------------------
// Exchanges mappers and properties of actors for the others.
void vtkIndirectPointSpheres::Exchange(bool pixelSizedAlone)
{
  for (auto& [actor, standIn] : this->StandIns)
  {
    if (pixelSizedAlone && !standIn.PixelSized)
    {
      continue;
    }
    // An actor refers to what it holds: VTK's garbage collector counts the references.
    const bool in = standIn.OtherMapper == standIn.Mapper;
    if (in)
    {
      standIn.Mapper->Register(actor);
      standIn.Property->Register(actor);
    }
    std::swap(ActorAccess::GetMapper(actor), standIn.OtherMapper);
    std::swap(ActorAccess::GetProperty(actor), standIn.OtherProperty);
    if (!in)
    {
      standIn.Mapper->UnRegister(actor);
      standIn.Property->UnRegister(actor);
    }
  }
}
