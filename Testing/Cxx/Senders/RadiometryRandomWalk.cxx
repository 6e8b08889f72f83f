// SPDX-License-Identifier: BSD-3-Clause
// Virtual lights of a random walk against closed forms and the lights' own maps: one bounce, all
// bounces, every kind of light, walls, materials, scales, and invariants.
#include "vtkIndirectWalkScene.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightTreeSampler.h"
#include "vtkMath.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"
#include "vtkRandomWalkLightSampler.h"
#include "vtkRenderWindow.h"
#include "vtkTexture.h"
#include "vtkUniformLightSampler.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace vtkIndirectTest;

namespace
{
void CheckFlux(
  const std::string& what, const glm::dvec3& flux, const glm::dvec3& expected, double tolerance)
{
  for (int c = 0; c < 3; ++c)
  {
    CheckRelative(what, flux[c], expected[c], tolerance, "a low-discrepancy sequence; facets");
  }
}
}

// In a sphere with a light at its centre all surfaces have the same irradiance: E0 rho^n in bounce
// n.
VTK_INDIRECT_TEST(WalkFurnace)
{
  const glm::dvec3 albedo(0.75, 0.5, 0.25);
  constexpr double radius = 2.0;
  WalkScene scene;
  scene.AddSphere(glm::dvec3(0.0), radius, 64, albedo);
  scene.AddPoint(glm::dvec3(0.0), { 1, 0, 0 });
  scene.SetEye(glm::dvec3(0.0), { 1, 0, 0 }, { 0, 1, 0 }, 90, 0.1, 10);
  const double area = 4.0 * vtkMath::Pi() * radius * radius;
  glm::dvec3 sum(0.0);
  glm::dvec3 term(1.0);
  for (const int bounces : { 1, 2, 4, 16 })
  {
    sum = term = glm::dvec3(0.0);
    term = glm::dvec3(1.0);
    for (int i = 0; i < bounces; ++i)
    {
      term *= albedo;
      sum += term;
    }
    const std::string what = std::to_string(bounces) + " bounces: ";
    scene.UseWalk(8192, bounces);
    CheckFlux(what + "flux", scene.GetReflectedFlux(), area * sum, 0.01);
    CheckRelative(what + "irradiance", scene.Copy("bounce").Mean(), sum.x, 0.015,
      "kernels of some thousand lights, facets");
  }
  // The pass's own walk beside samplers of the first bounce, whose lights are of the same kind, or
  // a part of the tree.
  vtkNew<vtkLightTreeSampler> tree;
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  for (const bool own : { true, false })
  {
    scene.Pass->SetSampler(own ? static_cast<vtkVirtualLightSampler*>(tree)
                               : static_cast<vtkVirtualLightSampler*>(scene.Sampler));
    scene.Sampler->SetNumberOfLights(1024);
    scene.Render();
    CheckRelative(own ? "of a tree" : "beside even lights", scene.Copy("bounce").Mean(), sum.x,
      0.025,
      "clusters of 8192 vertices, even lights' kernels; 0.002 of it what bowls do not spread");
  }
  scene.Pass->SetEstimator(splatting);
  scene.Render();
  CheckRelative("multiresolution", scene.Copy("bounce").Mean(), sum.x, 0.025, "the same");
  scene.Pass->SetEstimator(nullptr);
}

VTK_INDIRECT_TEST(WalkKindsOfLights)
{
  {
    WalkScene scene;
    scene.AddCorner();
    scene.AddSpot({ 1, 2, 1 }, { 0.4, 0, 0.4 }, 30, 8, { 1, 0, 0 });
    scene.CompareWithMaps("spot", 1);
  }
  {
    WalkScene scene;
    scene.AddCorner();
    scene.AddSpot({ 0.7, 0.9, 0.8 }, { 0.4, 0, 0.4 }, 80, 1, { 0.3, 0.1, 1 });
    scene.CompareWithMaps("wide spot", 1);
  }
  {
    WalkScene scene;
    scene.AddCorner();
    scene.AddPoint({ 0.5, 0.8, 0.9 }, { 0, 0, 1 });
    scene.CompareWithMaps("point", 1);
  }
  {
    WalkScene scene;
    scene.AddCorner();
    scene.AddPoint({ 30, 50, 40 }, { 1, 0, 0 });
    scene.CompareWithMaps("distant point", 1);
  }
  {
    WalkScene scene;
    scene.AddCorner();
    scene.AddDirectional({ -1, -2, -1.5 });
    scene.CompareWithMaps("directional", 1);
    scene.AddSpot({ 1, 2, 1 }, { 0.4, 0, 0.4 }, 30, 8, { 0, 0, 0.02 })->SetColor(1, 0.2, 0.1);
    scene.CompareWithMaps("two lights", 2);
  }
}

