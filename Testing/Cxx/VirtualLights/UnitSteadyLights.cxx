// SPDX-License-Identifier: BSD-3-Clause
// Lights that stay in place while the strengths of their maps change, and directions in the world
// that stand for one that turns.
#include "VirtualLights/vtkIndirectDirections.h"
#include "VirtualLights/vtkIndirectEmitters.h"
#include "VirtualLights/vtkIndirectSkyProjection.h"
#include "VirtualLights/vtkIndirectSteadyLights.h"
#include "vtkIndirectTestUtilities.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
using Clusters = vtkIndirectSenderClusters;
using Rows = std::vector<vtkIndirectSampler::Row>;

constexpr size_t NumberOfMaps = 3;

// Two squares that face each other; the first two maps see one each, the third sees both.
std::vector<Clusters::Sender> MakeSenders()
{
  constexpr int edge = 24;
  constexpr float area = 1.0f / (edge * edge);
  std::vector<Clusters::Sender> senders;
  for (int side = 0; side < 2; ++side)
  {
    for (int i = 0; i < edge * edge; ++i)
    {
      const glm::vec3 place((i % edge + 0.5) / edge, (i / edge + 0.5) / edge, 0.5 * side);
      const glm::vec3 normal(0.0f, 0.0f, side == 0 ? 1.0f : -1.0f);
      for (const int map : { side, 2 })
      {
        senders.push_back(
          { place, normal, area, area * glm::vec3(0.5f, 0.25f, 0.1f + 0.1f * map), map });
      }
    }
  }
  return senders;
}

glm::dvec3 SumLight(const Rows& rows)
{
  glm::dvec3 sum(0.0);
  for (const vtkIndirectSampler::Row& row : rows)
  {
    sum += glm::dvec3(row.DensityArea[0], row.DensityArea[1], row.DensityArea[2]);
  }
  return sum;
}
}

VTK_INDIRECT_TEST(SteadyLights)
{
  constexpr double error = 1e-3;
  Clusters clusters;
  clusters.SetSenders(MakeSenders());
  vtkIndirectSteadyLights steady;
  steady.Make(clusters, NumberOfMaps, 64, true, Clusters::StandardNearness, 0);
  Clusters other;
  other.SetSenders(MakeSenders());
  const std::vector<glm::dvec3> equal(NumberOfMaps, glm::dvec3(1.0));
  const Clusters::LightTree expected = other.MakeLights(equal, 64, error);
  steady.Relight(clusters, equal, error);
  const Rows lights = steady.GetLights();
  CheckEqual("as many as of equal strengths", static_cast<double>(lights.size()),
    static_cast<double>(expected.Lights.size()));
  double apart = 0.0;
  double distances = 0.0;
  double densities = 0.0;
  int divided = 0;
  for (size_t i = 0; i < std::min(lights.size(), expected.Lights.size()); ++i)
  {
    const Clusters::Light& light = expected.Lights[i];
    const vtkIndirectSampler::Row& row = lights[i];
    for (int c = 0; c < 3; ++c)
    {
      apart = std::max(apart, std::abs(row.Position[c] - light.Position[c]));
      densities = std::max(densities, std::abs(row.DensityArea[c] / light.DensityArea[c] - 1.0));
    }
    distances = std::max(distances, std::abs(row.ChildDistance - light.ChildDistance));
    divided += light.ChildDistance > 0.0 ? 1 : 0;
  }
  Check("some are divided", divided > 0);
  CheckEqual("at the same places", apart, 0.0);
  CheckAtMost("of the same light", densities, 1e-5, "sums of floats");
  CheckAtMost("divided within the same distances", distances, 1e-5, "sums of floats");

  // Other strengths move nothing, and no light is lost.
  const std::vector<glm::dvec3> strengths = { { 4, 1, 0 }, { 0, 0, 0 }, { 0.5, 0.25, 1 } };
  steady.Relight(clusters, strengths, error);
  const Rows& again = steady.GetLights();
  bool moved = false;
  for (size_t i = 0; i < lights.size(); ++i)
  {
    moved = moved || !std::equal(lights[i].Position, lights[i].Position + 3, again[i].Position) ||
      !std::equal(lights[i].Normal, lights[i].Normal + 3, again[i].Normal) ||
      lights[i].Area != again[i].Area;
  }
  Check("lights stay", !moved);
  const glm::dvec3 sum = SumLight(again);
  CheckRelative("red light", sum.x, 0.5 * (4.0 + 2.0 * 0.5), 1e-5, "sums of floats");
  CheckRelative("green light", sum.y, 0.25 * (1.0 + 2.0 * 0.25), 1e-5, "sums of floats");
  CheckRelative("blue light", sum.z, 0.3 * 2.0, 1e-5, "sums of floats");
  const Rows& branches = steady.GetBranches();
  glm::dvec3 leaves(0.0);
  for (size_t i = 0; i < branches.size(); ++i)
  {
    if (i % 9 != 0)
    {
      leaves += SumLight({ branches[i] });
    }
  }
  CheckRelative("of all leaves, which every child has", leaves.x, sum.x, 1e-5, "sums of floats");
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
  vtkIndirectEmitters::AddDirections(emitters, projection, nullptr, &turning);
  CheckEqual("all directions, lit or not", static_cast<double>(emitters.size()),
    vtkIndirectEmitters::NumberOfSkyGroups);
  glm::dvec3 facing(0.0);
  for (const vtkIndirectLight& emitter : emitters)
  {
    facing += emitter.Color * std::max(glm::dot(emitter.DirectionWC, light.DirectionWC), 0.0);
  }
  CheckRelative("irradiance of what faces the light", facing.x, 2.0, 1e-9, "rounding");
  CheckRelative("in blue", facing.z, 0.5, 1e-9, "rounding");
}
