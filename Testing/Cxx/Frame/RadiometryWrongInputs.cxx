// SPDX-License-Identifier: BSD-3-Clause
// Data with NaN or infinity: affected props take no part, and the rest is lit as without them.
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"
#include "vtkSphereSource.h"

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
}

// Fill values in files are treated as infinite positions, which VTK leaves out of bounds by itself.
VTK_INDIRECT_TEST(FillValues)
{
  const auto draw = [](double value)
  {
    Corner scene;
    vtkNew<vtkSphereSource> source;
    source->SetCenter(0.5, 0.3, 0.5);
    source->SetRadius(0.2);
    source->SetThetaResolution(24);
    source->SetPhiResolution(24);
    source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    source->Update();
    vtkNew<vtkPolyData> data;
    data->DeepCopy(source->GetOutput());
    // Towards invisible parts, from below.
    data->GetPoints()->SetPoint(1, 0.0, value, 0.0);
    data->GetPoints()->Modified();
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.9, 0.5, 0.2);
    scene.Renderer->AddActor(actor);
    scene.Render();
    scene.CheckBuffers(1);
    return scene.Copy("irradiance").Mean();
  };
  const double expected = draw(-Infinity);
  CheckAtLeast("there is light", expected, 1e-3, "the test's own power");
  for (const double value : { -1e20, -9.96921e36 })
  {
    CheckRelative("irradiance with " + std::to_string(value), draw(value), expected, 0.02,
      "faces at that point reach down to it, and hide a little");
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
