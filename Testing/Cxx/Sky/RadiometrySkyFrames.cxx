// SPDX-License-Identifier: BSD-3-Clause
// Depth maps of the sky that arrive over several frames: complete maps represent the whole sky.
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkEnvironmentLight.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkRSMGatherPass.h"
#include "vtkRenderWindow.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace vtkIndirectTest;

namespace
{
const glm::dvec3 WhiteFloor(0.8);

// Update rates at which a frame has time for 8 maps, for 128, for 129 with a still camera, and for
// 769: of 169,000 triangles, which are drawn in the time of 80,000.
constexpr double Moving = 15.0;
constexpr double MovingAtOnce = 1.0;
constexpr double Still = 0.99;
constexpr double StillAtOnce = 1e-4;

struct SkyScene : Scene
{
  vtkActor* Ball;

  SkyScene(vtkEnvironmentLight* sky, bool open)
    : Scene(96, 72)
  {
    this->Ball = this->AddSphere({ 1.2, 0.5, 1.2 }, 0.5, 291, WhiteFloor);
    if (!open)
    {
      this->AddQuad({ -2, 0, 2 }, { 2, 0, 2 }, { -2, 0, -2 }, WhiteFloor);
      this->AddDisk({ 0, 0.6, 0 }, { 0, 1, 0 }, 1.0, 128, WhiteFloor);
    }
    this->SetEye({ 0, 1.5, 6 }, { 0, 0.2, 0 }, { 0, 1, 0 }, 34, 0.1, 20);
    this->Pass->SetVisibilityToAuto();
    this->Pass->SetEnvironment(sky);
  }
  Image RenderAt(double rate)
  {
    this->Window->SetDesiredUpdateRate(rate);
    this->Render();
    return this->Copy("sky");
  }
  double CountTiles() { return this->ReadReport("sky_tiles_drawn"); }
};

// Largest relative difference of the means of the three colours.
double FindShift(const Image& image, const Image& expected)
{
  double most = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    most = std::max(most, std::abs(image.Mean(c) / expected.Mean(c) - 1.0));
  }
  return most;
}

// Blue above, brown below, and a sun.
void MakeSky(vtkEnvironmentLight* sky)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 32, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  auto* p = static_cast<float*>(image->GetScalarPointer());
  for (int j = 0; j < 32; ++j)
  {
    for (int i = 0; i < 64; ++i, p += 3)
    {
      p[0] = j < 16 ? 0.4f : 0.5f;
      p[1] = j < 16 ? 0.3f : 0.8f;
      p[2] = j < 16 ? 0.2f : 1.2f;
    }
  }
  auto* sun = static_cast<float*>(image->GetScalarPointer(6, 26, 0));
  sun[0] = sun[1] = sun[2] = 800.0f;
  sky->SetImage(image);
}

void CheckArrival(bool moving)
{
  vtkNew<vtkEnvironmentLight> sky;
  MakeSky(sky);
  const double rate = moving ? Moving : Still;
  const std::string name = moving ? "moving, " : "still, ";
  SkyScene whole(sky, false);
  const Image expected = whole.RenderAt(moving ? MovingAtOnce : StillAtOnce);
  const double all = whole.CountTiles();
  const double bytes = whole.ReadReport("bytes");
  // A moving frame also draws the sun's map: its direction is none of the 64, and the nearest of
  // them has some light.
  CheckAtLeast(name + "maps at once", all, moving ? 64 : 256, "a direction each");
  const Image normal = whole.Copy("normal");
  whole.Pass->SetVisibilityToNone();
  const double without =
    FindRelativeError(whole.RenderAt(moving ? MovingAtOnce : StillAtOnce), expected, normal);

  SkyScene scene(sky, false);
  Image last;
  double drawn = 0.0;
  for (int frames = 0; drawn < all && frames < 100; ++frames)
  {
    const Image image = scene.RenderAt(rate);
    const double now = scene.CountTiles();
    CheckAtMost(name + "maps drawn in a frame", now - drawn, moving ? 8 : 130,
      "169,000 triangles, drawn in the time of 80,000");
    CheckAtLeast(name + "and at least", now - drawn, 1, "all are asked for");
    CheckAtMost(name + "bytes", scene.ReadReport("bytes"), bytes, "those of all at once");
    const double error = FindRelativeError(image, expected, normal) / without;
    const double step = frames == 0 ? error : FindRelativeError(image, last, normal) / without;
    std::printf("       %g maps: error %.3f, step %.3f of no visibility's, mean off by %.4f\n", now,
      error, step, FindShift(image, expected));
    // The error of n directions goes with n to the power -3/4, and 8 of them have this error.
    const double bound = 0.35 * std::pow(8.0 / now, 0.75);
    CheckAtMost(name + "error over that of no visibility", error, bound, "see there");
    CheckAtMost(name + "step over that error", step,
      frames == 0 ? bound : 0.35 * std::pow(8.0 / drawn, 0.75) + bound,
      "the errors of both frames");
    drawn = now;
    last = image;
  }
  CheckEqual(name + "maps drawn in the end", drawn, all);
  Check(name + "and then all is as if drawn at once", last.Values == expected.Values);
  scene.RenderAt(rate);
  CheckEqual(name + "no more are drawn", scene.CountTiles(), drawn);
}
}

