// SPDX-License-Identifier: BSD-3-Clause
// Light of the sky by sums over spheres, against closed forms and rays in double precision.
#include "vtkIndirectProxyRays.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkEnvironmentLight.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkProxyAccumulationPass.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace vtkIndirectTest;

namespace
{
// Irradiance that a sphere wholly above a plane removes: sin^2 cos of a uniform sky.
double OverPlane(const Ball& ball, const glm::dvec3& p)
{
  const glm::dvec3 c = ball.Center - p;
  const double d = glm::length(c);
  return 1.0 - ball.Radius * ball.Radius * c.y / (d * d * d);
}

std::vector<Ball> MakeCluster(int count, double scale)
{
  Random random(21);
  std::vector<Ball> balls;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 d = std::cbrt(random.Next()) * random.NextDirection();
    balls.push_back(
      { scale * (glm::dvec3(0.2, 1.2, 0.0) + 0.7 * d), scale * random.Next(0.05, 0.1) });
  }
  return balls;
}

void Force(const char* paths)
{
  paths ? setenv("VTK_INDIRECT_PATHS", paths, 1) : unsetenv("VTK_INDIRECT_PATHS");
}

double LargestDifference(const Image& a, const Image& b)
{
  double largest = 0.0;
  for (size_t i = 0; i < a.Values.size(); ++i)
  {
    largest = std::max(largest, std::abs(static_cast<double>(a.Values[i]) - b.Values[i]));
  }
  return largest;
}

// Share of pixels whose values differ by more than `least`.
double ShareThatDiffers(const Image& a, const Image& b, double least)
{
  size_t count = 0;
  for (size_t i = 0; i < a.Values.size(); ++i)
  {
    count += std::abs(static_cast<double>(a.Values[i]) - b.Values[i]) > least ? 1 : 0;
  }
  return static_cast<double>(count) / static_cast<double>(a.Values.size());
}
}

VTK_INDIRECT_TEST(ProxiesSphereOverAPlane)
{
  // In a millionth and a million times the size, too.
  for (const double scale : { 1.0, 1e-9, 1e6 })
  {
    ProxyScene scene(scale);
    for (const double height : { 1.0, 1.5 })
    {
      const Ball ball = { scale * glm::dvec3(0.3, height, 0.0), scale };
      scene.SetBalls({ ball });
      CompareLight(
        scene, "sky", OnGround,
        [&](const Scene::Receiver& r) { return OverPlane(ball, r.Position); },
        { 0.01, 0.015, "order 4 cuts what is seen: 0.3 % in the mean of all distances" },
        "scale " + std::to_string(scale));
      CheckEqual("spheres", scene.Proxies->GetNumberOfSpheres(), 1.0);
      CheckEqual("polygons", scene.Proxies->GetNumberOfPolygons(), 1.0);
    }
  }
}

VTK_INDIRECT_TEST(ProxiesMeshesThatAreSpheres)
{
  // The same for a mesh, moved and scaled by its actor; and for spheres given by a user.
  ProxyScene scene;
  vtkActor* mesh = scene.AddSphere({ 0, 0, 0 }, 0.5, 48, White);
  mesh->SetScale(2.0);
  mesh->SetPosition(-0.4, 1.3, 0.2);
  const Ball ball = { { -0.4, 1.3, 0.2 }, 1.0 };
  auto expect = [&](const Scene::Receiver& r) { return OverPlane(ball, r.Position); };
  CompareLight(scene, "sky", OnGround, expect, { 0.01, 0.015, "as of points" });
  CheckEqual("spheres", scene.Proxies->GetNumberOfSpheres(), 1.0);
  vtkNew<vtkPolyData> given;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radius");
  radii->InsertNextValue(0.25);
  given->SetPoints(points);
  given->GetPointData()->AddArray(radii);
  scene.Proxies->SetProxies(mesh, given);
  const Ball half = { ball.Center, 0.5 };
  CompareLight(scene, "sky", OnGround,
    [&](const Scene::Receiver& r) { return OverPlane(half, r.Position); },
    { 0.01, 0.015, "half the radius, given" });
  scene.Proxies->SetProxies(mesh, nullptr);
  CompareLight(scene, "sky", OnGround, expect, { 0.01, 0.015, "as before" });
}

