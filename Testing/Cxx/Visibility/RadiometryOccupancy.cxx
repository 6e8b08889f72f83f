// SPDX-License-Identifier: BSD-3-Clause
// Voxels that hide the senders of estimators that sum over virtual lights: hidden receivers are
// dark, others keep their light, and all estimators agree.
#include "vtkIndirectDetails.h"
#include "vtkIndirectForcedPath.h"
#include "vtkIndirectVisibilityScene.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkAppendPolyData.h"
#include "vtkIndirectEstimatorPass.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRSMGatherPass.h"
#include "vtkRSMReferencePass.h"
#include "vtkStaticCellLocator.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace vtkIndirectTest;

namespace
{
struct OccupancyScene : VisibilityScene
{
  using VisibilityScene::VisibilityScene;

  Image Measure(vtkIndirectEstimatorPass* estimator, bool voxels)
  {
    return this->VisibilityScene::Measure(
      estimator, voxels ? vtkIndirectIlluminationPass::VOXELS : vtkIndirectIlluminationPass::NONE);
  }
};

// Six faces that point inwards, rotated about the vertical.
void AddRoom(Scene& scene, const glm::dvec3& size, double angle, double scale = 1.0,
  const glm::dvec3& place = glm::dvec3(0.0))
{
  const double c = std::cos(vtkMath::RadiansFromDegrees(angle));
  const double s = std::sin(vtkMath::RadiansFromDegrees(angle));
  auto at = [&](double x, double y, double z)
  { return place + scale * glm::dvec3(c * x - s * y, s * x + c * y, z); };
  const double x = size.x;
  const double y = size.y;
  const double z = size.z;
  const glm::dvec3 white(0.8, 0.6, 0.4);
  scene.AddQuad(at(0, 0, 0), at(x, 0, 0), at(0, y, 0), white);
  scene.AddQuad(at(0, 0, z), at(0, y, z), at(x, 0, z), white);
  scene.AddQuad(at(0, 0, 0), at(0, y, 0), at(0, 0, z), white);
  scene.AddQuad(at(x, 0, 0), at(x, 0, z), at(x, y, 0), white);
  scene.AddQuad(at(0, y, 0), at(x, y, 0), at(0, y, z), white);
  scene.AddQuad(at(0, 0, 0), at(0, 0, z), at(x, 0, 0), white);
}

// A room with blocks that hide much of it, seen from one of its corners.
void AddBlocks(OccupancyScene& scene, double scale, const glm::dvec3& place)
{
  auto at = [&](double x, double y, double z) { return place + scale * glm::dvec3(x, y, z); };
  AddRoom(scene, { 4.03, 3.01, 2.02 }, 0.0, scale, place);
  scene.AddBox(at(1.41, 0.63, 0.017), at(1.93, 1.87, 1.21), { 0.3, 0.6, 0.7 });
  scene.AddBox(at(2.61, 1.63, 0.017), at(3.13, 2.07, 0.71), { 0.7, 0.6, 0.3 });
  scene.AddSphere(at(2.87, 0.71, 0.63), 0.37 * scale, 48, { 0.5, 0.7, 0.5 });
  const double d = 1.0 / scale;
  scene.AddSpot(at(0.61, 1.47, 1.87), at(0.9, 1.3, 0.0), 55.0, 1.0, { 0.0, 0.0, d * d });
  scene.AddSpot(at(3.51, 1.13, 1.87), at(3.2, 1.4, 0.0), 45.0, 1.0, { 0.0, 0.0, d * d });
  scene.SetEye(at(0.11, 0.13, 1.83), at(2.7, 1.9, 0.5), { 0, 0, 1 }, 75.0, 0.05 * scale, 9 * scale);
}
}

