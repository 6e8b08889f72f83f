// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualLights/vtkIndirectEmitters.h"

#include "VirtualLights/vtkIndirectDirections.h"
#include "VirtualLights/vtkIndirectEmitterAccess.h"
#include "VirtualLights/vtkIndirectRectangle.h"
#include "VirtualLights/vtkIndirectSamplePattern.h"
#include "VirtualLights/vtkIndirectSkyProjection.h"
#include "vtkMath.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace
{
// Numbers of pieces start here: there are fewer directions of the sky.
constexpr int FirstPiece = 1024;
constexpr int MostPiecesPerEdge = 4;

double AddChannels(const glm::dvec3& light)
{
  return light.x + light.y + light.z;
}

size_t FindNearest(const glm::dvec3& direction, const std::vector<glm::dvec3>& lattice)
{
  size_t nearest = 0;
  for (size_t i = 1; i < lattice.size(); ++i)
  {
    if (glm::dot(direction, lattice[i]) > glm::dot(direction, lattice[nearest]))
    {
      nearest = i;
    }
  }
  return nearest;
}

// Returns a place within a part of an area light. Places of all parts also lie in columns and rows
// of their own, of which there are as many as parts: bars before the light hide a share of the
// places that is close to the share of the light.
glm::dvec2 FindPlaceIn(int x, int y, int pieces)
{
  // The numbers of parts along an edge are powers of two.
  const auto across = [pieces](int other)
  {
    const auto bits = vtkIndirectSamplePattern::ReverseBits(static_cast<std::uint32_t>(other));
    return bits / 4294967296.0 + 0.5 / pieces;
  };
  return { (x + across(y)) / pieces, (y + across(x)) / pieces };
}

// Returns true for an area light that is on. It may have no light, as a picture of a video may be
// black.
bool Shines(vtkAreaLight* light)
{
  return light->GetSwitch() && light->GetArea() > 0.0;
}

// Returns the mean radiance of a part of an area light.
glm::dvec3 FindRadiance(vtkAreaLight* light, int x, int y, int pieces)
{
  int columns;
  int rows;
  const std::vector<float>& radiances =
    vtkIndirectEmitterAccess::GetRadiances(light, columns, rows);
  // A pixel that lies in several parts counts for each part with its share there.
  auto share = [pieces](int pixel, int count, int piece)
  {
    const double lower = std::max(1.0 * pixel / count, 1.0 * piece / pieces);
    const double upper = std::min((pixel + 1.0) / count, (piece + 1.0) / pieces);
    return std::max(upper - lower, 0.0) * pieces;
  };
  glm::dvec3 sum(0.0);
  for (int j = 0; j < rows; ++j)
  {
    const double vertical = share(j, rows, y);
    for (int i = 0; vertical > 0.0 && i < columns; ++i)
    {
      const float* const radiance = &radiances[3 *
        (static_cast<size_t>(j) * static_cast<size_t>(columns) + static_cast<size_t>(i))];
      sum += vertical * share(i, columns, x) * glm::dvec3(radiance[0], radiance[1], radiance[2]);
    }
  }
  return sum;
}

// A part of a list, and its greatest extent, in place or in direction. Half a turn counts as much
// as the extent of all places.
struct Part
{
  std::vector<size_t> Members;
  int Axis = 0;
  double Extent = 0.0;
};

double GetCoordinate(const vtkIndirectLight& light, int axis, double size)
{
  return axis < 3 ? light.PositionWC[axis] : 0.5 * size * light.DirectionWC[axis - 3];
}

void Measure(Part& part, const vtkIndirectEmitters::List& list, double size)
{
  part.Extent = 0.0;
  for (int axis = 0; axis < 6; ++axis)
  {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -lower;
    for (const size_t i : part.Members)
    {
      const double place = GetCoordinate(list[i].Light, axis, size);
      lower = std::min(lower, place);
      upper = std::max(upper, place);
    }
    if (upper - lower > part.Extent)
    {
      part.Extent = upper - lower;
      part.Axis = axis;
    }
  }
}

// If the list has more than `most` lights, joins lights that are near each other and send the same
// way, at the place of the one nearest to their mean. The partition does not depend on the lights'
// strength, so lights stay in place while their images change.
void JoinAlike(vtkIndirectEmitters::List& list, size_t most)
{
  if (list.size() <= most)
  {
    return;
  }
  Part whole;
  whole.Members.resize(list.size());
  std::iota(whole.Members.begin(), whole.Members.end(), size_t(0));
  Measure(whole, list, 0.0);
  const double size = whole.Extent;
  Measure(whole, list, size);
  std::vector<Part> parts = { whole };
  while (parts.size() < most)
  {
    const auto widest = std::max_element(
      parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.Extent < b.Extent; });
    if (widest->Extent <= 0.0)
    {
      break;
    }
    std::vector<size_t>& members = widest->Members;
    const int axis = widest->Axis;
    const auto middle = members.begin() + static_cast<std::ptrdiff_t>(members.size() / 2);
    std::nth_element(members.begin(), middle, members.end(),
      [&](size_t a, size_t b)
      {
        const double x = GetCoordinate(list[a].Light, axis, size);
        const double y = GetCoordinate(list[b].Light, axis, size);
        return x < y || (x == y && a < b);
      });
    Part other;
    other.Members.assign(middle, members.end());
    members.erase(middle, members.end());
    Measure(*widest, list, size);
    Measure(other, list, size);
    parts.push_back(other);
  }
  vtkIndirectEmitters::List joined;
  for (const Part& part : parts)
  {
    glm::dvec3 mean(0.0);
    glm::dvec3 strength(0.0);
    for (const size_t i : part.Members)
    {
      mean += list[i].Light.PositionWC / static_cast<double>(part.Members.size());
      strength += list[i].Strength;
    }
    const size_t nearest = *std::min_element(part.Members.begin(), part.Members.end(),
      [&](size_t a, size_t b)
      {
        return glm::distance(list[a].Light.PositionWC, mean) <
          glm::distance(list[b].Light.PositionWC, mean);
      });
    joined.push_back(list[nearest]);
    joined.back().Strength = strength;
    joined.back().Pieces = part.Members.size();
  }
  list = std::move(joined);
}
}

