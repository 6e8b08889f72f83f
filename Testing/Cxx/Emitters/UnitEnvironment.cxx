// SPDX-License-Identifier: BSD-3-Clause
// An environment's light, in total and by direction, against integrals over the sphere.
#include "Emitters/vtkIndirectDirections.h"
#include "Emitters/vtkIndirectEmitterAccess.h"
#include "vtkEnvironmentLight.h"
#include "vtkImageData.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

using namespace vtkIndirectTest;

namespace
{
glm::dvec3 SumLight(vtkEnvironmentLight* environment)
{
  glm::dvec3 sum(0.0);
  for (const vtkIndirectEmitterAccess::Cell& cell : vtkIndirectEmitterAccess::GetCells(environment))
  {
    sum += glm::dvec3(cell.Light[0], cell.Light[1], cell.Light[2]);
  }
  return sum;
}

void MakeImage(vtkImageData* image, int columns, int rows, float value)
{
  image->SetDimensions(columns, rows, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  auto* p = static_cast<float*>(image->GetScalarPointer());
  std::fill(p, p + 3 * columns * rows, value);
}

// Light of each direction, which represents the cells nearest to it.
std::vector<glm::dvec3> Project(
  vtkEnvironmentLight* environment, const std::vector<glm::dvec3>& directions)
{
  std::vector<glm::dvec3> light(directions.size(), glm::dvec3(0.0));
  for (const vtkIndirectEmitterAccess::Cell& cell : vtkIndirectEmitterAccess::GetCells(environment))
  {
    light[vtkIndirectDirections::FindNearest(glm::make_vec3(cell.Direction), directions)] +=
      glm::make_vec3(cell.Light);
  }
  return light;
}
}

VTK_INDIRECT_TEST(EnvironmentIsAllOfTheSphere)
{
  vtkNew<vtkEnvironmentLight> environment;
  environment->SetRadiance(1.0, 2.0, 0.5);
  environment->SetScale(3.0);
  const glm::dvec3 sum = SumLight(environment);
  const double pi = vtkMath::Pi();
  CheckRelative("red over the sphere", sum.x, 4.0 * pi * 3.0, 1e-12, "rounding of a sum");
  CheckRelative("green over the sphere", sum.y, 4.0 * pi * 6.0, 1e-12, "rounding of a sum");

  vtkNew<vtkImageData> image;
  MakeImage(image, 3, 2, 2.0f);
  environment->SetImage(image);
  CheckRelative("six pixels", SumLight(environment).x, 4.0 * pi * 6.0, 1e-12, "rounding of a sum");
  for (const int count : { 16, 64, 256, 1024 })
  {
    const std::vector<glm::dvec3> lattice = vtkIndirectDirections::MakeLattice(count);
    const std::vector<glm::dvec3> light = Project(environment, lattice);
    glm::dvec3 total(0.0);
    double irradiance[3] = { 0.0, 0.0, 0.0 };
    for (size_t i = 0; i < lattice.size(); ++i)
    {
      total += light[i];
      for (int axis = 0; axis < 3; ++axis)
      {
        irradiance[axis] += light[i].x / 6.0 * std::max(lattice[i][axis], 0.0) / pi;
      }
    }
    CheckRelative("light of " + std::to_string(count) + " directions", total.x, 4.0 * pi * 6.0,
      1e-12, "all of it goes somewhere");
    for (int axis = 0; axis < 3; ++axis)
    {
      // Found: 0.0018 for 64 and 0.0006 for 256.
      CheckRelative("irradiance of an open plane", irradiance[axis], 1.0,
        count == 16     ? 0.03
          : count == 64 ? 0.005
                        : 0.002,
        "quadrature by so many directions");
    }
  }
}

VTK_INDIRECT_TEST(NearestDirectionOfALattice)
{
  const std::vector<glm::dvec3> from = vtkIndirectDirections::MakeLattice(1000);
  int differ = 0;
  for (const int count : { 1, 2, 7, 64, 2048, 8192 })
  {
    const std::vector<glm::dvec3> lattice = vtkIndirectDirections::MakeLattice(count);
    for (const glm::dvec3& direction : from)
    {
      differ += vtkIndirectDirections::FindNearestOfLattice(direction, lattice) !=
          vtkIndirectDirections::FindNearest(direction, lattice)
        ? 1
        : 0;
    }
  }
  CheckEqual("directions given to another place than by brute force", differ, 0);
}

VTK_INDIRECT_TEST(EnvironmentLiesAsASkyboxDoes)
{
  // One bright pixel of 64 x 32: column, row, and its direction.
  struct Case
  {
    int Column;
    int Row;
    glm::dvec3 From;
  };
  const Case cases[] = { { 32, 16, { 0, 0, -1 } }, { 48, 16, { 1, 0, 0 } },
    { 16, 16, { -1, 0, 0 } }, { 0, 16, { 0, 0, 1 } }, { 32, 31, { 0, 1, 0 } },
    { 32, 0, { 0, -1, 0 } } };
  for (const Case& c : cases)
  {
    vtkNew<vtkImageData> image;
    MakeImage(image, 64, 32, 0.0f);
    auto* pixel = static_cast<float*>(image->GetScalarPointer(c.Column, c.Row, 0));
    pixel[0] = pixel[1] = pixel[2] = 1e6f;
    vtkNew<vtkEnvironmentLight> environment;
    environment->SetImage(image);
    glm::dvec3 mean(0.0);
    for (const vtkIndirectEmitterAccess::Cell& cell :
      vtkIndirectEmitterAccess::GetCells(environment))
    {
      mean += cell.Light[0] * glm::dvec3(cell.Direction[0], cell.Direction[1], cell.Direction[2]);
    }
    const std::string name = std::to_string(c.Column) + ", " + std::to_string(c.Row);
    // The middle of the pixel is half of it, 2.8 degrees, beside each axis.
    CheckAtLeast("pixel " + name + " shines from where it is seen",
      glm::dot(glm::normalize(mean), c.From), std::cos(glm::radians(4.0)), "half a pixel");
    double radiance[3];
    const double direction[3] = { mean.x, mean.y, mean.z };
    environment->GetRadianceFrom(direction, radiance);
    CheckRelative("radiance from there", radiance[0], 1e6, 1e-12, "the pixel itself");
    // Rotated: up is now along x, right along y.
    environment->SetUp(2.0, 0.0, 0.0);
    environment->SetRight(0.0, 3.0, 0.0);
    const glm::dvec3 turned = c.From.x * glm::dvec3(0, 1, 0) + c.From.y * glm::dvec3(1, 0, 0) +
      c.From.z * glm::cross(glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0));
    glm::dvec3 after(0.0);
    for (const vtkIndirectEmitterAccess::Cell& cell :
      vtkIndirectEmitterAccess::GetCells(environment))
    {
      after += cell.Light[0] * glm::dvec3(cell.Direction[0], cell.Direction[1], cell.Direction[2]);
    }
    CheckAtLeast("and turns with Up and Right", glm::dot(glm::normalize(after), turned),
      std::cos(glm::radians(4.0)), "half a pixel");
  }
}