// A light that follows the camera is equivalent to a light at the same position.
VTK_INDIRECT_TEST(WalkHeadlight)
{
  WalkScene scene;
  scene.AddCorner();
  vtkLight* light = scene.AddDirectional({ -1.8, -1.3, -1.9 });
  scene.UseWalk(2048, 2);
  const glm::dvec3 flux = scene.GetReflectedFlux();
  light->SetLightTypeToHeadlight();
  scene.Render();
  const glm::dvec3 headlight = scene.GetReflectedFlux();
  CheckRelative("headlight", headlight.x, flux.x, 1e-4, "the same direction but for rounding");
  light->SetLightTypeToCameraLight();
  light->SetPosition(0, 0, 1);
  light->SetFocalPoint(0, 0, 0);
  scene.Render();
  CheckRelative("camera light", scene.GetReflectedFlux().x, flux.x, 1e-4, "the same direction");
}

// Nothing is lit behind a wall, after any number of bounces.
VTK_INDIRECT_TEST(WalkThroughNoWall)
{
  WalkScene scene;
  const glm::dvec3 white(0.8);
  for (const double x : { 0.0, 2.0 })
  {
    auto at = [&](double a, double b, double c) { return glm::dvec3(x + 2.0 * a, b, c); };
    scene.AddQuad(at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), white);
    scene.AddQuad(at(0, 0, 1), at(0, 1, 1), at(1, 0, 1), white);
    scene.AddQuad(at(0, 0, 0), at(0, 1, 0), at(0, 0, 1), white);
    scene.AddQuad(at(1, 0, 0), at(1, 0, 1), at(1, 1, 0), white);
    scene.AddQuad(at(0, 1, 0), at(1, 1, 0), at(0, 1, 1), white);
    scene.AddQuad(at(0, 0, 0), at(0, 0, 1), at(1, 0, 0), white);
  }
  scene.AddPoint({ 1, 0.5, 0.5 }, { 0, 0, 1 });
  scene.SetEye({ 0.1, 0.5, 0.5 }, { 1, 0.5, 0.5 }, { 0, 1, 0 }, 60, 0.05, 5);
  scene.UseWalk(20000, 16);
  double farthest = 0.0;
  int count = 0;
  for (const VirtualLight& light : scene.CopyLights())
  {
    farthest = std::max(farthest, light.DensityArea.x > 0.0 ? light.Position.x : 0.0);
    count += light.DensityArea.x > 0.0 ? 1 : 0;
  }
  CheckAtMost("farthest light", farthest, 2.0 + 1e-5, "the wall, and floats");
  Check("many", count > 15000);
}

VTK_INDIRECT_TEST(WalkScales)
{
  struct Place
  {
    double Scale;
    glm::dvec3 At;
  };
  Image expected;
  for (const Place& place : { Place{ 1.0, glm::dvec3(0.0) }, Place{ 1e-9, glm::dvec3(0.0) },
         Place{ 1e6, glm::dvec3(0.0) } })
  {
    WalkScene scene;
    scene.AddCorner(place.Scale, place.At);
    const double s = place.Scale;
    scene.AddSpot(place.At + s * glm::dvec3(1, 2, 1), place.At + s * glm::dvec3(0.4, 0, 0.4), 40, 1,
      { 1, 0, 0 });
    scene.UseWalk(1000, 4);
    scene.CheckBuffers(1);
    const Image image = scene.Copy("bounce");
    if (expected.Values.empty())
    {
      expected = image;
      continue;
    }
    double worst = 0.0;
    for (size_t i = 0; i < image.Values.size(); ++i)
    {
      worst = std::max(worst, std::abs(static_cast<double>(image.Values[i]) - expected.Values[i]));
    }
    CheckAtMost("difference over the mean at scale " + std::to_string(place.Scale),
      worst / expected.Mean(), 0.05, "edges of the picture's surfaces; floats of the triangles");
    CheckRelative("mean", image.Mean(), expected.Mean(), 1e-3, "the same paths");
  }
}

