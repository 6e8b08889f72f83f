// SPDX-License-Identifier: BSD-3-Clause
#include "Senders/vtkIndirectEmitters.h"

#include "Emitters/vtkIndirectAreaPyramid.h"
#include "Emitters/vtkIndirectDirections.h"
#include "Emitters/vtkIndirectEmitterAccess.h"
#include "Emitters/vtkIndirectRectangle.h"
#include "Emitters/vtkIndirectSkyProjection.h"
#include "Senders/vtkIndirectSamplePattern.h"
#include "Senders/vtkIndirectSenderClusters.h"
#include "vtkMath.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

namespace
{
// Numbers of pieces start here: there are fewer directions of the sky. Lights that turn have
// numbers below zero.
constexpr int FirstPiece = 1024;
constexpr int MostPiecesPerEdge = 4;

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

// If the list has more than `most` lights, joins lights that are near each other and send the same
// way, at the place of the one in their middle. The groups do not depend on the lights' strength,
// so lights stay in place while their images change.
void JoinAlike(vtkIndirectEmitters::List& list, size_t most)
{
  if (list.size() <= most)
  {
    return;
  }
  glm::dvec3 lower(std::numeric_limits<double>::infinity());
  glm::dvec3 upper = -lower;
  for (const vtkIndirectLight& light : list)
  {
    lower = glm::min(lower, light.PositionWC);
    upper = glm::max(upper, light.PositionWC);
  }
  // Half a turn of a normal counts as much as the extent of all places.
  const glm::dvec3 extent = upper - lower;
  const double scale = 0.5 / std::max({ extent.x, extent.y, extent.z, 1e-300 });
  std::vector<vtkIndirectSenderClusters::Sender> senders;
  for (const vtkIndirectLight& light : list)
  {
    senders.push_back({ glm::vec3(scale * (light.PositionWC - lower)), glm::vec3(light.DirectionWC),
      1.0f, glm::vec3(1.0f), 0 });
  }
  vtkIndirectSenderClusters clusters;
  clusters.SetSenders(std::move(senders));
  vtkIndirectEmitters::List joined;
  for (const std::vector<size_t>& group : clusters.FindGroups(static_cast<int>(most)))
  {
    joined.push_back(list[group.front()]);
    joined.back().Pieces = group.size();
    for (size_t i = 1; i < group.size(); ++i)
    {
      joined.back().Color += list[group[i]].Color;
    }
  }
  list = std::move(joined);
}
}

namespace
{
vtkIndirectLight MakeDirection(int number, const glm::dvec3& direction, const glm::dvec3& strength)
{
  vtkIndirectLight emitter;
  emitter.Index = number;
  emitter.DirectionWC = -direction;
  emitter.Color = strength;
  return emitter;
}

// Returns all groups, in the order of the coarse directions and then of those with a group of their
// own.
vtkIndirectEmitters::List MakeGroups(vtkIndirectSkyProjection& projection,
  vtkEnvironmentLight* environment, const std::vector<glm::dvec3>& coarse)
{
  const vtkIndirectSkyProjection::Result dark;
  const vtkIndirectSkyProjection::Result& sky = environment ? projection.Find(environment) : dark;
  vtkIndirectEmitters::List all;
  for (const glm::dvec3& direction : coarse)
  {
    all.push_back(MakeDirection(static_cast<int>(all.size()), direction, glm::dvec3(0.0)));
  }
  for (size_t i = 0; i < sky.Directions.size(); ++i)
  {
    const glm::dvec3 strength = sky.Light[i] / vtkMath::Pi();
    if (sky.IsStrong(i))
    {
      const int number = vtkIndirectEmitters::NumberOfSkyGroups + static_cast<int>(i);
      all.push_back(MakeDirection(number, sky.Middles[i], strength));
    }
    else
    {
      all[vtkIndirectDirections::FindNearest(sky.Directions[i], coarse)].Color += strength;
    }
  }
  return all;
}
}

