// SPDX-License-Identifier: BSD-3-Clause
// The reference with exact visibility: penumbrae of closed forms, opaque walls, rooms without
// occlusion, and the same picture at every scale.
#include "vtkIndirectVisibilityScene.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkAppendPolyData.h"
#include "vtkCubeSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRSMReferencePass.h"
#include "vtkStaticCellLocator.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

using namespace vtkIndirectTest;

namespace
{
struct ExactScene : Scene
{
  vtkNew<vtkRSMReferencePass> Reference;

  ExactScene(int width, int height)
    : Scene(width, height)
  {
    this->Reference->SetModeToVirtualLights();
    this->Pass->SetEstimator(this->Reference);
    this->Pass->SetVisibilityToAuto(); // the reference decides
    this->Sampler->SetNumberOfLights(256);
    this->Pass->SetReflectiveShadowMapResolution(128);
  }
  ~ExactScene() { this->Pass->SetEstimator(nullptr); }

  Image Measure(int visibility)
  {
    this->Reference->SetVisibility(visibility);
    this->Render();
    return this->Copy("irradiance");
  }

  // Six faces that point inwards.
  void AddRoom(
    const glm::dvec3& size, double scale = 1.0, const glm::dvec3& place = glm::dvec3(0.0))
  {
    auto at = [&](double x, double y, double z)
    { return place + scale * size * glm::dvec3(x, y, z); };
    const glm::dvec3 white(0.8, 0.6, 0.4);
    this->AddQuad(at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), white);
    this->AddQuad(at(0, 0, 1), at(0, 1, 1), at(1, 0, 1), white);
    this->AddQuad(at(0, 0, 0), at(0, 1, 0), at(0, 0, 1), white);
    this->AddQuad(at(1, 0, 0), at(1, 0, 1), at(1, 1, 0), white);
    this->AddQuad(at(0, 1, 0), at(1, 1, 0), at(0, 1, 1), white);
    this->AddQuad(at(0, 0, 0), at(0, 0, 1), at(1, 0, 0), white);
  }

  // A room with objects in it, two of which stand on its floor.
  void AddBlocks(double scale, const glm::dvec3& place)
  {
    auto at = [&](double x, double y, double z) { return place + scale * glm::dvec3(x, y, z); };
    this->AddRoom({ 4.0, 3.0, 2.0 }, scale, place);
    this->AddBox(at(1.4, 0.6, 0.0), at(1.9, 1.9, 1.2), { 0.3, 0.6, 0.7 });
    this->AddBox(at(2.6, 1.6, 0.0), at(3.1, 2.1, 0.7), { 0.7, 0.6, 0.3 });
    this->AddSphere(at(2.9, 0.7, 0.6), 0.4 * scale, 48, { 0.5, 0.7, 0.5 });
    const double d = 1.0 / scale;
    this->AddSpot(at(0.6, 1.5, 1.9), at(0.9, 1.3, 0.0), 55.0, 1.0, { 0.0, 0.0, d * d });
    this->AddSpot(at(3.5, 1.1, 1.9), at(3.2, 1.4, 0.0), 45.0, 1.0, { 0.0, 0.0, d * d });
    this->SetEye(at(0.1, 0.13, 1.8), at(2.7, 1.9, 0.5), { 0, 0, 1 }, 75.0, 0.05 * scale, 9 * scale);
  }
};

// Pixels whose values differ by more than a share of the mean.
int CountOthers(const Image& a, const Image& b, double share)
{
  int count = 0;
  for (size_t i = 0; i < a.Values.size(); i += a.Components)
  {
    count += std::abs(double(a.Values[i]) - b.Values[i]) > share * b.Mean();
  }
  return count;
}
}

