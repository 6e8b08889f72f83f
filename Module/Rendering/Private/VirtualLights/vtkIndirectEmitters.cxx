// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualLights/vtkIndirectEmitters.h"

#include "VirtualLights/vtkIndirectSkyGroups.h"
#include "vtkAreaLight.h"
#include "vtkMath.h"

#include <algorithm>

namespace
{
// Those of pieces follow: there are fewer directions of the sky.
constexpr int FirstPiece = 1024;
constexpr int MostPiecesPerEdge = 2;

glm::dvec3 ToVector(const double v[3])
{
  return { v[0], v[1], v[2] };
}

// What a part of an area light sends, its mean over the part.
glm::dvec3 FindRadiance(vtkAreaLight* light, int x, int y, int pieces)
{
  int columns;
  int rows;
  const std::vector<float>& radiances = light->GetRadiances(columns, rows);
  // A pixel that lies in several parts counts to each with what lies in it.
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
}

//------------------------------------------------------------------------------
void vtkIndirectEmitters::AddSky(
  List& emitters, vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment)
{
  for (const vtkIndirectSkyGroups::Group& group :
    vtkIndirectSkyGroups::Make(projection, environment))
  {
    vtkIndirectEmitter emitter;
    emitter.Number = group.Number;
    emitter.Light.DirectionWC = -group.Direction;
    emitter.Light.Color = glm::dvec3(1.0);
    emitter.Strength = group.Strength;
    emitters.push_back(emitter);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectEmitters::AddAreaLights(
  List& emitters, const std::vector<vtkSmartPointer<vtkAreaLight>>& lights)
{
  const int count = static_cast<int>(lights.size());
  const int pieces = count > 4 ? 1 : MostPiecesPerEdge;
  for (int number = 0; number < count; ++number)
  {
    vtkAreaLight* light = lights[static_cast<size_t>(number)];
    const double area = light->GetArea() / (pieces * pieces);
    if (!light->GetSwitch() || !(area > 0.0))
    {
      continue;
    }
    const glm::dvec3 origin = ToVector(light->GetOrigin());
    const glm::dvec3 edge1 = ToVector(light->GetPoint1()) - origin;
    const glm::dvec3 edge2 = ToVector(light->GetPoint2()) - origin;
    double normal[3];
    light->GetNormal(normal);
    for (int side = 0; side < (light->GetTwoSided() ? 2 : 1); ++side)
    {
      for (int i = 0; i < pieces * pieces; ++i)
      {
        const int x = i % pieces;
        const int y = i / pieces;
        const glm::dvec3 radiance = FindRadiance(light, x, y, pieces);
        if (radiance == glm::dvec3(0.0))
        {
          continue;
        }
        vtkIndirectEmitter emitter;
        emitter.Number =
          FirstPiece + ((2 * number + side) * MostPiecesPerEdge + y) * MostPiecesPerEdge + x;
        emitter.Light.Positional = true;
        emitter.Light.PositionWC = origin + (x + 0.5) / pieces * edge1 + (y + 0.5) / pieces * edge2;
        emitter.Light.DirectionWC = (side == 0 ? 1.0 : -1.0) * ToVector(normal);
        emitter.Light.Color = glm::dvec3(1.0);
        // L A cos / (pi d^2 + A): a spot of the whole hemisphere.
        emitter.Light.Attenuation = { area / vtkMath::Pi(), 0.0, 1.0 };
        emitter.Light.ConeAngle = 89.9;
        emitter.Light.Exponent = 1.0;
        emitter.Strength = radiance * (area / vtkMath::Pi());
        emitters.push_back(emitter);
      }
    }
  }
}

//------------------------------------------------------------------------------
double vtkIndirectEmitters::FindIrradiance(
  const std::vector<vtkSmartPointer<vtkAreaLight>>& lights, const double place[3])
{
  glm::dvec3 sum(0.0);
  for (const auto& light : lights)
  {
    const double area = light->GetSwitch() ? light->GetArea() : 0.0;
    if (area > 0.0)
    {
      const glm::dvec3 middle = 0.5 * (ToVector(light->GetPoint1()) + ToVector(light->GetPoint2()));
      const glm::dvec3 apart = middle - ToVector(place);
      double mean[3];
      light->GetMeanRadiance(mean);
      // A disk of its area, as virtual lights are.
      sum += ToVector(mean) * (area / (vtkMath::Pi() * glm::dot(apart, apart) + area));
    }
  }
  return std::max({ sum.x, sum.y, sum.z });
}
