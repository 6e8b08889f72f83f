// SPDX-License-Identifier: BSD-3-Clause
// Depth maps of virtual lights and of the sky at their limits: any size, lights inside of things,
// sheets, no casters, no props, half a sky, and many props.
#include "vtkIndirectHardCase.h"

#include "Emitters/vtkIndirectDirections.h"
#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkCubeSource.h"
#include "vtkEnvironmentLight.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"
#include "vtkRenderWindow.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace vtkIndirectTest;

namespace
{
using Polygon = std::vector<glm::dvec3>;

// 64 virtual lights of each kind and the sky, all of them with maps.
struct MapScene : HardCase
{
  vtkNew<vtkEnvironmentLight> Sky;

  explicit MapScene(const std::string& name, bool underSky = true)
    : HardCase(name, 48, 36)
  {
    this->Gather->SetModeToVirtualLights();
    this->Gather->InterpolationOff();
    this->Sampler->SetNumberOfLights(64);
    this->Pass->SetVisibilityToMaps();
    if (underSky)
    {
      this->Pass->SetEnvironment(this->Sky);
    }
  }

  /** Sets a sky of an image: a value for each row and column. */
  void SetImage(int columns, int rows, const std::function<float(int, int)>& value)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(columns, rows, 1);
    image->AllocateScalars(VTK_FLOAT, 3);
    auto* p = static_cast<float*>(image->GetScalarPointer());
    for (int j = 0; j < rows; ++j)
    {
      for (int i = 0; i < columns; ++i, p += 3)
      {
        std::fill(p, p + 3, value(i, j));
      }
    }
    this->Sky->SetImage(image);
  }

  bool ReportSays(const std::string& text)
  {
    return this->Pass->GetReport().find(text) != std::string::npos;
  }
};

bool Any(const Scene::Receiver&)
{
  return true;
}

double One(const Scene::Receiver&)
{
  return 1.0;
}

// Share of the pixels that are not bitwise equal.
double CountDifferent(const Image& image, const Image& expected)
{
  return GetShareOfDifferent(image, expected, 0.0);
}

void KeepFromCasting(Scene& scene)
{
  vtkPropCollection* props = scene.Renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    vtkNew<vtkInformation> keys;
    keys->Set(vtkIndirectIlluminationPass::CASTS_SHADOWS(), 0);
    vtkProp::SafeDownCast(props->GetItemAsObject(i))->SetPropertyKeys(keys);
  }
}
}

VTK_INDIRECT_TEST(MapsScale)
{
  for (const bool directional : { false, true })
  {
    Image expected[2];
    // No number here is round: see HardCases.Scale.
    for (const double scale : { 1.0, 1e-9, 1e-4, 1e6 })
    {
      MapScene scene("maps");
      auto at = [&](double x, double y, double z) { return scale * glm::dvec3(x, y, z); };
      scene.AddQuad(at(0, 0, 0), at(0, 0, 1.013), at(1.037, 0, 0), Albedo);
      scene.AddQuad(at(0, 0, 0), at(0, 0.981, 0), at(0, 0, 1.013), Albedo);
      scene.AddSphere(at(0.6123, 0.2571, 0.5317), 0.2013 * scale, 48, Albedo);
      if (directional)
      {
        scene.AddDirectional({ -0.4173, -0.7331, -0.5719 });
      }
      else
      {
        scene.AddPoint(at(0.7171, 0.8317, 0.8071), { 0.5, 0.3 / scale, 0.7 / (scale * scale) });
      }
      scene.SetEye(
        at(2.213, 1.617, 2.331), at(0.417, 0.313, 0.433), { 0, 1, 0 }, 32, scale, 6 * scale);
      scene.Render();
      scene.CheckBuffers(1);
      const Image images[2] = { scene.Copy("sky"), scene.Copy("bounce") };
      for (int i = 0; i < 2; ++i)
      {
        if (scale == 1.0)
        {
          expected[i] = images[i];
          Check("there is light", images[i].Mean() > 0.01);
          continue;
        }
        const std::string name =
          std::string(i == 0 ? "sky" : "bounce") + " at scale " + std::to_string(std::log10(scale));
        CheckAtMost(name + ": share of pixels that are otherwise",
          GetShareOfDifferent(images[i], expected[i], 0.02), 0.02,
          "single texels of maps go either way by rounding");
        CheckRelative(name + ": mean", images[i].Mean(), expected[i].Mean(), 1e-3, "the same");
      }
    }
  }
}

