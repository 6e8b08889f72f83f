// SPDX-License-Identifier: BSD-3-Clause
// Spheres of mappers hide senders beside voxels: compared with rays, light by light, in double
// precision.
#include "Visibility/vtkIndirectSphereGrid.h"
#include "vtkIndirectBalls.h"
#include "vtkIndirectForcedPath.h"
#include "vtkIndirectVisibilityScene.h"

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkIndirectEstimatorPass.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMath.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlane.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"
#include "vtkRSMReferencePass.h"
#include "vtkSphereSource.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace vtkIndirectTest;

namespace
{
// Spheres drawn by a mapper from points.
struct Balls
{
  vtkNew<vtkPolyData> Points;
  vtkNew<vtkActor> Actor;
  std::vector<Ball> All;

  explicit Balls(vtkMapper* mapper = nullptr)
  {
    vtkNew<vtkOpenGLSphereMapper> spheres;
    spheres->SetScaleArray("size");
    vtkMapper* const own = mapper ? mapper : spheres.Get();
    own->SetInputDataObject(this->Points);
    own->ScalarVisibilityOff();
    this->Actor->SetMapper(own);
    this->Actor->GetProperty()->SetColor(0.8, 0.8, 0.8);
    this->Actor->GetProperty()->SetAmbient(0.0);
    this->Actor->GetProperty()->SetSpecular(0.0);
  }

  void Set(const std::vector<Ball>& balls)
  {
    this->All = balls;
    SetBalls(this->Points, balls);
  }
};

struct SegmentScene : VisibilityScene
{
  using VisibilityScene::VisibilityScene;

  Image Measure(vtkIndirectEstimatorPass* estimator, bool voxels)
  {
    return this->VisibilityScene::Measure(
      estimator, voxels ? vtkIndirectIlluminationPass::VOXELS : vtkIndirectIlluminationPass::NONE);
  }
  Image MeasureReference(int visibility)
  {
    this->Reference->SetVisibility(visibility);
    return this->Measure(this->Reference, visibility == vtkRSMReferencePass::VOXELS);
  }
  std::string GetReport() { return this->Pass->GetReport(); }

  // A ceiling that a spot lights from below, a floor, and an eye that sees the floor.
  void AddFloorAndCeiling(double scale = 1.0, const glm::dvec3& place = glm::dvec3(0.0))
  {
    auto at = [&](double x, double y, double z) { return place + scale * glm::dvec3(x, y, z); };
    this->AddQuad(at(-2, -2, 2), at(-2, 2, 2), at(2, -2, 2), glm::dvec3(0.8));
    this->AddQuad(at(-2, -2, 0), at(2, -2, 0), at(-2, 2, 0), glm::dvec3(0.8));
    const double d = 1.0 / scale;
    this->AddSpot(at(0.0, 0.0, 1.7), at(0.0, 0.0, 2.0), 50.0, 0.0, { 0.0, 0.0, d * d });
    this->SetEye(at(0.0, -4.0, 1.2), at(0, 0, 0.2), { 0, 0, 1 }, 40.0, 0.5 * scale, 9.0 * scale);
  }
};

// True if a ball stands between two positions outside of it: by the nearest point of the segment.
bool Hides(const Ball& ball, const glm::dvec3& a, const glm::dvec3& b)
{
  const glm::dvec3 way = b - a;
  const double t = glm::dot(ball.Center - a, way) / glm::dot(way, way);
  return t > 0.0 && t < 1.0 && glm::length(a + t * way - ball.Center) < ball.Radius &&
    glm::length(a - ball.Center) > ball.Radius && glm::length(b - ball.Center) > ball.Radius;
}

// An image compared with sums over the lights that no ball hides.
struct Comparison
{
  double Bias = 0.0;
  double Error = 0.0;  // RMS over the mean
  double Hidden = 0.0; // share of the light that balls hide
  int Receivers = 0;
};
Comparison Compare(SegmentScene& scene, const Image& image, const std::vector<Ball>& balls)
{
  const std::vector<VirtualLight> lights = scene.CopyLights();
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
  Comparison result;
  double sum = 0.0;
  double open = 0.0;
  double found = 0.0;
  double squares = 0.0;
  for (size_t i = 0; i < receivers.size(); ++i)
  {
    const Scene::Receiver& receiver = receivers[i];
    if (!receiver.Lit)
    {
      continue;
    }
    std::vector<VirtualLight> visible;
    for (const VirtualLight& light : lights)
    {
      if (std::none_of(balls.begin(), balls.end(),
            [&](const Ball& ball) { return Hides(ball, receiver.Position, light.Position); }))
      {
        visible.push_back(light);
      }
    }
    const double expected = Gather(visible, receiver.Position, receiver.Normal).x;
    const double e = image.Values[image.Components * i];
    open += Gather(lights, receiver.Position, receiver.Normal).x;
    sum += expected;
    found += e;
    squares += (e - expected) * (e - expected);
    ++result.Receivers;
  }
  result.Bias = found / sum - 1.0;
  result.Error = std::sqrt(squares / result.Receivers) * result.Receivers / sum;
  result.Hidden = 1.0 - sum / open;
  return result;
}

std::vector<Ball> MakeCrowd(
  int count, double radius, double scale = 1.0, const glm::dvec3& place = glm::dvec3(0.0))
{
  Random random(59);
  std::vector<Ball> balls;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 at(random.Next(-1.5, 1.5), random.Next(-1.5, 1.5), random.Next(0.2, 1.5));
    balls.push_back({ place + scale * at, scale * radius * random.NextMagnitude(0.5, 2.0) });
  }
  return balls;
}

