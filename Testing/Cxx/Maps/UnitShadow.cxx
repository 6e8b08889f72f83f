// SPDX-License-Identifier: BSD-3-Clause
// Planes of shadow look-ups, depth buffer values, and the test for one surface.
#include "OpenGL/vtkIndirectKernels.h"
#include "vtkIndirectTestUtilities.h"

#include <algorithm>
#include <cmath>
#include <string>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

namespace
{
// Depth buffer value in double precision: rows 2 and 3 of the projection, to [0,1].
double StoredDepth(double depth, double n, double f, bool parallel)
{
  return parallel ? (depth - n) / (f - n) : f * (depth - n) / (depth * (f - n));
}

// Depth of the plane through p with normal n at tangents (perspective) or places (parallel) t.
double PlaneDepth(const glm::dvec3& p, const glm::dvec3& n, const glm::dvec2& t, bool parallel)
{
  const double offset = glm::dot(n, p);
  return parallel ? (n.x * t.x + n.y * t.y - offset) / n.z
                  : offset / glm::dot(n, glm::dvec3(t, -1.0));
}
}

VTK_INDIRECT_TEST(PlaneDepthGradient)
{
  Random random(12);
  for (bool parallel : { false, true })
  {
    const std::string what = parallel ? "parallel" : "perspective";
    double worst = 0.0;
    int wrongSide = 0;
    int compared = 0;
    for (int i = 0; i < 100000; ++i)
    {
      const double far = random.NextMagnitude(1e-2, 1e1);
      const double near = far * random.NextMagnitude(1.0 / 1024.0, 0.5);
      const double depth = random.Next(near, far);
      const glm::dvec3 p(depth * random.Next(-1.7, 1.7), depth * random.Next(-1.7, 1.7), -depth);
      const glm::dvec3 n = random.NextDirection();
      const double texel = random.NextMagnitude(1e-4, 1e-2);
      const vec3 gradient = vtkiPlaneDepthGradient(vec3(p), vec3(n), static_cast<float>(texel),
        static_cast<float>(near), static_cast<float>(far), parallel);
      const double facing = parallel ? n.z : -glm::dot(n, p) / depth;
      if (std::abs(facing) < 0.1)
      {
        continue; // relative rounding of the cosine grows without bound towards the horizon
      }
      wrongSide += (gradient.z == 1.0f) != (facing > 0.0);
      if (facing < 0.0)
      {
        continue;
      }
      const glm::dvec2 here = parallel ? glm::dvec2(p) : glm::dvec2(p) / depth;
      const double stored = StoredDepth(depth, near, far, parallel);
      for (int corner = 0; corner < 4; ++corner)
      {
        const glm::dvec2 shift(corner & 1 ? 1.5 : -1.5, corner & 2 ? 1.5 : -1.5);
        const double there = PlaneDepth(p, n, here + shift * texel, parallel);
        const double expected = StoredDepth(there, near, far, parallel) - stored;
        const double found = gradient.x * shift.x + gradient.y * shift.y;
        const double size = std::abs(gradient.x * shift.x) + std::abs(gradient.y * shift.y);
        worst = std::max(worst, std::abs(found - expected) / std::max(size, 1e-12));
        ++compared;
      }
    }
    // The cosine is at least 0.1, a difference of terms of up to 2.6: 1e-7 of rounding becomes
    // 3e-6.
    CheckAtMost(what + ": against the plane's own depth, worst relative difference", worst, 1e-5,
      "rounding of the cosine");
    CheckEqual(what + ": planes taken for the other side", wrongSide, 0);
    CheckAtLeast(what + ": comparisons", compared, 100000, "the test's own power");
  }
  CheckEqual("a plane that contains a parallel map's axis",
    vtkiPlaneDepthGradient(vec3(0.0f, 0.0f, -1.0f), vec3(1.0f, 0.0f, 0.0f), 0.01f, 0.5f, 2.0f, true)
      .z,
    0.0);
  CheckEqual("a plane through the light",
    vtkiPlaneDepthGradient(
      vec3(0.0f, 0.0f, -1.0f), vec3(1.0f, 0.0f, 0.0f), 0.01f, 0.5f, 2.0f, false)
      .z,
    0.0);
}

