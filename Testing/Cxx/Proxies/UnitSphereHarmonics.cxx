// SPDX-License-Identifier: BSD-3-Clause
// Sums over spheres in spherical harmonics of order 4, against quadrature and closed forms.
#include "OpenGL/vtkIndirectKernels.h"
#include "Proxies/vtkIndirectCoefficient.h"
#include "Proxies/vtkIndirectProxyTable.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

namespace
{
constexpr int Count = 16;

vtkiHarmonics4 Zero()
{
  vtkiHarmonics4 f;
  f.A = f.B = f.C = f.D = vec4(0.0f);
  return f;
}

vtkiHarmonics4 RandomVector(Random& random, double size)
{
  vtkiHarmonics4 f = Zero();
  double sum = 0.0;
  for (int i = 0; i < Count; ++i)
  {
    vtkIndirectCoefficient(f, i) = static_cast<float>(random.Next(-1.0, 1.0));
    sum += vtkIndirectCoefficient(f, i) * vtkIndirectCoefficient(f, i);
  }
  return vtkiHarmonicsAdd(Zero(), static_cast<float>(size / std::sqrt(sum)), f);
}

double Value(const vtkiHarmonics4& f, const glm::dvec3& d)
{
  return vtkiHarmonicsDot(f, vtkiHarmonics4At(vec3(d)));
}

double Distance(vtkiHarmonics4 f, vtkiHarmonics4 g)
{
  const vtkiHarmonics4 h = vtkiHarmonicsAdd(f, -1.0f, g);
  return std::sqrt(vtkiHarmonicsDot(h, h));
}

// Directions and weights of a midpoint rule over the sphere.
void ForSphere(const std::function<void(const glm::dvec3&, double)>& f, int panels = 1)
{
  const int around = 40;
  const int rings = 160 * panels;
  for (int j = 0; j < rings; ++j)
  {
    const double z = -1.0 + (2.0 * j + 1.0) / rings;
    const double s = std::sqrt(1.0 - z * z);
    for (int i = 0; i < around; ++i)
    {
      const double phi = 2.0 * vtkMath::Pi() * (i + 0.5) / around;
      f({ s * std::cos(phi), s * std::sin(phi), z }, 4.0 * vtkMath::Pi() / rings / around);
    }
  }
}

vtkiHarmonics4 Project(const std::function<double(const glm::dvec3&)>& function)
{
  double sums[Count] = {};
  ForSphere(
    [&](const glm::dvec3& d, double weight)
    {
      vtkiHarmonics4 y = vtkiHarmonics4At(vec3(d));
      const double value = weight * function(d);
      for (int i = 0; i < Count; ++i)
      {
        sums[i] += value * vtkIndirectCoefficient(y, i);
      }
    });
  vtkiHarmonics4 f;
  for (int i = 0; i < Count; ++i)
  {
    vtkIndirectCoefficient(f, i) = static_cast<float>(sums[i]);
  }
  return f;
}

const char* const Midpoints = "midpoint rule of 160 rings: 1/160^2 times the second derivative";

// The logarithm of a sphere's visibility.
vtkiHarmonics4 LogVisibility(double sine, const glm::dvec3& d)
{
  const double at = vtkiProxyRow(static_cast<float>(sine)) * (vtkIndirectProxyEntries - 1);
  const int row = std::min(static_cast<int>(at), vtkIndirectProxyEntries - 2);
  vec4 zonal;
  for (int i = 0; i < 4; ++i)
  {
    const float low = vtkIndirectProxyTable[row][i];
    zonal[i] = vtkiProxyRow(static_cast<float>(sine)) *
      (low + static_cast<float>(at - row) * (vtkIndirectProxyTable[row + 1][i] - low));
  }
  return vtkiZonalTo(zonal, vec3(d));
}

// A sky of radiance 1.
vtkiLightMatrix UniformSky()
{
  vtkiHarmonics4 light = Zero();
  light.A.x = 1.0f / VTKI_HARMONICS_Y00;
  return vtkiMakeLightMatrix(light);
}
}

