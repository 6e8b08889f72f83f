// SPDX-License-Identifier: BSD-3-Clause
// Deterministic patterns on the CPU. They use no standard distributions, whose values differ
// between libraries, and would change every image.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace vtkIndirectSamplePattern
{
/** This is the area of a disk over that of the square around it. */
constexpr double DiskShare = 0.78539816339744831;

/**
 * Returns the fraction of i times the golden ratio: with (i + 0.5) / n it makes the Fibonacci
 * lattice.
 */
inline double GoldenRatioFraction(int i)
{
  constexpr double golden = 0.61803398874989485;
  const double x = (i + 0.5) * golden;
  return x - std::floor(x);
}

/**
 * Maps the unit square to its inscribed disk, preserving areas. Shirley and Chiu 1997, "A low
 * distortion map between disk and square".
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
 * Makes two unit axes across a unit vector: Duff et al. 2017, "Building an orthonormal basis,
 * revisited".
 */
inline void FindAxes(const glm::dvec3& n, glm::dvec3& u, glm::dvec3& v)
{
  const double sign = std::copysign(1.0, n.z);
  const double a = -1.0 / (sign + n.z);
  const double b = n.x * n.y * a;
  u = { 1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x };
  v = { b, sign + n.y * n.y * a, -n.y };
}

/** Maps the unit square to the directions about a unit normal, with a density by the cosine. */
inline glm::dvec3 CosineDirection(const glm::dvec3& normal, const glm::dvec2& at)
{
  double x = at.x;
  double y = at.y;
  SquareToDisk(x, y);
  const glm::dvec2 p = 2.0 * glm::dvec2(x, y) - 1.0;
  glm::dvec3 u;
  glm::dvec3 v;
  FindAxes(normal, u, v);
  return glm::normalize(
    p.x * u + p.y * v + std::sqrt(std::max(0.0, 1.0 - glm::dot(p, p))) * normal);
}

/**
 * Returns direction i of n, spread evenly over the cone about -z of this cosine (-1: all
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

///@{
/**
 * Returns point i of a sequence in the unit square, [0,1); different seeds give independent
 * sequences. All points before a power of two are spread as evenly as possible, so a longer
 * sequence only adds points to a shorter one. The sequence has Sobol's first two coordinates, with
 * digits and order scrambled: Owen 1995, "Randomly permuted (t,m,s)-nets and (t,s)-sequences"; by
 * hashes as in Burley 2020, "Practical hash-based Owen scrambling".
 */
inline std::uint32_t ReverseBits(std::uint32_t x)
{
  x = (x >> 16u) | (x << 16u);
  x = ((x & 0xff00ff00u) >> 8u) | ((x & 0x00ff00ffu) << 8u);
  x = ((x & 0xf0f0f0f0u) >> 4u) | ((x & 0x0f0f0f0fu) << 4u);
  x = ((x & 0xccccccccu) >> 2u) | ((x & 0x33333333u) << 2u);
  return ((x & 0xaaaaaaaau) >> 1u) | ((x & 0x55555555u) << 1u);
}

/** Returns the digits of point i of Sobol's sequence, first two coordinates (Sobol 1967). */
inline glm::uvec2 SobolDigits(std::uint32_t i)
{
  std::uint32_t second = 0;
  for (std::uint32_t bits = i, column = 0x80000000u; bits; bits >>= 1u, column ^= column >> 1u)
  {
    second ^= bits & 1u ? column : 0u;
  }
  return { ReverseBits(i), second };
}

inline std::uint32_t Hash(std::uint32_t x)
{
  x ^= x >> 16u;
  x *= 0x7feb352du;
  x ^= x >> 15u;
  x *= 0x846ca68bu;
  return x ^ (x >> 16u);
}

/** Flips each digit or not, as decided by the higher digits. */
inline std::uint32_t ScrambleDigits(std::uint32_t x, std::uint32_t seed)
{
  x = ReverseBits(x) + seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return ReverseBits(x);
}

inline glm::dvec2 ScrambledPoint(std::uint32_t i, std::uint32_t seed)
{
  const glm::uvec2 digits = SobolDigits(ScrambleDigits(i, Hash(seed)));
  const std::uint32_t x = ScrambleDigits(digits.x, Hash(seed + 0x9e3779b9u));
  const std::uint32_t y = ScrambleDigits(digits.y, Hash(seed + 0x3c6ef372u));
  return glm::dvec2(x, y) * (1.0 / 4294967296.0);
}
///@}

/** Returns a point of the unit square that has nothing in common with those of other numbers. */
inline glm::dvec2 HashedPoint(std::uint32_t i, std::uint32_t seed)
{
  const std::uint32_t x = Hash(i * 0x9e3779b9u + Hash(seed));
  return glm::dvec2(x, Hash(x + 0x3c6ef372u)) * (1.0 / 4294967296.0);
}

/** This is the generator PCG32, O'Neill 2014; numbers in [0,1). */
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