VTK_INDIRECT_TEST(DepthToBufferSlope)
{
  double worst = 0.0;
  for (bool parallel : { false, true })
  {
    for (double depth = 0.2; depth < 2.0; depth += 0.01)
    {
      const double h = 1e-6;
      const double expected =
        (StoredDepth(depth + h, 0.1, 2.0, parallel) - StoredDepth(depth - h, 0.1, 2.0, parallel)) /
        (2.0 * h);
      const double found = vtkiDepthToBufferSlope(static_cast<float>(depth), 0.1f, 2.0f, parallel);
      worst = std::max(worst, std::abs(found - expected) / expected);
    }
  }
  CheckAtMost("against central differences, worst relative difference", worst, 1e-6, "rounding");
}

VTK_INDIRECT_TEST(Tent)
{
  double centre = 0.0;
  double whole = 0.0;
  for (int i = 0; i <= 1000; ++i)
  {
    const vec2 fraction(static_cast<float>(i) / 1000.0f, static_cast<float>(i % 7) / 6.0f);
    double sum = 0.0;
    glm::dvec2 mean(0.0);
    for (int k = 0; k < 4; ++k)
    {
      const vec2 neighbor = vtkiShadowNeighbor(k);
      Check("texel " + std::to_string(k),
        neighbor.x == static_cast<float>(k % 2) && neighbor.y == static_cast<float>(k / 2));
      const double weight = vtkiShadowWeight(neighbor, fraction);
      sum += weight;
      mean += weight * glm::dvec2(neighbor - fraction);
    }
    whole = std::max(whole, std::abs(sum - 1.0));
    centre = std::max(centre, glm::length(mean));
  }
  CheckAtMost("sum of the weights, less one", whole, 1e-6, "rounding");
  CheckAtMost("centre of the weights from the receiver", centre, 1e-6, "rounding");
}

VTK_INDIRECT_TEST(PackSlope)
{
  Random random(14);
  double worst = 0.0;
  int numbers = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const double angle = random.Next(0.0, 6.28);
    const glm::dvec2 slope =
      random.NextMagnitude(1e-3, 300.0) * glm::dvec2(std::cos(angle), std::sin(angle));
    const float packed = vtkiPackSlope(vec2(slope));
    numbers += !std::isnormal(packed);
    worst = std::max(
      worst, glm::length(glm::dvec2(vtkiUnpackSlope(packed)) - slope) / (1.0 + glm::length(slope)));
  }
  CheckEqual("codes that are no normal numbers", numbers, 0);
  // Half a step of both coordinates times the square of one more than the sum of a slope's
  // components, 300 root two.
  CheckAtMost("error of a packed slope over one more than it", worst,
    glm::length(glm::dvec2(0.5 / VTKI_CODE_STEPS_X, 0.5 / VTKI_CODE_STEPS_Y)) * 425.3 * 425.3 /
      301.0,
    "half a step");
}

