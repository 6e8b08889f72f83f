// SPDX-License-Identifier: BSD-3-Clause
// Deterministic patterns on the CPU. No standard distributions: their values differ between
// libraries, and with them every image.
#ifndef vtkIndirectSamplePattern_h
#define vtkIndirectSamplePattern_h

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace vtkIndirectSamplePattern
{
/** Area of a disk over that of the square around it. */
constexpr double DiskShare = 0.78539816339744831;

/** Fraction of i times the golden ratio: with (i + 0.5) / n it makes the Fibonacci lattice. */
inline double GoldenRatioFraction(int i)
{
  constexpr double golden = 0.61803398874989485;
  const double x = (i + 0.5) * golden;
  return x - std::floor(x);
}

/**
 * Unit square to the disk inscribed in it, areas kept.
 * Shirley and Chiu 1997, "A low distortion map between disk and square".
 */
inline void SquareToDisk(double& u, double& v)
{
  const double a = 2.0 * u - 1.0;
  const double b = 2.0 * v - 1.0;
  if (a == 0.0 && b == 0.0)
  {
    return;
  }
  constexpr double quarterPi = 0.78539816339744831;
  const bool wide = std::abs(a) > std::abs(b);
  const double radius = wide ? a : b;
  const double angle = wide ? quarterPi * (b / a) : quarterPi * (2.0 - a / b);
  u = 0.5 + 0.5 * radius * std::cos(angle);
  v = 0.5 + 0.5 * radius * std::sin(angle);
}

/**
 * Direction i of n, spread evenly over the cone about -z whose cosine is given (-1: all
 * directions): a Fibonacci lattice on the sphere, Swinbank and Purser 2006, "Fibonacci grids". No
 * direction lies on the cone's rim.
 */
inline glm::dvec3 DirectionInCone(int i, int n, double cosCone)
{
  const double cosine = 1.0 - (i + 0.5) / n * (1.0 - cosCone);
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  const double angle = 2.0 * 3.14159265358979323846 * GoldenRatioFraction(i);
  return { sine * std::cos(angle), sine * std::sin(angle), -cosine };
}

/** PCG32, O'Neill 2014; [0,1). */
class Random
{
public:
  explicit Random(std::uint32_t stream)
    : Increment((static_cast<std::uint64_t>(stream) << 1) | 1u)
  {
    this->Next();
    this->State += 0x853c49e6748fea9bULL;
    this->Next();
  }
  double Next()
  {
    const std::uint64_t old = this->State;
    this->State = old * 6364136223846793005ULL + this->Increment;
    const auto shifted = static_cast<std::uint32_t>(((old >> 18u) ^ old) >> 27u);
    const auto rotation = static_cast<std::uint32_t>(old >> 59u);
    const std::uint32_t bits = (shifted >> rotation) | (shifted << ((32u - rotation) & 31u));
    return bits * (1.0 / 4294967296.0);
  }

private:
  std::uint64_t State = 0;
  std::uint64_t Increment;
};
}

#endif