// Vertices of later bounces carry about the same light, so that no few of them decide how bright a
// crease is: the number of equal vertices with the same variance is near the number of vertices.
VTK_INDIRECT_TEST(WalkEqualLight)
{
  WalkScene scene;
  scene.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0.9, 0.9, 0.9 });
  scene.AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.9, 0.1, 0.1 });
  scene.AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.1, 0.1, 0.9 });
  scene.SetEye({ 2.2, 1.6, 2.3 }, { 0.4, 0.3, 0.4 }, { 0, 1, 0 }, 36, 0.5, 6);
  scene.AddPoint({ 0.3, 0.4, 0.2 }, { 1, 0, 0 });
  scene.Walk->SetFirstBounce(2);
  scene.UseWalk(32768, 16);
  const glm::dvec3 flux = scene.GetReflectedFlux();
  double sum = 0.0;
  double squares = 0.0;
  const std::vector<VirtualLight> lights = scene.CopyLights();
  for (const VirtualLight& light : lights)
  {
    const double largest =
      std::max({ light.DensityArea.x, light.DensityArea.y, light.DensityArea.z });
    sum += largest;
    squares += largest * largest;
  }
  CheckAtLeast("number of equal vertices over the number of vertices",
    sum * sum / squares / static_cast<double>(lights.size()), 0.65,
    "colours that reflect 0.1 to 0.9 of each other, and distances from the light that differ by a "
    "factor of 5");
  scene.UseWalk(262144, 16);
  CheckFlux("as much light as of many vertices", flux, scene.GetReflectedFlux(), 0.03);
  scene.Walk->SetFirstBounce(1);
}

// A small motion of a light moves its virtual lights by little; frames that do not change the light
// keep them.
VTK_INDIRECT_TEST(WalkMovesSmoothly)
{
  WalkScene scene;
  scene.AddCorner();
  vtkLight* light = scene.AddSpot({ 1, 2, 1 }, { 0.4, 0, 0.4 }, 40, 1, { 1, 0, 0 });
  scene.UseWalk(1000, 3);
  const std::vector<VirtualLight> before = scene.CopyLights();
  const Image image = scene.Copy("bounce");
  CheckEqual("walks", scene.ReadReport("walks"), 1);
  scene.SetEye({ 2.0, 1.7, 2.4 }, { 0.4, 0.3, 0.4 }, { 0, 1, 0 }, 36, 0.5, 6);
  scene.Render();
  CheckEqual("walks after the camera has moved", scene.ReadReport("walks"), 1);
  scene.SetEye({ 2.2, 1.6, 2.3 }, { 0.4, 0.3, 0.4 }, { 0, 1, 0 }, 36, 0.5, 6);
  light->SetPosition(1.0005, 2, 1);
  scene.Render();
  CheckEqual("walks after the light has", scene.ReadReport("walks"), 2);
  CheckEqual("trees", scene.ReadReport("walk_trees"), 1);
  const std::vector<VirtualLight> after = scene.CopyLights();
  int near = 0;
  for (const VirtualLight& a : before)
  {
    near += std::any_of(after.begin(), after.end(),
              [&](const VirtualLight& b) { return glm::length(a.Position - b.Position) < 0.01; })
      ? 1
      : 0;
  }
  CheckAtLeast("share of lights that are near where they were",
    static_cast<double>(near) / static_cast<double>(before.size()), 0.97,
    "a path meets another surface where it passes an edge");
  const Image moved = scene.Copy("bounce");
  double sum = 0.0;
  for (size_t i = 0; i < image.Values.size(); ++i)
  {
    sum += std::pow(static_cast<double>(moved.Values[i]) - image.Values[i], 2.0);
  }
  CheckAtMost("change of the irradiance over its mean, RMS",
    std::sqrt(sum / static_cast<double>(image.Values.size())) / image.Mean(), 0.02,
    "a step of 0.0005 in a scene of 1.7; another set of paths would be 0.1");
  // Colours are read again, the tree of triangles stays.
  vtkActor::SafeDownCast(scene.Renderer->GetViewProps()->GetItemAsObject(0))
    ->GetProperty()
    ->SetDiffuseColor(0.1, 0.1, 0.1);
  scene.Render();
  CheckEqual("trees after a change of colour", scene.ReadReport("walk_trees"), 1);
  CheckEqual("walks after it", scene.ReadReport("walks"), 3);
  scene.AddSphere({ 0.3, 0.3, 0.7 }, 0.1, 16, glm::dvec3(0.5));
  scene.Render();
  CheckEqual("trees after a new prop", scene.ReadReport("walk_trees"), 2);
}

