// SPDX-License-Identifier: BSD-3-Clause
// Bounds of senders' lobes: they contain all places where a lobe counts, and little else.
#include "OpenGL/vtkIndirectKernels.h"
#include "vtkIndirectTestUtilities.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

namespace
{
/** A lobe about an axis over a surface, of a flux over the lowest intensity that counts. */
struct Lobe
{
  glm::dvec3 Position;
  glm::dvec3 Axis;
  glm::dvec3 Side; // across the axis, towards the normal
  glm::dvec3 Normal;
  float Exponent;
  float Area;
  float Flux;

  vtkiSplat GetSplat() const
  {
    return vtkiWithinScene(vtkiMakeLobeSplat(vec3(this->Position), vec3(this->Axis),
      dot(vec3(this->Normal), vec3(this->Axis)), this->Exponent, this->Area, this->Flux));
  }

  glm::dvec3 GetPlace(double distance, double angle) const
  {
    return distance * (std::cos(angle) * this->Axis + std::sin(angle) * this->Side);
  }

  /** Returns the intensity over the squared distance, over the lowest that counts, by the shaders'
   * kernel. */
  float GetLevel(double distance, double angle) const
  {
    const vec3 toSender(-this->GetPlace(distance, angle));
    return this->Flux * length(toSender) *
      vtkiSenderLobeStrength(
        toSender, vec3(this->Normal), vec3(this->Axis), this->Exponent, this->Area);
  }

  /** The largest sampled angle at which the lobe counts at this distance; negative: none. Levels
   * fall with the angle, on the side on which the surface does not end them. */
  double FindEdge(double distance) const
  {
    if (!(this->GetLevel(distance, 0.0) >= 1.0f))
    {
      return -1.0;
    }
    double least = std::log(1e-9);
    double most = std::log(1.5707963);
    if (this->GetLevel(distance, std::exp(most)) >= 1.0f)
    {
      return std::exp(most);
    }
    for (int i = 0; i < 40; ++i)
    {
      const double middle = 0.5 * (least + most);
      (this->GetLevel(distance, std::exp(middle)) >= 1.0f ? least : most) = middle;
    }
    return std::exp(least);
  }
};

/** Place of a point relative to an ellipsoid, in double precision: 1 on it, more outside. */
double FindLobePlace(const vtkiSplat& splat, const glm::dvec3& p)
{
  const glm::dvec3 d = p - glm::dvec3(splat.center);
  const double along = glm::dot(d, glm::dvec3(splat.axis));
  const glm::dvec3 aside = d - along * glm::dvec3(splat.axis);
  return std::hypot(along / splat.along, glm::length(aside) / splat.across);
}

// Grazing to upright.
const double Elevations[] = { 0.0, 1e-4, 0.03, 0.7, 1.5707963267948966 };

Lobe MakeLobe(Random& random, double exponent, double elevation)
{
  Lobe lobe;
  lobe.Axis = glm::dvec3(0.0, 0.0, 1.0);
  lobe.Side = glm::dvec3(1.0, 0.0, 0.0);
  lobe.Normal = std::sin(elevation) * lobe.Axis + std::cos(elevation) * lobe.Side;
  lobe.Position = glm::dvec3(0.0);
  lobe.Exponent = static_cast<float>(exponent);
  lobe.Area = static_cast<float>(random.NextMagnitude(1e-10, 0.5));
  // From lobes that count nowhere to lobes that count everywhere.
  lobe.Flux = static_cast<float>(lobe.Area * random.NextMagnitude(0.3, 1e8));
  return lobe;
}
}