//------------------------------------------------------------------------------
void vtkIndirectEmitters::AddSteadyDirections(List& emitters, vtkIndirectSkyProjection& projection,
  vtkEnvironmentLight* environment, const List& turning)
{
  const std::vector<glm::dvec3> coarse = vtkIndirectDirections::MakeLattice(NumberOfSkyGroups);
  List all = MakeGroups(projection, environment, coarse);
  for (const vtkIndirectLight& light : turning)
  {
    for (const auto& [number, weight] :
      vtkIndirectDirections::FindAround(-light.DirectionWC, coarse))
    {
      all[number].Color += weight * light.Color;
    }
  }
  emitters.insert(emitters.end(), all.begin(), all.end());
}

//------------------------------------------------------------------------------
void vtkIndirectEmitters::AddDirections(List& emitters, vtkIndirectSkyProjection& projection,
  vtkEnvironmentLight* environment, const List& turning)
{
  List all =
    MakeGroups(projection, environment, vtkIndirectDirections::MakeLattice(NumberOfSkyGroups));
  for (size_t i = 0; i < turning.size(); ++i)
  {
    all.push_back(
      MakeDirection(-1 - static_cast<int>(i), -turning[i].DirectionWC, turning[i].Color));
  }
  std::copy_if(all.begin(), all.end(), std::back_inserter(emitters),
    std::mem_fn(&vtkIndirectLight::IsReflected));
}

//------------------------------------------------------------------------------
void vtkIndirectEmitters::AddAreaLights(
  List& emitters, const std::vector<vtkSmartPointer<vtkAreaLight>>& lights, bool inHaste)
{
  const auto count = std::count_if(
    lights.begin(), lights.end(), [](const auto& light) { return light->GetSwitch(); });
  const int pieces = count > 4 ? 1
    : count > 1 || inHaste     ? MostPiecesPerEdge / 2
                               : MostPiecesPerEdge;
  List all;
  for (int number = 0; number < static_cast<int>(lights.size()); ++number)
  {
    vtkAreaLight* light = lights[static_cast<size_t>(number)];
    if (!light->GetSwitch())
    {
      continue;
    }
    int columns;
    int rows;
    const std::vector<float>& radiances =
      vtkIndirectEmitterAccess::GetRadiances(light, columns, rows);
    vtkIndirectAreaPyramid pyramid;
    pyramid.Build(radiances, columns, rows, pieces);
    const int edge = pyramid.GetEdge(0);
    const double area = light->GetArea() / (pieces * pieces);
    const vtkIndirectRectangle whole(light);
    for (int side = 0; side < (whole.TwoSided ? 2 : 1); ++side)
    {
      for (int i = 0; i < pieces * pieces; ++i)
      {
        const int x = i % pieces;
        const int y = i / pieces;
        vtkIndirectLight emitter;
        emitter.Index =
          FirstPiece + ((2 * number + side) * MostPiecesPerEdge + y) * MostPiecesPerEdge + x;
        emitter.Positional = true;
        emitter.PositionWC = whole.GetPlace(FindPlaceIn(x, y, pieces));
        emitter.DirectionWC = (side == 0 ? 1.0 : -1.0) * whole.Normal;
        // The irradiance is L A cos / (pi d^2 + A): a spot of the whole hemisphere.
        emitter.Attenuation = { area / vtkMath::Pi(), 0.0, 1.0 };
        emitter.ConeAngle = 89.9;
        emitter.Exponent = 1.0;
        const glm::vec3 radiance = pyramid.GetMean(0, x * edge / pieces, y * edge / pieces);
        emitter.Color = glm::dvec3(radiance) * (area / vtkMath::Pi());
        all.push_back(emitter);
      }
    }
  }
  JoinAlike(all, MostPieces);
  std::copy_if(all.begin(), all.end(), std::back_inserter(emitters),
    std::mem_fn(&vtkIndirectLight::IsReflected));
}

//------------------------------------------------------------------------------
double vtkIndirectEmitters::FindIrradiance(
  const std::vector<vtkSmartPointer<vtkAreaLight>>& lights, const double place[3])
{
  glm::dvec3 sum(0.0);
  for (const auto& light : lights)
  {
    if (light->GetSwitch())
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