// Colours of points and cells, a texture, the back of a sheet, culling, PBR: equal to those in the
// maps.
VTK_INDIRECT_TEST(WalkMaterials)
{
  for (int kind = 0; kind < 8; ++kind)
  {
    WalkScene scene;
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(0, 0, 0);
    plane->SetPoint1(0, 0, 1);
    plane->SetPoint2(1, 0, 0);
    plane->SetResolution(5, 5);
    plane->Update();
    vtkNew<vtkPolyData> data;
    data->DeepCopy(plane->GetOutput());
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    const bool points = kind == 0;
    const vtkIdType count = points ? data->GetNumberOfPoints() : data->GetNumberOfCells();
    for (vtkIdType i = 0; i < count; ++i)
    {
      colors->InsertNextTuple3(
        static_cast<double>(i * 255 / count), 128, static_cast<double>(255 - i * 255 / count));
    }
    if (kind == 0)
    {
      data->GetPointData()->SetScalars(colors);
    }
    else if (kind == 1)
    {
      data->GetCellData()->SetScalars(colors);
    }
    if (kind == 6)
    {
      data->GetPointData()->SetNormals(nullptr);
      vtkNew<vtkFloatArray> values;
      for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
      {
        values->InsertNextValue(static_cast<float>(i % 3));
      }
      data->GetPointData()->SetScalars(values);
    }
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetScalarRange(0, 2);
    mapper->SetInterpolateScalarsBeforeMapping(kind == 6);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.2, 0.5, 0.8);
    actor->GetProperty()->SetDiffuse(0.9);
    vtkNew<vtkTexture> texture;
    vtkNew<vtkImageData> image;
    image->SetDimensions(8, 4, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int i = 0; i < 8 * 4 * 3; ++i)
    {
      static_cast<unsigned char*>(image->GetScalarPointer())[i] =
        static_cast<unsigned char>(i * 37 % 256);
    }
    texture->SetInputData(image);
    texture->SetInterpolate(1);
    const char* names[] = { "colours of points", "colours of cells", "texture", "back property",
      "culled", "physically based", "scalars interpolated", "flat" };
    if (kind == 2)
    {
      actor->SetTexture(texture);
    }
    bool below = false;
    if (kind == 3)
    {
      vtkNew<vtkProperty> back;
      back->SetDiffuseColor(0.9, 0.1, 0.4);
      actor->SetBackfaceProperty(back);
      below = true;
    }
    if (kind == 4)
    {
      actor->GetProperty()->BackfaceCullingOn();
      below = true;
      scene.AddQuad({ 0, 0.4, 0 }, { 0, 0.4, 1 }, { 1, 0.4, 0 }, { 0.7, 0.6, 0.5 });
    }
    if (kind == 5)
    {
      actor->GetProperty()->SetInterpolationToPBR();
      actor->GetProperty()->SetMetallic(0.25);
      scene.Gather->SpecularTransportOff(); // paths reflect only diffusely
    }
    if (kind == 7)
    {
      actor->GetProperty()->SetInterpolationToFlat();
    }
    scene.Renderer->AddActor(actor);
    scene.AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.5, 0.5, 0.5 });
    scene.AddQuad({ 0, -1, 0 }, { 0, 0, 0 }, { 0, -1, 1 }, { 0.5, 0.5, 0.5 });
    const double y = below ? -1.0 : 1.0;
    scene.AddSpot({ 0.6, 1.5 * y, 0.7 }, { 0.5, 0, 0.5 }, 50, 1, { 1, 0, 0 });
    scene.SetEye({ 2.2, 1.6 * y, 2.3 }, { 0.4, 0, 0.4 }, { 0, 1, 0 }, 36, 0.5, 6);
    scene.CompareWithMaps(names[kind], 1);
  }
}