VTK_INDIRECT_TEST(OccupancyConvexRoom)
{
  // In an empty convex room there is no occlusion: any loss is the voxels' error.
  for (double angle : { 0.0, 31.0 })
  {
    const std::string what = "room turned by " + std::to_string(static_cast<int>(angle)) + ": ";
    OccupancyScene scene(96, 72);
    AddRoom(scene, { 4.03, 3.01, 2.02 }, angle);
    const double c = std::cos(vtkMath::RadiansFromDegrees(angle));
    const double s = std::sin(vtkMath::RadiansFromDegrees(angle));
    auto at = [&](double x, double y, double z)
    { return glm::dvec3(c * x - s * y, s * x + c * y, z); };
    scene.AddPoint(at(2.1, 1.4, 1.1), { 0.0, 0.0, 1.0 });
    scene.SetEye(at(0.1, 0.1, 1.8), at(3.5, 2.5, 0.4), { 0, 0, 1 }, 80.0, 0.05, 9.0);
    scene.Sampler->SetNumberOfLights(1024);
    const Image open = scene.Measure(scene.Gather, false);
    const Image seen = scene.Measure(scene.Gather, true);
    int dark = 0;
    for (size_t i = 0; i < open.Values.size(); i += open.Components)
    {
      dark += seen.Values[i] < 0.5f * open.Values[i];
    }
    const double kept = seen.Mean() / open.Mean();
    std::cout << "  " << what << 100.0 * (1.0 - kept) << " % lost, "
              << 100.0 * dark / (open.Width * open.Height) << " % of pixels lose half\n";
    CheckAtLeast(what + "light that is left", kept, 0.98,
      "a voxel of about 90 along each of two edges, half of whose lights lie along the other wall");
    CheckAtMost(what + "light that is left", kept, 1.0, "nothing is added");
  }
}

VTK_INDIRECT_TEST(OccupancySphere)
{
  // Inside a ball every part sees every other.
  OccupancyScene scene(48, 48);
  scene.AddSphere(glm::dvec3(0.0), 2.0, 96, glm::dvec3(0.7));
  scene.AddPoint(glm::dvec3(0.0), { 0.0, 0.0, 1.0 });
  scene.SetEye({ 0, 0, 0 }, { 1, 0.3, 0.2 }, { 0, 0, 1 }, 90.0, 0.1, 10.0);
  const Image open = scene.Measure(scene.Gather, false);
  const Image seen = scene.Measure(scene.Gather, true);
  CheckRelative("mean irradiance", seen.Mean(), open.Mean(), 0.02,
    "lights nearer than a few voxels, within which the curve is not a plane, give that share");
}

VTK_INDIRECT_TEST(OccupancyTwoRooms)
{
  // A wall a fifth of a voxel thick, straight and slanted, between a lit room and a dark one.
  for (double slant : { 0.0, 0.4 })
  {
    OccupancyScene scene(96, 48);
    AddRoom(scene, { 4.03, 2.0, 2.0 }, 0.0);
    for (double x : { 2.02, 2.03 })
    {
      const glm::dvec3 a(x, 0, 0);
      const glm::dvec3 up(x + slant, 0, 2);
      const glm::dvec3 along(x + 0.5 * slant, 2, 0);
      x < 2.025 ? scene.AddQuad(a, up, along, glm::dvec3(0.8))
                : scene.AddQuad(a, along, up, glm::dvec3(0.8));
    }
    scene.AddPoint({ 1.0, 1.0, 1.7 }, { 0.0, 0.0, 1.0 });
    scene.SetEye({ 2.0, -5.0, 1.0 }, { 2.0, 1.0, 1.0 }, { 0, 0, 1 }, 30.0, 5.02, 7.5);
    scene.SetParallelEye(1.0);
    for (vtkIndirectEstimatorPass* estimator :
      { static_cast<vtkIndirectEstimatorPass*>(scene.Gather),
        static_cast<vtkIndirectEstimatorPass*>(scene.Splatting) })
    {
      double leak[2];
      for (bool voxels : { false, true })
      {
        const Image image = scene.Measure(estimator, voxels);
        const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
        double total = 0.0;
        double dark = 0.0;
        for (size_t i = 0; i < receivers.size(); ++i)
        {
          const double e = receivers[i].Lit ? image.Values[image.Components * i] : 0.0;
          const glm::dvec3& p = receivers[i].Position;
          total += e;
          dark += p.x > 2.03 + slant * (0.5 * p.z + 0.25 * p.y) + 1e-3 ? e : 0.0;
        }
        leak[voxels] = dark / total;
      }
      const std::string what = std::string(estimator->GetMethodName()) + ", slant " +
        std::to_string(slant).substr(0, 3) + ": light behind the wall over all";
      CheckAtMost(what, leak[1], 0.02, "the requirement: 2 %");
      CheckAtLeast(what + " without voxels", leak[0], 0.1, "the test's own power");
    }
  }
}