// A map that looks straight down onto planes: each texel has the depth and slope of the nearest
// plane at its centre. look: visibility of a receiver on `plane` at a place.
VTK_INDIRECT_TEST(ShadowVotes)
{
  struct Plane
  {
    double Depth; // at the origin
    double Slope;
    double Begin; // along x, texels
    double End;
  };
  auto look = [](const std::vector<Plane>& planes, int own, double x, double row)
  {
    const Plane& mine = planes[own];
    vtkiShadowPlane receiver;
    receiver.reference = static_cast<float>(mine.Depth + mine.Slope * x);
    receiver.gradient = vec2(static_cast<float>(mine.Slope), 0.0f);
    receiver.perTexel = 1e3f;
    receiver.rounding = 1e-6f;
    receiver.bias = 0.5e-3f; // half of a texel's width
    receiver.turned = false;
    receiver.facet = vec2(0.0f);
    const double first = std::floor(x);
    const vec2 fraction(static_cast<float>(x - first), static_cast<float>(row - std::floor(row)));
    vtkiShadowVotes votes = vtkiBeginShadow();
    float depths[4];
    for (int i = 0; i < 4; ++i)
    {
      const vec2 neighbor = vtkiShadowNeighbor(i);
      const double there = first + neighbor.x;
      double nearest = 1.0;
      double slope = 0.0;
      for (const Plane& plane : planes)
      {
        const double depth = plane.Depth + plane.Slope * there;
        if (there >= plane.Begin && there < plane.End && depth < nearest)
        {
          nearest = depth;
          slope = plane.Slope;
        }
      }
      depths[i] = static_cast<float>(nearest);
      vtkiVoteOnShadow(receiver, neighbor - fraction, depths[i],
        vec2(static_cast<float>(slope), 0.0f), vtkiShadowWeight(neighbor, fraction), i, votes);
    }
    float seen = 0.0f;
    for (int i = 0; i < 4; ++i)
    {
      const vec2 neighbor = vtkiShadowNeighbor(i);
      const bool counts = vtkiCountsForShadow(receiver, neighbor - fraction, depths[i], i, votes);
      seen += counts ? vtkiShadowWeight(neighbor, fraction) : 0.0f;
    }
    return static_cast<double>(vtkiShareOfShadow(seen, votes));
  };
  // Depths count 1e-3 as the width of a texel. A wall, left, meets a floor, right, at 0.3.
  const std::vector<Plane> corner = { { 0.5 - 0.3e-3 * -3.0, -3e-3, -1e9, 0.3 },
    { 0.5 - 0.3e-3 * 0.5, 0.5e-3, 0.3, 1e9 } };
  double least = 1.0;
  for (double x = -3.0; x <= 3.0; x += 0.01)
  {
    least = std::min(least, look(corner, x < 0.3 ? 0 : 1, x, 0.2));
  }
  CheckEqual("least that is seen where a wall meets a floor", least, 1.0);
  // A wall with its foot at 0.3, in front of a floor that begins there, hides the floor up to its
  // end at 40.
  std::vector<Plane> thin = { { 0.5 + 0.3e-3 * 3.0, -3e-3, 0.3, 40.0 },
    { 0.5 - 0.3e-3 * 0.5, 0.5e-3, 0.3, 1e9 } };
  for (const bool around : { false, true })
  {
    if (around)
    {
      thin[1].Begin = -1e9; // the floor extends to both sides of the wall
    }
    double most = 0.0;
    for (double x = 0.33; x <= 38.0; x += 0.01)
    {
      most = std::max(most, look(thin, 1, x, -0.3));
    }
    // Slopes are assumed to have an error of a hundredth: 0.01 of a texel from the foot.
    CheckEqual("most light behind a thin wall", most, 0.0);
  }
  double lit = 1.0;
  for (double x = -3.0; x <= 0.29; x += 0.01)
  {
    lit = std::min(lit, look(thin, 1, x, -0.3));
  }
  CheckEqual("least that is seen before the thin wall", lit, 1.0);
  // Far from its caster a shadow's edge is a texel wide to either side: no light comes farther into
  // the shadow, and no shadow farther out.
  double outside = 1.0;
  double inside = 0.0;
  double middle = 0.0;
  constexpr int edges = 100;
  for (int i = 0; i < edges; ++i)
  {
    const double at = (i + 0.5) / edges;
    const std::vector<Plane> edge = { { 0.4, 0.2e-3, at, 1e9 }, { 0.5, 0.5e-3, -1e9, 1e9 } };
    outside = std::min(outside, look(edge, 1, at - 1.01, 0.1));
    inside = std::max(inside, look(edge, 1, at + 1.01, 0.1));
    middle += look(edge, 1, at, 0.1) / edges;
  }
  CheckEqual("least that is seen a texel outside of a shadow", outside, 1.0);
  CheckEqual("most that is seen a texel inside", inside, 0.0);
  CheckAtMost("mean at edges anywhere in a texel, off one half", std::abs(middle - 0.5), 0.01,
    "the tent is even");
  // Inside a closed body: its front rises from its rim at 0.3, and the receiver falls from there;
  // beside the body is a floor. Also a round body, whose planes meet beyond its rim.
  for (const double beyond : { 0.0, 0.8 })
  {
    const std::vector<Plane> body = { { 0.5 - (0.3 + beyond) * -3e-3, -3e-3, -1e9, 0.3 },
      { 0.5 - (0.3 + beyond) * 3e-3, 3e-3, -1e9, 0.3 }, { 0.9, 0.0, -1e9, 1e9 } };
    double inner = 0.0;
    for (double x = -3.0; x <= 0.3; x += 0.01)
    {
      inner = std::max(inner, look(body, 0, x, 0.3));
    }
    CheckEqual("most light inside of a closed body", inner, 0.0);
    double front = 1.0;
    for (double x = -3.0; x <= 0.3; x += 0.01)
    {
      front = std::min(front, look(body, 1, x, 0.3));
    }
    CheckEqual("least that is seen of its front", front, 1.0);
  }
  // Concave facets at right angles, and convex ones.
  for (const double bend : { 1e-3, -1e-3 })
  {
    const std::vector<Plane> bent = { { 0.5, bend, -1e9, 0.2 },
      { 0.5 + 0.4 * bend, -bend, 0.2, 1e9 } };
    double dark = 1.0;
    for (double x = -3.0; x <= 3.0; x += 0.01)
    {
      dark = std::min(dark, look(bent, x < 0.2 ? 0 : 1, x, 0.4));
    }
    CheckEqual("least that is seen of two facets", dark, 1.0);
  }
}

