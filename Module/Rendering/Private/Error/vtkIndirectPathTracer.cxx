// SPDX-License-Identifier: BSD-3-Clause
#include "Error/vtkIndirectPathTracer.h"

#include "Emitters/vtkIndirectEmitterAccess.h"
#include "Emitters/vtkIndirectSkyProjection.h"
#include "Error/vtkIndirectSphericalRectangle.h"
#include "Senders/vtkIndirectSamplePattern.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/type_ptr.hpp>
#include <iterator>
#include <utility>

namespace
{
const auto SumColors = vtkIndirectSkyProjection::SumColors;

constexpr double Pi = 3.14159265358979323846;
// A ray begins this far from its surface, as a share of the scene's diagonal.
constexpr double Clearance = 1e-6;
// Rays into the sky are so many diagonals of the scene long.
constexpr double FarAway = 4.0;
// Steradians; rounding would show in smaller ones.
constexpr double LeastSolidAngle = 1e-4;
// Paths between surfaces that absorb nothing have an end.
constexpr int MostBounces = 256;
// Points of the sequence that a vertex of a path takes.
constexpr std::uint32_t PointsOfVertex = 4;

// Returns the place of a direction along a curve through all directions (Morton 1966), on which
// neighbours are near each other: places that are spread along the curve are spread over the sky.
std::uint32_t FindPlaceOnCurve(const glm::dvec3& direction)
{
  constexpr int bits = 10;
  const double across = 0.5 + 0.5 * std::atan2(direction.y, direction.x) / Pi;
  const double up = 0.5 + 0.5 * direction.z;
  std::uint32_t place = 0;
  for (int i = 1; i <= bits; ++i)
  {
    const auto digit = [i](double x)
    { return static_cast<std::uint32_t>(std::min(x, 0.9999999) * (1 << i)) & 1u; };
    place = (place << 2u) | (digit(across) << 1u) | digit(up);
  }
  return place;
}
}