VTK_INDIRECT_TEST(WalkHardCases)
{
  {
    // All black, no light, no surface.
    WalkScene scene;
    vtkActor* quad = scene.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, glm::dvec3(0.0));
    vtkLight* light = scene.AddPoint({ 0.5, 0.5, 0.5 }, { 1, 0, 0 });
    scene.SetEye({ 2, 2, 2 }, { 0.5, 0, 0.5 }, { 0, 1, 0 }, 40, 0.5, 6);
    scene.UseWalk(100, 4);
    CheckEqual("black: flux", glm::length(scene.GetReflectedFlux()), 0.0);
    light->SetIntensity(0.0);
    scene.Render();
    quad->VisibilityOff();
    scene.Render();
    light->SetIntensity(1.0);
    scene.Render();
    // White, and back again.
    quad->VisibilityOn();
    quad->GetProperty()->SetColor(1, 1, 1);
    scene.Render();
    CheckRelative("white: flux", scene.GetReflectedFlux().x, 1.0, 1.0, "there is some");
  }
  {
    // Degenerate triangles, or triangles with NaN; and normals against the winding, which VTK draws
    // black.
    WalkScene scene;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    vtkNew<vtkPoints> points;
    for (const glm::dvec3& p : { glm::dvec3(0, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0),
           glm::dvec3(1, 0, 1), glm::dvec3(nan, 0, 0) })
    {
      points->InsertNextPoint(p.x, p.y, p.z);
    }
    vtkNew<vtkCellArray> polygons;
    const vtkIdType triangles[][3] = { { 0, 1, 2 }, { 1, 3, 2 }, { 0, 0, 1 }, { 0, 1, 1 },
      { 0, 1, 4 }, { 4, 4, 4 } };
    for (const auto& triangle : triangles)
    {
      polygons->InsertNextCell(3, triangle);
    }
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    for (int i = 0; i < 5; ++i)
    {
      normals->InsertNextTuple3(0, 1, 0);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(polygons);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    scene.Renderer->AddActor(actor);
    scene.AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, glm::dvec3(0.5));
    scene.AddDirectional({ 0, -1, 0 });
    scene.SetEye({ 2, 2, 2 }, { 0.5, 0, 0.5 }, { 0, 1, 0 }, 40, 0.5, 6);
    scene.UseWalk(1000, 3);
    scene.CheckBuffers(1);
    // A square under perpendicular light reflects in its first bounce the light on its area.
    scene.UseWalk(4096, 1);
    CheckRelative("flux of the square", scene.GetReflectedFlux().x, 1.0, 0.005, "its area");
    data->GetPointData()->SetNormals(normals);
    scene.Render();
    CheckRelative("with its normals", scene.GetReflectedFlux().x, 1.0, 0.005, "its area");
    for (int i = 0; i < 5; ++i)
    {
      normals->SetTuple3(i, 0, -1, 0);
    }
    normals->Modified();
    data->Modified();
    scene.Render();
    CheckEqual("against the winding", scene.GetReflectedFlux().x, 0.0);
    for (int i = 0; i < 5; ++i)
    {
      normals->SetTuple3(i, 0, 0, 0);
    }
    normals->Modified();
    data->Modified();
    scene.Render();
    CheckEqual("zero normals", scene.GetReflectedFlux().x, 0.0);
  }
}