VTK_INDIRECT_TEST(SphereHarmonicsBasis)
{
  double worst = 0.0;
  for (int i = 0; i < Count; ++i)
  {
    vtkiHarmonics4 f = Project(
      [i](const glm::dvec3& d)
      {
        vtkiHarmonics4 y = vtkiHarmonics4At(vec3(d));
        return static_cast<double>(vtkIndirectCoefficient(y, i));
      });
    vtkIndirectCoefficient(f, i) -= 1.0f;
    worst = std::max(worst, Distance(f, Zero()));
  }
  CheckAtMost("the 16 functions, off from orthonormal", worst, 1e-3, Midpoints);
}

VTK_INDIRECT_TEST(SphereHarmonicsRotation)
{
  Random random(3);
  double worst = 0.0;
  for (int trial = 0; trial < 10; ++trial)
  {
    const vec4 zonal(random.Next(-1.0, 1.0), random.Next(-1.0, 1.0), random.Next(-1.0, 1.0),
      random.Next(-1.0, 1.0));
    const glm::dvec3 d = random.NextDirection();
    const vtkiHarmonics4 around = vtkiZonalTo(zonal, vec3(0.0f, 0.0f, 1.0f));
    const vtkiHarmonics4 turned = Project(
      [&](const glm::dvec3& w)
      {
        const double z = glm::dot(w, d);
        return Value(around, { std::sqrt(std::max(1.0 - z * z, 0.0)), 0.0, z });
      });
    worst = std::max(worst, Distance(vtkiZonalTo(zonal, vec3(d)), turned));
  }
  CheckAtMost("turned zonal functions", worst, 1e-3, Midpoints);
}

VTK_INDIRECT_TEST(SphereHarmonicsProduct)
{
  Random random(5);
  double worst = 0.0;
  double matrix = 0.0;
  double irradiance = 0.0;
  for (int trial = 0; trial < 10; ++trial)
  {
    const vtkiHarmonics4 f = RandomVector(random, 1.0);
    const vtkiHarmonics4 g = RandomVector(random, 1.0);
    const vtkiHarmonics4 exact =
      Project([&](const glm::dvec3& d) { return Value(f, d) * Value(g, d); });
    worst = std::max(worst, Distance(vtkiHarmonicProduct(f, g), exact));
    const glm::dvec3 n = random.NextDirection();
    const vtkiHarmonics4 lit = vtkiLitCosine(vtkiMakeLightMatrix(f), vec3(n));
    matrix = std::max(matrix, Distance(lit, vtkiHarmonicProduct(f, vtkiClampedCosine(vec3(n)))));
    // The integral of visibility, light and cosine is exact, with one product cut to order 4.
    double sum = 0.0;
    const vtkiHarmonics4 h = vtkiClampedCosine(vec3(n));
    ForSphere([&](const glm::dvec3& d, double weight)
      { sum += weight * Value(f, d) * Value(g, d) * Value(h, d); });
    irradiance = std::max(irradiance, std::abs(sum - vtkiHarmonicsDot(g, lit)));
  }
  CheckAtMost("products of two vectors of length 1", worst, 1e-3, Midpoints);
  CheckAtMost("the light's matrix against the product", matrix, 1e-6, "rounding");
  CheckAtMost("irradiance of light and what is seen", irradiance, 1e-3, Midpoints);
  // The cosine itself.
  const vtkiHarmonics4 cosine =
    Project([](const glm::dvec3& d) { return std::max(d.z, 0.0) / vtkMath::Pi(); });
  CheckAtMost("the clamped cosine over pi",
    Distance(cosine, vtkiClampedCosine(vec3(0.0f, 0.0f, 1.0f))), 1e-4, Midpoints);
}