// A closed box hides a light in it, except for light that its senders send along their horizons.
// The outside of the box sees the whole sky.
VTK_INDIRECT_TEST(MapsOfALightInside)
{
  Image images[3]; // light, sky, both
  for (int which = 0; which < 3; ++which)
  {
    MapScene scene("a light in a box", which > 0);
    scene.AddBox({ 0, 0, 0 }, { 1, 1, 1 }, Albedo);
    scene.AddQuad({ -2, -0.5, 3 }, { 3, -0.5, 3 }, { -2, -0.5, -2 }, Albedo);
    scene.SetEye({ 2.2, 4.6, 2.3 }, { 0.5, 0.0, 0.5 }, { 0, 1, 0 }, 40, 0.5, 9);
    if (which != 1)
    {
      scene.AddPoint({ 0.4, 0.55, 0.6 }, { 1, 0, 0 });
    }
    scene.Render();
    scene.CheckBuffers(which != 1 ? 1 : 0);
    images[which] = scene.Copy("irradiance");
    if (which == 0)
    {
      scene.Pass->SetVisibilityToNone();
      scene.Render();
      const Image open = scene.Copy("irradiance");
      CheckAtLeast("light where nothing hides it", open.Mean(), 0.01, "the test's own power");
      CheckAtMost("share of it that gets out", images[0].Mean() / open.Mean(), 0.02,
        "texels beside the box's edges");
      continue;
    }
    CompareLight(
      scene, "sky",
      [](const Scene::Receiver& r) { return r.Position.y > 0.99 && r.Normal.y > 0.99; }, One,
      { 0.002, 0.002, "the open sky's table" }, "the box's lid");
  }
  Image sum = images[0];
  for (size_t i = 0; i < sum.Values.size(); ++i)
  {
    sum.Values[i] += images[1].Values[i];
  }
  CheckAtMost("share of pixels in which light and sky do not add up",
    GetShareOfDifferent(images[2], sum, 1e-3), 0.0, "half floats, in another unit");
}

// A sheet occludes the sky and senders from both of its sides, independent of its winding.
VTK_INDIRECT_TEST(MapsOfASheet)
{
  const Polygon sheet = { { -0.5, 0.4, -0.5 }, { 0.5, 0.4, -0.5 }, { 0.5, 0.4, 0.5 },
    { -0.5, 0.4, 0.5 } };
  Image images[2][2];
  for (const bool turned : { false, true })
  {
    for (const bool lit : { false, true })
    {
      MapScene scene("a sheet", !lit);
      scene.AddQuad({ -2, 0, 2 }, { 2, 0, 2 }, { -2, 0, -2 }, Albedo);
      scene.AddQuad(sheet[0], sheet[turned ? 1 : 3], sheet[turned ? 3 : 1], Albedo);
      // The eye sees the floor under the sheet and around it.
      scene.SetEye({ -2.4, 0.35, 0.3 }, { 0, 0.05, 0 }, { 0, 1, 0 }, 26, 0.5, 8);
      if (lit)
      {
        // The floor sends light to a wall and to the sheet.
        scene.AddQuad({ 2, 0, 2 }, { 2, 2, 2 }, { 2, 0, -2 }, Albedo);
        scene.AddDirectional({ 1, -1, -0.3 });
      }
      else
      {
        CompareLight(
          scene, "sky",
          [](const Scene::Receiver& r) { return r.Normal.y > 0.99 && r.Position.y < 0.1; },
          [&](const Scene::Receiver& r) {
            return 1.0 - std::abs(PolygonFormFactor(r.Position, { 0, 1, 0 }, sheet));
          },
          { 0.02, 0.05, "256 directions, each hard" }, "the floor about the sheet");
      }
      scene.Render();
      scene.CheckBuffers(lit ? 1 : 0);
      images[turned][lit] = scene.Copy("irradiance");
    }
  }
  for (const bool lit : { false, true })
  {
    Check("there is light", images[0][lit].Mean() > 0.01);
    CheckAtMost(lit ? "share of pixels that the winding changes, by a light"
                    : "share of pixels that the winding changes, by the sky",
      GetShareOfDifferent(images[1][lit], images[0][lit], 1e-4), 0.0, "rounding of floats");
  }
}

