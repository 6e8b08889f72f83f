// SPDX-License-Identifier: BSD-3-Clause
// Depth maps of virtual lights and of directions: their shadows, and their redrawing.
#include "vtkIndirectDetails.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkEnvironmentLight.h"
#include "vtkLightTreeSampler.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRSMReferencePass.h"
#include "vtkRenderWindow.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace vtkIndirectTest;

namespace
{
const glm::dvec3 White(0.8);

// A box open towards the eye, with a sheet that blocks light to its right half.
void BuildRooms(Scene& scene)
{
  scene.AddQuad({ 0, 0, 1 }, { 2, 0, 1 }, { 0, 0, 0 }, White);
  scene.AddQuad({ 0, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, White);
  scene.AddQuad({ 0, 0, 1 }, { 0, 0, 0 }, { 0, 1, 1 }, { 0.8, 0.3, 0.2 });
  scene.AddQuad({ 2, 0, 0 }, { 2, 0, 1 }, { 2, 1, 0 }, White);
  scene.AddQuad({ 0, 1, 0 }, { 2, 1, 0 }, { 0, 1, 1 }, White);
  scene.AddQuad({ 1, 0, 0 }, { 1, 0, 0.8 }, { 1, 1, 0 }, White);
  scene.AddSpot({ 0.9, 0.8, 0.9 }, { 0.1, 0.2, 0.2 }, 25.0, 0.0, { 0, 0, 1 });
  scene.Sampler->SetNumberOfLights(256);
  scene.SetEye({ 1, 0.5, 3.5 }, { 1, 0.5, 0 }, { 0, 1, 0 }, 24, 0.1, 10);
}

// Irradiance of a scene's virtual lights without occlusion, with occlusion by triangles, and with
// the gather's look-ups in maps; and the receivers' normals.
struct Irradiances
{
  Image Open;
  Image Exact;
  Image Gathered;
  Image Normal;
};

Irradiances FindIrradiances(Scene& scene)
{
  Irradiances found;
  vtkNew<vtkRSMReferencePass> reference;
  reference->SetModeToVirtualLights();
  scene.Pass->SetEstimator(reference);
  scene.Render();
  found.Open = scene.Copy("irradiance");
  reference->SetVisibilityToExact();
  scene.Render();
  found.Exact = scene.Copy("irradiance");
  found.Normal = scene.Copy("normal");
  scene.Gather->SetModeToVirtualLights();
  scene.Gather->InterpolationOff();
  scene.Pass->SetEstimator(scene.Gather);
  scene.Pass->SetVisibilityToMaps();
  scene.Render();
  found.Gathered = scene.Copy("irradiance");
  return found;
}
}

VTK_INDIRECT_TEST(DepthMapsHideAsTrianglesDo)
{
  Scene scene(64, 48);
  BuildRooms(scene);
  const auto [open, exact, gathered, normal] = FindIrradiances(scene);
  const double without = FindRelativeError(open, exact, normal);
  // Texels of 128 about a sender are 2.7 degrees wide ahead of it.
  CheckAtMost("RMS error of maps over the mean, by that of no visibility",
    FindRelativeError(gathered, exact, normal) / without, 0.15, "one tap a light, 128 texels");
  CheckRelative("mean with maps", gathered.Mean(), exact.Mean(), 0.05, "one tap a light");
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  splatting->SetPlaneThreshold(0.0);
  splatting->SetNormalThreshold(0.0);
  scene.Pass->SetEstimator(splatting);
  scene.Render();
  CheckAtMost("subsplats of one pixel see the same lights",
    FindRelativeError(scene.Copy("irradiance"), gathered, normal), 2e-3, "half floats");
  scene.Pass->SetVisibilityToNone();
  scene.Render();
  CheckAtMost("and without maps what the open sum says",
    FindRelativeError(scene.Copy("irradiance"), open, normal), 2e-3, "half floats");
}

// A sheet hangs under a lit ceiling, near the edge of the ceiling. A few clusters stand for the
// ceiling, with places behind the sheet; nothing hides the ceiling's edge from the sheet's front.
VTK_INDIRECT_TEST(DepthMapsOfClustersThroughASheet)
{
  Scene scene(48, 32);
  const glm::dvec3 black(0.0);
  scene.AddQuad({ 0, 1, 0 }, { 2, 1, 0 }, { 0, 1, 1 }, glm::dvec3(0.8));
  scene.AddQuad({ 0, 0.5, 0.9 }, { 2, 0.5, 0.9 }, { 0, 0.98, 0.9 }, black);
  scene.AddSpot({ 1, -4, 0.5 }, { 1, 1, 0.5 }, 20.0, 0.0, { 1, 0, 0 });
  scene.SetEye({ 1, 0.75, 3.0 }, { 1, 0.75, 0.9 }, { 0, 1, 0 }, 12, 0.1, 10);
  scene.Pass->ShadowsOff();
  vtkNew<vtkLightTreeSampler> tree;
  tree->SetNumberOfLights(16);
  scene.Pass->SetSampler(tree);
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  for (vtkIndirectEstimatorPass* estimator : { static_cast<vtkIndirectEstimatorPass*>(scene.Gather),
         static_cast<vtkIndirectEstimatorPass*>(splatting) })
  {
    scene.Gather->SetModeToVirtualLights();
    scene.Pass->SetEstimator(estimator);
    scene.Pass->SetVisibilityToNone();
    scene.Render();
    const double open = scene.Copy("irradiance").Mean();
    scene.Pass->SetVisibilityToMaps();
    scene.Render();
    Check("the sheet's front is lit", open > 0.0);
    CheckRelative(std::string("light on the front: ") + estimator->GetClassName(),
      scene.Copy("irradiance").Mean(), open, 0.02, "nothing is hidden from it");
  }
  scene.Pass->SetEstimator(nullptr);
  scene.Pass->SetSampler(nullptr);
}

// A square sender half hidden by a straight edge: the form factor of its visible part.
VTK_INDIRECT_TEST(DepthMapsMakePenumbrae)
{
  Scene scene(48, 36);
  const double half = 0.2;
  const glm::dvec3 black(0.0);
  scene.AddQuad({ -half, -half, 0 }, { half, -half, 0 }, { -half, half, 0 }, glm::dvec3(0.8));
  scene.AddQuad({ -1.0, -0.5, 0.5 }, { 0, -0.5, 0.5 }, { -1.0, 0.5, 0.5 }, black);
  scene.AddQuad({ -0.5, -0.5, 1 }, { -0.5, 0.5, 1 }, { 0.5, -0.5, 1 }, glm::dvec3(0.5));
  // Far below the edge, so that the light is even on the sender and reaches no other sender.
  const glm::dvec3 way = glm::normalize(glm::dvec3(0.0, -5.0, 2.0));
  scene.AddSpot(40.0 * way, { 0, 0, 0 }, 0.42, 0.0, { 1, 0, 0 });
  scene.SetEye({ 0, 0, 0.55 }, { 0, 0, 1 }, { 0, 1, 0 }, 80, 0.01, 4);
  scene.Pass->SetReflectiveShadowMapResolution(256);
  scene.Pass->ShadowsOff();
  scene.Sampler->SetNumberOfLights(1024);
  scene.Gather->SetModeToVirtualLights();
  scene.Pass->SetVisibilityToMaps();
  scene.Render();
  const Image irradiance = scene.Copy("irradiance");
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
  const double radiosity = 0.8 * way.z;
  double measured = 0.0;
  double expected = 0.0;
  double shift = 0.0; // shift of the penumbra, from the light to the left and to the right
  double whole = 0.0;
  for (size_t i = 0; i < receivers.size(); ++i)
  {
    const glm::dvec3 p = receivers[i].Position;
    if (!receivers[i].Lit || p.z < 0.99)
    {
      continue;
    }
    const double left = std::max(-half, -p.x);
    const double e = left < half ? radiosity *
        PolygonFormFactor(p, { 0, 0, -1 },
          { { left, -half, 0 }, { half, -half, 0 }, { half, half, 0 }, { left, half, 0 } })
                                 : 0.0;
    const double open = radiosity *
      PolygonFormFactor(p, { 0, 0, -1 },
        { { -half, -half, 0 }, { half, -half, 0 }, { half, half, 0 }, { -half, half, 0 } });
    measured += irradiance.Values[3 * i];
    expected += e;
    // Place of the mean step from zero to full light.
    shift += std::abs(p.x) < half ? irradiance.Values[3 * i] / open - e / open : 0.0;
    whole += std::abs(p.x) < half ? 1.0 : 0.0;
  }
  CheckAtLeast("receivers in the penumbra", whole, 100.0, "the test's own power");
  CheckRelative("light under the edge", measured, expected, 0.02,
    "1024 lights, of which a quarter falls on the sender; a texel of a tile is 0.012 across");
  CheckAbsolute("where the penumbra lies, over its width", shift / whole, 0.0, 0.02, "as before");
}

// A lit patch on a ground, a wall that sees it at more than 72 degrees from its normal, and between
// them a sheet that hides it from parts of the wall.
VTK_INDIRECT_TEST(DepthMapsReachTheHorizon)
{
  Scene scene(64, 48);
  scene.AddQuad({ -0.4, -0.4, 0 }, { 0.4, -0.4, 0 }, { -0.4, 0.4, 0 }, White);
  scene.AddQuad({ 1.4, -0.6, -0.05 }, { 1.4, 0.6, -0.05 }, { 1.4, -0.6, 0.4 }, White);
  scene.AddQuad({ 0.8, -0.25, 0.03 }, { 0.8, 0.15, 0.03 }, { 0.8, -0.25, 0.12 }, White);
  scene.AddSpot({ 0, 0, 3 }, { 0, 0, 0 }, 4.0, 0.0, { 1, 1, 0 });
  scene.Sampler->SetNumberOfLights(256);
  scene.SetEye({ 0.9, 0, 0.18 }, { 1.4, 0, 0.18 }, { 0, 0, 1 }, 50, 0.01, 10);
  const auto [open, exact, gathered, normal] = FindIrradiances(scene);
  const double without = FindRelativeError(open, exact, normal);
  CheckAtLeast("RMS error of no visibility over the mean", without, 0.2, "the test's own power");
  CheckAtMost("that of maps over it", FindRelativeError(gathered, exact, normal) / without, 0.15,
    "one tap a light, texels of 1.2 degrees");
  CheckRelative("mean with maps", gathered.Mean(), exact.Mean(), 0.02, "to either side");
}

// A ball on a lit ground: every part of the ground above a point's horizon is visible, at grazing
// angles too, as for a wall that leans over the ground down to its foot.
VTK_INDIRECT_TEST(DepthMapsUnderABall)
{
  for (const int rows : { 20, 100 })
  {
    Scene scene(96, 72);
    scene.AddQuad({ -2, -2, 0 }, { 2, -2, 0 }, { -2, 2, 0 }, White);
    scene.AddSphere({ 0, 0, 0.5 }, 0.5, rows, White);
    scene.AddDirectional({ 0.3, 0.2, -1 });
    scene.SetEye({ 0, -3, 0.35 }, { 0, 0, 0.35 }, { 0, 0, 1 }, 18, 0.1, 10);
    vtkNew<vtkLightTreeSampler> tree;
    scene.Pass->SetSampler(tree);
    scene.Gather->SetModeToVirtualLights();
    scene.Gather->InterpolationOff();
    scene.Render();
    const Image open = scene.Copy("irradiance");
    scene.Pass->SetVisibilityToMaps();
    scene.Render();
    const Image seen = scene.Copy("irradiance");
    const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
    double squares = 0.0;
    double dark = 0.0;
    double pixels = 0.0;
    for (size_t i = 0; i < receivers.size(); ++i)
    {
      const double height = receivers[i].Position.z;
      if (receivers[i].Lit && height > 0.01 && height < 0.5)
      {
        const double hidden = 1.0 - seen.Values[3 * i] / open.Values[3 * i];
        squares += hidden * hidden;
        dark += hidden > 0.1 ? 1.0 : 0.0;
        pixels += 1.0;
      }
    }
    const std::string of = " of a ball of " + std::to_string(rows) + " rows";
    CheckAtLeast("pixels" + of, pixels, 2000.0, "the test's own power");
    CheckAtMost("what is hidden, RMS," + of, std::sqrt(squares / pixels), 0.04,
      "measured 0.027 of 20 rows, whose facets hide each other's edges, and 0.008");
    CheckAtMost("share of pixels that lose a tenth" + of, dark / pixels, 0.02, "0.011 and 0");
  }
}

// A frame without time for all maps shares the finished ones; the final result does not show this.
VTK_INDIRECT_TEST(DepthMapsArriveOverFrames)
{
  Scene scene(64, 48);
  BuildRooms(scene);
  // So many triangles that a moving frame has time for eight maps.
  scene.AddSphere({ 0.4, 0.2, 0.4 }, 0.1, 291, White);
  scene.Gather->SetModeToVirtualLights();
  scene.Gather->InterpolationOff();
  scene.Render();
  const Image open = scene.Copy("irradiance");
  const Image normal = scene.Copy("normal");
  scene.Pass->SetVisibilityToMaps();
  scene.Render();
  const double all = scene.ReadReport("tiles_drawn");
  const Image whole = scene.Copy("irradiance");
  const double without = FindRelativeError(open, whole, normal);

  scene.Pass->SetVisibilityToNone();
  scene.Render();
  scene.Pass->SetVisibilityToMaps();
  scene.Window->SetDesiredUpdateRate(15.0);
  double drawn = all;
  Image last = open;
  int frames = 0;
  for (; drawn < 2.0 * all && frames < 100; ++frames)
  {
    scene.Render();
    const double now = scene.ReadReport("tiles_drawn");
    CheckAtMost("maps drawn in a frame", now - drawn, 8.0,
      "a sphere of 169,000 triangles, drawn in the time of 80,000");
    CheckAtLeast("and at least", now - drawn, 1.0, "all are asked for");
    drawn = now;
    const Image image = scene.Copy("irradiance");
    const double error = FindRelativeError(image, whole, normal) / without;
    const double step = FindRelativeError(image, last, normal) / without;
    std::printf("       %g maps: error %.3f, step %.3f\n", drawn - all, error, step);
    CheckAtMost("error over that of no visibility", error, frames < 7 ? 1.0 : 0.2,
      "shared maps are never worse; 64 of them leave a tenth");
    CheckAtMost("step from the last frame over that error", step, frames < 7 ? 1.1 : 0.1,
      "an eighth of the lights that have maps changes; the first eight hide more than all do");
    last = image;
  }
  CheckEqual("maps drawn in the end", drawn, 2.0 * all);
  CheckEqual("and then all is as if drawn at once", FindRelativeError(last, whole, normal), 0.0);
  scene.Render();
  CheckEqual("no more are drawn", scene.ReadReport("tiles_drawn"), drawn);
}

// Moving frames look up at two of four neighbouring leaves; a still frame equals one without this.
// The range of depths splits leaves in moving frames as in still frames: no blocks of 4 x 4 pixels.
VTK_INDIRECT_TEST(DepthMapsOfMovingFrames)
{
  Scene scene(128, 96);
  BuildRooms(scene);
  scene.AddSphere({ 0.4, 0.2, 0.4 }, 0.1, 24, White);
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  SET_DETAIL(splatting, DepthRange, true);
  scene.Pass->SetEstimator(splatting);
  scene.Render();
  const Image open = scene.Copy("irradiance");
  const Image normal = scene.Copy("normal");
  scene.Pass->SetVisibilityToMaps();
  scene.Render();
  const Image still = scene.Copy("irradiance");
  const double drawn = scene.ReadReport("tiles_drawn");
  const double without = FindRelativeError(open, still, normal);
  scene.Window->SetDesiredUpdateRate(15.0);
  scene.Render();
  const Image moving = scene.Copy("irradiance");
  CheckEqual("maps that this takes", scene.ReadReport("tiles_drawn"), drawn);
  const double error = FindRelativeError(moving, still, normal) / without;
  CheckAtLeast("change over that by the maps", error, 1e-4, "fewer look-ups");
  CheckAtMost("change over that by the maps", error, 0.1,
    "each light's shadow ends up to a leaf aside, of pixels a 70th of the room; measured 0.07");
  CheckRelative("mean", moving.Mean(), still.Mean(), 0.005, "to either side");
  scene.Window->SetDesiredUpdateRate(1e-4);
  scene.Render();
  CheckEqual("change of the still picture that follows",
    FindRelativeError(scene.Copy("irradiance"), still, normal), 0.0);
}

// More lights than the memory for maps allows: neighbours share maps.
VTK_INDIRECT_TEST(DepthMapsAreBounded)
{
  Scene scene(64, 48);
  BuildRooms(scene);
  scene.Sampler->SetNumberOfLights(4096);
  scene.Gather->SetModeToVirtualLights();
  scene.Gather->InterpolationOff();
  scene.Render();
  const Image open = scene.Copy("irradiance");
  scene.Pass->SetVisibilityToMaps();
  scene.Render();
  CheckAtMost("maps", scene.ReadReport("tiles_drawn"), 1024.0, "80 MB");
  const Image seen = scene.Copy("irradiance");
  vtkNew<vtkRSMReferencePass> reference;
  reference->SetModeToVirtualLights();
  reference->SetVisibilityToExact();
  scene.Pass->SetEstimator(reference);
  scene.Render();
  const Image exact = scene.Copy("irradiance");
  const Image normal = scene.Copy("normal");
  CheckAtMost("RMS error of shared maps over the mean, by that of no visibility",
    FindRelativeError(seen, exact, normal) / FindRelativeError(open, exact, normal), 0.15,
    "that of a map a light, in DepthMapsHideAsTrianglesDo");
}

VTK_INDIRECT_TEST(DepthMapsAreKept)
{
  Scene scene(48, 36);
  BuildRooms(scene);
  vtkActor* ball = scene.AddSphere({ 0.4, 0.2, 0.4 }, 0.1, 24, White);
  vtkNew<vtkEnvironmentLight> sky;
  scene.Pass->SetEnvironment(sky);
  scene.Gather->SetModeToVirtualLights();
  scene.Pass->SetVisibilityToMaps();
  scene.Render();
  const double first = scene.ReadReport("tiles_drawn");
  Check(
    "each light, also of the sky, and each direction has a tile", first > 512.0 && first <= 768.0);
  scene.Renderer->GetActiveCamera()->Azimuth(3.0);
  scene.Render();
  CheckEqual("a turned camera draws none", scene.ReadReport("tiles_drawn"), first);
  sky->SetRadiance(1.0, 0.5, 0.25);
  sky->SetUp(1.0, 1.0, 0.0);
  scene.Render();
  CheckEqual("nor does another sky", scene.ReadReport("tiles_drawn"), first);
  const Image before = scene.Copy("sky");
  ball->SetPosition(0.3, 0.1, 0.1);
  scene.Render();
  const double moved = scene.ReadReport("tiles_drawn") - first;
  Check("a moved ball is drawn again where it can be seen", moved >= 256.0);
  const Image after = scene.Copy("sky");
  scene.Pass->CachingOff();
  scene.Render();
  const Image anew = scene.Copy("sky");
  CheckEqual("with what all tiles drawn anew give", anew.Mean(), after.Mean());
  Check("which is another picture", std::abs(after.Mean() - before.Mean()) > 1e-6);
  scene.CheckBuffers(1);
}

// A ball at the border of the scene, behind a wall, moves in every frame: the maps of the wall's
// lights, which cannot see it, are drawn again only if it enlarges the scene's bounds.
VTK_INDIRECT_TEST(DepthMapsStayWhileTheBorderMoves)
{
  Scene scene(48, 36);
  scene.AddQuad({ 0, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, White);
  scene.AddQuad({ 0, 0, 1 }, { 2, 0, 1 }, { 0, 0, 0 }, White);
  scene.AddQuad({ 1, 0, 0.3 }, { 1, 0, 0.8 }, { 1, 0.4, 0.3 }, White);
  vtkActor* ball = scene.AddSphere({ 0, 0, 0 }, 0.1, 24, White);
  scene.AddSpot({ 0.7, 0.5, 1.0 }, { 0.7, 0.5, 0.0 }, 20.0, 0.0, { 1, 0, 0 });
  scene.Sampler->SetNumberOfLights(64);
  scene.SetEye({ 1, 1.5, 3.5 }, { 1, 0.3, 0 }, { 0, 1, 0 }, 34, 0.1, 10);
  vtkNew<vtkEnvironmentLight> sky;
  scene.Pass->SetEnvironment(sky);
  scene.Gather->SetModeToVirtualLights();
  scene.Pass->SetVisibilityToMaps();
  auto count = [&]()
  { return scene.ReadReport("tiles_drawn") - scene.ReadReport("sky_tiles_drawn"); };
  // The ball also reflects the sky's light, which is off here.
  sky->SetRadiance(0.0, 0.0, 0.0);
  scene.Window->SetDesiredUpdateRate(15.0);
  auto place = [&](double z)
  {
    ball->SetPosition(0.7, 0.5, z);
    const double before = std::max(0.0, count());
    scene.Render();
    return count() - before;
  };
  place(-0.2);
  const double all = count();
  CheckAtLeast("maps", all, 30.0, "lights that send");
  CheckEqual("maps that a first step draws, which makes room", place(-0.21), all);
  for (int i = 0; i < 8; ++i)
  {
    CheckEqual("maps that a further step draws", place(-0.22 - 0.02 * i), 0.0);
  }
  CheckEqual("more room", place(-0.8), all);
  for (int i = 1; i < 8; ++i)
  {
    CheckEqual("a step back", place(-0.8 + 0.03 * i), 0.0);
  }
  const Image kept = scene.Copy("irradiance");
  scene.Pass->CachingOff();
  scene.Render();
  CheckRelative("and the light is that of a scene that has not moved", kept.Mean(),
    scene.Copy("irradiance").Mean(), 0.01, "other biases, which are shares of the scene's size");
  scene.Pass->CachingOn();
  CheckAtLeast("a far place", place(-20.0), all, "scene units change");
  CheckAtLeast("and back: less than half would be filled", place(-0.3), all, "they change again");
}
