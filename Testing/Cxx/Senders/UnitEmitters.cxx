// SPDX-License-Identifier: BSD-3-Clause
// Emitters of light that bounces: places of area lights, and the sky in a few directions.
#include "Emitters/vtkIndirectDirections.h"
#include "Emitters/vtkIndirectSkyProjection.h"
#include "Senders/vtkIndirectEmitters.h"
#include "vtkAreaLight.h"
#include "vtkEnvironmentLight.h"
#include "vtkImageData.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace vtkIndirectTest;

namespace
{
void MakeImage(vtkImageData* image, int columns, int rows)
{
  image->SetDimensions(columns, rows, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  auto* p = static_cast<float*>(image->GetScalarPointer());
  std::fill(p, p + 3 * columns * rows, 0.0f);
}
}

// Bars before a lamp, along either edge, hide about the same share of its places as of its area.
VTK_INDIRECT_TEST(PlacesOfALampBehindBars)
{
  vtkNew<vtkAreaLight> lamp;
  for (const int count : { 1, 3, 5 })
  {
    vtkIndirectEmitters::List places;
    vtkIndirectEmitters::AddAreaLights(
      places, std::vector<vtkSmartPointer<vtkAreaLight>>(count, lamp.Get()), false);
    const int each = count == 1 ? 16 : count == 3 ? 4 : 1;
    CheckEqual("places", static_cast<double>(places.size()), count * each);
    double worst = 0.0;
    for (int axis = 0; axis < 2; ++axis)
    {
      for (double begin = -0.5; begin < 0.5; begin += 0.01)
      {
        for (double end = begin; end <= 0.5; end += 0.01)
        {
          const auto hidden = std::count_if(places.begin(), places.begin() + each,
            [&](const vtkIndirectLight& place)
            {
              const double at = place.PositionWC[axis];
              return at > begin && at < end;
            });
          worst = std::max(worst, std::abs(1.0 * hidden / each - (end - begin)));
        }
      }
    }
    CheckAtMost("share", worst, 1.0 / each + 1e-9, "a place in the middle of each column and row");
  }
}

// More lamps than places share them: those that are near each other and face alike.
VTK_INDIRECT_TEST(PlacesOfManyLamps)
{
  constexpr int edge = 10;
  std::vector<vtkSmartPointer<vtkAreaLight>> lamps;
  for (int i = 0; i < edge * edge; ++i)
  {
    const double x = i % edge;
    const double y = i / edge;
    lamps.push_back(vtkSmartPointer<vtkAreaLight>::New());
    lamps.back()->SetOrigin(x, y, 0.0);
    lamps.back()->SetPoint1(x + 1.0, y, 0.0);
    lamps.back()->SetPoint2(x, y + 1.0, 0.0);
    lamps.back()->SetRadiance(1.0, x, y);
    lamps.back()->SetTwoSided(true);
  }
  vtkIndirectEmitters::List places;
  vtkIndirectEmitters::AddAreaLights(places, lamps, false);
  CheckEqual("places", static_cast<double>(places.size()), vtkIndirectEmitters::MostPieces);
  glm::dvec3 front(0.0);
  glm::dvec3 back(0.0);
  size_t pieces = 0;
  double most = 0.0;
  for (const vtkIndirectLight& place : places)
  {
    (place.DirectionWC.z > 0.0 ? front : back) += place.Color;
    pieces += place.Pieces;
    most = std::max(most, static_cast<double>(place.Pieces));
  }
  const glm::dvec3 all = glm::dvec3(100.0, 450.0, 450.0) / vtkMath::Pi();
  CheckAbsolute("light of the fronts", glm::length(front - all), 0.0, 1e-9, "rounding of a sum");
  CheckAbsolute("of the backs", glm::length(back - all), 0.0, 1e-9, "rounding of a sum");
  CheckEqual("sides of lamps", static_cast<double>(pieces), 2.0 * edge * edge);
  CheckAtMost("sides that share a place", most, 8.0, "two halvings more than 200 of 64");
  for (const auto& lamp : lamps)
  {
    lamp->SetRadiance(2.0, 1.0, 1.0);
  }
  vtkIndirectEmitters::List again;
  vtkIndirectEmitters::AddAreaLights(again, lamps, false);
  Check("other light has the same places",
    std::equal(places.begin(), places.end(), again.begin(), again.end(),
      [](const vtkIndirectLight& a, const vtkIndirectLight& b) { return a.Index == b.Index; }));
}

VTK_INDIRECT_TEST(SkyGroupsAreAllOfTheSky)
{
  const double pi = vtkMath::Pi();
  auto total = [](const vtkIndirectEmitters::List& groups)
  {
    glm::dvec3 sum(0.0);
    for (const vtkIndirectLight& group : groups)
    {
      sum += group.Color;
    }
    return sum;
  };
  vtkNew<vtkEnvironmentLight> environment;
  environment->SetRadiance(3.0, 1.0, 0.5);
  vtkIndirectSkyProjection projection;
  auto make = [&]()
  {
    vtkIndirectEmitters::List emitters;
    vtkIndirectEmitters::AddDirections(emitters, projection, environment);
    return emitters;
  };
  vtkIndirectEmitters::List groups = make();
  CheckEqual("groups of a uniform sky", static_cast<double>(groups.size()),
    vtkIndirectEmitters::NumberOfSkyGroups);
  CheckRelative("its light", total(groups).x, 4.0 * 3.0, 1e-12, "rounding of a sum");
  CheckRelative("in green", total(groups).y, 4.0, 1e-12, "rounding of a sum");
  Random random(7);
  double worst = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    const glm::dvec3 normal = random.NextDirection();
    double irradiance = 0.0;
    for (const vtkIndirectLight& group : groups)
    {
      irradiance += group.Color.y * std::max(glm::dot(-group.DirectionWC, normal), 0.0);
    }
    worst = std::max(worst, std::abs(irradiance - 1.0));
  }
  CheckAtMost("irradiance of an open plane, worst of all normals", worst, 0.04,
    "quadrature of a cosine by 16 directions");

