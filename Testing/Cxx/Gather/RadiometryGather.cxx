// SPDX-License-Identifier: BSD-3-Clause
// The gather's sums, against the same sums on the CPU in double precision.
#include "Maps/vtkIndirectLightMaps.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkRSMGatherPass.h"
#include "vtkRSMReferencePass.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
// A room without a front, a ball in it, lit by a spot.
struct Room : Scene
{
  vtkLight* Spot;

  Room(int width, int height)
    : Scene(width, height)
  {
    this->AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0.75, 0.75, 0.5 });
    this->AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.75, 0.125, 0.125 });
    this->AddQuad({ 1, 0, 0 }, { 1, 0, 1 }, { 1, 1, 0 }, { 0.125, 0.75, 0.125 });
    this->AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.75, 0.75, 0.75 });
    this->AddSphere({ 0.6, 0.25, 0.5 }, 0.2, 64, { 0.5, 0.5, 0.75 });
    this->Spot = this->AddSpot({ 0.5, 0.95, 0.7 }, { 0.35, 0, 0.4 }, 50, 1, { 0.2, 0, 1 });
    this->SetEye({ 0.5, 0.5, 2.6 }, { 0.5, 0.45, 0.5 }, { 0, 1, 0 }, 32, 0.5, 5);
  }
};

bool IsOfWall(const glm::dvec3& normal)
{
  return std::max({ std::abs(normal.x), std::abs(normal.y), std::abs(normal.z) }) > 0.99999;
}

// The texels of a map as lights, from its buffers and the map's geometry, in double precision. The
// area is that of a texel on the walls; on the ball, whose geometric normal is in no buffer, it is
// copied from the lights.
std::vector<VirtualLight> LightsFromMap(
  Scene& scene, int index, const std::vector<VirtualLight>& areas, size_t& next)
{
  const vtkIndirectLightMap& map =
    vtkIndirectLightMaps::Get(scene.Pass->GetReflectiveShadowMaps()).GetMap(index);
  const std::string name = "rsm" + std::to_string(index);
  const Image depth = scene.Copy(name + ".depth");
  const Image normal = scene.Copy(name + ".normal");
  const Image density = scene.Copy(name + ".density");
  const int n = depth.Height;
  const bool parallel = map.Projection == 0;
  const double halfWidth = map.HalfWidth / (parallel ? map.SceneScale : 1.0); // world lengths
  std::vector<VirtualLight> lights;
  for (int face = 0; face < map.NumberOfFaces; ++face)
  {
    // Face to world, without the scene's scale.
    const glm::dmat4 toScene = map.Faces[face].GetToScene();
    const glm::dvec3 eye(glm::inverse(map.WorldToLight)[3]);
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const int x = face * n + i;
        const double u = halfWidth * (2.0 * (i + 0.5) / n - 1.0);
        const double v = halfWidth * (2.0 * (j + 0.5) / n - 1.0);
        const double h = 2.0 * halfWidth / n;
        const double d = depth.At(x, j)[0];
        const glm::dvec3 p = parallel ? glm::dvec3(u, v, -d) : glm::dvec3(u * d, v * d, -d);
        const double footprint = parallel ? h * h : h * h * std::pow(1.0 + u * u + v * v, -1.5);
        VirtualLight light;
        light.Position = eye + glm::dmat3(toScene) * p;
        light.Normal = normal.Color(x, j);
        light.DensityArea = density.Color(x, j) * map.Light.Color * footprint;
        const double cosine = parallel
          ? glm::dot(light.Normal, -map.Light.DirectionWC)
          : glm::dot(light.Normal, glm::normalize(eye - light.Position));
        light.Area = IsOfWall(light.Normal) && cosine > 0.05
          ? footprint * (parallel ? 1.0 : glm::dot(p, p)) / cosine
          : areas[next % areas.size()].Area;
        light.Source = map.Light.Index;
        ++next;
        lights.push_back(light);
      }
    }
  }
  return lights;
}