VTK_INDIRECT_TEST(LobeSplatHoldsKernel)
{
  Random random(51);
  double outside = 0.0;
  double tightest = 1e9;
  double asPaper = 0.0;
  int lost = 0;
  int none = 0;
  int lobes = 0;
  // Exponents 0 and 1e-3 to 1e6, four a decade.
  for (int i = -13; i <= 24; ++i)
  {
    const double exponent = i == -13 ? 0.0 : std::pow(10.0, 0.25 * i);
    for (const double elevation : Elevations)
    {
      for (int k = 0; k < 12; ++k, ++lobes)
      {
        const Lobe lobe = MakeLobe(random, exponent, elevation);
        const vtkiSplat splat = lobe.GetSplat();
        // The paper's ellipsoid, without the region of lower exponents.
        const vtkiSplat paper = vtkiMakeSplat(vec3(0.0f), vec3(lobe.Axis), lobe.Exponent,
          std::sqrt(
            lobe.Flux / vtkiLobeIntegral(lobe.Exponent, dot(vec3(lobe.Normal), vec3(lobe.Axis)))),
          0.0f);
        double farthest = 0.0;
        for (int step = 0; step <= 160; ++step)
        {
          const double distance = std::pow(10.0, -7.0 * (1.0 - step / 160.0));
          const double edge = lobe.FindEdge(distance);
          if (edge >= 0.0)
          {
            lost += splat.across > 0.0f ? 0 : 1;
            const glm::dvec3 place = lobe.GetPlace(distance, edge);
            farthest = std::max(farthest, FindLobePlace(splat, place));
            asPaper = std::max(asPaper, FindLobePlace(paper, place));
          }
        }
        none += splat.across > 0.0f ? 0 : 1;
        outside = std::max(outside, splat.across > 0.0f ? farthest : 0.0);
        // A lobe that hardly counts anywhere has the bounds of a light without size.
        const bool bright = lobe.Flux > 4.0f * lobe.Area;
        tightest = std::min(tightest, bright && farthest > 0.0 ? farthest : 1e9);
      }
    }
  }
  CheckEqual("lobes", lobes, 2280);
  CheckEqual("places where a lobe counts that has no splat", lost, 0);
  CheckAtLeast("lobes that count nowhere, of 2280", none, 10, "the test's own power");
  CheckAtMost("farthest place at which a lobe counts, in half axes", outside, 1.0,
    "an ellipsoid that holds it; the margin covers rounding");
  CheckAtLeast("the same by the paper's ellipsoid alone", asPaper, 1.3, "the test's own power");
  CheckAtLeast(
    "farthest place of the loosest ellipsoid", tightest, 0.3, "no splat is far too large");
}

VTK_INDIRECT_TEST(LobeSplatAnywhere)
{
  // Rotated and moved, where positions are rounded by 6e-8 scene units, and against an ellipsoid
  // about a ball within which the exponent is arbitrary.
  Random random(52);
  double outside = 0.0;
  double narrower = 0.0;
  for (int i = 0; i < 3000; ++i)
  {
    const double exponent = i % 10 == 0 ? 0.0 : random.NextMagnitude(1e-2, 1e6);
    Lobe lobe = MakeLobe(random, exponent, Elevations[i % 5]);
    const glm::dvec3 axis = random.NextDirection();
    const glm::dvec3 side = glm::normalize(glm::cross(axis, random.NextDirection()));
    lobe.Normal = lobe.Normal.z * axis + lobe.Normal.x * side;
    lobe.Axis = axis;
    lobe.Side = side;
    lobe.Position = 0.5 * random.Next() * random.NextDirection();
    const vtkiSplat splat = lobe.GetSplat();
    for (int k = 0; k < 20; ++k)
    {
      const double distance = random.NextMagnitude(1e-6, 1.0);
      const double edge = lobe.FindEdge(distance);
      const glm::dvec3 place = lobe.Position + lobe.GetPlace(distance, edge);
      // Receivers are no farther from the middle of the scene than lights.
      if (edge >= 0.0 && glm::length(place) <= 0.5)
      {
        const double rounding = 2e-7 / std::min(splat.along, splat.across);
        outside = std::max(outside, FindLobePlace(splat, place) - rounding);
      }
    }
    const vtkiSplat ball =
      vtkiWithinScene(vtkiMakeSplat(vec3(lobe.Position), vec3(lobe.Axis), lobe.Exponent,
        std::sqrt(
          lobe.Flux / vtkiLobeIntegral(lobe.Exponent, dot(vec3(lobe.Normal), vec3(lobe.Axis)))),
        vtkiLobeReach(lobe.Exponent, lobe.Area)));
    narrower += splat.across < 0.5f * ball.across ? 1.0 / 3000.0 : 0.0;
  }
  CheckAtMost("farthest place at which a lobe counts, in half axes", outside, 1.0, "it is held");
  CheckAtLeast("share of lobes less than half as wide as with the ball held", narrower, 0.3,
    "mirrors would light all of a scene");
}