// Without casters all receivers see the open sky, and no surface reflects it.
VTK_INDIRECT_TEST(MapsOfNoCasters)
{
  for (const bool lit : { false, true })
  {
    MapScene scene("no casters");
    scene.AddQuad({ -1, 0, 1 }, { 1, 0, 1 }, { -1, 0, -1 }, Albedo);
    scene.AddSphere({ 0, 0.5, 0 }, 0.45, 64, Albedo);
    scene.SetEye({ 2, 1.5, 2 }, { 0, 0.2, 0 }, { 0, 1, 0 }, 32, 0.5, 6);
    KeepFromCasting(scene);
    if (lit)
    {
      scene.AddPoint({ 1, 2, 1 }, { 1, 0, 0 });
    }
    CompareLight(scene, "sky", Any, One, { 0.002, 0.002, "the open sky's table" },
      lit ? "beside a light" : "sky alone");
    scene.CheckBuffers(0);
    CheckEqual("maps", scene.ReadReport("tiles_drawn"), 0.0);
    const Image direct = scene.Copy("direct");
    Check("a light shines on them", (GetLargest(direct) > 0.1) == lit);
    CheckEqual("nothing else is reflected",
      GetShareOfDifferent(scene.Copy("irradiance"), scene.Copy("sky"), 1e-6), 0.0);
    // A caster makes a shadow.
    scene.AddQuad({ -3, 1.2, 3 }, { 3, 1.2, 3 }, { -3, 1.2, -3 }, Albedo);
    scene.SetEye({ 2, 0.9, 2 }, { 0, 0.2, 0 }, { 0, 1, 0 }, 32, 0.5, 6);
    scene.Render();
    CheckAtMost("under a lid", scene.Copy("sky").Mean(), 0.5, "it hides most of the sky");
  }
}

// Translucent props cast no shadow; if all are translucent, the delegate draws; an empty scene is
// valid.
VTK_INDIRECT_TEST(MapsOfTranslucentThings)
{
  MapScene scene("translucent things");
  scene.AddCorner(Albedo);
  scene.AddPoint({ 0.6, 0.7, 0.5 }, { 1, 0, 0 });
  scene.Render();
  const Image sky = scene.Copy("sky");
  const Image irradiance = scene.Copy("irradiance");
  vtkActor* glass = scene.AddQuad({ 0, 0.5, 0 }, { 0, 0.5, 0.8 }, { 0.8, 0.5, 0 }, Albedo);
  glass->GetProperty()->SetOpacity(0.5);
  scene.Render();
  CheckEqual("pixels of the sky that glass changes", CountDifferent(scene.Copy("sky"), sky), 0.0);
  CheckEqual("pixels of the rest", CountDifferent(scene.Copy("irradiance"), irradiance), 0.0);
  glass->GetProperty()->SetOpacity(1.0);
  scene.Render();
  Check("a pane that is opaque does", CountDifferent(scene.Copy("sky"), sky) > 0.1);
}

VTK_INDIRECT_TEST(MapsOfNothing)
{
  MapScene scene("a sky alone");
  scene.Sky->SetRadiance(2.0, 1.0, 0.5);
  scene.SetEye({ 0, 3, 0.01 }, { 0, 0, 0 }, { 0, 0, -1 }, 36, 0.1, 10);
  for (int i = 0; i < 2; ++i)
  {
    scene.Render();
    Check("the delegate alone draws", scene.ReportSays("nothing opaque is visible"));
    vtkActor* floor = scene.AddQuad({ -1, 0, 1 }, { 1, 0, 1 }, { -1, 0, -1 }, Albedo);
    auto two = [](const Scene::Receiver&) { return 2.0; };
    CompareLight(scene, "sky", Any, two, { 0.002, 0.002, "the open sky's table" }, "a floor");
    CheckEqual("its bounce", GetLargest(scene.Copy("bounce")), 0.0);
    floor->GetProperty()->SetOpacity(0.5);
    scene.Render();
    Check("and where all is translucent", scene.ReportSays("nothing opaque is visible"));
    scene.Renderer->RemoveViewProp(floor);
  }
}