const char* const Origin =
  "one light of 256 at one pixel of a hundred: in single precision a segment passes an outline, or "
  "its end lies in the neighbour";
}

VTK_INDIRECT_TEST(SphereSegmentsAreRays)
{
  // Balls between a lit ceiling and a floor, all estimators: the voxels of these two hide nothing.
  SegmentScene scene(40, 30);
  scene.AddFloorAndCeiling();
  Balls balls;
  balls.Set(MakeCrowd(40, 0.2));
  scene.Renderer->AddActor(balls.Actor);
  const Comparison none = Compare(scene, scene.Measure(scene.Gather, false), {});
  CheckAtMost("without visibility: RMSE over the mean", none.Error, 1e-5, "the test's own sums");
  auto check = [&](const std::string& name, const Image& image)
  {
    const Comparison c = Compare(scene, image, balls.All);
    CheckAtLeast("light that is hidden", c.Hidden, 0.3, "the test's own power");
    CheckAtLeast("receivers", c.Receivers, 600, "the test's own power");
    CheckAtMost(name + ": RMSE over the mean", c.Error, 2e-3, Origin);
  };
  check("gather", scene.Measure(scene.Gather, true));
  check("reference by voxels", scene.MeasureReference(vtkRSMReferencePass::VOXELS));
  check("reference, exact", scene.MeasureReference(vtkRSMReferencePass::EXACT));
  check("multiresolution, compute", scene.Measure(scene.Splatting, true));
  const vtkIndirectForcedPath path("compute=off");
  scene.Splatting->Modified();
  check("multiresolution, fragments", scene.Measure(scene.Splatting, true));
}