VTK_INDIRECT_TEST(ProxiesTwoSpheres)
{
  ProxyScene scene;
  for (const double apart : { 2.2, 1.0, 0.0 })
  {
    const std::vector<Ball> balls = { { { -0.5 * apart, 1.2, 0 }, 0.7 },
      { { 0.5 * apart, 1.2 + 0.3 * (2.2 - apart), 0 }, 0.7 } };
    scene.SetBalls(balls);
    // Side by side the spheres are separate; one behind the other counts twice a part that order 4
    // blurs.
    const double bias = apart > 2.0 ? 0.01 : 0.04;
    CompareLight(
      scene, "sky", OnGround, [&](const Scene::Receiver& r) { return Open(balls, r.Position); },
      { bias, 2.0 * bias, "stated bias: logarithms add up what is hidden twice" },
      std::to_string(apart) + " apart");
  }
}

VTK_INDIRECT_TEST(ProxiesCluster)
{
  // 200 spheres, many behind each other. With groups the bias is within the goal.
  const std::vector<Ball> balls = MakeCluster(200, 1.0);
  ProxyScene scene;
  scene.SetBalls(balls);
  CompareLight(scene, "sky", OnGround,
    [&](const Scene::Receiver& r) { return Open(balls, r.Position); },
    { 0.03, 0.06, "goals of the method: 3 % and 0.1" });
  const Image groups = scene.Copy("sky");
  scene.Proxies->GroupsOff();
  scene.Proxies->SetInfluenceScale(1000.0);
  scene.Render();
  Check("single spheres hide too much", scene.Copy("sky").Mean() < groups.Mean());
  scene.Proxies->SetInfluenceScale(15.0);
  scene.Render();
  CheckAtLeast("cut off at 15 radii, by so much", LargestDifference(scene.Copy("sky"), groups),
    0.02, "what lies beyond adds up");
}

VTK_INDIRECT_TEST(ProxiesChoicesAreTheSame)
{
  // Tiles or the tree in compute shaders, and blended rectangles.
  for (const bool groups : { true, false })
  {
    for (const int step : { 1, 4 })
    {
      Image sky[2];
      Image bounce[2];
      Image normal;
      for (int i = 0; i < 2; ++i)
      {
        Force(i ? "compute=off" : "compute=on");
        ProxyScene scene;
        scene.SetBalls(MakeCluster(300, 1.0));
        scene.Proxies->SetGroups(groups);
        scene.Proxies->SetReceiverStep(step);
        scene.Render();
        sky[i] = scene.Copy("sky");
        bounce[i] = scene.Copy("bounce");
        normal = scene.Copy("normal");
      }
      Force(nullptr);
      const std::string name =
        std::string(groups ? "groups" : "spheres") + ", step " + std::to_string(step);
      Check(name + ": there is light", sky[0].Mean() > 0.2 && bounce[0].Mean() > 0.002);
      if (step == 1)
      {
        CheckAtMost(
          name + ": sky", LargestDifference(sky[0], sky[1]), 2e-3, "sums in another order");
        CheckAtMost(name + ": bounce", LargestDifference(bounce[0], bounce[1]), 2e-3,
          "the same; the side on which a sender is open may turn");
        continue;
      }
      const char* const why =
        "pixels that no receiver serves share some in tiles, and are summed "
        "by themselves in rectangles; more of them since no receiver serves a "
        "normal 46 degrees from its own: 0.018 and 0.031 measured";
      CheckAtMost(
        name + ": pixels whose sky differs", ShareThatDiffers(sky[0], sky[1], 2e-3), 0.02, why);
      CheckAtMost(name + ": sky, RMS", FindRelativeError(sky[0], sky[1], normal), 0.035, why);
      CheckAtMost(
        name + ": bounce, mean", std::abs(bounce[0].Mean() / bounce[1].Mean() - 1.0), 0.02, why);
    }
  }
}

