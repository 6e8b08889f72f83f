// SPDX-License-Identifier: BSD-3-Clause
// Specular reflection of rectangles by receivers, against sums over the rectangle in double
// precision of the lobes as VTK's lights evaluate them.
#include "Maps/vtkIndirectLobeTable.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "vtkIndirectTestUtilities.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

namespace
{
const double Pi = std::acos(-1.0);
const glm::dvec3 Normal(0, 0, 1);

struct Rectangle
{
  glm::dvec3 Corner;
  glm::dvec3 Edge1;
  glm::dvec3 Edge2;

  // The integral of a function of directions, over edge squared cells.
  double Sum(const std::function<double(const glm::dvec3&)>& function, int edge) const
  {
    const glm::dvec3 span = glm::cross(this->Edge1, this->Edge2);
    double sum = 0.0;
    for (int j = 0; j < edge; ++j)
    {
      for (int i = 0; i < edge; ++i)
      {
        const glm::dvec3 way =
          this->Corner + (i + 0.5) / edge * this->Edge1 + (j + 0.5) / edge * this->Edge2;
        const double r = glm::length(way);
        sum += function(way / r) * std::abs(glm::dot(span, way)) / (r * r * r);
      }
    }
    return sum / edge / edge;
  }
  double Power(const glm::dvec3& mirror, double power) const
  {
    return vtkiPowerIntegral(vec3(this->Corner), vec3(this->Edge1), vec3(this->Edge2), vec3(Normal),
      vec3(mirror), static_cast<float>(power), true);
  }
  double Share(const vtkiTransform& transform) const
  {
    return vtkiTransformedShare(
      vec3(this->Corner), vec3(this->Edge1), vec3(this->Edge2), vec3(Normal), transform, true);
  }
};

glm::dvec3 Mirror(const glm::dvec3& way)
{
  return 2.0 * glm::dot(Normal, way) * Normal - way;
}

glm::dvec3 View(double cosine)
{
  return { std::sqrt(1.0 - cosine * cosine), 0.0, cosine };
}

// Rectangles around the point where the mirrored view meets a plane, and beside it; also across the
// horizon.
std::vector<Rectangle> MakeRectangles(const glm::dvec3& mirror)
{
  std::vector<Rectangle> all;
  const glm::dvec3 x = glm::normalize(glm::cross(mirror, glm::dvec3(0.1, 1.0, 0.3)));
  const glm::dvec3 y = glm::cross(mirror, x);
  for (const double edge : { 0.3, 1.0, 4.0 })
  {
    for (const double beside : { 0.0, 0.5, 1.2 })
    {
      for (const double turn : { 0.0, 0.6 })
      {
        const glm::dvec3 along = std::cos(turn) * x + std::sin(turn) * mirror;
        const glm::dvec3 middle = mirror + beside * (0.8 * x + 0.6 * y);
        all.push_back({ middle - 0.5 * edge * (along + y), edge * along, edge * y });
      }
    }
  }
  return all;
}

double Interpolate(double row, double column, int entry)
{
  const int last = vtkIndirectLobeEntries - 1;
  const int i = std::min(static_cast<int>(row), last - 1);
  const int j = std::min(static_cast<int>(column), last - 1);
  auto mix = [](double a, double b, double t) { return a + t * (b - a); };
  auto at = [&](int k)
  {
    return mix(
      vtkIndirectLobeTable[k][j][entry], vtkIndirectLobeTable[k][j + 1][entry], column - j);
  };
  return mix(at(i), at(i + 1), row - i);
}

// VTK's PBR with F0 and F90 of one: D V cosL.
double TrowbridgeReitz(const glm::dvec3& light, const glm::dvec3& view, double roughness)
{
  if (light.z <= 0.0)
  {
    return 0.0;
  }
  const glm::dvec3 middle = glm::normalize(light + view);
  const double alpha2 = std::pow(roughness, 4.0);
  const double d = (middle.z * alpha2 - middle.z) * middle.z + 1.0;
  const double a2 = roughness * roughness;
  const double shared = 0.5 /
    (light.z * std::sqrt(a2 + view.z * view.z * (1.0 - a2)) +
      view.z * std::sqrt(a2 + light.z * light.z * (1.0 - a2)));
  return alpha2 / (Pi * d * d) * shared * light.z;
}
}

