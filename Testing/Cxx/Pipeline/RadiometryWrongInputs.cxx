// SPDX-License-Identifier: BSD-3-Clause
// Data with NaN, infinity or values that stand for none: what they spoil takes no part, and the
// rest is lit as without it.
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkLODProp3D.h"
#include "vtkLight.h"
#include "vtkMolecule.h"
#include "vtkMoleculeMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"
#include "vtkSphereSource.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
using CompositeMapper = vtkCompositePolyDataMapper;
#else
#include "vtkCompositePolyDataMapper2.h"
using CompositeMapper = vtkCompositePolyDataMapper2;
#endif

#include <cmath>
#include <limits>
#include <string>

using namespace vtkIndirectTest;

namespace
{
struct Corner : Scene
{
  Corner()
    : Scene(48, 36)
  {
    this->AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0.8, 0.8, 0.8 });
    this->AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.3, 0.6, 0.9 });
    this->AddSpot({ 0.9, 1.4, 0.8 }, { 0.4, 0, 0.4 }, 40, 1, { 1, 0, 0 });
    this->SetEye({ 2.2, 1.6, 2.3 }, { 0.4, 0.3, 0.4 }, { 0, 1, 0 }, 36, 0.5, 6);
    this->Pass->SetReflectiveShadowMapResolution(128);
  }
};

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

enum KindType
{
  MESH,
  BLOCK,
  PART,
  LEVEL,
  MOSTLY, // more of its points are fill values than not
  MOLECULE,
  NOTHING // all of its points are fill values
};

// By default, VTK scales points to the size of them all, which leaves nothing of the sphere.
void KeepScale(vtkPolyDataMapper* mapper)
{
  auto* drawing = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  if (drawing)
  {
    drawing->SetVBOShiftScaleMethod(0);
  }
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  mapper->SetVBOShiftScaleMethod(0);
#endif
}

// Towards invisible parts, from below.
void SpoilPoints(vtkPolyData* data, int kind, double value)
{
  vtkPoints* points = data->GetPoints();
  const vtkIdType count = points->GetNumberOfPoints();
  points->SetPoint(1, 0.0, value, 0.0);
  for (vtkIdType i = 0; kind == MOSTLY && i < count; ++i)
  {
    const vtkIdType face[3] = { 1, 1, points->InsertNextPoint(0.0, value, 0.0) };
    data->GetPolys()->InsertNextCell(3, face);
  }
  for (vtkIdType i = 0; kind == NOTHING && i < count; ++i)
  {
    points->SetPoint(i, 0.0, value, 0.0);
  }
}

vtkSmartPointer<vtkProp> MakeSpoiltProp(int kind, double value)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->GetProperty()->SetColor(0.9, 0.5, 0.2);
  if (kind == MOLECULE)
  {
    vtkNew<vtkMolecule> molecule;
    molecule->GetPoints()->SetDataTypeToDouble();
    molecule->AppendAtom(6, 0.5, 0.3, 0.5);
    molecule->AppendAtom(6, 0.0, value, 0.0);
    vtkNew<vtkMoleculeMapper> mapper;
    mapper->SetInputData(molecule);
    mapper->SetAtomicRadiusTypeToUnitRadius();
    mapper->SetAtomicRadiusScaleFactor(0.2f);
    mapper->RenderBondsOff();
    actor->SetMapper(mapper);
    return actor;
  }
  vtkNew<vtkSphereSource> source;
  source->SetCenter(0.5, 0.3, 0.5);
  source->SetRadius(0.2);
  source->SetThetaResolution(24);
  source->SetPhiResolution(24);
  source->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  source->Update();
  vtkNew<vtkPolyData> data;
  data->DeepCopy(source->GetOutput());
  data->GetPointData()->Initialize();
  SpoilPoints(data, kind, value);
  if (kind == BLOCK)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, data);
    vtkNew<CompositeMapper> mapper;
    mapper->SetInputDataObject(blocks);
    KeepScale(mapper);
    actor->SetMapper(mapper);
    return actor;
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  KeepScale(mapper);
  if (kind == LEVEL)
  {
    auto levels = vtkSmartPointer<vtkLODProp3D>::New();
    levels->AddLOD(mapper, actor->GetProperty(), 0.0);
    return levels;
  }
  actor->SetMapper(mapper);
  if (kind == PART)
  {
    auto assembly = vtkSmartPointer<vtkAssembly>::New();
    assembly->AddPart(actor);
    return assembly;
  }
  return actor;
}
}