VTK_INDIRECT_TEST(ProxiesFewerReceivers)
{
  const std::vector<Ball> balls = MakeCluster(200, 1.0);
  ProxyScene scene(1.0, 144);
  scene.SetBalls(balls);
  scene.Render();
  const Image full = scene.Copy("sky");
  const Image normal = scene.Copy("normal");
  const double limits[] = { 0.02, 0.04, 0.08 };
  for (int i = 0; i < 3; ++i)
  {
    scene.Proxies->SetReceiverStep(2 << i);
    scene.Render();
    CheckAtMost("a receiver in " + std::to_string((2 << i) * (2 << i)) + " pixels",
      FindRelativeError(scene.Copy("sky"), full, normal), limits[i],
      "spheres of 3 to 7 pixels; 0.017, 0.032 and 0.050 measured");
    CheckEqual("the step in force", scene.ReadReport("ReceiverStep"), 2 << i);
  }
}

VTK_INDIRECT_TEST(ProxiesUpsampling)
{
  // Equation (11) and bilinear upsampling in doubles, from a receiver at every pixel.
  constexpr int step = 4;
  ProxyScene scene(1.0, 144);
  scene.SetBalls(MakeCluster(40, 1.0));
  scene.Proxies->SetPreset(vtkIndirectEstimatorPass::PAPER);
  scene.Proxies->SetReceiverStep(1);
  scene.Render();
  const Image full = scene.Copy("sky");
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const double* place = camera->GetPosition();
  const double* way = camera->GetDirectionOfProjection();
  const glm::dvec3 eye(place[0], place[1], place[2]);
  const glm::dvec3 forward(way[0], way[1], way[2]);
  const double pixel =
    2.0 * std::tan(0.5 * glm::radians(camera->GetViewAngle())) / full.Height; // at depth one
  auto depth = [&](size_t i) { return glm::dot(receivers[i].Position - eye, forward); };
  auto find = [&](int x, int y) { return static_cast<size_t>(y) * full.Width + x; };
  scene.Proxies->SetReceiverStep(step);
  Image found[2];
  for (const int upsampling :
    { vtkProxyAccumulationPass::BILATERAL, vtkProxyAccumulationPass::BILINEAR })
  {
    scene.Proxies->SetUpsampling(upsampling);
    scene.Render();
    const Image image = scene.Copy("sky");
    const bool bilateral = upsampling == vtkProxyAccumulationPass::BILATERAL;
    found[bilateral ? 0 : 1] = image;
    double worst = 0.0;
    int count = 0;
    for (size_t i = 0; i < receivers.size(); ++i)
    {
      const int x = receivers[i].X;
      const int y = receivers[i].Y;
      const int column = x / step;
      const int row = y / step;
      if (!receivers[i].Lit || (column + 1) * step >= full.Width || (row + 1) * step >= full.Height)
      {
        continue;
      }
      double sum = 0.0;
      double weights = 0.0;
      for (int k = 0; k < 4; ++k)
      {
        const int right = k & 1;
        const int above = k >> 1;
        const size_t other = find((column + right) * step, (row + above) * step);
        const double across = static_cast<double>(x % step) / step;
        const double along = static_cast<double>(y % step) / step;
        double weight = (right ? across : 1.0 - across) * (above ? along : 1.0 - along) + 1e-3;
        if (bilateral)
        {
          const double width = step * pixel * depth(i);
          const double same =
            std::pow(std::max(glm::dot(receivers[i].Normal, receivers[other].Normal), 0.0), 32) *
            width / (width + std::abs(depth(i) - depth(other)));
          weight *= same > 0.05 ? same : 0.0;
        }
        weight = receivers[other].Lit ? weight : 0.0;
        sum += weight * full.Values[3 * other];
        weights += weight;
      }
      if (weights > 1e-2)
      {
        ++count;
        worst = std::max(worst, std::abs(image.Values[3 * i] - sum / weights));
      }
    }
    const std::string name = bilateral ? "bilateral: " : "bilinear: ";
    CheckAtLeast(name + "pixels", count, 5000, "the test's own power");
    CheckAtMost(name + "difference to the weighted mean, worst", worst, 2e-3,
      "normals of 15 bits, to the power 32");
  }
  CheckAtLeast("difference between both", LargestDifference(found[0], found[1]), 0.1,
    "the test's own power: fringes along edges");
}