//------------------------------------------------------------------------------
vtkIndirectPathTracer::vtkIndirectPathTracer(const vtkIndirectFrame& frame,
  const vtkIndirectSurfaces& surfaces, vtkEnvironmentLight* environment,
  const std::vector<vtkSmartPointer<vtkAreaLight>>& areaLights, int bounces)
  : Frame(frame)
  , Surfaces(surfaces)
  , LastBounce(bounces > 0 ? bounces : MostBounces)
{
  std::copy_if(frame.Lights.begin(), frame.Lights.end(), std::back_inserter(this->Lights),
    std::mem_fn(&vtkIndirectLight::IsReflected));
  for (const vtkSmartPointer<vtkAreaLight>& light : areaLights)
  {
    if (light->GetSwitch())
    {
      Rectangle rectangle;
      rectangle.Shape = vtkIndirectRectangle(light, frame.SceneCenter, frame.SceneScale);
      rectangle.Radiances =
        vtkIndirectEmitterAccess::GetRadiances(light, rectangle.Columns, rectangle.Rows);
      const glm::dvec3& edge1 = rectangle.Shape.Edge1;
      const glm::dvec3& edge2 = rectangle.Shape.Edge2;
      rectangle.IsRectangular =
        std::abs(glm::dot(edge1, edge2)) < 1e-9 * glm::length(edge1) * glm::length(edge2);
      this->Rectangles.push_back(std::move(rectangle));
    }
  }
  if (environment)
  {
    std::vector<std::pair<std::uint32_t, vtkIndirectEmitterAccess::Cell>> cells;
    for (const vtkIndirectEmitterAccess::Cell& cell :
      vtkIndirectEmitterAccess::GetCells(environment))
    {
      cells.emplace_back(FindPlaceOnCurve(glm::make_vec3(cell.Direction)), cell);
    }
    std::stable_sort(
      cells.begin(), cells.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    double sum = 0.0;
    for (const auto& [place, cell] : cells)
    {
      this->SkyDirections.push_back(glm::make_vec3(cell.Direction));
      this->SkyLight.push_back(glm::make_vec3(cell.Light));
      this->SkySums.push_back(sum += SumColors(this->SkyLight.back()));
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectPathTracer::AddLights(const Place& place, Candidates& candidates) const
{
  for (const vtkIndirectLight& light : this->Lights)
  {
    glm::dvec3 end = place.Position - FarAway * light.DirectionWC;
    double falloff = place.GetShareOfVTKLights();
    if (light.Positional)
    {
      end = this->Frame.ToScene(light.PositionWC);
      const double distance = glm::length(place.Position - end);
      falloff *= light.FindFalloff(
        (place.Position - end) / std::max(distance, 1e-300), distance / this->Frame.SceneScale);
    }
    const double cosine = glm::dot(place.Normal, glm::normalize(end - place.Position));
    candidates.push_back({ std::max(cosine, 0.0) * falloff * light.Color, end });
  }
}

//------------------------------------------------------------------------------
// Draws one cell of the sky, in proportion to its light.
void vtkIndirectPathTracer::AddSky(const Place& place, double number, Candidates& candidates) const
{
  if (this->SkySums.empty() || !(this->SkySums.back() > 0.0))
  {
    return;
  }
  const double all = this->SkySums.back();
  const size_t cell = std::min(
    static_cast<size_t>(std::upper_bound(this->SkySums.begin(), this->SkySums.end(), number * all) -
      this->SkySums.begin()),
    this->SkySums.size() - 1);
  const double cosine = std::max(glm::dot(place.Normal, this->SkyDirections[cell]), 0.0);
  const glm::dvec3& light = this->SkyLight[cell];
  candidates.push_back({ cosine / Pi * all / SumColors(light) * light,
    place.Position + FarAway * this->SkyDirections[cell] });
}

//------------------------------------------------------------------------------
// Draws one place on each rectangle: by the solid angle, or by the area where it looks small, and
// of parallelograms.
void vtkIndirectPathTracer::AddRectangles(
  const Place& place, const glm::dvec2& at, Candidates& candidates) const
{
  for (const Rectangle& rectangle : this->Rectangles)
  {
    const vtkIndirectRectangle& shape = rectangle.Shape;
    const vtkIndirectSphericalRectangle seen(shape, place.Position);
    const bool bySolidAngle = rectangle.IsRectangular && seen.GetSolidAngle() > LeastSolidAngle;
    const glm::dvec2 along = bySolidAngle ? seen.GetPlace(at) : at;
    const glm::dvec3 end = shape.GetPlace(along);
    const glm::dvec3 way = end - place.Position;
    const double squared = glm::dot(way, way);
    const glm::dvec3 direction = way / std::sqrt(std::max(squared, 1e-300));
    double sent = -glm::dot(shape.Normal, direction);
    sent = shape.TwoSided ? std::abs(sent) : std::max(sent, 0.0);
    const double received = std::max(glm::dot(place.Normal, direction), 0.0);
    glm::dvec3 light(0.0);
    if (sent > 0.0 && received > 0.0 && !rectangle.Radiances.empty())
    {
      const int x = std::min(static_cast<int>(along.x * rectangle.Columns), rectangle.Columns - 1);
      const int y = std::min(static_cast<int>(along.y * rectangle.Rows), rectangle.Rows - 1);
      const auto pixel = static_cast<size_t>(y * rectangle.Columns + x);
      const double solidAngle =
        bySolidAngle ? seen.GetSolidAngle() : shape.GetArea() * sent / squared;
      light =
        solidAngle * received / Pi * glm::dvec3(glm::make_vec3(&rectangle.Radiances[3 * pixel]));
    }
    candidates.push_back({ light, end });
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectPathTracer::FindDirect(const Place& place, bool withLights,
  const glm::dvec2& at, const glm::dvec2& choice, Candidates& candidates) const
{
  candidates.clear();
  if (withLights)
  {
    this->AddLights(place, candidates);
  }
  this->AddSky(place, choice.x, candidates);
  this->AddRectangles(place, at, candidates);
  double all = 0.0;
  for (const Candidate& candidate : candidates)
  {
    all += SumColors(candidate.Light);
  }
  if (!(all > 0.0) || !std::isfinite(all))
  {
    return glm::dvec3(0.0);
  }
  double left = choice.y * all;
  const Candidate* chosen = nullptr;
  for (const Candidate& candidate : candidates)
  {
    const double light = SumColors(candidate.Light);
    if (light > 0.0 && (!chosen || left > 0.0))
    {
      chosen = &candidate;
    }
    left -= light;
  }
  // Light from behind the facet does not arrive, whatever the interpolated normal is.
  const glm::dvec3 way = chosen->End - place.Position;
  const bool hidden = glm::dot(place.FacetNormal, way) <= 0.0 ||
    this->Surfaces.GetTree().IsBlocked(place.Position + Clearance * place.FacetNormal, chosen->End);
  return hidden ? glm::dvec3(0.0) : chosen->Light * (all / SumColors(chosen->Light));
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectPathTracer::TracePath(
  const Place& place, std::uint32_t number, std::uint32_t seed, Candidates& candidates) const
{
  // Beyond the second vertex, even points of a sequence would take a fifth of the time for nothing.
  const auto point = [&](std::uint32_t dimension)
  {
    return dimension < 2 * PointsOfVertex
      ? vtkIndirectSamplePattern::ScrambledPoint(number, seed + dimension)
      : vtkIndirectSamplePattern::HashedPoint(number, seed + dimension);
  };
  glm::dvec3 sum = this->FindDirect(place, false, point(0), point(1), candidates);
  glm::dvec3 carried(1.0);
  Place from = place;
  for (int bounce = 1; bounce <= this->LastBounce; ++bounce)
  {
    const std::uint32_t first = static_cast<std::uint32_t>(bounce) * PointsOfVertex;
    const glm::dvec3 direction =
      vtkIndirectSamplePattern::CosineDirection(from.Normal, point(first));
    Place to;
    if (glm::dot(direction, from.FacetNormal) <= 0.0 ||
      !this->Surfaces.Meet(
        from.Position + Clearance * from.FacetNormal, direction, from.Triangle, to) ||
      !to.Sends)
    {
      break;
    }
    if (glm::dot(to.Normal, direction) >= 0.0)
    {
      to.Normal = to.FacetNormal;
    }
    carried *= to.Albedo;
    sum += carried * this->FindDirect(to, true, point(first + 1), point(first + 2), candidates);
    const double onward = std::min(std::max({ carried.x, carried.y, carried.z }), 1.0);
    if (!(point(first + 3).x < onward))
    {
      break;
    }
    carried /= onward;
    from = to;
  }
  return sum;
}

//------------------------------------------------------------------------------
void vtkIndirectPathTracer::AddPaths(const Place& place, std::uint32_t seed, int first, int paths,
  glm::vec3& sum, float& squares) const
{
  Candidates candidates;
  for (int i = first; i < first + paths; ++i)
  {
    const glm::dvec3 path = this->TracePath(place, static_cast<std::uint32_t>(i), seed, candidates);
    sum += path;
    squares += static_cast<float>(glm::dot(path, path) / 3.0);
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectPathTracer::FindIrradiance(
  const Place& place, std::uint32_t seed, int paths) const
{
  glm::dvec3 sum(0.0);
  Candidates candidates;
  for (int i = 0; i < paths; ++i)
  {
    sum += this->TracePath(place, static_cast<std::uint32_t>(i), seed, candidates);
  }
  return sum / static_cast<double>(std::max(paths, 1));
}
