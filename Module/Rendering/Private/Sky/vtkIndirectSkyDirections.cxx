// SPDX-License-Identifier: BSD-3-Clause
#include "Sky/vtkIndirectSkyDirections.h"

#include "Emitters/vtkIndirectDirections.h"
#include "Emitters/vtkIndirectEmitterAccess.h"
#include "Emitters/vtkIndirectSkyProjection.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "vtkEnvironmentLight.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <iterator>
#include <numeric>

namespace
{
constexpr int LeastLattice = vtkIndirectSkyProjection::FineDirections;
// Pieces of the sky along an edge of the octahedron's square, two degrees across. A piece that a
// receiver's horizon cuts counts by the visibility of its middle: an open plane gets less from a
// uniform sky by a third of the square of the piece's half width, 0.0003.
constexpr int Pieces = 64;

// Sums the even halves of clamped cosines, for the normal of each texel: see
// vtkIndirectLibSky.glsl.
std::vector<float> GatherEvenHalves(const std::vector<glm::vec3>& flux)
{
  using namespace vtkIndirectKernels;
  // The loops go coordinate by coordinate, with the texels inside, so that compilers can vectorize
  // them.
  constexpr size_t texels = static_cast<size_t>(VTKI_OPEN_SKY_TEXELS) * VTKI_OPEN_SKY_TEXELS;
  std::vector<float> normals[3];
  for (size_t i = 0; i < texels; ++i)
  {
    const glm::vec3 normal =
      vtkiOpenSkyNormal(vec2(i % VTKI_OPEN_SKY_TEXELS, i / VTKI_OPEN_SKY_TEXELS));
    for (int c = 0; c < 3; ++c)
    {
      normals[c].push_back(normal[c]);
    }
  }
  std::vector<float> sums(texels, 0.0f);
  const float* const x = normals[0].data();
  const float* const y = normals[1].data();
  const float* const z = normals[2].data();
  float* const sum = sums.data();
  for (const glm::vec3& entry : flux)
  {
    for (size_t i = 0; i < texels; ++i)
    {
      sum[i] += std::abs(entry.x * x[i] + entry.y * y[i] + entry.z * z[i]);
    }
  }
  return sums;
}
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyDirections::Update(
  vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment, int count, int still)
{
  const bool other = this->Environment.Take({ "environment", environment }) || still != this->Still;
  if (!other && count == this->Count && still == this->Still)
  {
    return false;
  }
  if (other)
  {
    this->Still = still;
    this->FindLight(projection, environment);
  }
  this->FindOthers(count);
  this->Count = count;
  this->Still = still;
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyDirections::UpdateFiner(
  vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment, int count, int still)
{
  const bool other = this->Environment.Take({ "environment", environment });
  if (!other && count == this->Count && still == this->Still)
  {
    return false;
  }
  this->Count = count;
  this->Still = still;
  this->FindLight(projection, environment);
  this->Lattice = vtkIndirectDirections::MakeLattice(count);
  this->ShareLattice();
  return true;
}

//------------------------------------------------------------------------------
// Distributes all light but the strong directions' over the lattice.
void vtkIndirectSkyDirections::ShareLattice()
{
  std::vector<glm::dvec3> light(this->Lattice.size(), glm::dvec3(0.0));
  for (const Cell& cell : this->Cells)
  {
    light[vtkIndirectDirections::FindNearestOfLattice(cell.Direction, this->Lattice)] += cell.Light;
  }
  this->Others = this->FindLit(light);
}

//------------------------------------------------------------------------------
std::vector<vtkIndirectSkyDirections::Summand> vtkIndirectSkyDirections::FindLit(
  const std::vector<glm::dvec3>& light) const
{
  std::vector<Summand> lit;
  for (size_t i = 0; i < light.size(); ++i)
  {
    if (vtkIndirectSkyProjection::SumColors(light[i]) > 0.0)
    {
      lit.push_back({ i, light[i], this->Lattice[i] });
    }
  }
  return lit;
}

//------------------------------------------------------------------------------
// Finds the strong directions, and all other light in small pieces.
void vtkIndirectSkyDirections::FindLight(
  vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment)
{
  using namespace vtkIndirectKernels;
  const std::vector<vtkIndirectEmitterAccess::Cell>& cells =
    vtkIndirectEmitterAccess::GetCells(environment);
  const vtkIndirectSkyProjection::Result& sky =
    projection.Find(environment, std::max(this->Still, LeastLattice));
  const auto still = sky.Directions.begin() + this->Still;
  const auto added = sky.Directions.begin() + std::max(this->Still, LeastLattice);
  this->Lattice.assign(sky.Directions.begin(), still);
  this->Lattice.insert(this->Lattice.end(), added, sky.Directions.end());
  this->Strong.clear();
  this->Known.clear();
  this->Sharing.clear();
  this->Cells.clear();
  this->OpenTexels.clear();
  for (size_t i = 0; i < sky.Light.size(); ++i)
  {
    if (sky.IsStrong(i))
    {
      this->Strong.push_back({ i, sky.Light[i], sky.Middles[i] });
    }
  }
  this->Flux.assign(static_cast<size_t>(Pieces) * Pieces, glm::dvec3(0.0));
  double rest = 0.0;
  for (size_t i = 0; i < cells.size(); ++i)
  {
    const double sent = vtkIndirectSkyProjection::SumColors(glm::make_vec3(cells[i].Light));
    if (sky.IsStrong(sky.Nearest[i]))
    {
      continue;
    }
    const glm::dvec3 d = glm::make_vec3(cells[i].Direction);
    this->Cells.push_back({ d, glm::make_vec3(cells[i].Light), 0, -2.0 });
    rest += sent;
    const vec2 place = vtkiOctahedralEncode(vec3(d));
    auto find = [](float p)
    { return std::clamp(static_cast<int>((0.5f + 0.5f * p) * Pieces), 0, Pieces - 1); };
    this->Flux[static_cast<size_t>(find(place.y)) * Pieces + find(place.x)] +=
      sent / vtkMath::Pi() * d;
  }
  // The unit is the radiance of a uniform sky with as much light.
  this->Unit = rest > 0.0 ? rest / (4.0 * vtkMath::Pi()) : 1.0;
}

//------------------------------------------------------------------------------
void vtkIndirectSkyDirections::FindOthers(int count)
{
  const auto known = this->Known.find(count);
  if (known != this->Known.end())
  {
    this->Others = known->second;
    return;
  }
  std::vector<size_t> numbers(static_cast<size_t>(count));
  std::iota(numbers.begin(), numbers.end(), size_t(0));
  for (size_t i = static_cast<size_t>(this->Still); i < this->Lattice.size(); ++i)
  {
    numbers.push_back(i);
  }
  this->Others = this->Share(numbers);
  this->Known[count] = this->Others;
}

//------------------------------------------------------------------------------
std::vector<vtkIndirectSkyDirections::Summand> vtkIndirectSkyDirections::Share(
  const std::vector<size_t>& numbers)
{
  // If the previous directions are among these, cells are shared with the additional ones only.
  const bool more =
    std::includes(numbers.begin(), numbers.end(), this->Sharing.begin(), this->Sharing.end());
  std::vector<size_t> added;
  if (more)
  {
    std::set_difference(numbers.begin(), numbers.end(), this->Sharing.begin(), this->Sharing.end(),
      std::back_inserter(added));
  }
  this->Sharing = numbers;
  std::vector<glm::dvec3> light(this->Lattice.size(), glm::dvec3(0.0));
  for (Cell& cell : this->Cells)
  {
    cell.Cosine = more ? cell.Cosine : -2.0;
    for (const size_t number : more ? added : numbers)
    {
      const double cosine = glm::dot(cell.Direction, this->Lattice[number]);
      if (cosine > cell.Cosine)
      {
        cell.Cosine = cosine;
        cell.Nearest = number;
      }
    }
    light[cell.Nearest] += cell.Light;
  }
  return this->FindLit(light);
}

//------------------------------------------------------------------------------
vtkIndirectSkyDirections::OpenSky vtkIndirectSkyDirections::MakeOpenSky(
  const std::vector<Summand>& summed)
{
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
  std::vector<glm::vec3> summedFlux;
  for (const Summand& summand : summed)
  {
    summedFlux.emplace_back(0.5 * vtkIndirectSkyProjection::SumColors(summand.Light) /
      vtkMath::Pi() / this->Unit * this->Lattice[summand.Number]);
    sky.SummedFlux += summedFlux.back();
  }
  if (this->OpenTexels.empty())
  {
    this->OpenTexels = GatherEvenHalves(flux);
  }
  const std::vector<float> summedTexels = GatherEvenHalves(summedFlux);
  for (size_t i = 0; i < summedTexels.size(); ++i)
  {
    sky.Texels.insert(sky.Texels.end(), { this->OpenTexels[i], summedTexels[i], 0.0f, 1.0f });
  }
  return sky;
}

//------------------------------------------------------------------------------
vtkIndirectSkyDirections::OpenColors vtkIndirectSkyDirections::MakeOpenColors(
  const std::vector<Summand>& summed) const
{
  OpenColors sky;
  std::vector<float> texels[3];
  for (int color = 0; color < 3; ++color)
  {
    std::vector<glm::vec3> flux;
    for (const Summand& summand : summed)
    {
      flux.emplace_back(
        0.5 * summand.Light[color] / vtkMath::Pi() / this->Unit * this->Lattice[summand.Number]);
      sky.Flux[color] += flux.back();
    }
    texels[color] = GatherEvenHalves(flux);
  }
  for (size_t i = 0; i < texels[0].size(); ++i)
  {
    sky.Texels.insert(sky.Texels.end(), { texels[0][i], texels[1][i], texels[2][i], 1.0f });
  }
  return sky;
}