// Without shadows no map is drawn; resources are released and made again.
VTK_INDIRECT_TEST(WalkWithoutMaps)
{
  WalkScene scene;
  scene.AddCorner();
  scene.AddSpot({ 1, 2, 1 }, { 0.4, 0, 0.4 }, 40, 1, { 1, 0, 0 });
  scene.Pass->ShadowsOff();
  scene.UseWalk(1000, 2);
  CheckEqual("faces drawn", scene.ReadReport("faces_drawn"), 0);
  const Image image = scene.Copy("bounce");
  scene.Pass->ReleaseGraphicsResources(scene.Window.Get());
  scene.Render();
  const Image again = scene.Copy("bounce");
  Check("the same after a release", image.Values == again.Values);
  scene.Pass->ShadowsOn();
  scene.Render();
  Check("shadows need them", scene.ReadReport("faces_drawn") > 0);
  CheckRelative("and change nothing", scene.Copy("bounce").Mean(), image.Mean(), 1e-6, "the same");
}

// Bounces two and three, added by hand to samplers of the first one.
VTK_INDIRECT_TEST(WalkAddedSampler)
{
  WalkScene scene;
  scene.AddCorner();
  scene.AddSpot({ 1, 2, 1 }, { 0.4, 0, 0.4 }, 40, 1, { 1, 0, 0 });
  scene.UseWalk(8192, 1);
  const glm::dvec3 first = scene.GetReflectedFlux();
  scene.UseWalk(8192, 3);
  const glm::dvec3 all = scene.GetReflectedFlux();
  vtkNew<vtkRandomWalkLightSampler> later;
  later->SetFirstBounce(2);
  later->SetNumberOfLights(8192);
  scene.Walk->SetNumberOfLights(4096);
  scene.Pass->SetSampler(scene.Sampler);
  scene.Sampler->SetNumberOfLights(4096);
  scene.Pass->AddSampler(later);
  scene.Render();
  const glm::dvec3 added = scene.GetReflectedFlux();
  CheckRelative("flux", added.x - first.x, all.x - first.x, 0.02, "8192 vertices, even lights");
  scene.Pass->RemoveSampler(later);
}

// A walk that continues while nothing changes ends as one with the full length at once.
VTK_INDIRECT_TEST(WalkExtendsOverFrames)
{
  WalkScene scene;
  scene.AddCorner();
  vtkLight* light = scene.AddSpot({ 1, 2, 1 }, { 0.4, 0, 0.4 }, 40, 1, { 1, 0, 0 });
  scene.Pass->SetVisibilityToNone();
  scene.UseWalk(16384, 3);
  const Image truth = scene.Copy("bounce");
  scene.UseWalk(2048, 3);
  const Image atOnce = scene.Copy("bounce");
  scene.UseWalk(128, 3);
  auto differ = [](const Image& a, const Image& b)
  {
    double sum = 0.0;
    for (size_t i = 0; i < a.Values.size(); ++i)
    {
      sum += std::pow(a.Values[i] - b.Values[i], 2);
    }
    return std::sqrt(sum / static_cast<double>(a.Values.size())) / b.Mean();
  };
  const double first = differ(scene.Copy("bounce"), truth);
  scene.Walk->SetNumberOfFrames(16);
  const double walks = scene.ReadReport("walks");
  for (int frame = 0; frame < 20; ++frame)
  {
    scene.Render();
  }
  CheckEqual("walks in the frames after the first", scene.ReadReport("walks") - walks, 15);
  const Image extended = scene.Copy("bounce");
  CheckAtMost("RMSE after 16 frames over that of the first", differ(extended, truth) / first, 0.5,
    "measured 0.33: sixteen times the lights, with areas to match");
  CheckAtMost("RMSE to as many paths at once", differ(extended, atOnce), 1e-6,
    "the same sequence, but for rounding of the number of paths");

  // Frames of interaction keep the existing lights; a moved light begins anew.
  scene.Window->SetDesiredUpdateRate(30.0);
  scene.Render();
  CheckAtLeast("lights in a frame of interaction", scene.ReadReport("virtual_lights"), 1024,
    "half of 2048: those of before are kept");
  light->SetPosition(1.0, 2.1, 1.0);
  scene.Render();
  scene.Render();
  CheckAtMost("lights when one has moved", scene.ReadReport("virtual_lights"), 256,
    "twice 128: the number is met about");
  scene.Window->SetDesiredUpdateRate(0.0001);
  scene.Render();
  CheckAtLeast(
    "lights when all stands again", scene.ReadReport("virtual_lights"), 192, "twice as many paths");
}