// A frame without time for all maps sums the directions with a map, scaled to all of the light.
VTK_INDIRECT_TEST(SkyArrivesOverFrames)
{
  CheckArrival(true);
}

VTK_INDIRECT_TEST(SkyArrivesOverFramesStill)
{
  CheckArrival(false);
}

// Unoccluded receivers have constant brightness while maps arrive.
VTK_INDIRECT_TEST(SkyArrivesWithoutFlicker)
{
  for (const bool uniform : { true, false })
  {
    const std::string name = uniform ? "uniform, " : "coloured, ";
    vtkNew<vtkEnvironmentLight> sky;
    if (!uniform)
    {
      MakeSky(sky);
    }
    SkyScene whole(sky, true);
    const Image expected = whole.RenderAt(MovingAtOnce);
    const double all = whole.CountTiles();
    auto sum = [](const Image& image) { return image.Mean(0) + image.Mean(1) + image.Mean(2); };
    SkyScene scene(sky, true);
    double drawn = 0.0;
    for (int frames = 0; drawn < all && frames < 100; ++frames)
    {
      const Image image = scene.RenderAt(Moving);
      drawn = scene.CountTiles();
      CheckRelative(name + "sum of the colours' means", sum(image), sum(expected), 1e-4,
        "the ratio that is seen of what is summed; facets hide grazing directions");
      CheckAtMost(name + "largest shift of a colour's mean", FindShift(image, expected),
        uniform ? 1e-4 : 0.15 / drawn, "colours are those of the directions that there are");
    }
    CheckEqual(name + "maps drawn in the end", drawn, all);
  }
}

// More strong directions than a frame has time for: those without a map yet cast no shadow.
VTK_INDIRECT_TEST(SkyArrivesWithManySuns)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 32, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  auto* p = static_cast<float*>(image->GetScalarPointer());
  std::fill(p, p + 3 * 64 * 32, 0.01f);
  for (int i = 0; i < 20; ++i)
  {
    auto* sun = static_cast<float*>(image->GetScalarPointer(3 * i + 1, 18 + i % 3 * 3, 0));
    sun[0] = sun[1] = sun[2] = 100.0f;
  }
  vtkNew<vtkEnvironmentLight> sky;
  sky->SetImage(image);
  SkyScene whole(sky, false);
  const Image expected = whole.RenderAt(MovingAtOnce);
  const double all = whole.CountTiles();
  SkyScene scene(sky, false);
  double drawn = 0.0;
  double last = 1e30;
  Image now;
  for (int frames = 0; drawn < all && frames < 100; ++frames)
  {
    now = scene.RenderAt(Moving);
    CheckAtMost("maps drawn in a frame", scene.CountTiles() - drawn, 8,
      "169,000 triangles, drawn in the time of 80,000");
    drawn = scene.CountTiles();
    if (frames < 5)
    {
      CheckAtMost("light of a frame with more suns' maps", now.Mean(), 1.002 * last,
        "each hides some; the others have a hundredth of the light");
      last = now.Mean();
    }
  }
  CheckEqual("maps drawn in the end", drawn, all);
  Check("and then all is as if drawn at once", now.Values == expected.Values);
}

