// SPDX-License-Identifier: BSD-3-Clause
// The specular lobe of a receiver, and its bounds over a patch of surface.
#include "OpenGL/vtkIndirectKernels.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

VTK_INDIRECT_TEST(GlossyLobe)
{
  Random random(41);
  double worst = 0.0;
  int lit = 0;
  int steps = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const vec3 n(random.NextDirection());
    const vec3 s(random.NextDirection());
    const vec3 position(glm::dvec3(random.NextDirection() * random.NextMagnitude(1e-3, 1e3)));
    const vec3 d(glm::dvec3(random.NextDirection() * random.NextMagnitude(1e-3, 1e3)));
    const float power = static_cast<float>(random.NextMagnitude(0.1, 128.0));
    const float area = static_cast<float>(random.NextMagnitude(1e-6, 1e2));
    const double measured = vtkiGlossyWeight(d, s, n, vtkiMirror(position, n), power, area);
    // VTK's shader: reflect(-l, n) . v, and no lobe below the horizon.
    const glm::dvec3 nd = glm::normalize(glm::dvec3(n));
    const glm::dvec3 l = glm::normalize(glm::dvec3(d));
    const double mirrored = glm::dot(glm::reflect(-l, nd), -glm::normalize(glm::dvec3(position)));
    const double r2 = glm::dot(glm::dvec3(d), glm::dvec3(d));
    const double cosine = std::max(-glm::dot(glm::dvec3(s), l), 0.0);
    const double lobe = mirrored > 0.0 && glm::dot(nd, l) > 0.0 ? std::pow(mirrored, power) : 0.0;
    const double strength = 1.0 / (vtkMath::Pi() * r2 + area);
    if (std::abs(glm::dot(nd, l)) < 1e-6)
    {
      ++steps;
      continue;
    }
    lit += lobe > 0.1 ? 1 : 0;
    worst = std::max(worst, std::abs(measured - cosine * strength * lobe) / strength);
  }
  CheckAtLeast("lobes", lit, 1000, "the test's own power");
  CheckAtMost("lights on the horizon, left out", steps, 10, "VTK's lobe has a step there");
  CheckAtMost("worst difference to VTK's formula, over the light's strength", worst, 1e-4,
    "128 times the rounding of a cosine of 32-bit floats, 2^-24, a few times");
  CheckEqual("where sender and receiver coincide",
    vtkiGlossyWeight(vec3(0.0f), vec3(0.0f, 0.0f, 1.0f), vec3(0.0f, 0.0f, 1.0f),
      vec3(0.0f, 0.0f, 1.0f), 10.0f, 1.0f),
    0.0);
  const vec3 mirror = vtkiMirror(vec3(0.0f), vec3(0.0f, 0.0f, 1.0f));
  CheckEqual("mirror direction of an eye in the surface", mirror.z, 1.0);
}

// The bound of a patch's error holds for anything on the patch.
VTK_INDIRECT_TEST(GlossyVariation)
{
  Random random(42);
  double worst = 0.0;
  double tightest = 1e30;
  int hits = 0;
  int hidden = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const glm::dvec3 n = random.NextDirection();
    const glm::dvec3 eye = random.NextDirection() * random.NextMagnitude(0.05, 10.0);
    const glm::dvec3 light = random.NextDirection() * random.NextMagnitude(0.01, 10.0);
    const glm::dvec3 s = random.NextDirection();
    const double radius = random.NextMagnitude(1e-4, 0.1);
    const double turn = random.NextMagnitude(1e-4, 0.2);
    const float power = static_cast<float>(random.NextMagnitude(1.0, 128.0));
    const float area = static_cast<float>(random.NextMagnitude(1e-6, 1e-1));
    auto weight = [&](const glm::dvec3& p, const glm::dvec3& normal)
    {
      const vec3 normalR(normal);
      return static_cast<double>(vtkiGlossyWeight(
        vec3(light - p), vec3(s), normalR, vtkiMirror(vec3(p - eye), normalR), power, area));
    };
    const vec3 normalR(n);
    const double bound = vtkiGlossyVariation(vec3(light), vec3(s), vtkiMirror(vec3(-eye), normalR),
      power, area, static_cast<float>(radius), static_cast<float>(turn),
      static_cast<float>(glm::length(eye)), false);
    const float horizon =
      vtkiGlossyHorizon(vec3(light), normalR, static_cast<float>(radius), static_cast<float>(turn));
    for (int k = 0; k < 16; ++k)
    {
      const glm::dvec3 p = random.NextDirection() * (radius * random.Next());
      // A normal turned by at most this angle.
      const glm::dvec3 axis = glm::normalize(glm::cross(n, random.NextDirection()));
      const double angle = turn * random.Next();
      const glm::dvec3 normal = std::cos(angle) * n + std::sin(angle) * axis;
      const double value = weight(p, normal);
      if (value > 0.0)
      {
        ++hits;
        // Far out in a lobe 32-bit cosines have an error of a few roundings times the power.
        worst = std::max(worst, value / std::max(bound, 1e-30));
        hidden += horizon < 0.0f ? 1 : 0;
        tightest = std::min(tightest, bound / value);
      }
    }
  }
  CheckAtLeast("weights on patches", hits, 10000, "the test's own power");
  CheckAtMost("largest weight over its patch's bound", worst, 1.001, "rounding");
  CheckAtMost(
    "smallest bound over a weight", tightest, 2.0, "the test's own power: it is no wide bound");
  CheckEqual("weights where all of the patch was thought below the horizon", hidden, 0);
}

VTK_INDIRECT_TEST(GlossyBesideMirrors)
{
  // No receiver of a tile sees the lights left out of its list.
  Random random(61);
  double most = 0.0;
  int left = 0;
  int kept = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const auto radius = static_cast<float>(random.NextMagnitude(1e-4, 0.3));
    const vec3 axis(random.NextDirection());
    const double spread = random.Next(0.0, 0.6);
    const auto power = static_cast<float>(i % 10 == 0 ? 0.0 : random.NextMagnitude(1.0, 1e6));
    const vec3 toSender(random.NextDirection() * random.NextMagnitude(1e-3, 1.0));
    const bool beside =
      vtkiIsBesideMirrors(toSender, radius, axis, static_cast<float>(std::cos(spread)), power);
    left += beside;
    kept += !beside;
    for (int k = 0; beside && k < 10; ++k)
    {
      // A mirror direction at the cone's edge and a receiver at the ball's, towards the sender.
      const glm::dvec3 towards = glm::normalize(
        glm::dvec3(toSender) - glm::dot(glm::dvec3(toSender), glm::dvec3(axis)) * glm::dvec3(axis));
      const double turn = k == 0 ? spread : spread * random.Next();
      const glm::dvec3 mirror = std::cos(turn) * glm::dvec3(axis) + std::sin(turn) * towards;
      const glm::dvec3 way = glm::dvec3(toSender) +
        double(radius) * (k < 5 ? glm::normalize(mirror) : random.NextDirection());
      const double cosine = glm::dot(glm::normalize(way), mirror);
      most = std::max(most, cosine > 0.0 ? std::pow(cosine, double(power)) : 0.0);
    }
  }
  CheckAtLeast("senders that are left out", left, 3000, "the test's own power");
  CheckAtLeast("senders that are kept", kept, 3000, "the test's own power");
  CheckAtMost("largest lobe towards one that is left out", most, 1.2e-7, "exp(-16)");
}