VTK_INDIRECT_TEST(DepthToBuffer)
{
  Random random(13);
  double worst = 0.0;
  double worstParallel = 0.0;
  for (int i = 0; i < 100000; ++i)
  {
    const auto f = static_cast<float>(random.NextMagnitude(1e-3, 1e3));
    const auto n = static_cast<float>(f * random.NextMagnitude(1.0 / 1024.0, 0.5));
    const auto depth = static_cast<float>(random.Next(n, f));
    const double nd = n;
    const double fd = f;
    // Rows 2 and 3 of the projections that draw the maps, then [-1,1] to [0,1].
    const double clipZ = (fd + nd) / (fd - nd) * depth - 2.0 * fd * nd / (fd - nd);
    const double expected = 0.5 * clipZ / depth + 0.5;
    worst = std::max(worst, std::abs(vtkiDepthToBuffer(depth, n, f, false) - expected));
    const double expectedParallel = 0.5 * (2.0 * depth - fd - nd) / (fd - nd) + 0.5;
    worstParallel =
      std::max(worstParallel, std::abs(vtkiDepthToBuffer(depth, n, f, true) - expectedParallel));
  }
  CheckAtMost("perspective, worst difference", worst, 3e-7, "five roundings near one");
  CheckAtMost("parallel, worst difference", worstParallel, 3e-7, "five roundings near one");
  CheckEqual("near plane", vtkiDepthToBuffer(0.5f, 0.5f, 2.0f, false), 0.0);
  CheckEqual("far plane", vtkiDepthToBuffer(2.0f, 0.5f, 2.0f, false), 1.0);
  CheckEqual("in the light", vtkiDepthToBuffer(0.0f, 0.5f, 2.0f, false), 0.0);
}

