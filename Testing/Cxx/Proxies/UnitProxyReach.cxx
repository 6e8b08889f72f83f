// SPDX-License-Identifier: BSD-3-Clause
// Radii within which spheres count, by brute force: the cut-off error is at most 1/256, and larger
// with a fifth less.
#include "OpenGL/vtkIndirectKernels.h"
#include "Proxies/vtkIndirectCoefficient.h"
#include "Proxies/vtkIndirectProxyLight.h"
#include "Proxies/vtkIndirectProxyReach.h"
#include "Proxies/vtkIndirectProxyTable.h"
#include "vtkEnvironmentLight.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;
using Light = vtkIndirectProxyReach::Coefficients;

namespace
{
vtkiHarmonics4 OfColor(const Light& light, int color)
{
  vtkiHarmonics4 f;
  for (int i = 0; i < vtkIndirectProxyLight::NumberOfCoefficients; ++i)
  {
    vtkIndirectCoefficient(f, i) = static_cast<float>(light[static_cast<size_t>(i)][color]);
  }
  return f;
}

void AddFrom(Light& light, const vec3& d, const glm::dvec3& sent)
{
  const vtkiHarmonics4 y = vtkiHarmonics4At(d);
  for (int i = 0; i < vtkIndirectProxyLight::NumberOfCoefficients; ++i)
  {
    light[static_cast<size_t>(i)] += static_cast<double>(vtkIndirectCoefficient(y, i)) * sent;
  }
}

Light Uniform()
{
  Light light;
  light.fill(glm::dvec3(0.0));
  light[0] = glm::dvec3(1.0 / VTKI_HARMONICS_Y00);
  return light;
}

vec4 Logarithm(float sine)
{
  const float at = vtkiProxyRow(sine) * (vtkIndirectProxyEntries - 1);
  const int row = std::min(static_cast<int>(at), vtkIndirectProxyEntries - 2);
  vec4 zonal;
  for (int i = 0; i < 4; ++i)
  {
    const float low = vtkIndirectProxyTable[row][i];
    zonal[i] = vtkiProxyRow(sine) *
      (low + (at - static_cast<float>(row)) * (vtkIndirectProxyTable[row + 1][i] - low));
  }
  return zonal;
}

struct Change
{
  double Hides = 0.0;
  double Sends = 0.0;
  double Exact = 0.0;
};

// The largest differences between a sphere with these reaches and one that counts everywhere, over
// the largest irradiance, at many normals, directions and distances. hides, sends: the reaches.
Change FindChange(const Light& all, double hides, double sends)
{
  std::vector<vec3> directions;
  const int count = 300;
  for (int i = 0; i < count; ++i)
  {
    const float z = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / count;
    const float s = std::sqrt(1.0f - z * z);
    const float turn = 2.39996323f * static_cast<float>(i) + 0.7f;
    directions.emplace_back(s * std::sin(turn), z, s * std::cos(turn));
  }
  Change change;
  for (int color = 0; color < 3; ++color)
  {
    const vtkiHarmonics4 light = OfColor(all, color);
    const vtkiLightMatrix matrix = vtkiMakeLightMatrix(light);
    std::vector<vtkiHarmonics4> lit;
    double largest = 0.0;
    for (const vec3& n : directions)
    {
      lit.push_back(vtkiLitCosine(matrix, n));
      largest =
        std::max(largest, static_cast<double>(vtkiHarmonicsDot(light, vtkiClampedCosine(n))));
    }
    if (!(largest > 0.0))
    {
      continue;
    }
    for (const float place : { 0.9f, 0.96f, 0.99f, 1.0f, 1.3f })
    {
      const float weight = vtkiProxyWithin(place, 1.0f);
      const float sine = 1.0f / (place * static_cast<float>(hides));
      const vec4 zonal = Logarithm(sine);
      const float sendsSine = 1.0f / (place * static_cast<float>(sends));
      const vtkiProxyOperator exact = vtkiExactOperator(sendsSine);
      for (const vec3& d : directions)
      {
        const vtkiHarmonics4 whole = vtkiHarmonicsExp(vtkiZonalTo(zonal, d));
        const vtkiHarmonics4 cut = vtkiHarmonicsExp(vtkiZonalTo(weight * zonal, d));
        const vtkiHarmonics4 lost = vtkiHarmonicsAdd(cut, -1.0f, whole);
        const double radiance = vtkiProxyRadiance(light, d, sendsSine);
        for (size_t i = 0; i < directions.size(); ++i)
        {
          change.Hides = std::max(
            change.Hides, std::abs(static_cast<double>(vtkiHarmonicsDot(lit[i], lost))) / largest);
          const double given = vtkiDiskIrradiance(sendsSine, glm::dot(d, directions[i]));
          change.Sends = std::max(
            change.Sends, (1.0 - static_cast<double>(weight)) * given * radiance / largest);
        }
        const double own = vtkiProxyExactIrradiance(exact, light, d, d) * 2.0 * vtkMath::Pi() *
          static_cast<double>(vtkiProxyRow(sendsSine));
        change.Exact = std::max(change.Exact, (1.0 - static_cast<double>(weight)) * own / largest);
      }
    }
  }
  return change;
}

void CheckChosen(const std::string& name, const Light& light)
{
  const double cut = vtkIndirectProxyReach::Cut;
  const vtkIndirectProxyReach reach = vtkIndirectProxyReach::Find(light, false);
  const Change change = FindChange(light, reach.Hides, reach.Sends);
  const std::string with =
    name + ", " + std::to_string(reach.Hides) + " and " + std::to_string(reach.Sends) + " radii: ";
  const char* const why = "1/256; the tests' directions miss the largest irradiance by 1 % at most";
  CheckAtMost(with + "what is not hidden", change.Hides, 1.01 * cut, why);
  CheckAtMost(with + "what is not sent", change.Sends, 1.01 * cut, why);
  CheckAtMost(with + "what is not sent by the exact operator", change.Exact, 1.01 * cut, why);
  const Change less = FindChange(light, 0.8 * reach.Hides, 0.8 * reach.Sends);
  const char* const chosen = "1/0.8^2 of it, but for what directions and distances miss";
  CheckAtLeast(with + "what a fifth less does not hide", less.Hides, 1.3 * cut, chosen);
  CheckAtLeast(with + "what a fifth less does not send", less.Sends, 1.3 * cut, chosen);
}
}