VTK_INDIRECT_TEST(SphereHarmonicsExponential)
{
  Random random(7);
  const std::pair<double, double> sizes[] = { { 0.1, 2e-4 }, { 0.5, 1e-3 }, { 1.0, 6e-3 },
    { 2.0, 4e-2 } };
  for (const auto& size : sizes)
  {
    double worst = 0.0;
    for (int trial = 0; trial < 10; ++trial)
    {
      vtkiHarmonics4 f = RandomVector(random, size.first);
      f.A.x = static_cast<float>(-2.0 * size.first); // as for visibility with a mean below 1
      const vtkiHarmonics4 exact =
        Project([&](const glm::dvec3& d) { return std::exp(Value(f, d)); });
      worst = std::max(worst, Distance(vtkiHarmonicsExp(f), exact) / Distance(exact, Zero()));
    }
    CheckAtMost("exponential of length " + std::to_string(size.first) + ", relative", worst,
      size.second, "squares are cut to order 4 before they are squared again: grows as the cube");
  }
  // The visibility of any logarithm is finite and at most one.
  for (double times : { 1.0, 10.0, 1e3, 1e5 })
  {
    for (double sine : { 0.3, 0.7, 1.0 })
    {
      const vtkiHarmonics4 seen = vtkiHarmonicsExp(vtkiHarmonicsAdd(
        Zero(), static_cast<float>(times), LogVisibility(sine, { 0.0, 0.6, 0.8 })));
      const double mean = seen.A.x * VTKI_HARMONICS_Y00;
      Check(std::to_string(times) + " spheres of sine " + std::to_string(sine),
        std::isfinite(Distance(seen, Zero())) && mean > -0.02 && mean < 1.0 + 1e-5,
        std::to_string(mean));
    }
  }
}

// Error of the exponential in irradiance, over that of an open sky: for sums over one to sixty
// random spheres, up to 65 degrees to either side, against their visibility and against the exact
// exponential of the same sums. The sums are as long as in real scenes.
VTK_INDIRECT_TEST(SphereHarmonicsLongSums)
{
  struct Band
  {
    double Longest;
    double MostOff;   // RMS, from the visibility
    double MostApart; // from the exact exponential
    double Off = 0.0;
    double OffExact = 0.0;
    double Apart = 0.0;
    int Count = 0;
  };
  // A fifth more than measured.
  Band bands[] = { { 1.0, 0.005, 0.0003 }, { 4.0, 0.018, 0.007 }, { 8.0, 0.034, 0.024 },
    { 1e9, 0.026, 0.024 } };
  Random random(31);
  double bias = 0.0;
  Band all = { 0.0, 0.022, 0.0 };
  for (int trial = 0; trial < 300; ++trial)
  {
    const vec3 normal(random.NextDirection());
    const auto count = static_cast<int>(std::exp(random.Next(0.0, std::log(60.0))));
    std::vector<std::pair<glm::dvec3, double>> spheres; // directions, cosines of half their angles
    vtkiHarmonics4 sum = Zero();
    for (int i = 0; i < count; ++i)
    {
      const double sine = std::exp(random.Next(std::log(0.05), std::log(0.9)));
      spheres.emplace_back(random.NextDirection(), std::sqrt(1.0 - sine * sine));
      sum = vtkiHarmonicsAdd(sum, 1.0f, LogVisibility(sine, spheres.back().first));
    }
    vtkiHarmonics4 rest = sum;
    rest.A.x = 0.0f;
    const double length = Distance(rest, Zero());
    const vtkiHarmonics4 cosine = vtkiClampedCosine(normal);
    double seen = 0.0;
    double exact = 0.0;
    ForSphere(
      [&](const glm::dvec3& d, double weight)
      {
        exact += weight * std::exp(Value(sum, d)) * Value(cosine, d);
        const double lit = weight * std::max(glm::dot(d, glm::dvec3(normal)), 0.0) / vtkMath::Pi();
        seen += lit > 0.0 &&
            std::none_of(spheres.begin(), spheres.end(),
              [&d](const auto& sphere) { return glm::dot(d, sphere.first) > sphere.second; })
          ? lit
          : 0.0;
      });
    const double found = vtkiHarmonicsDot(vtkiHarmonicsExp(sum), cosine);
    bias += found - seen;
    Band* own = std::find_if(std::begin(bands), std::end(bands) - 1,
      [length](const Band& band) { return length < band.Longest; });
    for (Band* band : { own, &all })
    {
      band->Off += std::pow(found - seen, 2);
      band->OffExact += std::pow(exact - seen, 2);
      band->Apart += std::pow(found - exact, 2);
      ++band->Count;
    }
  }
  const auto rms = [](double squares, int count) { return std::sqrt(squares / count); };
  for (const Band& band : bands)
  {
    const std::string name = "sums no longer than " + std::to_string(band.Longest);
    Check(name, band.Count >= 20, std::to_string(band.Count) + " of them");
    CheckAtMost(name + ", off from what is seen", rms(band.Off, band.Count), band.MostOff,
      "logarithms add up what is hidden twice, order 4 blurs it");
    CheckAtMost(name + ", off from the exact exponential", rms(band.Apart, band.Count),
      band.MostApart, "squares are cut to order 4 before they are squared again");
  }
  std::cout << "all: off by " << rms(all.Off, all.Count) << ", the exact exponential by "
            << rms(all.OffExact, all.Count) << "\n";
  CheckAtMost("all sums, off from what is seen", rms(all.Off, all.Count), all.MostOff, "the same");
  CheckAtMost("all sums, over what the exact exponential is off",
    rms(all.Off, all.Count) / rms(all.OffExact, all.Count), 1.0,
    "logarithms are those whose exponential by the kernel is nearest to what is seen");
  CheckAtMost("all sums, bias", std::abs(bias) / all.Count, 0.005, "the same");
}