VTK_INDIRECT_TEST(ProxiesSendLight)
{
  // A white sphere over a plane, both under a uniform sky. Only the sky beside the plane lights the
  // sphere's lower half; without shadows the whole sky does.
  ProxyScene scene;
  const Ball ball = { { 0.3, 1.5, 0.0 }, 1.0 };
  scene.SetBalls({ ball });
  scene.Proxies->SetIndirectLightToAveraged();
  CompareLight(
    scene, "bounce", OnGround,
    [&](const Scene::Receiver& r) { return 1.0 - OverPlane(ball, r.Position); },
    { 0.05, 0.1, "in all of a uniform sky a white sphere is as bright as that; disks of order 3" },
    "unshadowed");
  const double whole = scene.Copy("bounce").Mean();
  scene.Proxies->SetIndirectLightToExact();
  scene.Render();
  CheckRelative("each place as its normal has it, in light that is the same for all of them",
    scene.Copy("bounce").Mean(), whole, 1e-3, "entries of the operator");
  scene.Proxies->SetIndirectLightToShadowed();
  scene.Render();
  const double shadowed = scene.Copy("bounce").Mean();
  Check("the plane hides the sky from it", shadowed < 0.8 * whole && shadowed > 0.05 * whole,
    std::to_string(shadowed / whole));
  scene.Atoms->GetProperty()->SetColor(0.0, 0.0, 0.0);
  scene.Render();
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
  const Image dark = scene.Copy("bounce");
  double most = 0.0;
  for (size_t i = 0; i < receivers.size(); ++i)
  {
    most = std::max(most, receivers[i].Lit && OnGround(receivers[i]) ? dark.Values[3 * i] : 0.0);
  }
  CheckEqual("a black one sends nothing", most, 0.0);
  scene.Proxies->SetIndirectLightToOff();
  scene.Render();
  CheckEqual("nor does it when it is not asked for", scene.Copy("bounce").Mean(), 0.0);
}

VTK_INDIRECT_TEST(ProxiesMove)
{
  // In every frame moving spheres give the same as a new pass.
  ProxyScene moving;
  Image last;
  std::vector<Ball> balls = MakeCluster(60, 1.0);
  for (int frame = 0; frame < 4; ++frame)
  {
    for (Ball& ball : balls)
    {
      ball.Center += glm::dvec3(0.05, 0.02 * std::sin(8.0 * ball.Center.x), -0.03);
    }
    moving.SetBalls(balls);
    moving.Render();
    const Image now = moving.Copy("sky");
    Check("it moves", frame == 0 || LargestDifference(now, last) > 1e-3);
    last = now;
  }
  ProxyScene fresh;
  fresh.SetBalls(balls);
  fresh.Render();
  CheckAtMost("a fresh pass", LargestDifference(fresh.Copy("sky"), last), 3e-3,
    "units of another scene, whose rounding what touches its own sphere magnifies");
  moving.Render();
  CheckEqual("a still one is that of the fresh pass",
    LargestDifference(moving.Copy("sky"), fresh.Copy("sky")), 0.0);
}