VTK_INDIRECT_TEST(OccupancyExact)
{
  // Against the same lights with segments tested against every triangle of the scene.
  OccupancyScene scene(40, 30);
  AddBlocks(scene, 1.0, glm::dvec3(0.0));
  const Image open = scene.Measure(scene.Gather, false);
  const Image seen = scene.Measure(scene.Gather, true);
  vtkNew<vtkAppendPolyData> all;
  vtkActorCollection* actors = scene.Renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    all->AddInputData(vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput());
  }
  all->Update();
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(all->GetOutput());
  locator->BuildLocator();
  const std::vector<VirtualLight> lights = scene.CopyLights();
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
  double exactSum = 0.0;
  double seenSum = 0.0;
  double openSum = 0.0;
  double squares = 0.0;
  double openSquares = 0.0;
  int count = 0;
  for (size_t i = 0; i < receivers.size(); ++i)
  {
    if (!receivers[i].Lit)
    {
      continue;
    }
    std::vector<VirtualLight> visible;
    for (const VirtualLight& light : lights)
    {
      const glm::dvec3 way = light.Position - receivers[i].Position;
      if (glm::dot(way, receivers[i].Normal) <= 0.0 || glm::dot(way, light.Normal) >= 0.0)
      {
        continue;
      }
      // Its ends are on surfaces, to the precision of the buffers.
      const glm::dvec3 a = receivers[i].Position + 1e-3 * receivers[i].Normal;
      const glm::dvec3 b = light.Position + 1e-3 * light.Normal;
      double t;
      double x[3];
      double parameters[3];
      int sub;
      if (!locator->IntersectWithLine(&a[0], &b[0], 0.0, t, x, parameters, sub))
      {
        visible.push_back(light);
      }
    }
    const double exact = Gather(visible, receivers[i].Position, receivers[i].Normal).x;
    const double e = seen.Values[seen.Components * i];
    const double o = open.Values[open.Components * i];
    exactSum += exact;
    seenSum += e;
    openSum += o;
    squares += std::pow(e - exact, 2.0);
    openSquares += std::pow(o - exact, 2.0);
    ++count;
  }
  CheckAtLeast("receivers", count, 300, "the test's own power");
  const double mean = exactSum / count;
  const double bias = seenSum / exactSum - 1.0;
  const double error = std::sqrt(squares / count) / mean;
  const double openBias = openSum / exactSum - 1.0;
  const double openError = std::sqrt(openSquares / count) / mean;
  std::cout << "  without: bias " << openBias << ", RMSE " << openError << "\n";
  CheckAtLeast("bias without voxels", openBias, 0.1, "the test's own power");
  // Blocks of about twenty voxels are up to a voxel wider on each side, and so are their shadows.
  CheckAbsolute("bias", bias, 0.0, 0.1 * openBias + 0.03,
    "2 of 20 voxels of what the blocks hide, and what a room loses along its edges");
  CheckAtMost("RMSE over the mean", error, 0.35 * openError,
    "shadows' outlines are off by a voxel of the twenty of a block: the root of 0.1 of the area");
}

VTK_INDIRECT_TEST(OccupancySame)
{
  // The shader's walk and the CPU's, at every pixel and through subsplats of one pixel.
  OccupancyScene scene(40, 30);
  AddBlocks(scene, 1.0, glm::dvec3(0.0));
  const Image exact = scene.Measure(scene.Reference, true);
  const Image open = scene.Measure(scene.Reference, false);
  CheckAtLeast("what voxels change", RootMeanSquare(open, exact), 0.1, "the test's own power");
  auto compare = [&](const std::string& what, vtkIndirectEstimatorPass* estimator)
  {
    const Image image = scene.Measure(estimator, true);
    CheckAtMost(what, RootMeanSquare(image, exact), 1e-3,
      "one light of 256 at one pixel of 300: rounding moves a segment past the edge of a voxel");
  };
  compare("gather", scene.Gather);
  compare("multiresolution, compute", scene.Splatting);
  {
    const vtkIndirectForcedPath path("compute=off");
    scene.Splatting->Modified();
    compare("multiresolution, fragments", scene.Splatting);
  }
  // With more lights than a uniform block holds.
  scene.Sampler->SetNumberOfLights(1500);
  const Image many = scene.Measure(scene.Reference, true);
  CheckAtMost(
    "1500 lights", RootMeanSquare(scene.Measure(scene.Splatting, true), many), 1e-3, "as before");
}