void CheckReference(Room& scene, int maps)
{
  scene.Render();
  const std::vector<VirtualLight> gpu = scene.CopyLights();
  std::vector<VirtualLight> lights;
  size_t next = 0;
  for (int i = 0; i < maps; ++i)
  {
    const std::vector<VirtualLight> some = LightsFromMap(scene, i, gpu, next);
    lights.insert(lights.end(), some.begin(), some.end());
  }
  if (!CheckEqual("virtual lights", gpu.size(), lights.size()))
  {
    return;
  }
  double position = 0.0;
  double normal = 0.0;
  double facet = 0.0;
  double density = 0.0;
  double area = 0.0;
  double largest = 0.0;
  int lit = 0;
  for (const VirtualLight& light : lights)
  {
    largest = std::max(largest, light.DensityArea.x);
  }
  for (size_t i = 0; i < gpu.size(); ++i)
  {
    density = std::max(density, glm::length(gpu[i].DensityArea - lights[i].DensityArea) / largest);
    if (glm::length(lights[i].Normal) > 0.5)
    {
      ++lit;
      position = std::max(position, glm::length(gpu[i].Position - lights[i].Position));
      double& worst = IsOfWall(lights[i].Normal) ? normal : facet;
      worst = std::max(worst, glm::length(gpu[i].Normal - lights[i].Normal));
      area = std::max(area, std::abs(gpu[i].Area / lights[i].Area - 1.0));
    }
  }
  CheckAtLeast("texels that hold a surface", lit, 1000, "the test's own power");
  CheckAtMost(
    "worst distance between a light and its texel", position, 2e-6, "floats in a room of one");
  CheckAtMost("worst difference of normals on the walls", normal, 1e-6, "floats");
  // Half the diagonal of a facet of 64 by 64, 2 pi / 64 by pi / 64, is 0.055.
  CheckAtMost("on the ball, whose facets send", facet, 0.056, "half a facet's diagonal");
  CheckAtMost("worst relative difference of areas on the walls", area, 1.1e-3,
    "the cosine is stored in half floats; drivers may cut them off, 2^-10");
  CheckAtMost("worst difference of B A, of the largest", density, 1e-5, "floats");

  // Areas and facets' normals as stored; both are checked above.
  std::vector<VirtualLight> senders = lights;
  for (size_t i = 0; i < gpu.size(); ++i)
  {
    senders[i].Area = gpu[i].Area;
    senders[i].Normal = gpu[i].Normal;
  }
  const Image irradiance = scene.Copy("irradiance");
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
  std::vector<double> errors;
  double mean = 0.0;
  double meanGPU = 0.0;
  for (int y = 0; y < irradiance.Height; ++y)
  {
    for (int x = 0; x < irradiance.Width; ++x)
    {
      const Scene::Receiver& r = receivers[y * irradiance.Width + x];
      if (!r.Lit)
      {
        continue;
      }
      const glm::dvec3 expected = Gather(senders, r.Position, r.Normal);
      const glm::dvec3 value = irradiance.Color(x, y);
      mean += expected.x + expected.y + expected.z;
      meanGPU += value.x + value.y + value.z;
      for (int c = 0; c < 3; ++c)
      {
        errors.push_back(expected[c] > 0.0 ? std::abs(value[c] / expected[c] - 1.0) : value[c]);
      }
    }
  }
  CheckAtLeast("receivers", errors.size() / 3.0, 1000, "the test's own power");
  CheckRelative("mean irradiance", meanGPU, mean, 1e-5, "rounding");
  CheckAtMost("99.9th percentile of the relative error", Percentile(errors, 0.999), 1e-4,
    "rounding of floats, largest where walls meet");
  Check("another kernel would be rejected: r^2 + A / pi without the bound",
    [&]()
    {
      double sum = 0.0;
      for (size_t i = 0; i < receivers.size(); ++i)
      {
        std::vector<VirtualLight> points = lights;
        if (i % 97 == 0 && receivers[i].Lit)
        {
          for (VirtualLight& light : points)
          {
            light.Area = 0.0;
          }
          const double with = Gather(lights, receivers[i].Position, receivers[i].Normal).x;
          const double without = Gather(points, receivers[i].Position, receivers[i].Normal).x;
          sum = std::max(sum, std::abs(without / with - 1.0));
        }
      }
      return sum > 1e-4;
    }());
  scene.CheckBuffers(maps);

  // The module's own double-precision sum, against the one of this test.
  vtkNew<vtkRSMReferencePass> reference;
  scene.Pass->SetEstimator(reference);
  scene.Render();
  const Image oracle = scene.Copy("irradiance");
  std::vector<double> differences;
  for (size_t i = 0; i < receivers.size(); ++i)
  {
    if (receivers[i].Lit)
    {
      const double expected = Gather(gpu, receivers[i].Position, receivers[i].Normal).x;
      const double value = oracle.Values[3 * i];
      differences.push_back(expected > 0.0 ? std::abs(value / expected - 1.0) : value);
    }
  }
  CheckAtMost("vtkRSMReferencePass, 99.9th percentile of the relative error",
    Percentile(differences, 0.999), 1e-4, "receivers from float buffers, largest where walls meet");
  scene.Pass->SetEstimator(scene.Gather);
}
}