// A sky that shines only from above or from below the horizon. Half a sky gives a ball (1 +- y) / 2
// by the normal's height y; surfaces that face the other half get nothing.
VTK_INDIRECT_TEST(MapsOfHalfASky)
{
  for (const bool above : { false, true })
  {
    const double sign = above ? 1.0 : -1.0;
    auto value = [above](int, int row) { return (row >= 32) == above ? 1.0f : 0.0f; };
    const std::string name = above ? "from above" : "from below";
    for (const bool moving : { false, true })
    {
      MapScene scene("a ball");
      scene.SetImage(128, 64, value);
      scene.AddSphere({ 0, 0, 0 }, 1.0, 96, Albedo);
      scene.SetEye({ 0, 0, 6 }, { 0, 0, 0 }, { 0, 1, 0 }, 22, 0.1, 10);
      scene.Window->SetDesiredUpdateRate(moving ? 15.0 : 0.0001);
      CompareLight(
        scene, "sky", Any,
        [&](const Scene::Receiver& r) { return 0.5 * (1.0 + sign * r.Normal.y); },
        { 0.005, 0.015, "rows of 2.8 degrees; facets of 3.8 degrees hide grazing directions" },
        name + (moving ? ", moving" : ""));
    }
    // A table seen from its lit side, with a sheet in front of it.
    MapScene scene("a table");
    scene.SetImage(128, 64, value);
    const double y = 0.5 * sign;
    const Polygon sheet = { { -0.4, y, -0.4 }, { 0.4, y, -0.4 }, { 0.4, y, 0.4 },
      { -0.4, y, 0.4 } };
    scene.AddQuad({ -1, 0, 1 }, { 1, 0, 1 }, { -1, 0, -1 }, Albedo);
    scene.AddQuad(sheet[0], sheet[3], sheet[1], Albedo);
    scene.SetEye({ 1.9, 2.2 * sign, 1.9 }, { 0, 0, 0 }, { 0, 1, 0 }, 40, 0.5, 9);
    CompareLight(
      scene, "sky", [&](const Scene::Receiver& r) { return std::abs(r.Position.y) < 0.1; },
      [&](const Scene::Receiver& r) {
        return 1.0 - std::abs(PolygonFormFactor(r.Position, { 0, sign, 0 }, sheet));
      },
      { 0.01, 0.04, "256 directions, each hard" }, name + ": a table");
    scene.SetEye({ 1.9, -2.2 * sign, 1.9 }, { 0, 0, 0 }, { 0, 1, 0 }, 40, 0.5, 9);
    scene.Render();
    Check("its other side is seen", GetLargest(scene.Copy("albedo")) > 0.5);
    CheckAtMost(name + ": its other side", GetLargest(scene.Copy("sky")), 1e-7,
      "0 on llvmpipe; a step of a float on a GPU");
  }
}

// A black image is no light, and changes no light.
VTK_INDIRECT_TEST(MapsOfABlackSky)
{
  MapScene scene("a black image", false);
  scene.AddCorner(Albedo);
  scene.AddPoint({ 0.6, 0.7, 0.5 }, { 1, 0, 0 });
  scene.Render();
  const Image irradiance = scene.Copy("irradiance");
  Check("there is light", irradiance.Mean() > 0.01);
  scene.SetImage(64, 32, [](int, int) { return 0.0f; });
  scene.Pass->SetEnvironment(scene.Sky);
  scene.Render();
  scene.CheckBuffers(1);
  CheckEqual("largest of the sky", GetLargest(scene.Copy("sky")), 0.0);
  CheckEqual("pixels that it changes", CountDifferent(scene.Copy("irradiance"), irradiance), 0.0);
  CheckEqual("its maps", scene.ReadReport("sky_tiles_drawn"), 0.0);
}

// One bright texel acts as a directional light: the same irradiance, the same shadow.
VTK_INDIRECT_TEST(MapsOfOneBrightTexel)
{
  constexpr int columns = 512;
  constexpr int rows = 256;
  const double pi = vtkMath::Pi();
  // A direction with a map of the sky, so that the texel is not moved to another.
  const glm::dvec3 from = vtkIndirectDirections::MakeLattice(256)[60];
  const int column = static_cast<int>((0.5 * std::atan2(from.x, -from.z) / pi + 0.5) * columns);
  const int row = static_cast<int>((std::asin(from.y) / pi + 0.5) * rows);
  constexpr double radiance = 1e5;
  const double latitude = pi * ((row + 0.5) / rows - 0.5);
  const double solidAngle =
    2.0 * pi / columns * 2.0 * std::sin(0.5 * pi / rows) * std::cos(latitude);
  // Irradiance in VTK's units is physical irradiance over pi.
  const double facing = radiance * solidAngle / pi;

  MapScene scene("one bright texel");
  scene.SetImage(columns, rows,
    [&](int i, int j) { return i == column && j == row ? static_cast<float>(radiance) : 0.0f; });
  scene.AddQuad({ -2, 0, 2 }, { 2, 0, 2 }, { -2, 0, -2 }, Albedo);
  scene.AddQuad({ -0.5, 0.6, -0.5 }, { -0.5, 0.6, 0.5 }, { 0.5, 0.6, -0.5 }, Albedo);
  scene.SetEye({ 0, 7, 0.01 }, { 0, 0, 0 }, { 0, 0, -1 }, 34, 0.5, 12);
  // Intersection of the light's ray from a position on the floor with the sheet's plane, and its
  // distance from the sheet's edge: negative inside.
  auto beyondEdge = [&](const glm::dvec3& p)
  {
    const glm::dvec3 q = p + from * (0.6 / from.y);
    return std::max(std::abs(q.x), std::abs(q.z)) - 0.5;
  };
  constexpr double margin = 0.03; // texels of 0.005 and a pixel of the sky, 0.35 degrees
  CompareLight(
    scene, "sky",
    [&](const Scene::Receiver& r)
    { return std::abs(r.Position.y) < 0.1 && std::abs(beyondEdge(r.Position)) > margin; },
    [&](const Scene::Receiver& r) { return beyondEdge(r.Position) < 0.0 ? 0.0 : facing * from.y; },
    { 0.01, 0.01, "a pixel of the sky is 0.7 degrees wide" }, "floor and shadow");
  const Image sky = scene.Copy("sky");
  int dark = 0;
  for (size_t i = 0; i < sky.Values.size(); i += 3)
  {
    dark += sky.Values[i] == 0.0f;
  }
  CheckAtLeast("pixels in the shadow", dark, 30, "the test's own power");
}