VTK_INDIRECT_TEST(SphereSegmentsAlone)
{
  // Only balls: a lit one, one that sees it, small ones between. There are no voxels.
  SegmentScene scene(32, 24);
  Balls balls;
  std::vector<Ball> all = MakeCrowd(60, 0.09);
  for (Ball& ball : all)
  {
    ball.Center.z -= 0.85;
  }
  all.push_back({ { 0.0, 0.0, 3.4 }, 1.9 });
  all.push_back({ { 0.0, 0.0, -3.4 }, 1.9 });
  balls.Set(all);
  scene.Renderer->AddActor(balls.Actor);
  scene.AddSpot({ 0.0, 3.0, 0.9 }, { 0.0, 0.6, 1.7 }, 30.0, 0.0, { 1.0, 0.0, 0.0 });
  scene.SetEye({ 0.0, -6.0, 2.0 }, { 0, 0, -0.8 }, { 0, 0, 1 }, 40.0, 1.0, 12.0);
  const Image image = scene.Measure(scene.Gather, true);
  const Comparison c = Compare(scene, image, all);
  CheckAtLeast("receivers", c.Receivers, 150, "the test's own power");
  CheckAtLeast("light that is hidden", c.Hidden, 0.1, "the test's own power");
  CheckAtMost("RMSE over the mean", c.Error, 2e-3, Origin);
  CheckAtMost("exact reference",
    Compare(scene, scene.MeasureReference(vtkRSMReferencePass::EXACT), all).Error, 2e-3, Origin);
  const std::string report = scene.GetReport();
  Check("the report says by what",
    report.find("segments against 62 spheres of the data") != std::string::npos, report);
  Check("and that nothing is left out",
    report.find("it blocks no indirect light") == std::string::npos, report);
}

VTK_INDIRECT_TEST(SphereSegmentsUmbra)
{
  // A ball that hides the whole lit patch from the floor under it: no light there, and none is lost
  // outside of its shadow.
  SegmentScene scene(48, 36);
  scene.AddQuad({ -2, -2, 0 }, { 2, -2, 0 }, { -2, 2, 0 }, glm::dvec3(0.8));
  scene.AddQuad({ -0.2, -0.2, 2 }, { -0.2, 0.2, 2 }, { 0.2, -0.2, 2 }, glm::dvec3(0.8));
  scene.AddSpot({ 0.0, 0.0, 1.6 }, { 0, 0, 2 }, 20.0, 0.0, { 1.0, 0.0, 0.0 });
  scene.SetEye({ 0.0, 0.0, 8.0 }, { 0, 0, 0 }, { 0, 1, 0 }, 25.0, 0.5, 9.0);
  Balls ball;
  const glm::dvec3 center(0.0, 0.0, 0.8);
  ball.Set({ { center, 0.5 } });
  scene.Renderer->AddActor(ball.Actor);
  const Image image = scene.Measure(scene.Gather, true);
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
  // Cones through the patch's corners: tangents from its outer ones to the ball, on the floor.
  const double apart = 2.0 - center.z;
  const double sine = 0.5 / apart;
  const double tangent = sine / std::sqrt(1.0 - sine * sine);
  const double umbra = 2.0 * tangent - std::sqrt(2.0) * 0.2 * center.z / apart - 0.1;
  const double penumbra = 2.0 * tangent + std::sqrt(2.0) * 0.2 * 2.0 * center.z / apart + 0.6;
  int dark = 0;
  int bright = 0;
  int wrong = 0;
  const std::vector<VirtualLight> lights = scene.CopyLights();
  for (size_t i = 0; i < receivers.size(); ++i)
  {
    const Scene::Receiver& r = receivers[i];
    const double e = image.Values[image.Components * i];
    const double distance = std::hypot(r.Position.x, r.Position.y);
    if (!r.Lit || r.Position.z > 1e-3)
    {
      continue;
    }
    if (distance < umbra)
    {
      ++dark;
      wrong += e > 0.0;
    }
    else if (distance > penumbra)
    {
      ++bright;
      const double open = Gather(lights, r.Position, r.Normal).x;
      wrong += std::abs(e - open) > 1e-5 * open;
    }
  }
  CheckAtLeast("pixels in the umbra", dark, 20, "the test's own power");
  CheckAtLeast("pixels outside of the shadow", bright, 100, "the test's own power");
  CheckEqual("pixels that have light there, or have lost some here", wrong, 0);
}