VTK_INDIRECT_TEST(ExactPenumbra)
{
  // A lit square over a floor, and half way between them the edge of a plate: a point of the floor
  // at x sees the part of the square beyond -x. The plate is one sheet, of either orientation.
  constexpr double half = 0.1;
  for (const bool turned : { false, true })
  {
    const std::string what = turned ? "sheet turned down: " : "sheet turned up: ";
    ExactScene scene(128, 32);
    scene.AddQuad({ -half, -half, 2 }, { -half, half, 2 }, { half, -half, 2 }, glm::dvec3(0.8));
    scene.AddQuad({ -2, -2, 0 }, { 2, -2, 0 }, { -2, 2, 0 }, glm::dvec3(0.8));
    const glm::dvec3 corner(-2, -2, 1);
    const glm::dvec3 along(0, -2, 1);
    const glm::dvec3 across(-2, 2, 1);
    scene.AddQuad(corner, turned ? across : along, turned ? along : across, glm::dvec3(0.8));
    // The light reaches only the square: its cone ends in empty space.
    scene.AddSpot({ 0.0, 0.0, 1.2 }, { 0, 0, 2 }, 12.0, 0.0, { 1.0, 0.0, 0.0 });
    scene.SetEye({ 0.0, 0.0, 0.95 }, { 0, 0, 0 }, { 0, 1, 0 }, 10.0, 0.1, 5.0);
    scene.Sampler->SetNumberOfLights(1024);
    const Image open = scene.Measure(vtkRSMReferencePass::NONE);
    const Image exact = scene.Measure(vtkRSMReferencePass::EXACT);
    const std::vector<VirtualLight> lights = scene.CopyLights();
    const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
    const glm::dvec3 flux = scene.GetReflectedFlux();
    double worst = 0.0;
    double total = 0.0;
    double expectedTotal = 0.0;
    double crossing = 0.0;
    for (size_t i = 0; i < receivers.size(); ++i)
    {
      const glm::dvec3& p = receivers[i].Position;
      const double e = exact.Values[exact.Components * i];
      const double o = open.Values[open.Components * i];
      // The closed form: the radiosity is the flux over the area, the form factor Lambert's.
      const double seenFrom = glm::clamp(-p.x, -half, half);
      const double expected = seenFrom < half ? flux.x / (4.0 * half * half) *
          PolygonFormFactor(p, { 0, 0, 1 },
            { { seenFrom, -half, 2 }, { half, -half, 2 }, { half, half, 2 },
              { seenFrom, half, 2 } })
                                              : 0.0;
      total += e;
      expectedTotal += expected;
      // The senders beyond the edge.
      double sum = 0.0;
      bool grazes = false;
      for (const VirtualLight& light : lights)
      {
        // Crossing of the segment at the plate's height.
        const double passes = 0.5 * (light.Position.x + p.x);
        grazes = grazes || std::abs(passes) < 4e-5;
        sum += passes > 0.0 ? Gather({ light }, p, receivers[i].Normal).x : 0.0;
      }
      worst = std::max(worst, grazes ? 0.0 : std::abs(e - sum) / open.Mean());
      // Half of the square is visible below the plate's edge.
      crossing += e > 0.5 * o ? 1.0 : 0.0;
    }
    CheckAtMost(what + "worst difference to the sum of the senders beyond the edge", worst, 1e-5,
      "single precision of the buffers");
    CheckRelative(what + "light on the floor over the closed form", total, expectedTotal, 0.02,
      "1.5 % fall of the lamp's light over the square, and 1024 of its texels");
    const double pixel = 1.0 / 128.0;
    CheckAbsolute(what + "share of the floor that sees more than half", crossing / receivers.size(),
      0.5, pixel, "a pixel");
    CheckAtLeast(what + "light without visibility over that with it", open.Mean() / exact.Mean(),
      1.8, "the test's own power: half of the floor is dark");
  }
}