VTK_INDIRECT_TEST(ProxyReachIsChosen)
{
  CheckChosen("uniform", Uniform());
  Light sun;
  sun.fill(glm::dvec3(0.0));
  AddFrom(sun, glm::normalize(vec3(1.0f, 2.0f, -0.5f)), { 1.0, 0.8, 0.5 });
  CheckChosen("a sun alone", sun);
  Random random(17);
  for (int trial = 0; trial < 3; ++trial)
  {
    Light light = Uniform();
    for (int i = 0; i < 6; ++i)
    {
      const double size = random.NextMagnitude(0.1, 30.0);
      AddFrom(light, vec3(random.NextDirection()),
        { size, size * random.Next(0.0, 1.0), size * random.Next(0.2, 1.0) });
    }
    CheckChosen("environment " + std::to_string(trial), light);
  }
}

VTK_INDIRECT_TEST(ProxyReachOfEnvironments)
{
  vtkNew<vtkEnvironmentLight> sky;
  sky->SetRadiance(0.3, 0.5, 1.0);
  const vtkIndirectProxyReach uniform =
    vtkIndirectProxyReach::Find(vtkIndirectProxyLight::Project(sky), false);
  // A small sphere removes s^2 of the light from its direction, 17/16 of that with a cosine of
  // order 3, and 1.013 at the place where its weight begins to fall: 16.6 radii.
  CheckAbsolute("radii of a uniform sky", uniform.Hides, 16.6, 0.05, "16 sqrt(17/16 1.013)");
  CheckAbsolute(
    "radii within which it sends", uniform.Sends, 16.6, 0.05, "the same without a table");
  CheckAbsolute("contrast", uniform.Contrast, 1.0, 1e-3, "it is uniform");
  Light sun;
  sun.fill(glm::dvec3(0.0));
  AddFrom(sun, vec3(0.0f, 1.0f, 0.0f), glm::dvec3(1.0));
  // The cut-off error of the paper's radii.
  const char* const measured = "as the header and the page say";
  CheckAbsolute(
    "15 radii, uniform", 1.0 / FindChange(Uniform(), 15.0, 4.0).Hides, 209.0, 3.0, measured);
  CheckAbsolute("15 radii, a sun", 1.0 / FindChange(sun, 15.0, 4.0).Hides, 72.0, 1.0, measured);
  CheckAbsolute(
    "4 radii, uniform", 1.0 / FindChange(Uniform(), 15.0, 4.0).Sends, 14.9, 0.3, measured);
  const vtkIndirectProxyReach small = vtkIndirectProxyReach::Find(sun, false);
  CheckAtLeast("radii of a sun", small.Hides, 1.3 * uniform.Hides,
    "order 4 makes it 16/4.25 times as bright as its irradiance");
  Check("a sphere's disk blurs the sun that it sends", small.Sends < uniform.Sends,
    std::to_string(small.Sends));
  // Turned, brighter, or of one colour: the same.
  Light turned;
  turned.fill(glm::dvec3(0.0));
  AddFrom(turned, glm::normalize(vec3(-1.0f, 0.3f, 2.0f)), glm::dvec3(0.0, 1e9, 0.0));
  CheckRelative("of one turned", vtkIndirectProxyReach::Find(turned, false).Hides, small.Hides,
    5e-3, "what the search misses");
  Light none;
  none.fill(glm::dvec3(0.0));
  CheckEqual("radii without light", vtkIndirectProxyReach::Find(none, true).Hides, 2.0);
}
