// SPDX-License-Identifier: BSD-3-Clause
// Occlusion by spheres: jointly from afar, against disks in pictures, and by groups of them; by
// many random ones, and by those next to the receiver.
#include "vtkIndirectTestUtilities.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "Proxies/vtkIndirectProxySilhouette.h"
#include "Proxies/vtkIndirectProxyTable.h"
#include "Proxies/vtkIndirectProxyTree.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;
using Silhouette = vtkIndirectProxySilhouette;

namespace
{
// The area that some opaque balls cover, averaged over directions, over pi: by points in a square.
double CoveredArea(const std::vector<Silhouette::Ball>& balls)
{
  constexpr int directions = 24;
  constexpr int places = 96;
  double size = 0.0;
  for (const Silhouette::Ball& ball : balls)
  {
    size = std::max(size, glm::length(ball.Center) + ball.Radius);
  }
  Random random(3);
  double sum = 0.0;
  for (int k = 0; k < directions; ++k)
  {
    const glm::dvec3 way = random.NextDirection();
    const glm::dvec3 x = glm::normalize(
      glm::cross(way, std::abs(way.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 y = glm::cross(way, x);
    for (int i = 0; i < places * places; ++i)
    {
      const double u = size * (2.0 * (i % places + 0.5) / places - 1.0);
      const double v = size * (2.0 * (i / places + 0.5) / places - 1.0);
      sum += std::any_of(balls.begin(), balls.end(),
               [&](const Silhouette::Ball& ball)
               {
                 return glm::length(glm::dvec2(glm::dot(ball.Center, x) - u,
                          glm::dot(ball.Center, y) - v)) < ball.Radius;
               })
        ? 1.0
        : 0.0;
    }
  }
  return sum * 4.0 * size * size / (places * places * directions) / 3.14159265358979;
}

vtkiHarmonics4 ZeroHarmonics()
{
  vtkiHarmonics4 f;
  f.A = f.B = f.C = f.D = vec4(0.0f);
  return f;
}

// The zonal logarithm of a sphere's visibility.
vec4 Logarithm(double sine)
{
  const float share = vtkiProxyRow(static_cast<float>(sine));
  const float place = share * (vtkIndirectProxyEntries - 1);
  const int row = std::min(static_cast<int>(place), vtkIndirectProxyEntries - 2);
  vec4 zonal;
  for (int i = 0; i < 4; ++i)
  {
    const float low = vtkIndirectProxyTable[row][i];
    zonal[i] =
      share * (low + (place - static_cast<float>(row)) * (vtkIndirectProxyTable[row + 1][i] - low));
  }
  return zonal;
}

// Irradiance of a uniform sky of radiance 1 for the normal +z.
double Irradiance(const vtkiHarmonics4& logarithms)
{
  return vtkiHarmonicsDot(vtkiHarmonicsExp(logarithms), vtkiClampedCosine(vec3(0.0f, 0.0f, 1.0f)));
}

std::vector<Silhouette::Ball> MakeBalls(int count, double apart, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Silhouette::Ball> balls;
  for (int i = 0; i < count; ++i)
  {
    balls.push_back(
      { apart * std::cbrt(random.Next()) * random.NextDirection(), random.Next(0.7, 1.3), 1.0 });
  }
  return balls;
}
}

VTK_INDIRECT_TEST(ProxySilhouetteOfPairs)
{
  CheckAbsolute("one in the other", Silhouette::FindOverlap(2.0, 1.0, 0.5), 1.0, 0.01, "wholly");
  CheckAbsolute("two at one place", Silhouette::FindOverlap(1.0, 1.0, 0.0), 1.0, 0.01, "wholly");
  // Touching balls: half of the mean of intersections over directions, by an independent
  // quadrature.
  CheckAbsolute("touching ones", Silhouette::FindOverlap(1.0, 1.0, 2.0),
    Integrate(
      0.0, 1.0,
      [](double cosine)
      {
        const double half = std::sqrt(1.0 - cosine * cosine);
        return 2.0 / 3.14159265358979 * (std::acos(half) - half * std::sqrt(1.0 - half * half));
      },
      64),
    0.005, "linear between entries of a table");
  const double far = Silhouette::FindOverlap(3.0, 1.0, 300.0);
  CheckRelative("far apart", far, 0.5 * 1e-4, 1e-3, "disk over the sphere of directions, twice");
  double jump = 0.0;
  for (double distance = 0.0; distance < 12.0; distance += 0.01)
  {
    jump = std::max(jump,
      std::abs(Silhouette::FindOverlap(1.0, 0.6, distance) -
        Silhouette::FindOverlap(1.0, 0.6, distance + 0.01)));
  }
  CheckAtMost("steps for steps of a hundredth", jump, 0.02, "no slope is above one or so");
}

VTK_INDIRECT_TEST(ProxySilhouetteOfGroups)
{
  for (const double apart : { 0.5, 1.0, 2.0, 4.0 })
  {
    double found = 0.0;
    double covered = 0.0;
    double tree = 0.0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
    {
      const std::vector<Silhouette::Ball> balls = MakeBalls(4, apart, seed);
      found += Silhouette::FindArea(balls.data(), 4);
      covered += CoveredArea(balls);
      std::vector<vtkIndirectProxySphere> spheres(4);
      for (size_t i = 0; i < 4; ++i)
      {
        spheres[i].Center = 0.01 * balls[i].Center;
        spheres[i].Radius = 0.01 * balls[i].Radius;
      }
      vtkIndirectProxyTree groups;
      groups.Build(spheres, 0.4, 0.0);
      const vtkIndirectProxyTree::Entry& root = groups.GetEntries().front();
      tree += 1e4 * root.Share * root.Radius * root.Radius;
    }
    const std::string name = "four balls within " + std::to_string(apart) + " radii";
    const double most = apart < 2.0 ? 0.13 : 0.03;
    const char* const origin = apart < 2.0
      ? "overlaps of pairs, as if in no relation: too little of four that are inside of each other"
      : "overlaps of pairs, as if in no relation; 24 directions";
    CheckRelative(name, found, covered, most, origin);
    CheckRelative(name + ", their group", tree, covered, most, origin);
  }
}

VTK_INDIRECT_TEST(ProxySharesAtRandom)
{
  // Random disks that hide a share p of the light leave (1 - p a)^N on average.
  Random random(5);
  for (const double share : { 0.3, 0.6 })
  {
    const float sine = 0.4f;
    const double covered = 0.5 * (1.0 - std::sqrt(1.0 - sine * sine));
    const vec4 zonal = vtkiZonalShare(Logarithm(sine), sine, static_cast<float>(share));
    const int count = static_cast<int>(1.0 / (share * covered));
    const int sets = 400;
    double measured = 0.0;
    for (int set = 0; set < sets; ++set)
    {
      vtkiHarmonics4 sum = ZeroHarmonics();
      for (int i = 0; i < count; ++i)
      {
        sum = vtkiHarmonicsAdd(sum, 1.0f, vtkiZonalTo(zonal, vec3(random.NextDirection())));
      }
      measured += Irradiance(sum) / sets;
    }
    CheckRelative("disks that hide a share of " + std::to_string(share), measured,
      std::pow(1.0 - share * covered, count), 0.03,
      "400 sets, each off by 0.1; by the share of an opaque one's logarithm it is 10 % and more");
  }
}

VTK_INDIRECT_TEST(ProxySmallSpheresAtRandom)
{
  // Random spheres hide what they cover: each of N leaves 1 - a of every direction, and sets of
  // them (1 - a)^N on average.
  Random random(17);
  for (const double sine : { 0.05, 0.1, 0.2 })
  {
    const double covered = 0.5 * (1.0 - std::sqrt(1.0 - sine * sine));
    const int count = static_cast<int>(0.5 / covered);
    const int sets = 64;
    double measured = 0.0;
    for (int set = 0; set < sets; ++set)
    {
      vtkiHarmonics4 sum = ZeroHarmonics();
      for (int i = 0; i < count; ++i)
      {
        sum =
          vtkiHarmonicsAdd(sum, 1.0f, vtkiZonalTo(Logarithm(sine), vec3(random.NextDirection())));
      }
      measured += Irradiance(sum) / sets;
    }
    CheckRelative("half of the sky, by spheres of sine " + std::to_string(sine), measured,
      std::pow(1.0 - covered, count), 0.01,
      "64 sets, each off by 0.05 and less; by logarithms that are linear from zero to the first "
      "row of the table small ones are 2.5 % too dark");
  }
}

VTK_INDIRECT_TEST(ProxyDrawnSpheresNearby)
{
  // A drawn sphere at a point of its surface, and an intersecting one.
  const vec3 n(0.0f, 0.0f, 1.0f);
  auto add = [&](vtkiHarmonics4& sum, const glm::dvec3& center)
  {
    const float sine = vtkiProxySine(vec3(center), 1.0f, n, true);
    const vec3 d(glm::normalize(center));
    sum = vtkiHarmonicsAdd(sum, vtkiProxyAbove(d.z, sine), vtkiZonalTo(Logarithm(sine), d));
  };
  const glm::dvec3 own(0.0, 0.0, -1.0005);
  vtkiHarmonics4 sum = ZeroHarmonics();
  add(sum, own);
  CheckAbsolute("its own surface", Irradiance(sum), 1.0, 1e-4,
    "what is below hides nothing; a hemisphere of order 4 would ring by 0.011");
  for (const double height : { -0.7, -0.4, -0.1, 0.2, 0.5 })
  {
    // Near the seam of both.
    const glm::dvec3 d(std::sqrt(1.0 - height * height), 0.0, height);
    const double cosine = std::sqrt(1.0 - 1.0 / (1.01 * 1.01));
    constexpr int ways = 20000;
    double exact = 0.0;
    for (int i = 0; i < ways; ++i)
    {
      const double share = (i + 0.5) / ways;
      const double turn = 2.399963229728653 * i;
      const glm::dvec3 way(std::sqrt(share) * std::cos(turn), std::sqrt(share) * std::sin(turn),
        std::sqrt(1.0 - share));
      exact += glm::dot(way, d) < cosine ? 1.0 / ways : 0.0;
    }
    sum = ZeroHarmonics();
    add(sum, own);
    add(sum, 1.01 * d);
    CheckAbsolute("beside one whose center is at " + std::to_string(height), Irradiance(sum), exact,
      0.015,
      "order 4 of what fills nearly a hemisphere; shrunk, as what stands for a surface, up to "
      "0.06");
  }
}
