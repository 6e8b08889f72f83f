// SPDX-License-Identifier: BSD-3-Clause
// The lobe of a specular sender: integrals, flux over the hemisphere, limits.
#include "OpenGL/vtkIndirectKernels.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

namespace
{
const double Exponents[] = { 0.0, 0.3, 1.0, 2.0, 5.0, 20.0, 128.0, 1e3, 1e4, 1e5, 1e6 };
// Elevations of the axis over the surface, down to grazing.
const double Elevations[] = { 0.0, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.3, 0.7, 1.2, 1.5707963267948966 };

// The integral over the hemisphere about z of max(r.w, 0)^power times (w.z)^cosines, in double
// precision. About the axis: rings of angle a, on which the part above the horizon is an arc (for
// its length) whose heights integrate in closed form.
double IntegrateLobe(double power, double elevation, int cosines)
{
  const double s = std::sin(elevation);
  const double c = std::cos(elevation);
  auto ring = [&](double a)
  {
    // Heights on the ring: s cos a + c sin a cos t, t in [-pi, pi].
    const double mean = s * std::cos(a);
    const double swing = c * std::sin(a);
    double t = vtkMath::Pi();
    if (mean < swing)
    {
      t = std::acos(std::max(-mean / swing, -1.0));
    }
    return cosines == 0 ? 2.0 * t : 2.0 * (mean * t + swing * std::sin(t));
  };
  // Two pieces, on both sides of the angle at which rings meet the horizon, which has a root there.
  const double meet = std::asin(s);
  const double width = std::min(0.5 * vtkMath::Pi(), 12.0 / std::sqrt(power + 1.0));
  auto piece = [&](double from, double to)
  {
    if (!(to > from))
    {
      return 0.0;
    }
    auto f = [&](double u)
    {
      const double a = from + (to - from) * u * u * (3.0 - 2.0 * u);
      return std::exp(power * std::log(std::max(std::cos(a), 1e-300))) * std::sin(a) * ring(a) *
        6.0 * u * (1.0 - u) * (to - from);
    };
    return Integrate(0.0, 1.0, f, 4000);
  };
  return piece(0.0, std::min(meet, width)) + piece(std::min(meet, width), width);
}
}

VTK_INDIRECT_TEST(SenderLobeIntegrals)
{
  CheckRelative("quadrature of a cosine", IntegrateLobe(1.0, 0.5 * vtkMath::Pi(), 0), vtkMath::Pi(),
    1e-9, "rounding");
  CheckRelative("quadrature of a lune", IntegrateLobe(0.0, 0.3, 0), vtkMath::Pi() + 0.6, 1e-7,
    "the ends of 4000 intervals");
  double integral = 0.0;
  double flux = 0.0;
  double worse = 0.0;
  for (const double power : Exponents)
  {
    for (const double elevation : Elevations)
    {
      const auto p = static_cast<float>(power);
      const auto cosine = static_cast<float>(std::sin(elevation));
      const double n =
        std::abs(vtkiLobeIntegral(p, cosine) / IntegrateLobe(power, elevation, 0) - 1.0);
      integral = std::max(integral, n);
      worse = std::max(worse, power >= 10.0 ? n : 0.0);
      flux = std::max(
        flux, std::abs(vtkiPhongFlux(p, cosine) / IntegrateLobe(power, elevation, 1) - 1.0));
    }
  }
  CheckAtMost("clamped lobe, exponents 0 to 1e6, grazing to upright, worst relative error",
    integral, 0.009, "Wallace's approximation at one degree of freedom");
  CheckAtMost("the same from exponent 10 on", worse, 5e-4, "Wallace's approximation at eleven");
  CheckAtMost("flux of a Phong surface, worst relative error", flux, 2.5e-3,
    "Wallace's approximation at two degrees of freedom");
  Check("the whole lobe in place of the clamped one would be rejected",
    !WouldPass(2.0 * vtkMath::Pi() / 21.0, IntegrateLobe(20.0, 0.03, 0), 0.01));
}