// A prop that moves out of the scene's bounds, so that all tiles are refitted: old maps are used
// until their turn comes.
VTK_INDIRECT_TEST(SkyOfMovingThings)
{
  vtkNew<vtkEnvironmentLight> sky;
  SkyScene whole(sky, false);
  whole.RenderAt(MovingAtOnce);
  SkyScene scene(sky, false);
  scene.RenderAt(MovingAtOnce);
  const double before = scene.CountTiles();
  for (SkyScene* moved : { &whole, &scene })
  {
    moved->Ball->SetPosition(1.5, 0.4, -1.0);
  }
  const Image expected = whole.RenderAt(MovingAtOnce);
  const double all = whole.CountTiles();
  CheckEqual("all maps are drawn again", all, 2.0 * before);
  // Receivers where neither position of the ball changes much.
  std::vector<char> counts;
  for (const Scene::Receiver& r : whole.GetReceivers())
  {
    counts.push_back(r.Lit && r.Position.x < -0.5);
  }
  double drawn = before;
  Image now;
  for (int frames = 0; drawn < all && frames < 100; ++frames)
  {
    now = scene.RenderAt(Moving);
    CheckAtMost("maps drawn in a frame", scene.CountTiles() - drawn, 8,
      "169,000 triangles, drawn in the time of 80,000");
    drawn = scene.CountTiles();
    double squares = 0.0;
    double sum = 0.0;
    double count = 0.0;
    for (size_t i = 0; i < counts.size(); ++i)
    {
      const double difference = now.Values[3 * i] - expected.Values[3 * i];
      squares += counts[i] ? difference * difference : 0.0;
      sum += counts[i] ? expected.Values[3 * i] : 0.0;
      count += counts[i] ? 1.0 : 0.0;
    }
    Check("receivers are seen", count > 500.0, "a test of nothing passes");
    CheckAtMost("RMS difference far from the ball, over the mean", std::sqrt(squares * count) / sum,
      0.03, "the ball hides a hundredth; tiles of another fit have other texels");
  }
  CheckEqual("maps drawn in the end", drawn, all);
  Check("and then all is as if drawn at once", now.Values == expected.Values);
}

// Maps of virtual lights and of the sky share one time budget, and neither waits for the other.
VTK_INDIRECT_TEST(SkySharesTheTimeForMaps)
{
  vtkNew<vtkEnvironmentLight> sky;
  SkyScene scene(sky, false);
  scene.AddSpot({ 0, 3, 1 }, { 0, 0, 0 }, 25.0, 0.0, { 0, 0, 1 });
  scene.Sampler->SetNumberOfLights(64);
  scene.Gather->SetModeToVirtualLights();
  scene.Pass->SetVisibilityToMaps();
  scene.Window->SetDesiredUpdateRate(Moving);
  double all = 0.0;
  double ofSky = 0.0;
  for (int frames = 0; frames < 60; ++frames)
  {
    scene.Render();
    const double drawn = scene.ReadReport("tiles_drawn") - all;
    const double drawnOfSky = scene.CountTiles() - ofSky;
    CheckAtMost(
      "maps drawn in a frame", drawn, 8, "169,000 triangles, drawn in the time of 80,000");
    if (frames < 10)
    {
      CheckAtLeast("of the sky", drawnOfSky, 4, "half of the time");
      CheckAtLeast("of virtual lights", drawn - drawnOfSky, 4, "half of the time");
    }
    else if (ofSky >= 64)
    {
      CheckEqual("of the sky when its maps are there", drawnOfSky, 0);
    }
    all += drawn;
    ofSky += drawnOfSky;
  }
  CheckEqual("maps of the sky in the end", ofSky, 64);
  CheckAtLeast("maps of lights in the end", all - ofSky, 64, "of the spot and of the sky's bounce");
}

// Area lights have their share from the first frame on, within the same budget.
VTK_INDIRECT_TEST(AreaLightsShareTheTimeForMaps)
{
  SkyScene scene(nullptr, false);
  scene.AddSpot({ 0, 3, 1 }, { 0, 0, 0 }, 25.0, 0.0, { 0, 0, 1 });
  vtkNew<vtkAreaLight> lamp;
  lamp->SetOrigin(-0.5, 2.0, -0.5);
  lamp->SetPoint1(0.5, 2.0, -0.5);
  lamp->SetPoint2(-0.5, 2.0, 0.5);
  scene.Pass->AddAreaLight(lamp);
  scene.Sampler->SetNumberOfLights(64);
  scene.Gather->SetModeToVirtualLights();
  scene.Pass->SetVisibilityToMaps();
  scene.Window->SetDesiredUpdateRate(Moving);
  double all = 0.0;
  for (int frames = 0; frames < 4; ++frames)
  {
    scene.Render();
    const double drawn = scene.ReadReport("tiles_drawn") - all;
    CheckEqual("maps drawn in a frame", drawn, 8);
    all += drawn;
    const std::string missing =
      "depth maps of " + std::to_string(64 - 4 * (frames + 1)) + " points of area lights";
    Check("half of them are of the area light",
      std::string(scene.Pass->GetReport()).find(missing) != std::string::npos, missing);
  }
}