VTK_INDIRECT_TEST(OccupancySubsplats)
{
  // At borders of visibility the picture has edges inside surfaces.
  OccupancyScene scene(160, 120);
  AddBlocks(scene, 1.0, glm::dvec3(0.0));
  const Image full = scene.Measure(scene.Gather, true);
  vtkNew<vtkMultiresolutionSplattingPass> defaults;
  const double error = RootMeanSquare(scene.Measure(defaults, true), full);
  const Image open = scene.Measure(scene.Gather, false);
  const double openError = RootMeanSquare(scene.Measure(defaults, false), open);
  std::cout << "  RMSE over the mean " << error << ", without voxels " << openError << "\n";
  CheckAtMost("RMSE over the mean", error, 0.04,
    "the median of hard scenes without voxels, and half of it for shadows");
  CheckAtMost("bias", std::abs(scene.Measure(defaults, true).Mean() / full.Mean() - 1.0), 0.01,
    "interpolation takes and gives");
}

VTK_INDIRECT_TEST(OccupancyManyLights)
{
  // More lights than any OpenGL's shader can test in one draw: several sums.
  OccupancyScene scene(24, 18);
  AddBlocks(scene, 1.0, glm::dvec3(0.0));
  scene.Sampler->SetNumberOfLights(2500);
  const Image expected = scene.Measure(scene.Reference, true);
  const double open = scene.Measure(scene.Reference, false).Mean();
  CheckAtLeast("light without voxels over that with them", open / expected.Mean(), 1.1,
    "the test's own power");
  auto check = [&](const std::string& name, vtkIndirectEstimatorPass* estimator, double most)
  {
    const Image image = scene.Measure(estimator, true);
    CheckAtMost(name + ": RMSE over the mean", RootMeanSquare(image, expected), most,
      "segments that graze voxels go either way by rounding");
    CheckEqual(name + ": lights", scene.ReadReport("virtual_lights"), 2500);
  };
  check("gather", scene.Gather, 0.005);
  check("multiresolution", scene.Splatting, 0.005);
  {
    const vtkIndirectForcedPath path("compute=off");
    scene.Splatting->Modified();
    check("multiresolution, fragments", scene.Splatting, 0.005);
  }
  vtkNew<vtkMultiresolutionSplattingPass> defaults;
  check("multiresolution by default", defaults, 0.04);
}

VTK_INDIRECT_TEST(OccupancyScales)
{
  // Voxels scale with the scene.
  Image first;
  for (const auto& [scale, place] :
    { std::pair(1.0, glm::dvec3(0.0)), std::pair(1e-9, glm::dvec3(0.0)),
      std::pair(1e9, glm::dvec3(0.0)), std::pair(1.0, glm::dvec3(1e4, -3e4, 2e4)) })
  {
    OccupancyScene scene(48, 36);
    AddBlocks(scene, scale, place);
    const Image image = scene.Measure(scene.Gather, true);
    if (first.Values.empty())
    {
      first = image;
      continue;
    }
    CheckRelative("mean irradiance at scale " + std::to_string(scale), image.Mean(), first.Mean(),
      0.01, "segments past the edges of voxels go either way by rounding");
    CheckAtMost("RMSE over the mean", RootMeanSquare(image, first), 0.03, "the same");
  }
}