VTK_INDIRECT_TEST(ProxiesHardCases)
{
  const std::vector<std::pair<std::string, std::vector<Ball>>> cases = {
    { "nothing", {} },
    { "radius 0", { { { 0, 1, 0 }, 0.0 } } },
    { "around a receiver", { { { 0, 0.2, 0 }, 1.0 } } },
    { "around all of them", { { { 0, 1, 0 }, 50.0 } } },
    { "at a receiver", { { { 0, 0, 0 }, 0.3 } } },
    { "a point", { { { 0, 1, 0 }, 1e-6 } } },
    { "below", { { { 0, -2, 0 }, 1.0 } } },
    { "at one place", std::vector<Ball>(2000, { { 0, 1, 0 }, 0.5 }) },
  };
  for (const auto& entry : cases)
  {
    for (const bool groups : { true, false })
    {
      ProxyScene scene(1.0, 40);
      scene.SetBalls(entry.second);
      scene.Proxies->SetGroups(groups);
      scene.Render();
      // VTK also draws spheres around the eye, behind it.
      const Image bounce = scene.Copy("bounce");
      Check(entry.first + ": finite",
        std::isfinite(bounce.Mean()) && std::isfinite(scene.Copy("sky").Mean()));
      if (entry.second.size() != 1 || entry.second.front().Radius < 10.0)
      {
        scene.CheckBuffers(0);
      }
      const double mean = scene.Copy("sky").Mean();
      Check(entry.first + ": in range", mean >= 0.0 && mean < 1.02, std::to_string(mean));
    }
  }
  ProxyScene scene(1.0, 40);
  scene.SetBalls(std::vector<Ball>(100000, { { 0, 1.2, 0 }, 1.0 }));
  const Ball one = { { 0, 1.2, 0 }, 1.0 };
  CompareLight(
    scene, "sky", OnGround, [&](const Scene::Receiver& r) { return OverPlane(one, r.Position); },
    { 0.01, 0.015, "they are one" }, "100,000 at one place");
  // Nearly at one place, so that none contains another: sums of many logarithms stay finite.
  Random random(2);
  std::vector<Ball> near;
  for (int i = 0; i < 5000; ++i)
  {
    near.push_back({ glm::dvec3(0, 1.2, 0) + 0.02 * random.NextDirection(), 1.0 });
  }
  scene.SetBalls(near);
  scene.Render();
  scene.CheckBuffers(0);
}

VTK_INDIRECT_TEST(ProxiesUnderASun)
{
  // 10,000 times as bright as the sky, in four degrees: in order 4 as broad as a cosine.
  ProxyScene scene;
  scene.SetBalls(MakeCluster(50, 1.0));
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 32, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  auto* p = static_cast<float*>(image->GetScalarPointer());
  std::fill(p, p + 64 * 32 * 3, 1.0f);
  auto* bright = static_cast<float*>(image->GetScalarPointer(20, 26, 0));
  std::fill(bright, bright + 3, 1e4f);
  scene.Sky->SetImage(image);
  scene.Render();
  scene.CheckBuffers(0);
  double open = 1.0; // irradiance of the open plane
  for (int x = 0; x < 64; ++x)
  {
    for (int y = 16; y < 32; ++y)
    {
      const double low = std::sin(vtkMath::Pi() * (y / 32.0 - 0.5));
      const double high = std::sin(vtkMath::Pi() * ((y + 1) / 32.0 - 0.5));
      const double share = 0.5 * (high * high - low * low) * 2.0 / 64.0;
      open += x == 20 && y == 26 ? (1e4 - 1.0) * share : 0.0;
    }
  }
  // In a corner, where the cluster hides little.
  double found = 0.0;
  for (const Scene::Receiver& r : scene.GetReceivers())
  {
    if (r.Lit && OnGround(r) && r.Position.x < -2.0 && r.Position.z > 1.0)
    {
      found = std::max(found, scene.Copy("sky").Color(r.X, r.Y).x);
      break;
    }
  }
  CheckRelative("irradiance of the open ground", found, open, 0.15,
    "order 3 of a clamped cosine, 60 degrees from it, and some shadow");
}