//------------------------------------------------------------------------------
void vtkIndirectEmitters::AddSky(
  List& emitters, vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment)
{
  const vtkIndirectSkyProjection::Result& sky =
    projection.Find(environment, vtkIndirectSkyProjection::FineDirections);
  const std::vector<glm::dvec3>& fine = sky.Directions;
  const std::vector<glm::dvec3> coarse = vtkIndirectDirections::MakeLattice(NumberOfSkyGroups);
  List all;
  auto add = [&all](int number, const glm::dvec3& direction, const glm::dvec3& strength)
  {
    vtkIndirectEmitter emitter;
    emitter.Number = number;
    emitter.Light.DirectionWC = -direction;
    emitter.Light.Color = glm::dvec3(1.0);
    emitter.Strength = strength;
    all.push_back(emitter);
  };
  for (const glm::dvec3& direction : coarse)
  {
    add(static_cast<int>(all.size()), direction, glm::dvec3(0.0));
  }
  for (size_t i = 0; i < fine.size(); ++i)
  {
    const glm::dvec3 strength = sky.Light[i] / vtkMath::Pi();
    if (sky.IsStrong(i))
    {
      add(NumberOfSkyGroups + static_cast<int>(i), sky.Middles[i], strength);
    }
    else
    {
      all[FindNearest(fine[i], coarse)].Strength += strength;
    }
  }
  std::copy_if(all.begin(), all.end(), std::back_inserter(emitters),
    [](const vtkIndirectEmitter& emitter) { return AddChannels(emitter.Strength) > 0.0; });
}

//------------------------------------------------------------------------------
void vtkIndirectEmitters::AddAreaLights(
  List& emitters, const std::vector<vtkSmartPointer<vtkAreaLight>>& lights, bool inHaste)
{
  const auto count = std::count_if(lights.begin(), lights.end(), Shines);
  const int pieces = count > 4 ? 1
    : count > 1 || inHaste     ? MostPiecesPerEdge / 2
                               : MostPiecesPerEdge;
  List all;
  for (int number = 0; number < static_cast<int>(lights.size()); ++number)
  {
    vtkAreaLight* light = lights[static_cast<size_t>(number)];
    if (!Shines(light))
    {
      continue;
    }
    const double area = light->GetArea() / (pieces * pieces);
    const vtkIndirectRectangle whole(light);
    for (int side = 0; side < (whole.TwoSided ? 2 : 1); ++side)
    {
      for (int i = 0; i < pieces * pieces; ++i)
      {
        const int x = i % pieces;
        const int y = i / pieces;
        vtkIndirectEmitter emitter;
        emitter.Number =
          FirstPiece + ((2 * number + side) * MostPiecesPerEdge + y) * MostPiecesPerEdge + x;
        emitter.Light.Positional = true;
        emitter.Light.PositionWC = whole.GetPlace(FindPlaceIn(x, y, pieces));
        emitter.Light.DirectionWC = (side == 0 ? 1.0 : -1.0) * whole.Normal;
        emitter.Light.Color = glm::dvec3(1.0);
        // The irradiance is L A cos / (pi d^2 + A): a spot of the whole hemisphere.
        emitter.Light.Attenuation = { area / vtkMath::Pi(), 0.0, 1.0 };
        emitter.Light.ConeAngle = 89.9;
        emitter.Light.Exponent = 1.0;
        emitter.Strength = FindRadiance(light, x, y, pieces) * (area / vtkMath::Pi());
        all.push_back(emitter);
      }
    }
  }
  JoinAlike(all, MostPieces);
  std::copy_if(all.begin(), all.end(), std::back_inserter(emitters),
    [](const vtkIndirectEmitter& emitter) { return emitter.Strength != glm::dvec3(0.0); });
}

//------------------------------------------------------------------------------
double vtkIndirectEmitters::FindIrradiance(
  const std::vector<vtkSmartPointer<vtkAreaLight>>& lights, const double place[3])
{
  glm::dvec3 sum(0.0);
  for (const auto& light : lights)
  {
    if (Shines(light))
    {
      const double area = light->GetArea();
      const glm::dvec3 middle =
        0.5 * (glm::make_vec3(light->GetPoint1()) + glm::make_vec3(light->GetPoint2()));
      const glm::dvec3 apart = middle - glm::make_vec3(place);
      glm::dvec3 mean;
      light->GetMeanRadiance(&mean[0]);
      // The light counts as a disk of its area, as virtual lights do.
      sum += mean * (area / (vtkMath::Pi() * glm::dot(apart, apart) + area));
    }
  }
  return std::max({ sum.x, sum.y, sum.z });
}