VTK_INDIRECT_TEST(SphereHarmonicsVisibility)
{
  // Irradiance of a uniform sky partly hidden by one sphere, by the table, its interpolation and
  // the exponential, against the same sphere's visibility cut to order 4.
  const vtkiLightMatrix sky = UniformSky();
  double fit = 0.0;
  for (double sine = 0.01; sine < 1.0; sine += 0.0133)
  {
    const double cosine = std::sqrt(1.0 - sine * sine);
    const vtkiHarmonics4 seen = vtkiHarmonicsExp(LogVisibility(sine, { 0.0, 0.0, 1.0 }));
    double zonal[4];
    for (int l = 0; l < 4; ++l)
    {
      zonal[l] = 2.0 * vtkMath::Pi() *
        Integrate(
          -1.0, cosine,
          [l](double z)
          {
            vtkiHarmonics4 y = vtkiHarmonics4At(
              vec3(static_cast<float>(std::sqrt(1.0 - z * z)), 0.0f, static_cast<float>(z)));
            return static_cast<double>(vtkIndirectCoefficient(y, l * (l + 1)));
          },
          4);
    }
    const vtkiHarmonics4 exact =
      vtkiZonalTo(vec4(zonal[0], zonal[1], zonal[2], zonal[3]), vec3(0.0f, 0.0f, 1.0f));
    for (double tilt = 0.0; tilt < 3.2; tilt += 0.2)
    {
      const vtkiHarmonics4 c = vtkiLitCosine(
        sky, vec3(static_cast<float>(std::sin(tilt)), 0.0f, static_cast<float>(std::cos(tilt))));
      fit = std::max(
        fit, std::abs(static_cast<double>(vtkiHarmonicsDot(c, seen) - vtkiHarmonicsDot(c, exact))));
    }
  }
  CheckAtMost("irradiance beside one sphere, fit and interpolation", fit, 8e-3,
    "near a full hemisphere, where there is no logarithm; below sine 0.7 1e-3");
}