// Fill values in files are treated as infinite positions, which VTK leaves out of bounds by itself.
VTK_INDIRECT_TEST(FillValues)
{
  const auto draw = [](int kind, double value)
  {
    Corner scene;
    scene.Renderer->AddViewProp(MakeSpoiltProp(kind, value));
    scene.Render();
    scene.CheckBuffers(1);
    Check("the prop is named",
      std::isinf(value) ||
        scene.Pass->GetReport().find("of its points lie beyond 1e19") != std::string::npos);
    return scene.Copy("irradiance").Mean();
  };
  for (int kind = MESH; kind <= NOTHING; ++kind)
  {
    const double expected = draw(kind, -Infinity);
    CheckAtLeast("there is light", expected, 1e-3, "the test's own power");
    for (const double value : { -1e20, -9.96921e36 })
    {
      CheckRelative("irradiance of kind " + std::to_string(kind) + " with " + std::to_string(value),
        draw(kind, value), expected, 0.02,
        "faces at that point reach down to it, and hide a little");
    }
  }
}

VTK_INDIRECT_TEST(WrongSphereSizes)
{
  for (const double size : { 0.2, -1.0, NaN, 1e30, Infinity })
  {
    Corner scene;
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> sizes;
    sizes->SetName("size");
    vtkNew<vtkCellArray> cells;
    for (vtkIdType i = 0; i < 2; ++i)
    {
      points->InsertNextPoint(0.3 + 0.4 * static_cast<double>(i), 0.3, 0.5);
      sizes->InsertNextValue(i == 0 ? 0.2f : static_cast<float>(size));
      cells->InsertNextCell(1, &i);
    }
    data->SetPoints(points);
    data->SetVerts(cells);
    data->GetPointData()->AddArray(sizes);
    vtkNew<vtkOpenGLSphereMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetScaleArray("size");
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    scene.Renderer->AddActor(actor);
    scene.Render();
    scene.CheckBuffers(1);
  }
}

VTK_INDIRECT_TEST(GlassOfNoRoughness)
{
  for (const double roughness : { 0.2, NaN })
  {
    Corner scene;
    vtkActor* glass = scene.AddSphere({ 0.5, 0.4, 0.5 }, 0.2, 32, { 1, 1, 1 });
    vtkProperty* property = glass->GetProperty();
    property->SetInterpolationToPBR();
    property->SetMetallic(0.0);
    property->SetOpacity(0.3);
    property->SetBaseIOR(1.5);
    property->SetRoughness(roughness);
    scene.Gather->SetModeToVirtualLights();
    scene.Render();
    scene.CheckBuffers(1);
    for (const float value : scene.Copy("lobes").Values)
    {
      if (!std::isfinite(value))
      {
        Check("lobes are finite", false);
        break;
      }
    }
  }
}

// A light with a number that is not finite is left out, with its bounces, and is named.
VTK_INDIRECT_TEST(LightsWithoutAPlace)
{
  const auto draw = [](double position, double exponent)
  {
    Corner scene;
    scene.Pass->SetNumberOfBounces(3);
    vtkLight* second = scene.AddSpot({ 0.9, 1.4, 0.8 }, { 0.4, 0, 0.4 }, 40, 1, { 1, 0, 0 });
    second->SetIntensity(std::isfinite(position + exponent) ? 0.0 : 1.0);
    second->SetPosition(position, 1.4, 0.8);
    second->SetExponent(exponent);
    scene.Render();
    scene.CheckBuffers(1);
    const std::string report = scene.Pass->GetReport();
    Check("it is named where it has no place",
      (report.find("its place or its strength is not finite") != std::string::npos) ==
        !std::isfinite(position + exponent));
    return scene.Copy("irradiance").Mean();
  };
  const double expected = draw(0.9, 1.0);
  CheckAtLeast("there is light", expected, 1e-3, "the test's own power");
  CheckRelative("irradiance beside a light at NaN", draw(NaN, 1.0), expected, 1e-6, "it is dark");
  CheckRelative(
    "irradiance beside an exponent of NaN", draw(0.9, NaN), expected, 1e-6, "it is dark");
}