namespace
{
// Many props give the same picture as one prop with all of their triangles. Most of them are
// smaller than the texels of maps.
void CheckManyProps(int edge)
{
  Image images[2][3];
  for (const bool merged : { false, true })
  {
    MapScene scene("many props");
    vtkNew<vtkAppendPolyData> all;
    vtkNew<vtkCubeSource> cube;
    cube->Update();
    for (int i = 0; i < edge * edge; ++i)
    {
      // Heights and sizes without a pattern, by the golden ratio.
      const double height = std::fmod(i * 0.6180339887, 1.0);
      const double size = 0.4 + 0.5 * std::fmod(i * 0.7548776662, 1.0);
      vtkNew<vtkTransform> place;
      place->Translate(i % edge * 100.0 / edge, 6.0 * height, i / edge * 100.0 / edge);
      place->Scale(size, size, size);
      vtkNew<vtkTransformPolyDataFilter> moved;
      moved->SetInputConnection(cube->GetOutputPort());
      moved->SetTransform(place);
      moved->Update();
      if (merged)
      {
        all->AddInputData(moved->GetOutput());
        continue;
      }
      scene.AddSource(moved, Albedo);
    }
    if (merged)
    {
      scene.AddSource(all, Albedo);
    }
    scene.AddQuad({ -5, -1, 105 }, { 105, -1, 105 }, { -5, -1, -5 }, Albedo);
    // Maps are fitted to bounds: two specks give both scenes the same.
    scene.AddTriangles({ { -5, -1, -5 }, { -4.99, -1, -5 }, { -5, -0.99, -5 }, { 105, 8, 105 },
                         { 104.99, 8, 105 }, { 105, 7.99, 105 } },
      {}, { 0, 1, 2, 3, 4, 5 }, Albedo);
    scene.AddDirectional({ -0.4173, -0.7331, -0.5719 });
    scene.SetEye({ 50, 60, 130 }, { 50, 0, 50 }, { 0, 1, 0 }, 50, 5, 300);
    // With so many props a frame draws only part of the maps.
    double drawn = 0.0;
    double before = -1.0;
    for (int frame = 0; frame < 20 && drawn > before; ++frame)
    {
      scene.Render();
      before = drawn;
      drawn = scene.ReadReport("tiles_drawn");
    }
    CheckEqual("maps that are missing", drawn - before, 0.0);
    scene.CheckBuffers(1);
    const char* const names[] = { "sky", "bounce", "direct" };
    for (int i = 0; i < 3; ++i)
    {
      images[merged][i] = scene.Copy(names[i]);
      Check("there is light", images[merged][i].Mean() > 1e-3);
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    // A texel of the sky's maps of senders that goes the other way moves a virtual light: found
    // 0.0029 of the pixels, and 0.0005 of the mean.
    const bool bounce = i == 1;
    CheckAtMost("share of pixels that are otherwise",
      GetShareOfDifferent(images[0][i], images[1][i], bounce ? 1e-2 : 1e-3), bounce ? 4e-3 : 2e-3,
      "single texels of outlines go either way by rounding");
    CheckRelative("means", images[0][i].Mean(), images[1][i].Mean(), 1e-3, "the same");
  }
}
}

VTK_INDIRECT_TEST(MapsOfManyProps)
{
  CheckManyProps(16);
}

VTK_INDIRECT_TEST(MapsOfTenThousandProps)
{
  CheckManyProps(100);
}