VTK_INDIRECT_TEST(SphereHarmonicsOverAPlane)
{
  // A sphere wholly above a plane removes sin^2 cos of a uniform sky.
  const vtkiLightMatrix sky = UniformSky();
  const vec3 n(0.0f, 0.0f, 1.0f);
  const vtkiHarmonics4 c = vtkiLitCosine(sky, n);
  double squares = 0.0;
  double mean = 0.0;
  double bias = 0.0;
  double worst = 0.0;
  int count = 0;
  for (double height : { 1.0, 1.2, 1.6, 2.5, 4.0 })
  {
    for (double x = 0.05; x < 8.0; x += 0.1)
    {
      const double d = std::sqrt(x * x + height * height);
      const double sine = vtkiProxySine(
        vec3(static_cast<float>(x), 0.0f, static_cast<float>(height)), 1.0f, n, false);
      const double measured =
        vtkiHarmonicsDot(c, vtkiHarmonicsExp(LogVisibility(sine, { x / d, 0.0, height / d })));
      const double exact = 1.0 - height / (d * d * d);
      squares += (measured - exact) * (measured - exact);
      bias += measured - exact;
      mean += exact;
      worst = std::max(worst, std::abs(measured - exact));
      ++count;
    }
  }
  CheckAtMost("root mean square error over the mean", std::sqrt(squares / count) / (mean / count),
    0.015, "order 4 cuts the visibility");
  CheckAtMost("worst error, of the open sky's 1", worst, 0.03,
    "the closest: a sphere that touches the plane seen under 80 degrees");
  CheckAbsolute("bias over the mean", bias / mean, 0.0, 0.01, "the same");
}

VTK_INDIRECT_TEST(SphereHarmonicsTwoSpheres)
{
  // Two spheres beside each other with increasing overlap: the bias of sums of logarithms.
  const vtkiLightMatrix sky = UniformSky();
  const vtkiHarmonics4 c = vtkiLitCosine(sky, vec3(0.0f, 0.0f, 1.0f));
  for (double apart : { 1.2, 0.8, 0.4, 0.0 })
  {
    const double sine = 0.5;
    const glm::dvec3 first(std::sin(0.5 * apart), 0.0, std::cos(0.5 * apart));
    const glm::dvec3 second(-first.x, 0.0, first.z);
    const double cosine = std::sqrt(1.0 - sine * sine);
    double exact = 0.0;
    ForSphere(
      [&](const glm::dvec3& d, double weight)
      {
        if (glm::dot(d, first) < cosine && glm::dot(d, second) < cosine)
        {
          exact += weight * std::max(d.z, 0.0) / vtkMath::Pi();
        }
      },
      3);
    const double measured = vtkiHarmonicsDot(c,
      vtkiHarmonicsExp(
        vtkiHarmonicsAdd(LogVisibility(sine, first), 1.0f, LogVisibility(sine, second))));
    CheckAbsolute("two spheres " + std::to_string(apart) + " radians apart", measured, exact,
      apart > 0.9 ? 0.03 : 0.15,
      "too dark where they overlap: the same directions are hidden twice, blurred to order 4");
    if (apart < 0.5)
    {
      Check("  and the bias is dark", measured < exact + 0.01);
    }
  }
}