VTK_INDIRECT_TEST(SphereSegmentsBesideVoxels)
{
  // A wall of polygons and balls: both hide.
  SegmentScene scene(32, 24);
  scene.AddFloorAndCeiling();
  scene.AddBox({ -1.5, -0.2, 0.9 }, { 0.3, 1.5, 1.0 }, glm::dvec3(0.7));
  Balls balls;
  balls.Set(MakeCrowd(25, 0.15));
  scene.Renderer->AddActor(balls.Actor);
  const Image expected = scene.MeasureReference(vtkRSMReferencePass::VOXELS);
  const Image both = scene.Measure(scene.Gather, true);
  CheckAtMost("gather beside the reference: RMSE over the mean", RootMeanSquare(both, expected),
    2e-3, Origin);
  CheckAtMost("multiresolution", RootMeanSquare(scene.Measure(scene.Splatting, true), expected),
    2e-3, Origin);
  const Comparison c = Compare(scene, both, balls.All);
  CheckAtLeast("light that balls hide", c.Hidden, 0.1, "the test's own power");
  CheckAtMost("light over that with balls alone", 1.0 + c.Bias, 0.9, "the test's own power");
  const Image exact = scene.MeasureReference(vtkRSMReferencePass::EXACT);
  CheckRelative("mean beside triangles and balls", both.Mean(), exact.Mean(), 0.05,
    "a wall of 30 voxels is up to one wider on each side");
  const std::string report = scene.GetReport();
  Check("the exact one says both",
    report.find("triangles, and segments against 25 spheres of the data") != std::string::npos,
    report);
}

VTK_INDIRECT_TEST(SphereSegmentsScales)
{
  // Far from the origin, and at the smallest and largest scales of real scenes.
  for (const auto& [scale, place] :
    { std::pair(1e-9, glm::dvec3(0.0)), std::pair(1e6, glm::dvec3(1e4, -3e4, 2e4)) })
  {
    SegmentScene scene(24, 18);
    scene.AddFloorAndCeiling(scale, place);
    scene.SetEye(place + scale * glm::dvec3(0, -4, 1.2), place + scale * glm::dvec3(0, 0, 0.2),
      { 0, 0, 1 }, 40.0, 0.5 * scale, 9.0 * scale);
    Balls balls;
    balls.Set(MakeCrowd(40, 0.2, scale, place));
    scene.Renderer->AddActor(balls.Actor);
    const Comparison c = Compare(scene, scene.Measure(scene.Gather, true), balls.All);
    CheckAtLeast("light that is hidden", c.Hidden, 0.3, "the test's own power");
    CheckAtMost("RMSE over the mean", c.Error, 0.01,
      "places of the report's receivers are off by rounding, as is what they see");
  }
}

VTK_INDIRECT_TEST(SphereSegmentsManyLights)
{
  // More rounds than llvmpipe's loops allow, if one draw tested all lights.
  SegmentScene scene(16, 12);
  scene.AddFloorAndCeiling();
  Balls balls;
  balls.Set(MakeCrowd(4000, 0.02));
  scene.Renderer->AddActor(balls.Actor);
  scene.Sampler->SetNumberOfLights(2500);
  const Image expected = scene.MeasureReference(vtkRSMReferencePass::VOXELS);
  auto check = [&](const std::string& name, vtkIndirectEstimatorPass* estimator)
  {
    CheckAtMost(name + ": RMSE over the mean",
      RootMeanSquare(scene.Measure(estimator, true), expected), 2e-3, Origin);
  };
  check("gather", scene.Gather);
  check("multiresolution, compute", scene.Splatting);
  const vtkIndirectForcedPath path("compute=off");
  scene.Splatting->Modified();
  check("multiresolution, fragments", scene.Splatting);
}