VTK_INDIRECT_TEST(AllTexelsSpot)
{
  Room scene(64, 48);
  scene.Pass->SetReflectiveShadowMapResolution(96);
  CheckReference(scene, 1);
}

VTK_INDIRECT_TEST(AllTexelsTwoLights)
{
  Room scene(48, 36);
  scene.Pass->SetReflectiveShadowMapResolution(40);
  scene.AddDirectional({ -0.4, -0.5, -0.7 })->SetColor(0.5, 1.0, 0.25);
  scene.AddPoint({ 0.3, 0.6, 0.8 }, { 0, 0, 3 })->SetIntensity(0.7);
  CheckReference(scene, 3);
}

VTK_INDIRECT_TEST(LightLinearity)
{
  Room scene(40, 30);
  scene.Pass->SetReflectiveShadowMapResolution(48);
  vtkLight* sun = scene.AddDirectional({ -0.4, -0.5, -0.7 });
  sun->SetColor(0.5, 1.0, 0.25);
  auto measure = [&](bool first, bool second)
  {
    scene.Spot->SetSwitch(first);
    sun->SetSwitch(second);
    scene.Render();
    return scene.Copy("irradiance");
  };
  const Image both = measure(true, true);
  const Image a = measure(true, false);
  const Image b = measure(false, true);
  double worst = 0.0;
  for (size_t i = 0; i < both.Values.size(); ++i)
  {
    const double sum = double(a.Values[i]) + b.Values[i];
    worst = std::max(worst, sum > 0.0 ? std::abs(both.Values[i] / sum - 1.0) : both.Values[i]);
  }
  CheckAtLeast("mean irradiance of the first light", a.Mean(), 1e-3, "the test's own power");
  CheckAtLeast("mean irradiance of the second light", b.Mean(), 1e-3, "the test's own power");
  CheckAtMost("two lights over the sum of each, worst", worst, 1e-5, "rounding of sums");

  for (double intensity : { 1e-12, 1e12 })
  {
    scene.Spot->SetIntensity(intensity);
    const Image scaled = measure(true, false);
    double deviation = 0.0;
    for (size_t i = 0; i < a.Values.size(); ++i)
    {
      const double expected = a.Values[i] * intensity;
      deviation = std::max(deviation,
        expected > 0.0 ? std::abs(scaled.Values[i] / expected - 1.0) : double(scaled.Values[i]));
    }
    CheckAtMost("intensity " + std::to_string(std::log10(intensity)) + " decades: worst deviation",
      deviation, 1e-5, "rounding");
    scene.CheckBuffers(1);
  }
  scene.Spot->SetIntensity(1.0);
  scene.Spot->SetColor(0.25, 0.5, 0.0);
  const Image colored = measure(true, false);
  CheckRelative("a quarter of red light", colored.Mean(0) / a.Mean(0), 0.25, 1e-5, "rounding");
  CheckRelative("half of green light", colored.Mean(1) / a.Mean(1), 0.5, 1e-5, "rounding");
  CheckEqual("no blue light", colored.Mean(2), 0.0);
}