VTK_INDIRECT_TEST(EnvironmentSunLosesNothing)
{
  vtkNew<vtkImageData> image;
  MakeImage(image, 2048, 1024, 0.25f);
  auto* pixel = static_cast<float*>(image->GetScalarPointer(700, 800, 0));
  pixel[0] = pixel[1] = pixel[2] = 5e4f;
  vtkNew<vtkEnvironmentLight> environment;
  environment->SetImage(image);
  const double pi = vtkMath::Pi();
  const double sun = 2.0 * pi / 2048.0 *
    (std::sin(pi * (801.0 / 1024.0 - 0.5)) - std::sin(pi * (800.0 / 1024.0 - 0.5)));
  CheckRelative("sky and sun", SumLight(environment).x, pi + (5e4 - 0.25) * sun, 1e-9,
    "rounding of a sum of two million");
}

VTK_INDIRECT_TEST(EnvironmentRefusesWhatIsNoRadiance)
{
  vtkNew<vtkImageData> image;
  MakeImage(image, 8, 4, 1.0f);
  auto* p = static_cast<float*>(image->GetScalarPointer());
  p[0] = std::nanf("");
  p[4] = -1.0f;
  p[8] = HUGE_VALF;
  vtkNew<vtkEnvironmentLight> environment;
  environment->SetImage(image);
  const glm::dvec3 sum = SumLight(environment);
  Check("what is left is finite", std::isfinite(sum.x + sum.y + sum.z) && sum.x > 0.0);
  vtkNew<vtkEnvironmentLight> dark;
  dark->SetRadiance(0.0, 0.0, 0.0);
  Check("a dark sky has no cells", vtkIndirectEmitterAccess::GetCells(dark).empty());
}