VTK_INDIRECT_TEST(ExactWall)
{
  // A closed room divided by a wall of one sheet, straight and slanted, and of either orientation.
  for (const double slant : { 0.0, 0.4 })
  {
    for (const bool turned : { false, true })
    {
      for (const int mode :
        { vtkRSMReferencePass::VIRTUAL_LIGHTS, vtkRSMReferencePass::ALL_TEXELS })
      {
        ExactScene scene(64, 32);
        scene.AddRoom({ 4.0, 2.0, 2.0 });
        const glm::dvec3 up(2.0 + slant, 0, 2);
        const glm::dvec3 along(2.0 + 0.5 * slant, 2, 0);
        scene.AddQuad({ 2, 0, 0 }, turned ? up : along, turned ? along : up, glm::dvec3(0.8));
        scene.AddPoint({ 1.0, 1.0, 1.7 }, { 0.0, 0.0, 1.0 });
        scene.SetEye({ 2.0, -5.0, 1.0 }, { 2.0, 1.0, 1.0 }, { 0, 0, 1 }, 30.0, 5.02, 7.5);
        scene.SetParallelEye(1.0);
        scene.Pass->SetReflectiveShadowMapResolution(16);
        scene.Reference->SetMode(mode);
        double leak[2];
        double lit[2];
        for (const bool exact : { false, true })
        {
          const Image image =
            scene.Measure(exact ? vtkRSMReferencePass::EXACT : vtkRSMReferencePass::NONE);
          const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
          lit[exact] = leak[exact] = 0.0;
          for (size_t i = 0; i < receivers.size(); ++i)
          {
            const double e = receivers[i].Lit ? image.Values[image.Components * i] : 0.0;
            const glm::dvec3& p = receivers[i].Position;
            const double beyond = p.x - 2.0 - slant * (0.5 * p.z + 0.25 * p.y);
            leak[exact] += beyond > 1e-3 ? e : 0.0;
            lit[exact] += beyond < -1e-3 ? e : 0.0;
          }
        }
        const std::string what = std::string(mode ? "virtual lights" : "all texels") + ", slant " +
          std::to_string(slant).substr(0, 3) + (turned ? ", turned" : "");
        CheckEqual(what + ": light behind the wall", leak[1], 0.0);
        CheckAtLeast(what + ": share of it without visibility", leak[0] / (leak[0] + lit[0]), 0.1,
          "the test's own power");
        // A coarse map's texel whose centre is beside an edge may lie behind the wall there.
        CheckAtMost(what + ": light before the wall over that without visibility", lit[1] / lit[0],
          1.0 + 1e-6, "nothing is added");
        CheckAtLeast(what + ": light before the wall over that without visibility", lit[1] / lit[0],
          mode ? 1.0 - 1e-6 : 1.0 - 1.0 / 128.0,
          mode ? "nothing stands between" : "a texel of the 16 x 16 x 6 at each of the 12 edges");
      }
    }
  }
}

VTK_INDIRECT_TEST(ExactConvex)
{
  // In a convex room, and inside a ball, there is no occlusion: the same sums.
  for (const bool ball : { false, true })
  {
    const std::string what = ball ? "ball: " : "room: ";
    ExactScene scene(48, 36);
    const glm::dvec3 middle(2.1, 1.4, 1.1);
    ball ? scene.AddSphere(middle, 2.0, 96, glm::dvec3(0.7)) : nullptr;
    if (!ball)
    {
      scene.AddRoom({ 4.03, 3.01, 2.02 });
    }
    scene.AddPoint(middle, { 0.0, 0.0, 1.0 });
    scene.SetEye({ 0.2, 1.3, 1.2 }, { 3.5, 2.5, 0.4 }, { 0, 0, 1 }, 80.0, 0.05, 9.0);
    scene.Sampler->SetNumberOfLights(1024);
    const Image open = scene.Measure(vtkRSMReferencePass::NONE);
    const Image exact = scene.Measure(vtkRSMReferencePass::EXACT);
    CheckRelative(what + "light that is left", exact.Mean(), open.Mean(), ball ? 1e-4 : 1e-6,
      ball ? "smooth normals see senders on their own facets, which are below the horizon"
           : "nothing is in the way");
    CheckEqual(what + "pixels that differ by 1e-4 of the mean and more",
      CountOthers(exact, open, ball ? 1e-3 : 1e-4), 0);
  }
}

VTK_INDIRECT_TEST(ExactSameAsLocator)
{
  // The same senders, with segments tested by VTK's own locator against every triangle.
  for (const int mode : { vtkRSMReferencePass::VIRTUAL_LIGHTS, vtkRSMReferencePass::ALL_TEXELS })
  {
    ExactScene scene(40, 30);
    scene.AddBlocks(1.0, glm::dvec3(0.0));
    scene.Pass->SetReflectiveShadowMapResolution(mode ? 128 : 12);
    scene.Reference->SetMode(mode);
    const Image open = scene.Measure(vtkRSMReferencePass::NONE);
    const Image seen = scene.Measure(vtkRSMReferencePass::EXACT);
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
    double squares = 0.0;
    double mean = 0.0;
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
        const glm::dvec3 a = receivers[i].Position + 1e-4 * receivers[i].Normal;
        const glm::dvec3 b = light.Position + 1e-4 * light.Normal;
        double t;
        double x[3];
        double parameters[3];
        int sub;
        if (glm::dot(way, receivers[i].Normal) > 0.0 && glm::dot(way, light.Normal) < 0.0 &&
          !locator->IntersectWithLine(&a[0], &b[0], 0.0, t, x, parameters, sub))
        {
          visible.push_back(light);
        }
      }
      const double expected = Gather(visible, receivers[i].Position, receivers[i].Normal).x;
      squares += std::pow(seen.Values[seen.Components * i] - expected, 2.0);
      mean += expected;
      ++count;
    }
    mean /= count;
    const std::string what = mode ? "virtual lights: " : "all texels: ";
    CheckAtLeast(what + "receivers", count, 300, "the test's own power");
    CheckAtLeast(what + "light without visibility over that with it", open.Mean() / seen.Mean(),
      1.1, "the test's own power");
    CheckAtMost(what + "RMSE over the mean", std::sqrt(squares / count) / mean, 5e-3,
      "ends a few 1e-5 of the scene apart: a segment at an outline goes either way, one light of "
      "256 at one pixel of a hundred");
  }
}