VTK_INDIRECT_TEST(SameSurface)
{
  const vec3 up(0.0f, 0.0f, 1.0f);
  auto same = [&](const vec3& offset, const vec3& normal)
  { return vtkiSameSurface(offset, up, normal, 0.9f, 0.1f); };
  Check("the same point", same(vec3(0.0f), up));
  Check("far along the plane", same(vec3(1e6f, -1e6f, 0.0f), up));
  Check("on the tolerance", same(vec3(3.0f, 0.0f, 0.1f), up));
  Check("above the tolerance", !same(vec3(3.0f, 0.0f, 0.11f), up));
  Check("below the tolerance", !same(vec3(3.0f, 0.0f, -0.11f), up));
  Check("the other way round", !same(vec3(0.0f, 0.0f, 0.0f), -up));
  const auto tilt = static_cast<float>(std::acos(0.9));
  Check("tilted by less than the limit",
    same(vec3(0.0f), vec3(std::sin(0.99f * tilt), 0.0f, std::cos(0.99f * tilt))));
  Check("tilted by more than the limit",
    !same(vec3(0.0f), vec3(std::sin(1.01f * tilt), 0.0f, std::cos(1.01f * tilt))));
  Check("off the sample's plane though on the pixel's",
    !same(vec3(1.0f, 0.0f, 0.0f), vec3(std::sin(0.9f * tilt), 0.0f, std::cos(0.9f * tilt))));
}

// One plane decides, and its normal.
VTK_INDIRECT_TEST(LiesOnPlane)
{
  const vec3 up(0.0f, 0.0f, 1.0f);
  const vec3 tilted = glm::normalize(vec3(0.3f, 0.0f, 1.0f));
  Check("far along the plane", vtkiLiesOnPlane(vec3(1e6f, 0.0f, 0.0f), tilted, up, 0.9f, 0.1f));
  Check("above the plane", !vtkiLiesOnPlane(vec3(0.0f, 0.0f, 0.11f), up, up, 0.9f, 0.1f));
  Check("the other's plane", !vtkiLiesOnPlane(vec3(1e6f, 0.0f, 0.0f), up, tilted, 0.9f, 0.1f));
  Check("normals disagree", !vtkiLiesOnPlane(vec3(0.0f), -up, up, 0.9f, 0.1f));
}

// Samples lie at every step-th pixel and on the border: weights add up to one, and interpolate the
// pixel's own place exactly.
VTK_INDIRECT_TEST(GridCells)
{
  double worst = 0.0;
  for (int step = 1; step <= 9; ++step)
  {
    for (int width = 1; width <= 40; ++width)
    {
      const ivec2 last(width - 1, 2 * width - 1);
      for (int x = 0; x < width; ++x)
      {
        const ivec2 pixel(x, 2 * x + 1);
        const vtkiGridCell cell = vtkiFindCell(pixel, step, last);
        glm::dvec3 sum(0.0);
        for (int i = 0; i < 4; ++i)
        {
          const ivec2 place = min((cell.corner + ivec2(i & 1, i >> 1)) * step, last);
          sum += double(vtkiCellWeight(cell, i)) * glm::dvec3(place.x, place.y, 1.0);
        }
        worst = std::max(worst, glm::length(sum - glm::dvec3(pixel.x, pixel.y, 1.0)));
      }
    }
  }
  CheckAtMost("distance of the interpolated place, pixels", worst, 1e-5, "float");
}

VTK_INDIRECT_TEST(Agreement)
{
  const vec3 up(0.0f, 0.0f, 1.0f);
  auto agreement = [&](const vec3& offset, const vec3& normal)
  { return double(vtkiAgreement(offset, up, normal, 2.0f)); };
  CheckEqual("the same surface", agreement(vec3(5.0f, -7.0f, 0.0f), up), 1.0);
  CheckEqual("half a distance above", agreement(vec3(0.0f, 0.0f, 1.0f), up), 0.5);
  CheckEqual("behind", agreement(vec3(0.0f), -up), 0.0);
  const vec3 tilted(0.6f, 0.0f, 0.8f);
  CheckAtMost("power 8 of the cosine", std::abs(agreement(vec3(0.0f), tilted) - std::pow(0.8, 8)),
    1e-6, "float");
  CheckEqual("no distance", double(vtkiAgreement(vec3(0.0f), up, up, 0.0f)), 1.0);
}