VTK_INDIRECT_TEST(SphereSegmentsLongLists)
{
  // Nested balls, hundreds in a list, with more rounds than a row of lights allows.
  SegmentScene scene(16, 12);
  scene.AddFloorAndCeiling();
  Balls balls;
  std::vector<Ball> crowd = MakeCrowd(900, 0.25);
  for (Ball& ball : crowd)
  {
    ball.Center = glm::dvec3(0.0, 0.0, 1.0) + 0.1 * (ball.Center - glm::dvec3(0.0, 0.0, 1.0));
  }
  balls.Set(crowd);
  scene.Renderer->AddActor(balls.Actor);
  std::vector<glm::dvec4> spheres;
  for (const Ball& ball : crowd)
  {
    spheres.emplace_back(ball.Center, ball.Radius);
  }
  vtkIndirectSphereGrid grid;
  grid.Build(spheres);
  CheckAtLeast("longest list", static_cast<double>(grid.GetLongestList()), 256.0, "its power");
  CheckAtLeast("rounds of a row of lights, if all took four times the mean",
    4.0 * 256.0 * grid.GetNumberOfSteps(), 65536.0, "what llvmpipe has: the test's own power");
  const Comparison c = Compare(scene, scene.Measure(scene.Gather, true), balls.All);
  CheckAtLeast("light that is hidden", c.Hidden, 0.1, "the test's own power");
  CheckAtMost("gather: RMSE over the mean", c.Error, 2e-3, Origin);
  CheckAtMost("multiresolution",
    Compare(scene, scene.Measure(scene.Splatting, true), balls.All).Error, 2e-3, Origin);
}

VTK_INDIRECT_TEST(SphereSegmentsUpdates)
{
  // Lists are rebuilt in the frame in which spheres have moved, and in no other.
  SegmentScene scene(24, 18);
  scene.AddFloorAndCeiling();
  vtkActor* const box = scene.AddBox({ 1.5, 1.5, 0.1 }, { 1.7, 1.7, 0.3 }, glm::dvec3(0.7));
  Balls balls;
  const std::vector<Ball> crowd = MakeCrowd(40, 0.2);
  balls.Set(crowd);
  scene.Renderer->AddActor(balls.Actor);
  auto updates = [&scene]() { return scene.ReadReport("sphere_updates"); };
  scene.Measure(scene.Gather, false);
  CheckEqual("without visibility", updates(), 0);
  scene.Measure(scene.Gather, true);
  CheckEqual("the first frame", updates(), 1);
  scene.SetEye({ 0.3, -4.0, 1.2 }, { 0, 0, 0.2 }, { 0, 0, 1 }, 40.0, 0.5, 9.0);
  scene.Render();
  CheckEqual("the eye has moved", updates(), 1);
  balls.Actor->GetProperty()->SetColor(0.5, 0.8, 0.2);
  box->SetPosition(0.1, 0.0, 0.0);
  scene.Render();
  CheckEqual("another colour, and a box that has moved", updates(), 1);
  scene.Measure(scene.Splatting, true);
  CheckEqual("another estimator", updates(), 1);
  for (int frame = 0; frame < 3; ++frame)
  {
    std::vector<Ball> moved = crowd;
    for (Ball& ball : moved)
    {
      ball.Center.x += 0.1 * (frame + 1) * std::sin(10.0 * ball.Center.y);
    }
    balls.Set(moved);
    const Comparison c = Compare(scene, scene.Measure(scene.Gather, true), moved);
    CheckAtMost("balls that have moved: RMSE over the mean", c.Error, 2e-3, Origin);
    CheckEqual("updates", updates(), frame + 2);
  }
  balls.Set(crowd);
  balls.Actor->SetPosition(0.2, 0.0, 0.0);
  std::vector<Ball> shifted = crowd;
  for (Ball& ball : shifted)
  {
    ball.Center.x += 0.2;
  }
  CheckAtMost("an actor that has moved",
    Compare(scene, scene.Measure(scene.Gather, true), shifted).Error, 2e-3, Origin);
  const double before = updates();
  scene.Measure(scene.Gather, false);
  scene.Measure(scene.Gather, true);
  CheckEqual("asked for again", updates(), before + 1);
  scene.Pass->CachingOff();
  scene.Render();
  scene.Render();
  CheckEqual("two frames without caching", updates(), before + 3);
}