VTK_INDIRECT_TEST(ExactScales)
{
  // The same picture at any scale. Far from the origin points are rounded to floats, here by 5e-5
  // of the scene, and the lights with them: the effect of this without visibility is the measure.
  Image first[2];
  for (const auto& [scale, place] : { std::pair(1.0, glm::dvec3(0.0)),
         std::pair(1e-9, glm::dvec3(0.0)), std::pair(1e-3, glm::dvec3(0.0)),
         std::pair(1e6, glm::dvec3(0.0)), std::pair(1.0, glm::dvec3(1e3, -3e3, 2e3)) })
  {
    ExactScene scene(64, 48);
    scene.AddBlocks(scale, place);
    const Image open = scene.Measure(vtkRSMReferencePass::NONE);
    const Image image = scene.Measure(vtkRSMReferencePass::EXACT);
    if (first[0].Values.empty())
    {
      first[0] = open;
      first[1] = image;
      continue;
    }
    const std::string what = "scale 1e" +
      std::to_string(static_cast<int>(std::round(std::log10(scale)))) + ", place " +
      std::to_string(static_cast<int>(place.x)) + ": ";
    const double error = RootMeanSquare(open, first[0]);
    const double bias = std::abs(open.Mean() / first[0].Mean() - 1.0);
    CheckRelative(what + "mean irradiance", image.Mean(), first[1].Mean(), 1e-3 + 2.0 * bias,
      "segments at outlines go either way by rounding; twice what there is without visibility");
    CheckAtMost(
      what + "RMSE over the mean", RootMeanSquare(image, first[1]), 5e-3 + 2.0 * error, "the same");
  }
}

VTK_INDIRECT_TEST(ExactDoubled)
{
  // A duplicated floor, and one over another: geometry in or behind the surface hides nothing.
  for (const double depth : { 0.0, 1e-7, 1e-3 })
  {
    ExactScene scene(32, 32);
    scene.AddQuad({ -2, -2, 0 }, { 2, -2, 0 }, { -2, 2, 0 }, glm::dvec3(0.8));
    scene.AddQuad({ -2, -2, 2 }, { -2, 2, 2 }, { 2, -2, 2 }, glm::dvec3(0.8));
    scene.AddQuad({ -2, -2, -depth }, { 2, -2, -depth }, { -2, 2, -depth }, glm::dvec3(0.8));
    scene.AddSpot({ 0, 0, 0.5 }, { 0, 0, 2 }, 50.0, 0.0, { 1.0, 0.0, 0.0 });
    scene.SetEye({ 0, 0, 1.5 }, { 0, 0, 0 }, { 0, 1, 0 }, 50.0, 0.1, 9.0);
    const Image open = scene.Measure(vtkRSMReferencePass::NONE);
    const Image exact = scene.Measure(vtkRSMReferencePass::EXACT);
    CheckRelative("light on a floor over another at " + std::to_string(depth), exact.Mean(),
      open.Mean(), 1e-6, "nothing is in front of it");
    CheckAtLeast("light", open.Mean(), 1e-3, "the test's own power");
  }
}