VTK_INDIRECT_TEST(SphereHarmonicsAverage)
{
  // A light of order 3, a sphere lit by it: mean radiance over the disk, and at its middle.
  Random random(11);
  double averaged = 0.0;
  double middle = 0.0;
  double all = 0.0;
  for (int trial = 0; trial < 40; ++trial)
  {
    vtkiHarmonics4 light = Zero();
    light.A.x = 2.0f;
    for (int i = 1; i < 9; ++i)
    {
      vtkIndirectCoefficient(light, i) = static_cast<float>(random.Next(-1.0, 1.0));
    }
    const double sine = random.Next(0.05, 0.99);
    const double cosine = std::sqrt(1.0 - sine * sine);
    const int around = 12;
    double sum = 0.0;
    for (int i = 0; i < around; ++i)
    {
      const double turn = 2.0 * vtkMath::Pi() * i / around;
      sum += Integrate(
               0.0, 1.0,
               [&](double u)
               {
                 const double z = cosine + (1.0 - cosine) * u * u;
                 const double s = std::sqrt(std::max(1.0 - z * z, 0.0));
                 const double distance = z - std::sqrt(std::max(z * z - cosine * cosine, 0.0));
                 const glm::dvec3 normal =
                   (distance * glm::dvec3(s * std::cos(turn), s * std::sin(turn), z) -
                     glm::dvec3(0.0, 0.0, 1.0)) /
                   sine;
                 return 2.0 * u *
                   vtkiHarmonicsDot(light, vtkiClampedCosine(vec3(glm::normalize(normal))));
               },
               4) /
        around;
    }
    const vec3 d(0.0f, 0.0f, 1.0f);
    averaged += std::pow(vtkiProxyRadiance(light, d, static_cast<float>(sine)) - sum, 2);
    middle += std::pow(vtkiProxyRadianceAtMiddle(light, d) - sum, 2);
    all += sum * sum;
  }
  CheckAtMost("averaged radiance by polynomials, RMS over RMS", std::sqrt(averaged / all), 2.8e-3,
    "0.28 % in the paper");
  CheckAtLeast("radiance at the middle, the same", std::sqrt(middle / all), 0.03,
    "7 to 8 % in the paper, with more light from one side");
}

