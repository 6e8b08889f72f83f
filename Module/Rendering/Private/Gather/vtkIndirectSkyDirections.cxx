// SPDX-License-Identifier: BSD-3-Clause
#include "Gather/vtkIndirectSkyDirections.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "VirtualLights/vtkIndirectDirections.h"
#include "vtkEnvironmentLight.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{
// From this share of all light on a direction's shadow is seen by itself: eight grey levels of 256
// where it is hidden from a surface that faces it. At most 32 directions have so much.
constexpr double StrongShare = 1.0 / 32.0;
// Strong directions are those of so many at least: of fewer each has such a share.
constexpr int LeastLattice = 256;
// Pieces of the sky along an edge of the octahedron's square, two degrees across. A piece that a
// receiver's horizon cuts counts as what is seen of its middle: that is a third of the square of
// its half width, 0.0003, less than what an open plane gets from a uniform sky.
constexpr int Pieces = 64;

glm::dvec3 ToVector(const double v[3])
{
  return { v[0], v[1], v[2] };
}

double Sum(const glm::dvec3& light)
{
  return light.x + light.y + light.z;
}
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyDirections::Update(vtkEnvironmentLight* environment, int count, int still)
{
  const int lattice = std::max(still, LeastLattice);
  if (this->Lattice.size() != static_cast<size_t>(lattice))
  {
    this->Lattice = vtkIndirectDirections::MakeNestedLattice(lattice);
    this->Forget();
  }
  const vtkMTimeType time = environment->GetMTime();
  const bool other = environment != this->Environment || time != this->Time;
  if (!other && count == this->Count && still == this->Still)
  {
    return false;
  }
  if (other)
  {
    this->FindLight(environment);
    this->Known.clear();
  }
  this->FindOthers(environment, count);
  this->Environment = environment;
  this->Time = time;
  this->Count = count;
  this->Still = still;
  return true;
}

//------------------------------------------------------------------------------
// What is strong, and all the rest in small pieces.
void vtkIndirectSkyDirections::FindLight(vtkEnvironmentLight* environment)
{
  using namespace vtkIndirectKernels;
  const std::vector<vtkEnvironmentLight::Cell>& cells = environment->GetCells();
  const std::vector<size_t> nearest =
    vtkIndirectDirections::FindNearest(cells, this->Lattice, this->Lattice.size());
  std::vector<glm::dvec3> light(this->Lattice.size(), glm::dvec3(0.0));
  double total = 0.0;
  for (size_t i = 0; i < cells.size(); ++i)
  {
    light[nearest[i]] += ToVector(cells[i].Light);
    total += Sum(ToVector(cells[i].Light));
  }
  this->Strong.clear();
  for (size_t i = 0; i < light.size(); ++i)
  {
    if (Sum(light[i]) > StrongShare * total)
    {
      this->Strong.push_back({ i, light[i] });
    }
  }
  this->IsOfOthers.assign(cells.size(), 0);
  this->Flux.assign(static_cast<size_t>(Pieces) * Pieces, glm::dvec3(0.0));
  double rest = 0.0;
  for (size_t i = 0; i < cells.size(); ++i)
  {
    const double sent = Sum(ToVector(cells[i].Light));
    if (Sum(light[nearest[i]]) > StrongShare * total)
    {
      continue;
    }
    this->IsOfOthers[i] = 1;
    rest += sent;
    const glm::dvec3 d = ToVector(cells[i].Direction);
    const vec2 place = vtkiOctahedralEncode(vec3(d));
    auto find = [](float p)
    { return std::clamp(static_cast<int>((0.5f + 0.5f * p) * Pieces), 0, Pieces - 1); };
    this->Flux[static_cast<size_t>(find(place.y)) * Pieces + find(place.x)] +=
      sent / vtkMath::Pi() * d;
  }
  // That of a uniform sky with as much light.
  this->Unit = rest > 0.0 ? rest / (4.0 * vtkMath::Pi()) : 1.0;
}

//------------------------------------------------------------------------------
void vtkIndirectSkyDirections::FindOthers(vtkEnvironmentLight* environment, int count)
{
  const auto known = this->Known.find(count);
  if (known != this->Known.end())
  {
    this->Others = known->second;
    return;
  }
  std::vector<vtkEnvironmentLight::Cell> cells;
  const std::vector<vtkEnvironmentLight::Cell>& all = environment->GetCells();
  for (size_t i = 0; i < all.size(); ++i)
  {
    if (this->IsOfOthers[i])
    {
      cells.push_back(all[i]);
    }
  }
  const std::vector<size_t> nearest =
    vtkIndirectDirections::FindNearest(cells, this->Lattice, static_cast<size_t>(count));
  std::vector<glm::dvec3> light(static_cast<size_t>(count), glm::dvec3(0.0));
  for (size_t i = 0; i < cells.size(); ++i)
  {
    light[nearest[i]] += ToVector(cells[i].Light);
  }
  this->Others.clear();
  for (size_t i = 0; i < light.size(); ++i)
  {
    if (Sum(light[i]) > 0.0)
    {
      this->Others.push_back({ i, light[i] });
    }
  }
  this->Known[count] = this->Others;
}

//------------------------------------------------------------------------------
vtkIndirectSkyDirections::OpenSky vtkIndirectSkyDirections::MakeOpenSky() const
{
  using namespace vtkIndirectKernels;
  OpenSky sky;
  std::vector<glm::vec3> flux;
  for (const glm::dvec3& piece : this->Flux)
  {
    if (piece != glm::dvec3(0.0))
    {
      flux.emplace_back(0.5 * piece / this->Unit);
      sky.Flux += flux.back();
    }
  }
  std::vector<glm::vec3> summed;
  for (const Summand& summand : this->Others)
  {
    summed.emplace_back(
      0.5 * Sum(summand.Light) / vtkMath::Pi() / this->Unit * this->Lattice[summand.Number]);
    sky.SummedFlux += summed.back();
  }
  auto gather = [](const std::vector<glm::vec3>& list, const glm::vec3& normal)
  {
    float sum = 0.0f;
    for (const glm::vec3& entry : list)
    {
      sum += std::abs(glm::dot(entry, normal));
    }
    return sum;
  };
  for (int y = 0; y < VTKI_OPEN_SKY_TEXELS; ++y)
  {
    for (int x = 0; x < VTKI_OPEN_SKY_TEXELS; ++x)
    {
      const glm::vec3 normal = vtkiOpenSkyNormal(vec2(x, y));
      sky.Texels.insert(
        sky.Texels.end(), { gather(flux, normal), gather(summed, normal), 0.0f, 1.0f });
    }
  }
  return sky;
}