VTK_INDIRECT_TEST(LobeOfAPower)
{
  for (const double power : { 0.0, 1.0, 5.5, 20.0, 60.0, 100.0, 1000.0 })
  {
    const Rectangle wide = { { -500.0, -500.0, 0.01 }, { 1000, 0, 0 }, { 0, 1000, 0 } };
    CheckRelative("power " + std::to_string(power) + ", all around", wide.Power(Normal, power),
      2.0 * Pi / (power + 1.0), 1e-3, "a square of 1000 at a hundredth, eight nodes an edge");
    double worst = 0.0;
    for (const double cosine : { 1.0, 0.8, 0.5, 0.2 })
    {
      const glm::dvec3 mirror = Mirror(View(cosine));
      for (const Rectangle& rectangle : MakeRectangles(mirror))
      {
        auto lobe = [&](const glm::dvec3& way)
        {
          const double mirrored = way.z > 0.0 ? glm::dot(mirror, way) : 0.0;
          return mirrored > 0.0 ? std::pow(mirrored, power) : 0.0;
        };
        const double expected = rectangle.Sum(lobe, power > 100.0 ? 600 : 300);
        const double measured = rectangle.Power(mirror, power);
        worst = std::max(worst, std::abs(measured - expected) * (power + 1.0) / (2.0 * Pi));
      }
    }
    CheckAtMost("power " + std::to_string(power) + ": error over all around", worst, 2e-3,
      "sums of 300 x 300, cut at the horizon in steps of these");
  }
}

VTK_INDIRECT_TEST(LobeOfTrowbridgeReitz)
{
  // Bound of the error for any part of the sphere: half of that of fit_lobes.py --errors, and the
  // error of interpolation.
  struct Views
  {
    std::vector<double> Cosines;
    double Error;
  };
  const Views all[] = { { { 1.0, 0.95, 0.8 }, 0.045 }, { { 0.65, 0.5 }, 0.075 },
    { { 0.3, 0.15 }, 0.13 } };
  for (const Views& views : all)
  {
    double worst = 0.0;
    double mean = 0.0;
    int count = 0;
    for (const double cosine : views.Cosines)
    {
      for (const double roughness : { 0.1, 0.2, 0.33, 0.5, 0.7, 0.85, 1.0 })
      {
        const glm::dvec3 view = View(cosine);
        const vec2 place = vtkiTablePlace(
          static_cast<float>(cosine), static_cast<float>(roughness), vtkIndirectLeastRoughness);
        const double last = vtkIndirectLobeEntries - 1;
        float entries[6];
        for (int k = 0; k < 6; ++k)
        {
          entries[k] = static_cast<float>(Interpolate(place.y * last, place.x * last, k));
        }
        const vtkiTransform transform = vtkiTableTransform(
          vec4(entries[0], entries[1], entries[2], entries[3]), vec3(Normal), vec3(view));
        for (const Rectangle& rectangle : MakeRectangles(Mirror(view)))
        {
          const double expected = rectangle.Sum([&](const glm::dvec3& way)
            { return TrowbridgeReitz(way, view, roughness); },
            roughness < 0.15    ? 1000
              : roughness < 0.3 ? 600
                                : 200);
          const double measured = entries[4] * rectangle.Share(transform);
          const double error = std::abs(measured - expected) / entries[4];
          worst = std::max(worst, error);
          mean += error;
          ++count;
        }
      }
    }
    const std::string name = "views down to " + std::to_string(views.Cosines.back());
    CheckAtMost(name + ": error over all around", worst, views.Error, "the fit's own error");
    CheckAtMost(name + ": its mean", mean / count, 0.25 * views.Error, "the fit's own error");
  }
}

// Rectangles of all sizes, places and orientations, and lobes from the whole hemisphere to a tenth
// of a degree: shares of at most one, and always numbers.
VTK_INDIRECT_TEST(LobeExtremes)
{
  Random random(11);
  int bad = 0;
  double most = 0.0;
  double mostOfCosines = 0.0;
  for (int i = 0; i < 200000; ++i)
  {
    const double size = random.NextMagnitude(1e-5, 1e5);
    const Rectangle rectangle = { random.NextMagnitude(1e-6, 1e6) * random.NextDirection(),
      size * random.NextDirection(), size * random.NextDirection() };
    glm::dvec3 mirror = random.NextDirection();
    mirror.z = std::abs(mirror.z);
    const double power = i % 7 == 0 ? 0.0 : random.NextMagnitude(0.1, 3e4);
    const double share =
      rectangle.Power(i % 5 == 0 ? Normal : mirror, power) * (power + 1.0) / (2.0 * Pi);
    const int row = i % vtkIndirectLobeEntries;
    const int column = (i / vtkIndirectLobeEntries) % vtkIndirectLobeEntries;
    const float* entry = vtkIndirectLobeTable[row][column];
    const double ofCosines = rectangle.Share(
      vtkiTableTransform(vec4(entry[0], entry[1], entry[2], entry[3]), vec3(Normal), vec3(mirror)));
    bad += std::isfinite(share) && std::isfinite(ofCosines) ? 0 : 1;
    most = std::max(most, share);
    mostOfCosines = std::max(mostOfCosines, ofCosines);
  }
  CheckEqual("values that are no numbers", bad, 0);
  CheckAtMost("share of all around, powers", most, 1.0 + 1e-6, "single precision");
  CheckAtMost("share of all around, cosines", mostOfCosines, 1.0 + 1e-6, "single precision");
}