VTK_INDIRECT_TEST(SphereHarmonicsExactOperator)
{
  // A light of order 3 and a sphere lit by it, anywhere above a receiver: irradiance from each
  // point of its disk with its normal's radiance, against one radiance for the whole disk.
  Random random(13);
  double exact = 0.0;
  double averaged = 0.0;
  double middle = 0.0;
  double all = 0.0;
  for (int trial = 0; trial < 60; ++trial)
  {
    vtkiHarmonics4 light = Zero();
    light.A.x = 2.0f;
    for (int i = 1; i < 9; ++i)
    {
      vtkIndirectCoefficient(light, i) = static_cast<float>(random.Next(-1.0, 1.0));
    }
    const glm::dvec3 n = random.NextDirection();
    const glm::dvec3 d = random.NextDirection();
    const double sine = random.Next(0.05, 0.99);
    const double cosine = std::sqrt(1.0 - sine * sine);
    const glm::dvec3 x = glm::normalize(
      glm::cross(d, std::abs(d.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 y = glm::cross(d, x);
    const vtkiHarmonics4 receiver = vtkiClampedCosine(vec3(n));
    const int around = 16;
    double sum = 0.0;
    for (int i = 0; i < around; ++i)
    {
      const double turn = 2.0 * vtkMath::Pi() * i / around;
      const glm::dvec3 side = std::cos(turn) * x + std::sin(turn) * y;
      sum += Integrate(
               0.0, 1.0,
               [&](double u)
               {
                 const double z = cosine + (1.0 - cosine) * u * u;
                 const glm::dvec3 way = z * d + std::sqrt(std::max(1.0 - z * z, 0.0)) * side;
                 const double distance = z - std::sqrt(std::max(z * z - cosine * cosine, 0.0));
                 const vec3 normal(glm::normalize(distance * way - d));
                 return 2.0 * u * Value(receiver, way) *
                   vtkiHarmonicsDot(light, vtkiClampedCosine(normal));
               },
               4) /
        around;
    }
    // Over the solid angle, as the other values.
    const float s = static_cast<float>(sine);
    const double disk = vtkiDiskIrradiance(s, static_cast<float>(glm::dot(n, d))) /
      (2.0 * vtkMath::Pi() * vtkiProxyRow(s));
    const double sent[3] = {
      vtkiProxyExactIrradiance(vtkiExactOperator(s), light, vec3(d), vec3(n)),
      disk * vtkiProxyRadiance(light, vec3(d), s), disk * vtkiProxyRadianceAtMiddle(light, vec3(d))
    };
    sum = std::max(sum, 0.0); // order 3 rings below the horizon
    exact += (sent[0] - sum) * (sent[0] - sum);
    averaged += (sent[1] - sum) * (sent[1] - sum);
    middle += (sent[2] - sum) * (sent[2] - sum);
    all += sum * sum;
  }
  CheckAtMost("irradiance by the operator, RMS over RMS", std::sqrt(exact / all), 1e-3,
    "entries are fitted to 3e-4 of at most 0.23, in the mean far better");
  CheckAtLeast("of the averaged radiance, the same", std::sqrt(averaged / all),
    5.0 * std::sqrt(exact / all), "it is one for all of the disk");
  CheckAtLeast("of the radiance at the middle", std::sqrt(middle / all), std::sqrt(averaged / all),
    "it is that of the middle for all of the disk");
  // Under uniform light they are equal.
  vtkiHarmonics4 uniform = Zero();
  uniform.A.x = 1.0f / VTKI_HARMONICS_Y00;
  for (const float s : { 0.1f, 0.6f, 1.0f })
  {
    CheckRelative("of a uniform light, that of a disk",
      2.0 * vtkMath::Pi() * vtkiProxyRow(s) *
        vtkiProxyExactIrradiance(
          vtkiExactOperator(s), uniform, vec3(0.0f, 0.6f, 0.8f), vec3(0.0f, 0.0f, 1.0f)),
      vtkiDiskIrradiance(s, 0.8f), 1e-5, "entries that the fit has exactly");
  }
}

VTK_INDIRECT_TEST(SphereHarmonicsReplacement)
{
  const vec3 n(0.0f, 0.0f, 1.0f);
  CheckEqual("no radius", vtkiProxySine(vec3(0.0f, 0.0f, 1.0f), 0.0f, n, false), 0.0);
  CheckEqual("far: r / d", vtkiProxySine(vec3(3.0f, 0.0f, 4.0f), 1.0f, n, false), 0.2f);
  CheckEqual("at the center: hides nothing", vtkiProxySine(vec3(0.0f), 1.0f, n, false), 0.0);
  CheckEqual(
    "inside, under the center", vtkiProxySine(vec3(0.0f, 0.0f, 0.5f), 1.0f, n, false), 1.0);
  // Spheres of the receiver's own surface, which extend beyond it a little.
  const vtkiLightMatrix sky = UniformSky();
  const vtkiHarmonics4 c = vtkiLitCosine(sky, n);
  double worst = 0.0;
  for (const glm::dvec3& center : { glm::dvec3(0.0, 0.0, -0.95), glm::dvec3(0.3, 0.0, -0.95),
         glm::dvec3(0.6, 0.0, -0.6), glm::dvec3(0.8, 0.0, -0.3) })
  {
    const double sine = vtkiProxySine(vec3(center), 1.0f, n, false);
    worst = std::max(worst,
      std::abs(
        1.0 - vtkiHarmonicsDot(c, vtkiHarmonicsExp(LogVisibility(sine, glm::normalize(center))))));
  }
  CheckAtMost("what own spheres take of the sky", worst, 0.02,
    "order 4 lets the blocked lower half ring into the upper");
  // Continuous while a sphere moves past.
  double jump = 0.0;
  for (double height : { -0.9, -0.3, 0.0, 0.1, 0.6, 0.95 })
  {
    double before = -1.0;
    for (double x = 2.0; x > 0.0; x -= 1e-3)
    {
      const double sine = vtkiProxySine(
        vec3(static_cast<float>(x), 0.0f, static_cast<float>(height)), 1.0f, n, false);
      jump = std::max(jump, before < 0.0 ? 0.0 : std::abs(sine - before));
      before = sine;
    }
  }
  CheckAtMost("steps of the sine for steps of a thousandth of the radius", jump, 0.01,
    "slopes of up to 8: a fade over a quarter of the radius");
}