  // A dark ground, and a sun in the sky.
  vtkNew<vtkImageData> image;
  MakeImage(image, 256, 128);
  for (int row = 64; row < 128; ++row)
  {
    for (int column = 0; column < 256; ++column)
    {
      auto* pixel = static_cast<float*>(image->GetScalarPointer(column, row, 0));
      std::fill(pixel, pixel + 3, row == 100 && column == 70 ? 5000.0f : 1.0f);
    }
  }
  environment->SetImage(image);
  groups = make();
  // The lowest row of directions but one is 9 degrees below the horizon: within half a group.
  CheckAtLeast("directions above the horizon, and the sun", static_cast<double>(groups.size()), 17,
    "half of 32");
  CheckAtMost("without those below it", static_cast<double>(groups.size()), 26,
    "groups reach 20 degrees from their direction");
  const auto sun = std::max_element(groups.begin(), groups.end(),
    [](const vtkIndirectLight& a, const vtkIndirectLight& b) { return a.Color.x < b.Color.x; });
  Check("which stands by itself", sun->Index >= vtkIndirectEmitters::NumberOfSkyGroups);
  const double longitude = 2.0 * pi * (70.5 / 256 - 0.5);
  const double latitude = pi * (100.5 / 128 - 0.5);
  const glm::dvec3 from(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
    -std::cos(latitude) * std::cos(longitude));
  CheckAtLeast("where it is", glm::dot(-sun->DirectionWC, from), std::cos(glm::radians(0.5)),
    "the sky around it, of which a circle of 7 degrees has a 24th of the sun's light");

  vtkNew<vtkImageData> black;
  MakeImage(black, 4, 2);
  environment->SetImage(black);
  Check("a black sky has no groups", make().empty());
}

// Three directions stand for a direction between them, and change smoothly with it.
VTK_INDIRECT_TEST(DirectionsAround)
{
  const std::vector<glm::dvec3> directions =
    vtkIndirectDirections::MakeLattice(vtkIndirectEmitters::NumberOfSkyGroups);
  auto weigh = [&](const glm::dvec3& direction)
  {
    std::vector<double> weights(directions.size(), 0.0);
    for (const auto& [number, weight] : vtkIndirectDirections::FindAround(direction, directions))
    {
      weights[number] += weight;
    }
    return weights;
  };
  Random random(5);
  double wrong = 0.0;
  double least = 0.0;
  double farthest = 0.0;
  double step = 0.0;
  for (int i = 0; i < 500; ++i)
  {
    const glm::dvec3 direction = random.NextDirection();
    const std::vector<double> weights = weigh(direction);
    const std::vector<double> beside =
      weigh(glm::normalize(direction + 1e-4 * random.NextDirection()));
    glm::dvec3 sum(0.0);
    for (size_t k = 0; k < directions.size(); ++k)
    {
      sum += weights[k] * directions[k];
      least = std::min(least, weights[k]);
      step = std::max(step, std::abs(weights[k] - beside[k]));
      if (weights[k] > 1e-6)
      {
        farthest = std::max(farthest, std::acos(glm::dot(directions[k], direction)));
      }
    }
    wrong = std::max(wrong, glm::length(sum - direction));
  }
  CheckAtMost("sum of the directions", wrong, 1e-12, "rounding");
  CheckEqual("no weight is negative", least, 0.0);
  CheckAtMost("the farthest", farthest, 0.9, "edges of a hull of 32 places");
  CheckAtMost("over a step of 1e-4", step, 5e-4, "slopes of weights over edges of 0.5");
  const std::vector<double> own = weigh(directions[7]);
  CheckRelative("a direction of the lattice stands for itself", own[7], 1.0, 1e-9, "rounding");

  // Lights that turn light surfaces that see their directions as they do themselves.
  vtkIndirectSkyProjection projection;
  vtkIndirectLight light;
  light.Color = { 2.0, 1.0, 0.5 };
  light.DirectionWC = -glm::normalize(glm::dvec3(0.3, 0.8, -0.5));
  const vtkIndirectEmitters::List turning = { light };
  vtkIndirectEmitters::List emitters;
  vtkIndirectEmitters::AddSteadyDirections(emitters, projection, nullptr, turning);
  CheckEqual("all directions, lit or not", static_cast<double>(emitters.size()),
    vtkIndirectEmitters::NumberOfSkyGroups);
  glm::dvec3 facing(0.0);
  for (const vtkIndirectLight& emitter : emitters)
  {
    facing += emitter.Color * std::max(glm::dot(emitter.DirectionWC, light.DirectionWC), 0.0);
  }
  CheckRelative("irradiance of what faces the light", facing.x, 2.0, 1e-9, "rounding");
  CheckRelative("in blue", facing.z, 0.5, 1e-9, "rounding");

  // In a picture of one view each light has its own direction, and nothing else sends.
  vtkIndirectEmitters::List ofView;
  vtkIndirectEmitters::AddDirections(ofView, projection, nullptr, turning);
  CheckEqual("directions of a view", static_cast<double>(ofView.size()), 1.0);
  CheckEqual("cosine to the light's direction",
    glm::dot(ofView.front().DirectionWC, light.DirectionWC),
    glm::dot(light.DirectionWC, light.DirectionWC));
  CheckEqual("the light's strength", ofView.front().Color.x, light.Color.x);
}