// A joint test of several positions must hold between any two of them.
VTK_INDIRECT_TEST(OneSurface)
{
  constexpr int count = 6;
  constexpr float cosine = 0.9f;
  constexpr float tolerance = 0.1f;
  Random random(14);
  int accepted = 0;
  int wrong = 0;
  int declined = 0; // although every pair agrees
  int planes = 0;
  double worstTurn = 0.0;
  for (int i = 0; i < 100000; ++i)
  {
    const double bend = i % 4 == 0 ? 0.0 : random.NextMagnitude(1e-3, 1.0);
    const double rough = i % 4 == 0 ? 0.0 : random.NextMagnitude(1e-4, 1.0);
    const glm::dvec3 reference = random.NextDirection();
    vec3 places[count];
    vec3 normals[count];
    float height = 0.0f;
    float turn = 0.0f;
    float radius = 0.0f;
    vec2 code(0.0f);
    for (int k = 0; k < count; ++k)
    {
      const glm::dvec3 normal = glm::normalize(reference + bend * random.NextDirection());
      const glm::dvec3 along = random.NextDirection();
      const glm::dvec3 place =
        along - glm::dot(along, reference) * reference + rough * random.Next(-1.0, 1.0) * reference;
      normals[k] = k == 0 ? vec3(reference) : vec3(normal);
      places[k] = vec3(place);
      const vec2 own = vtkiOctahedralEncode(normals[k]);
      code = k == 0 ? own : code;
      const vec3 offset = places[k] - places[0];
      const float byCode =
        VTKI_TURN_PER_CODE * (std::abs(own.x - code.x) + std::abs(own.y - code.y));
      height = std::max(height, std::abs(glm::dot(normals[0], offset)));
      turn = std::max(turn, byCode);
      radius = std::max(radius, glm::length(offset));
      worstTurn =
        std::max(worstTurn, double(glm::length(normals[k] - normals[0])) - double(byCode));
    }
    const bool one = vtkiOneSurface(height, turn, radius, cosine, tolerance);
    bool all = true;
    for (int a = 0; a < count; ++a)
    {
      for (int b = 0; b < count; ++b)
      {
        // Rounding of positions and products of length one.
        all = all &&
          vtkiSameSurface(
            places[a] - places[b], normals[b], normals[a], cosine - 1e-6f, tolerance + 1e-6f);
      }
    }
    accepted += one;
    wrong += one && !all;
    declined += all && !one;
    planes += i % 4 == 0 && one;
  }
  CheckAtMost("length between normals beyond that of their codes", worstTurn, 1e-6, "rounding");
  CheckEqual("taken for one surface though a pair disagrees", wrong, 0);
  CheckEqual("planes", planes, 25000);
  CheckAtLeast("bent or rough surfaces taken for one", accepted - planes, 1000, "the test's power");
  CheckAtLeast("agreeing pairs not taken for one", declined, 1, "the bounds are not exact");
}

VTK_INDIRECT_TEST(Gamma)
{
  double worst = 0.0;
  double encoded = 0.0;
  for (int i = 0; i <= 4000; ++i)
  {
    const auto v = static_cast<float>(i / 1000.0);
    const vec3 round = vtkiEncodeGamma(vtkiDecodeGamma(vec3(v, 0.5f * v, 2.0f * v)));
    worst = std::max(worst, std::abs(round.x - double(v)) / std::max(double(v), 1e-3));
    encoded = std::max(encoded,
      std::abs(vtkiDecodeGamma(vec3(v)).y - std::pow(double(v), 2.2)) /
        std::max(std::pow(double(v), 2.2), 1e-9));
  }
  CheckAtMost("round trip, worst relative error", worst, 1e-6, "two rounded powers");
  CheckAtMost("decoding against double precision", encoded, 1e-6, "the rounded exponent");
  const vec3 black = vtkiDecodeGamma(vec3(-1.0f, 0.0f, -1e-30f));
  Check("nothing below zero comes out", black == vec3(0.0f));
}