VTK_INDIRECT_TEST(ExactProperty)
{
  // With NONE the pass's Visibility decides, VOXELS is that of the pass, EXACT needs no voxels;
  // these are released after use.
  ExactScene scene(40, 30);
  scene.AddBlocks(1.0, glm::dvec3(0.0));
  const Image open = scene.Measure(vtkRSMReferencePass::NONE);
  const Image voxels = scene.Measure(vtkRSMReferencePass::VOXELS);
  scene.Pass->SetVisibilityToVoxels();
  CheckEqual("VOXELS of the pass against its own",
    RootMeanSquare(scene.Measure(vtkRSMReferencePass::NONE), voxels), 0.0);
  const Image exact = scene.Measure(vtkRSMReferencePass::EXACT);
  scene.Pass->SetVisibilityToAuto();
  CheckEqual("EXACT with VOXELS of the pass and without",
    RootMeanSquare(scene.Measure(vtkRSMReferencePass::EXACT), exact), 0.0);
  Check("the report says so",
    scene.Pass->GetReport().find("segments against all ") != std::string::npos);
  const double error = RootMeanSquare(voxels, exact);
  std::cout << "  RMSE of voxels over the mean " << error << ", of nothing "
            << RootMeanSquare(open, exact) << "\n";
  CheckAtLeast("RMSE of voxels over the mean", error, 0.005, "blocks are wider by a voxel");
  CheckAtMost("RMSE of voxels over that of nothing", error / RootMeanSquare(open, exact), 0.5,
    "they know most of it");
  const double withTree = scene.ReadReport("main_memory_bytes");
  scene.Measure(vtkRSMReferencePass::NONE);
  CheckAtMost("main memory afterwards", scene.ReadReport("main_memory_bytes"), 0.1 * withTree,
    "triangles and voxels are let go");
  CheckEqual("NONE again", RootMeanSquare(scene.Copy("irradiance"), open), 0.0);
  // A moved prop occludes at its new position.
  vtkActorCollection* actors = scene.Renderer->GetActors();
  actors->InitTraversal();
  vtkActor* block = nullptr;
  for (int i = 0; i <= 6; ++i)
  {
    block = actors->GetNextActor();
  }
  const double before = scene.Measure(vtkRSMReferencePass::EXACT).Mean();
  block->SetPosition(0.0, 0.0, 0.5);
  const double moved = scene.Measure(vtkRSMReferencePass::EXACT).Mean();
  CheckAtLeast("change of the mean when a block has moved", std::abs(moved / before - 1.0), 1e-3,
    "it hides other light");
}

VTK_INDIRECT_TEST(ExactGlyphsBesideMeshes)
{
  // A block of a glyph hides what the same block of a mesh does.
  const auto measure = [](bool glyph, bool visible)
  {
    ExactScene scene(40, 30);
    scene.AddRoom({ 2, 2, 1 });
    scene.AddSpot({ 0.6, 1.0, 0.8 }, { 0.3, 1.0, 0.0 }, 35.0, 0.0, { 1.0, 0.0, 0.0 });
    scene.SetEye({ 1.0, 0.1, 0.9 }, { 1.2, 1.2, 0.2 }, { 0, 0, 1 }, 80.0, 0.01, 9.0);
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(0.1);
    cube->SetYLength(1.2);
    cube->SetZLength(0.6);
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(1.0, 1.0, 0.3);
    vtkNew<vtkPolyData> place;
    place->SetPoints(points);
    vtkNew<vtkGlyph3DMapper> glyphs;
    glyphs->SetInputData(place);
    glyphs->SetSourceConnection(cube->GetOutputPort());
    glyphs->ScalingOff();
    vtkNew<vtkPolyDataMapper> mesh;
    mesh->SetInputConnection(cube->GetOutputPort());
    vtkNew<vtkActor> actor;
    if (glyph)
    {
      actor->SetMapper(glyphs);
    }
    else
    {
      actor->SetMapper(mesh);
      actor->SetPosition(1.0, 1.0, 0.3);
    }
    actor->SetVisibility(visible);
    scene.Renderer->AddActor(actor);
    return scene.Measure(vtkRSMReferencePass::EXACT);
  };
  const Image mesh = measure(false, true);
  CheckAtLeast("light that a block hides: RMSE over the mean",
    RootMeanSquare(measure(false, false), mesh), 0.1, "the test's own power");
  CheckAtMost("a glyph beside a mesh: RMSE over the mean",
    RootMeanSquare(measure(true, true), mesh), 1e-3,
    "the same triangles, pixels at the silhouette, colours in bytes");
}