VTK_INDIRECT_TEST(Neighborhood)
{
  Room scene(24, 18);
  const int n = 64;
  scene.Pass->SetReflectiveShadowMapResolution(n);
  scene.Render();
  const std::vector<VirtualLight> areas = scene.CopyLights();
  size_t next = 0;
  const std::vector<VirtualLight> lights = LightsFromMap(scene, 0, areas, next);
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
  const vtkIndirectLightMap& map =
    vtkIndirectLightMaps::Get(scene.Pass->GetReflectiveShadowMaps()).GetMap(0);
  const glm::dmat4 worldToFace = map.WorldToLight;
  const double halfWidth = map.HalfWidth;

  for (double radius : { 0.15, 1.5 })
  {
    // The sum restricted to the disk: texels on its rim count by their covered share.
    std::vector<double> expected;
    std::vector<bool> inside;
    double mean = 0.0;
    for (const Scene::Receiver& r : receivers)
    {
      double sum = 0.0;
      const glm::dvec3 p = glm::dvec3(worldToFace * glm::dvec4(r.Position, 1.0));
      inside.push_back(false);
      if (r.Lit && p.z < 0.0)
      {
        const glm::dvec2 at = 0.5 * glm::dvec2(p) / (-p.z * halfWidth) + 0.5;
        inside.back() = std::max(std::abs(at.x - 0.5), std::abs(at.y - 0.5)) < 0.5;
        for (int j = 0; j < n; ++j)
        {
          for (int i = 0; i < n; ++i)
          {
            const glm::dvec2 texel((i + 0.5) / n, (j + 0.5) / n);
            const double distance = glm::length(texel - at);
            double share = distance < radius ? 1.0 : 0.0;
            if (std::abs(distance - radius) < 1.0 / n)
            {
              share = 0.0;
              for (int k = 0; k < 64; ++k)
              {
                const glm::dvec2 part =
                  texel + (glm::dvec2(k % 8 + 0.5, k / 8 + 0.5) / 8.0 - 0.5) / double(n);
                share += glm::length(part - at) < radius ? 1.0 / 64.0 : 0.0;
              }
            }
            if (share > 0.0)
            {
              sum += share * Gather({ lights[j * n + i] }, r.Position, r.Normal).x;
            }
          }
        }
      }
      mean += sum / receivers.size();
      expected.push_back(sum);
    }

    scene.Gather->SetModeToNeighborhood();
    scene.Gather->SetNeighborhoodRadius(radius);
    double rmse[2] = {};
    for (int k = 0; k < 2; ++k)
    {
      scene.Gather->SetNumberOfSamples(k == 0 ? 512 : 16384);
      scene.Render();
      const Image irradiance = scene.Copy("irradiance");
      double sum = 0.0;
      for (size_t i = 0; i < expected.size(); ++i)
      {
        const double value = irradiance.Values[3 * i];
        sum += value / expected.size();
        rmse[k] += (value - expected[i]) * (value - expected[i]) / expected.size();
      }
      rmse[k] = std::sqrt(rmse[k]) / mean;
      const std::string what =
        "radius " + std::to_string(radius) + ", " + (k == 0 ? "512" : "16384") + " samples: ";
      CheckRelative(what + "mean over the sum in the disk", sum, mean, k == 0 ? 0.05 : 0.005,
        "sampling; with xi^2 for xi it would be 0.67");
      CheckAtMost(what + "RMSE of the mean", rmse[k], k == 0 ? 0.2 : 0.02, "sampling");
    }
    CheckAtMost("radius " + std::to_string(radius) + ": error falls with samples", rmse[1],
      0.5 * rmse[0], "at least as a random pattern's, 1 / sqrt(32)");
    scene.Gather->SetModeToAllTexels();
    scene.Render();
    const Image all = scene.Copy("irradiance");
    double sums[2] = {};
    int receiversInside = 0;
    for (size_t i = 0; i < expected.size(); ++i)
    {
      if (inside[i])
      {
        ++receiversInside;
        sums[0] += expected[i];
        sums[1] += all.Values[3 * i];
      }
    }
    CheckAtLeast("receivers in the map", receiversInside, 50, "the test's own power");
    if (radius > 1.0)
    {
      CheckRelative(
        "a disk over the whole map against all texels", sums[0], sums[1], 1e-4, "rounding");
    }
    else
    {
      CheckAtMost(
        "a small disk's share of all texels", sums[0] / sums[1], 0.9, "the test's own power");
    }
  }
}

namespace
{
// RMSE over the mean, and relative error of the mean, of an interpolated frame.
struct Deviation
{
  double RMSE = 0.0;
  double Mean = 0.0;
  double Different = 0.0; // share of values that differ from the gathered ones
};

Deviation CompareInterpolated(Scene& scene, const Image& full, int step)
{
  scene.Gather->InterpolationOn();
  scene.Gather->SetInterpolationStep(step);
  scene.Render();
  const Image coarse = scene.Copy("irradiance");
  Deviation result;
  const double share = 1.0 / full.Values.size();
  double mean = 0.0;
  for (size_t i = 0; i < full.Values.size(); ++i)
  {
    mean += full.Values[i] * share;
    result.RMSE += std::pow(double(coarse.Values[i]) - full.Values[i], 2.0) * share;
    result.Mean += (double(coarse.Values[i]) - full.Values[i]) * share;
    result.Different += coarse.Values[i] != full.Values[i] ? share : 0.0;
  }
  result.RMSE = std::sqrt(result.RMSE) / mean;
  result.Mean /= mean;
  return result;
}
}