VTK_INDIRECT_TEST(OccupancyUpdates)
{
  OccupancyScene scene(48, 36);
  AddRoom(scene, { 4.03, 3.01, 2.02 }, 0.0);
  vtkActor* wall = scene.AddBox({ 1.9, 0.5, 0.02 }, { 2.0, 2.5, 2.0 }, glm::dvec3(0.7));
  scene.AddPoint({ 0.7, 1.4, 1.1 }, { 0.0, 0.0, 1.0 });
  scene.SetEye({ 3.9, 0.1, 1.8 }, { 1.0, 2.5, 0.4 }, { 0, 0, 1 }, 80.0, 0.05, 9.0);
  auto updates = [&scene]() { return scene.ReadReport("voxel_updates"); };
  scene.Measure(scene.Gather, false);
  CheckEqual("updates without voxels", updates(), 0);
  const double hidden = scene.Measure(scene.Gather, true).Mean();
  CheckEqual("updates of the first frame", updates(), 1);
  scene.SetEye({ 3.8, 0.1, 1.8 }, { 1.0, 2.5, 0.4 }, { 0, 0, 1 }, 80.0, 0.05, 9.0);
  scene.Render();
  CheckEqual("updates when the eye moved", updates(), 1);
  scene.Measure(scene.Splatting, true);
  CheckEqual("updates by another estimator: the voxels are shared", updates(), 1);
  scene.SetEye({ 3.9, 0.1, 1.8 }, { 1.0, 2.5, 0.4 }, { 0, 0, 1 }, 80.0, 0.05, 9.0);
  // Moved aside in the same frame; the bounds stay those of the room.
  wall->SetPosition(-1.85, 0.0, 0.0);
  const double moved = scene.Measure(scene.Gather, true).Mean();
  CheckEqual("updates when a wall moved", updates(), 2);
  const double open = scene.Measure(scene.Gather, false).Mean();
  CheckAtLeast("light when the wall is out of the way, over that of before", moved / hidden, 1.1,
    "it hid light");
  CheckAtLeast("light over that without voxels", moved / open, 0.9, "little hides anything now");
  scene.Pass->CachingOff();
  const double before = updates();
  scene.Measure(scene.Gather, true);
  scene.Render();
  CheckEqual("updates of two frames without caching", updates() - before, 2);
  Check("the report says so",
    scene.Pass->GetReport().find("occupied voxels of 128") != std::string::npos);
}

VTK_INDIRECT_TEST(OccupancyThinPlate)
{
  // A plate a hundredth of a voxel thick in mid-air: each side sees the half space in front of it.
  OccupancyScene scene(32, 32);
  scene.AddQuad({ -2, -2, 2 }, { -2, 2, 2 }, { 2, -2, 2 }, glm::dvec3(0.8)); // ceiling
  scene.AddQuad({ -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }, glm::dvec3(0.8));
  scene.AddQuad({ -1, -1, -3e-4 }, { -1, 1, -3e-4 }, { 1, -1, -3e-4 }, glm::dvec3(0.8));
  scene.AddQuad({ -2, -2, -2 }, { 2, -2, -2 }, { -2, 2, -2 }, glm::dvec3(0.8)); // floor
  scene.AddSpot({ 0, 0, 0.5 }, { 0, 0, 2 }, 60.0, 0.0, { 0.0, 0.0, 1.0 }); // lights the ceiling
  scene.SetEye({ 0.1, 0.2, 1.5 }, { 0, 0, 0 }, { 0, 1, 0 }, 50.0, 0.1, 9.0);
  const Image open = scene.Measure(scene.Gather, false);
  const Image top = scene.Measure(scene.Gather, true);
  CheckRelative("light on the plate", top.Mean(), open.Mean(), 0.01, "nothing is in the way");
  // The floor below the plate sees the ceiling only past the rim.
  scene.SetEye({ 0.1, 0.2, -0.5 }, { 0, 0, -2 }, { 0, 1, 0 }, 10.0, 0.1, 9.0);
  const Image below = scene.Measure(scene.Gather, true);
  const Image through = scene.Measure(scene.Gather, false);
  CheckAtMost("light under it", below.Mean() / through.Mean(), 0.05,
    "the plate covers all of the lit disk but its rim, which is dark from there");
}

VTK_INDIRECT_TEST(OccupancyNothing)
{
  // Without polygons there are no voxels; the report says so.
  OccupancyScene scene(16, 16);
  scene.Pass->SetVisibilityToVoxels();
  scene.Render();
  scene.AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, glm::dvec3(0.5));
  scene.AddDirectional({ 0, 0, -1 });
  scene.SetEye({ 0.5, 0.5, 2 }, { 0.5, 0.5, 0 }, { 0, 1, 0 }, 40, 0.1, 10);
  // One plane: no voxel hides the plane itself.
  const Image seen = scene.Measure(scene.Gather, true);
  for (float value : seen.Values)
  {
    if (!std::isfinite(value))
    {
      Check("irradiance is finite", false);
      break;
    }
  }
  scene.Measure(scene.Gather, false);
  Check("the report says what is left out",
    scene.Pass->GetReport().find("Visibility is none or nothing has polygons") !=
      std::string::npos);
}
