// SPDX-License-Identifier: BSD-3-Clause
// Points of a light with a size, and the maps from each of them.
#include "Maps/vtkIndirectLightMap.h"
#include "Maps/vtkIndirectPenumbra.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

namespace
{
double DiskShare(double t)
{
  const double c = std::max(-1.0, std::min(1.0, t));
  return 0.5 + (c * std::sqrt(1.0 - c * c) + std::asin(c)) / vtkMath::Pi();
}

std::vector<glm::dvec3> MakePoints()
{
  std::vector<glm::dvec3> points;
  vtkiLightPairs pairs = vtkiBeginLightPairs();
  for (int i = 0; i < VTKI_LIGHT_PAIRS; ++i)
  {
    points.emplace_back(vtkiNextLightPoint(pairs, i));
    points.push_back(-points.back());
  }
  return points;
}

// Share of the points on one side of edges at all places across a direction, against a disk: RMS
// over the disk's width, and the largest difference.
void Compare(
  const std::vector<glm::dvec3>& points, const glm::dvec3& across, double& rms, double& most)
{
  std::vector<double> places;
  for (const glm::dvec3& point : points)
  {
    places.push_back(glm::dot(point, across));
  }
  std::sort(places.begin(), places.end());
  constexpr int steps = 1000;
  double squares = 0.0;
  most = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    const double t = 2.0 * (i + 0.5) / steps - 1.0;
    const double below =
      double(std::upper_bound(places.begin(), places.end(), t) - places.begin()) / places.size();
    const double difference = below - DiskShare(t);
    squares += difference * difference;
    most = std::max(most, std::abs(difference));
  }
  rms = std::sqrt(squares / steps);
}

vtkIndirectFrame MakeScaledFrame(double scale)
{
  vtkIndirectFrame frame;
  frame.SceneCenter = glm::dvec3(3.0, -2.0, 5.0) * scale;
  const glm::dvec3 half(0.5, 0.3, 0.4);
  frame.SceneScale = 0.5 / (glm::length(half) * scale);
  vtkIndirectCaster caster;
  for (int i = 0; i < 3; ++i)
  {
    caster.Bounds[2 * i] = frame.SceneCenter[i] - half[i] * scale;
    caster.Bounds[2 * i + 1] = frame.SceneCenter[i] + half[i] * scale;
  }
  frame.Casters.push_back(caster);
  return frame;
}

vtkIndirectPenumbra::Light Fit(
  const vtkIndirectFrame& frame, const vtkIndirectLight& light, double scale)
{
  vtkIndirectLight placed = light;
  placed.PositionWC = frame.SceneCenter + light.PositionWC * scale;
  placed.Size = light.Positional ? light.Size * scale : light.Size;
  vtkIndirectLightMap map;
  map.Fit(frame, placed);
  return vtkIndirectPenumbra::Fit(frame, map);
}

// The largest coordinate of a caster's corner in the images of the tiles, 1 at their border;
// infinite if a corner is not between the depth planes.
double FindReach(const vtkIndirectFrame& frame, const vtkIndirectPenumbra::Light& fit)
{
  double reach = 0.0;
  for (const vtkIndirectDepthTile& tile : fit.Tiles)
  {
    const glm::dmat4 toClip = tile.GetWorldToClip(frame);
    for (int i = 0; i < 8; ++i)
    {
      const double* b = frame.Casters.front().Bounds;
      const glm::dvec4 p =
        toClip * glm::dvec4(b[i & 1], b[2 + ((i >> 1) & 1)], b[4 + ((i >> 2) & 1)], 1.0);
      const bool between = p.w > 0.0 && std::abs(p.z) <= p.w * (1.0 + 1e-9);
      reach = std::max(reach,
        between ? std::max(std::abs(p.x), std::abs(p.y)) / p.w
                : std::numeric_limits<double>::infinity());
    }
  }
  return reach;
}
}

VTK_INDIRECT_TEST(LightPoints)
{
  const std::vector<glm::dvec3> points = MakePoints();
  CheckEqual("points", double(points.size()), VTKI_LIGHT_POINTS);
  glm::dvec3 mean(0.0);
  double farthest = 0.0;
  for (const glm::dvec3& point : points)
  {
    mean += point;
    farthest = std::max(farthest, glm::length(point));
  }
  CheckEqual("their mean is the centre", glm::length(mean), 0.0);
  CheckAtMost("the farthest is in the ball", farthest, 1.0 + 1e-6, "rounding");

  Random random(5);
  double worst = 0.0;
  double squares = 0.0;
  double worstRMS = 0.0;
  constexpr int directions = 2000;
  for (int i = 0; i < directions; ++i)
  {
    double rms = 0.0;
    double most = 0.0;
    Compare(points, random.NextDirection(), rms, most);
    worst = std::max(worst, most);
    worstRMS = std::max(worstRMS, rms);
    squares += rms * rms;
  }
  // Random points have an RMS of sqrt(v (1 - v) / 32): 0.062 on average over the disk's width.
  CheckAtMost("share of the disk behind an edge, RMS over edges of all directions",
    std::sqrt(squares / directions), 0.03, "half of that of points at random");
  CheckAtMost("worst direction, RMS", worstRMS, 0.06, "that of points at random");
  CheckAtMost("worst edge", worst, 0.15, "four points and a half of 32");
  double acrossRMS = 0.0;
  for (int i = 0; i < 180; ++i)
  {
    const double turn = vtkMath::Pi() * i / 180.0;
    double rms = 0.0;
    Compare(points, { std::cos(turn), std::sin(turn), 0.0 }, rms, worst);
    acrossRMS = std::max(acrossRMS, rms);
  }
  CheckAtMost("edges seen along the light's axis, worst RMS", acrossRMS, 0.03,
    "points are even in that disk");
}