VTK_INDIRECT_TEST(Interpolation)
{
  // Smooth: a wall that hangs above a lit floor and fills the view.
  Scene smooth(128, 96);
  smooth.AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, glm::dvec3(0.75));
  smooth.AddQuad({ -1, 0.3, 0 }, { 2, 0.3, 0 }, { -1, 2.3, 0 }, glm::dvec3(0.5));
  smooth.AddSpot({ 0.5, 0.25, 1.2 }, { 0.5, 0, 0.5 }, 30, 1, { 1, 0, 0 });
  smooth.SetEye({ 0.5, 0.8, 2 }, { 0.5, 0.8, 0 }, { 0, 1, 0 }, 27, 0.5, 5);
  smooth.Pass->SetReflectiveShadowMapResolution(128);
  smooth.Gather->SetModeToVirtualLights();
  smooth.Sampler->SetNumberOfLights(1024);
  smooth.Render();
  const Image smoothFull = smooth.Copy("irradiance");
  for (int step : { 2, 4, 8 })
  {
    const Deviation d = CompareInterpolated(smooth, smoothFull, step);
    const std::string what = "smooth scene, step " + std::to_string(step) + ": ";
    CheckAtMost(what + "RMSE over the mean", d.RMSE, 5e-5 * step * step,
      "curvature of the irradiance: grows with the square of the step");
    CheckAbsolute(what + "mean", d.Mean, 0.0, 5e-5 * step * step, "the same");
    CheckAtLeast(what + "share of interpolated values", d.Different, 0.5, "the test's own power");
  }
  smooth.CheckBuffers(1);

  // The disk kernel has a dark line narrower than a pixel where walls meet; interpolation blurs it.
  Room room(128, 96);
  room.Pass->SetReflectiveShadowMapResolution(128);
  room.Gather->SetModeToVirtualLights();
  room.Sampler->SetNumberOfLights(1024);
  room.Render();
  const Image roomFull = room.Copy("irradiance");
  for (int step : { 2, 4 })
  {
    const Deviation d = CompareInterpolated(room, roomFull, step);
    const std::string what = "walls that meet, step " + std::to_string(step) + ": ";
    CheckAtMost(
      what + "RMSE over the mean", d.RMSE, 0.15, "the line's depth on its share of the pixels");
    CheckAbsolute(what + "mean", d.Mean, 0.0, 0.02, "the line's area");
  }

  // Interpolation preserves a constant field: a receiver so small that its irradiance hardly
  // varies.
  Scene flat(64, 64);
  flat.AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, glm::dvec3(0.75));
  flat.AddQuad({ 0.5, 0.5, 1 }, { 0.5, 0.501, 1 }, { 0.501, 0.5, 1 }, glm::dvec3(0.75));
  flat.AddSpot({ -0.5, 0.5, 0.9 }, { 0.5, 0.5, 0 }, 25, 0, { 1, 0, 0 });
  flat.SetEye({ 0.5005, 0.5005, 0.5 }, { 0.5005, 0.5005, 1 }, { 0, 1, 0 }, 0.11, 0.1, 1);
  flat.Pass->SetReflectiveShadowMapResolution(64);
  flat.Gather->SetModeToVirtualLights();
  flat.Sampler->SetNumberOfLights(256);
  flat.Render();
  const Image gathered = flat.Copy("irradiance");
  flat.Gather->InterpolationOn();
  flat.Render();
  const Image interpolated = flat.Copy("irradiance");
  double worst = 0.0;
  double variation = 0.0;
  for (size_t i = 0; i < gathered.Values.size(); ++i)
  {
    worst = std::max(worst, std::abs(interpolated.Values[i] / double(gathered.Values[i]) - 1.0));
    variation =
      std::max(variation, std::abs(gathered.Values[i] / double(gathered.Values[0]) - 1.0));
  }
  CheckAtLeast("irradiance of the small receiver", gathered.Mean(), 0.01, "the test's own power");
  CheckAtMost("variation over it", variation, 2e-4, "its size");
  CheckAtMost("interpolated against gathered, worst", worst, 5e-6,
    "weights sum to one; positions are rounded to 6e-8 of the scene");
}