VTK_INDIRECT_TEST(SenderLobeFlux)
{
  // Irradiance of a sphere about the light, which the lobe meets at a right angle, times its area.
  // The lobe is narrow: directions are placed about its axis in rings.
  double worst = 0.0;
  const double area = 1e-3;
  for (const double power : Exponents)
  {
    for (const double elevation : Elevations)
    {
      for (const double distance : { 1e-4, 0.03, 1.0, 30.0 })
      {
        const glm::dvec3 axis(std::cos(elevation), 0.0, std::sin(elevation));
        const glm::dvec3 side(0.0, 1.0, 0.0);
        const glm::dvec3 up = glm::cross(axis, side);
        const double widened = vtkiLobeExponent(
          static_cast<float>(power), static_cast<float>(distance), static_cast<float>(area));
        const double width = std::min(0.5 * vtkMath::Pi(), 8.0 / std::sqrt(widened + 1.0));
        const int rings = 200;
        const int steps = 200;
        double sum = 0.0;
        for (int i = 0; i < rings; ++i)
        {
          const double a = width * (i + 0.5) / rings;
          for (int j = 0; j < steps; ++j)
          {
            const double t = 2.0 * vtkMath::Pi() * (j + 0.5) / steps;
            const glm::dvec3 w =
              std::cos(a) * axis + std::sin(a) * (std::cos(t) * side + std::sin(t) * up);
            const vec3 toSender(-distance * w);
            sum += vtkiSenderLobeWeight(toSender, vec3(0.0f, 0.0f, 1.0f), glm::normalize(toSender),
                     vec3(axis), static_cast<float>(power), static_cast<float>(area)) *
              std::sin(a) * (width / rings) * (2.0 * vtkMath::Pi() / steps);
          }
        }
        // The kernel's denominator contains the light's own size.
        const double flux = sum *
          (distance * distance +
            static_cast<double>(
              vtkiLobeSize(static_cast<float>(widened), static_cast<float>(area))));
        worst = std::max(worst, std::abs(flux - 1.0));
      }
    }
  }
  CheckAtMost("flux over the hemisphere, exponents 0 to 1e6, grazing to upright, at any distance",
    worst, 0.01, "0.9 % of the lobe's integral and 0.1 % of steps across the horizon");
}

VTK_INDIRECT_TEST(SenderLobeLimits)
{
  Random random(21);
  int notFinite = 0;
  int unbounded = 0;
  int behind = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const double power = i % 7 == 0 ? 0.0 : random.NextMagnitude(1e-3, 1e6);
    const double area = random.NextMagnitude(1e-12, 1e2);
    const double r = i % 11 == 0 ? 0.0 : random.NextMagnitude(1e-9, 1e3);
    const vec3 normal(random.NextDirection());
    vec3 direction(random.NextDirection());
    direction = dot(direction, normal) < 0.0f ? -direction : direction;
    const glm::dvec3 w = i % 3 == 0 ? glm::dvec3(direction) : random.NextDirection();
    const vec3 toSender(-r * w);
    const vec3 receiver(random.NextDirection());
    const float weight = vtkiSenderLobeWeight(
      toSender, normal, receiver, direction, static_cast<float>(power), static_cast<float>(area));
    const float variation = vtkiSenderLobeVariation(
      toSender, normal, direction, static_cast<float>(power), static_cast<float>(area), 0.01f);
    notFinite += std::isfinite(weight) && weight >= 0.0f && std::isfinite(variation) ? 0 : 1;
    // A light of flux one sends one over its area, and twice that if half of the lobe is cut off.
    const double most = 2.0 / area;
    unbounded += weight <= 1.01 * most ? 0 : 1;
    behind += dot(normal, vec3(w)) <= 0.0f && weight > 0.0f ? 1 : 0;
  }
  CheckEqual("weights and variations that are no numbers, or negative", notFinite, 0);
  CheckEqual("weights beyond their bound", unbounded, 0);
  CheckEqual("weights of what is behind the sender", behind, 0);

  // A flat mirror in pieces: with lobes at least as wide as the pieces, their light on a wall is
  // even.
  for (const double distance : { 0.1, 1.0 })
  {
    const int edge = 40;
    const double step = 0.02;
    double least = 1e30;
    double most = 0.0;
    for (int k = 0; k < 21; ++k)
    {
      double sum = 0.0;
      for (int i = 0; i < edge * edge; ++i)
      {
        const glm::dvec3 at(step * (i % edge - edge / 2), step * (i / edge - edge / 2), 0.0);
        const glm::dvec3 receiver(step * k / 20.0, 0.3 * step * k / 20.0, distance);
        sum += vtkiSenderLobeWeight(vec3(at - receiver), vec3(0.0f, 0.0f, 1.0f),
          vec3(0.0f, 0.0f, -1.0f), vec3(0.0f, 0.0f, 1.0f), 1e6f, static_cast<float>(step * step));
      }
      least = std::min(least, sum * step * step);
      most = std::max(most, sum * step * step);
    }
    CheckRelative("beam of a mirror in pieces, brightest place", most, 1.0, 0.1,
      "what overlap of neighbours leaves, and the disks' own size");
    CheckRelative("darkest place", least, 1.0, 0.1, "the same");
  }
}