VTK_INDIRECT_TEST(LightPointAxes)
{
  Random random(6);
  double worst = 0.0;
  for (int i = 0; i < 10000; ++i)
  {
    const double turn = random.Next(0.0, 2.0 * vtkMath::Pi());
    const double r = i == 0 ? 0.0 : i < 3 ? 1.0 : random.Next();
    vec3 x;
    vec3 y;
    vec3 z;
    vtkiLightPointAxes(vec2(glm::dvec2(r * std::cos(turn), r * std::sin(turn))), x, y, z);
    const glm::dvec3 a(x);
    const glm::dvec3 b(y);
    const glm::dvec3 c(z);
    worst = std::max({ worst, std::abs(glm::length(a) - 1.0), std::abs(glm::length(b) - 1.0),
      std::abs(glm::length(c) - 1.0), std::abs(glm::dot(a, b)),
      glm::length(glm::cross(a, b) - c) });
  }
  // At 90 degrees the third coordinate is the root of a rounding.
  CheckAtMost("axes are unit, at right angles and right-handed", worst, 1e-3, "rounding");
}

VTK_INDIRECT_TEST(PenumbraMaps)
{
  vtkIndirectLight point;
  point.Positional = true;
  point.PositionWC = { 2.0, 3.0, 1.0 };
  point.Size = 0.2;
  vtkIndirectLight inside = point;
  inside.PositionWC = { 0.1, 0.05, -0.2 };
  vtkIndirectLight vast = point;
  vast.Size = 1e30;
  vtkIndirectLight spot = point;
  spot.ConeAngle = 8.0;
  spot.DirectionWC = -glm::normalize(spot.PositionWC);
  vtkIndirectLight sun;
  sun.DirectionWC = glm::normalize(glm::dvec3(0.3, -1.0, 0.2));
  sun.Size = vtkMath::RadiansFromDegrees(0.27);
  vtkIndirectLight wide = sun;
  wide.Size = vtkMath::RadiansFromDegrees(90.0);
  const struct
  {
    const char* Name;
    vtkIndirectLight Light;
    int Faces;
    bool HoldsAll;
  } cases[] = { { "a point light aside", point, 1, true }, { "one among casters", inside, 6, true },
    { "one larger than the scene", vast, 6, true }, { "a narrow spot", spot, 1, false },
    { "the sun", sun, 1, true }, { "half of the sky", wide, 1, true } };
  for (const auto& c : cases)
  {
    const vtkIndirectPenumbra::Light unit = Fit(MakeScaledFrame(1.0), c.Light, 1.0);
    const std::string name(c.Name);
    CheckEqual(name + ": faces", unit.Map.Map.NumberOfFaces, c.Faces);
    CheckEqual(name + ": tiles", double(unit.Tiles.size()), c.Faces * VTKI_LIGHT_POINTS);
    CheckEqual(name + ": holds all", unit.Map.HoldsAll, c.HoldsAll);
    Check(name + ": numbers are finite",
      std::isfinite(unit.Map.Map.HalfWidth) && std::isfinite(unit.Map.Map.Far) &&
        std::isfinite(unit.Map.Size) && unit.Map.Map.Near < unit.Map.Map.Far && unit.Texels > 0.0);
    if (c.Faces == 1 && c.HoldsAll)
    {
      CheckAtMost(
        name + ": casters in the tiles", FindReach(MakeScaledFrame(1.0), unit), 1.0, "all of them");
    }
    for (double scale : { 1e-6, 1e6 })
    {
      const vtkIndirectPenumbra::Light other = Fit(MakeScaledFrame(scale), c.Light, scale);
      CheckRelative(name + ": half width at scale " + std::to_string(scale),
        other.Map.Map.HalfWidth, unit.Map.Map.HalfWidth, 1e-9, "rounding");
      CheckRelative(name + ": texels", other.Texels, unit.Texels, 1e-9, "lengths are scene units");
    }
  }
}