// The first directions of a nested order are nearly as even as a lattice of that number.
VTK_INDIRECT_TEST(EnvironmentNestedDirections)
{
  Random random(3);
  std::vector<glm::dvec3> normals;
  for (int i = 0; i < 4000; ++i)
  {
    normals.push_back(random.NextDirection());
  }
  vtkNew<vtkEnvironmentLight> uniform;
  // Error of the irradiance of a uniform sky over all normals.
  auto measure = [&](const std::vector<glm::dvec3>& directions, double& worst)
  {
    const std::vector<glm::dvec3> light = Project(uniform, directions);
    double squares = 0.0;
    worst = 0.0;
    for (const glm::dvec3& n : normals)
    {
      double sum = 0.0;
      for (size_t i = 0; i < directions.size(); ++i)
      {
        sum += light[i].x / vtkMath::Pi() * std::max(glm::dot(directions[i], n), 0.0);
      }
      squares += (sum - 1.0) * (sum - 1.0);
      worst = std::max(worst, std::abs(sum - 1.0));
    }
    return std::sqrt(squares / static_cast<double>(normals.size()));
  };
  auto nearest = [](const std::vector<glm::dvec3>& directions)
  {
    double most = -1.0;
    for (size_t i = 0; i < directions.size(); ++i)
    {
      for (size_t k = 0; k < i; ++k)
      {
        most = std::max(most, glm::dot(directions[i], directions[k]));
      }
    }
    return std::acos(most);
  };
  for (const int count : { 256, 1024 })
  {
    const std::vector<glm::dvec3> nested = vtkIndirectDirections::MakeNestedLattice(count);
    std::vector<glm::dvec3> plain = vtkIndirectDirections::MakeLattice(count);
    std::vector<glm::dvec3> sorted = nested;
    double worstCover = 0.0;
    auto before = [](const glm::dvec3& a, const glm::dvec3& b) { return a.y > b.y; };
    std::sort(sorted.begin(), sorted.end(), before);
    std::sort(plain.begin(), plain.end(), before);
    Check("the same places", sorted == plain);
    for (size_t part = 4; part <= nested.size(); ++part)
    {
      double widest = 1.0;
      for (const glm::dvec3& direction : plain)
      {
        double cosine = -1.0;
        for (size_t i = 0; i < part; ++i)
        {
          cosine = std::max(cosine, glm::dot(direction, nested[i]));
        }
        widest = std::min(widest, cosine);
      }
      // The least radius of that many circles that cover a sphere (1.209 times its area).
      const double least = std::acos(std::max(-1.0, 1.0 - 2.418 / static_cast<double>(part)));
      worstCover = std::max(worstCover, std::acos(widest) / least);
    }
    CheckAtMost("largest gap of the first ones, however many, over the least there can be",
      worstCover, 2.0, "farthest points are within a factor of two of the best");
    for (int part = count / 4; part >= 16; part /= 4)
    {
      const std::vector<glm::dvec3> some(nested.begin(), nested.begin() + part);
      const std::vector<glm::dvec3> own = vtkIndirectDirections::MakeLattice(part);
      double worst = 0.0;
      double ownWorst = 0.0;
      const double rms = measure(some, worst);
      const double ownRms = measure(own, ownWorst);
      const std::string name = std::to_string(part) + " of " + std::to_string(count);
      CheckAtMost(name + ": RMS error of a uniform sky over all normals", rms, 2.0 * ownRms,
        "twice that of a lattice of so many");
      CheckAtMost(name + ": largest", worst, 2.0 * ownWorst, "twice that of a lattice of so many");
      CheckAtLeast(name + ": nearest neighbours over those of a lattice",
        nearest(some) / nearest(own), 0.5, "a place moves by less than a quarter of a cell");
    }
  }
}