VTK_INDIRECT_TEST(SphereSegmentsKinds)
{
  // Props that count as spheres, and casters among them.
  SegmentScene scene(24, 18);
  scene.AddFloorAndCeiling();
  const std::vector<Ball> crowd = MakeCrowd(40, 0.2);
  auto check = [&](const std::string& name, Balls& balls, const std::vector<Ball>& blockers)
  {
    scene.Renderer->AddActor(balls.Actor);
    const Comparison c = Compare(scene, scene.Measure(scene.Gather, true), blockers);
    CheckAtMost(name + ": RMSE over the mean", c.Error, 3e-3, Origin);
    const double hidden = blockers.empty() ? 0.0 : 0.1;
    CheckAtLeast(name + ": light that is hidden", c.Hidden, hidden, "the test's own power");
    scene.Renderer->RemoveActor(balls.Actor);
  };
  {
    vtkNew<vtkGlyph3DMapper> glyphs;
    vtkNew<vtkSphereSource> source;
    source->SetRadius(1.0);
    source->SetThetaResolution(64);
    source->SetPhiResolution(64);
    glyphs->SetSourceConnection(source->GetOutputPort());
    glyphs->SetScaleArray("size");
    glyphs->SetScaleModeToScaleByMagnitude();
    Balls balls(glyphs);
    balls.Set(crowd);
    check("glyphs", balls, crowd);
    vtkNew<vtkCubeSource> cubes;
    glyphs->SetSourceConnection(cubes->GetOutputPort());
    check("glyphs that are cubes", balls, {});
    scene.Renderer->AddActor(balls.Actor);
    scene.Render();
    Check("are named",
      scene.GetReport().find("there are glyphs that are no spheres") != std::string::npos);
    scene.Renderer->RemoveActor(balls.Actor);
  }
  {
    // Splats clipped by shader code as in ParaView; they have no surface, but look like spheres.
    vtkNew<vtkPointGaussianMapper> splats;
    splats->SetScaleArray("size");
    splats->SetScaleFactor(1.0);
    splats->EmissiveOff();
    splats->SetSplatShaderCode("//VTK::Color::Impl\n"
                               "float distance2 = dot(offsetVCVSOutput.xy,offsetVCVSOutput.xy);\n"
                               "if (distance2 > 1.0) { discard; }\n");
    Balls balls(splats);
    balls.Set(crowd);
    check("splats", balls, crowd);
    vtkNew<vtkInformation> keys;
    keys->Set(vtkIndirectIlluminationPass::CASTS_SHADOWS(), 0);
    balls.Actor->SetPropertyKeys(keys);
    check("splats that cast no shadows", balls, {});
  }
  Balls balls;
  balls.Set(crowd);
  vtkNew<vtkInformation> keys;
  keys->Set(vtkIndirectIlluminationPass::CASTS_SHADOWS(), 0);
  balls.Actor->SetPropertyKeys(keys);
  check("spheres that cast no shadows", balls, {});
  balls.Actor->SetPropertyKeys(nullptr);
  balls.Actor->GetProperty()->SetOpacity(0.5);
  check("translucent ones", balls, {});
  balls.Actor->GetProperty()->SetOpacity(1.0);
  balls.Actor->SetScale(1.0, 1.0, 0.5);
  check("stretched ones", balls, {});
  balls.Actor->SetScale(0.5);
  std::vector<Ball> half = crowd;
  for (Ball& ball : half)
  {
    ball.Center *= 0.5;
    ball.Radius *= 0.5;
  }
  check("smaller ones", balls, half);
  balls.Actor->SetScale(1.0);
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1.0, 0.0, 0.0);
  balls.Actor->GetMapper()->AddClippingPlane(plane);
  std::vector<Ball> right = crowd;
  right.erase(std::remove_if(
                right.begin(), right.end(), [](const Ball& ball) { return ball.Center.x < 0.0; }),
    right.end());
  check("those that a plane leaves", balls, right);
}
