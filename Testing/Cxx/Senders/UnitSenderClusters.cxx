// SPDX-License-Identifier: BSD-3-Clause
// A few lights that represent the texels of many maps: no light is lost, nor where strengths of
// maps change and lights stay.
#include "Senders/vtkIndirectSenderClusters.h"
#include "Senders/vtkIndirectSenderTexels.h"
#include "Senders/vtkIndirectSteadyLights.h"
#include "vtkIndirectTestUtilities.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
using Clusters = vtkIndirectSenderClusters;

// A unit square of edge * edge texels perpendicular to z, in each of several maps.
void AddSquare(std::vector<Clusters::Sender>& senders, int edge, int maps, double z, double up,
  const glm::vec3& albedo)
{
  const float area = 1.0f / static_cast<float>(edge * edge);
  for (int map = 0; map < maps; ++map)
  {
    for (int j = 0; j < edge; ++j)
    {
      for (int i = 0; i < edge; ++i)
      {
        senders.push_back({ glm::vec3((i + 0.5) / edge, (j + 0.5) / edge, z),
          glm::vec3(0.0, 0.0, up), area, albedo * area, map });
      }
    }
  }
}

constexpr size_t NumberOfMaps = 3;

// Two squares that face each other; the first two maps see one each, the third sees both.
std::vector<Clusters::Sender> MakeFacingSquares(float distance = 0.5f)
{
  constexpr int edge = 24;
  constexpr float area = 1.0f / (edge * edge);
  std::vector<Clusters::Sender> senders;
  for (int side = 0; side < 2; ++side)
  {
    for (int i = 0; i < edge * edge; ++i)
    {
      const glm::vec3 place((i % edge + 0.5) / edge, (i / edge + 0.5) / edge, distance * side);
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

glm::dvec3 SumLight(const std::vector<Clusters::Light>& lights)
{
  glm::dvec3 sum(0.0);
  for (const Clusters::Light& light : lights)
  {
    sum += light.DensityArea;
  }
  return sum;
}

bool AreAtSamePlaces(const std::vector<Clusters::Light>& a, const std::vector<Clusters::Light>& b)
{
  return a.size() == b.size() &&
    std::equal(a.begin(), a.end(), b.begin(),
      [](const Clusters::Light& x, const Clusters::Light& y)
      { return x.Position == y.Position && x.Normal == y.Normal; });
}
}

VTK_INDIRECT_TEST(ClustersKeepTheLight)
{
  std::vector<Clusters::Sender> senders;
  AddSquare(senders, 40, 3, 0.0, 1.0, { 0.5f, 0.25f, 0.125f });
  const std::vector<glm::dvec3> strengths = { { 1, 1, 1 }, { 0.5, 0.2, 0.3 }, { 2, 1, 0 } };
  Clusters clusters;
  clusters.SetSenders(senders);
  for (const int count : { 1, 7, 100, 256 })
  {
    const std::string name = " of " + std::to_string(count) + " lights";
    const std::vector<Clusters::Light> lights = clusters.MakeLights(strengths, count, 0.0).Lights;
    CheckEqual("number" + name, static_cast<double>(lights.size()), count);
    const glm::dvec3 sum = SumLight(lights);
    CheckRelative("red" + name, sum.x, 0.5 * 3.5, 1e-6, "floats of the senders");
    CheckRelative("green" + name, sum.y, 0.25 * 2.2, 1e-6, "floats of the senders");
    CheckRelative("blue" + name, sum.z, 0.125 * 1.3, 1e-6, "floats of the senders");
    double area = 0.0;
    for (const Clusters::Light& light : lights)
    {
      area += light.Area;
    }
    // Not three times: every map sees the same square.
    CheckRelative("area" + name, area, 1.0, 1e-5, "floats of the senders");
    double squares = 0.0;
    for (const Clusters::Sender& sender : senders)
    {
      double nearest = 2.0;
      for (const Clusters::Light& light : lights)
      {
        const glm::dvec3 d = light.Position - glm::dvec3(sender.Position);
        nearest = std::min(nearest, glm::dot(d, d));
      }
      squares += nearest;
    }
    CheckAtMost("RMS distance to the nearest" + name,
      std::sqrt(squares / static_cast<double>(senders.size())),
      std::sqrt(5.0 / 24.0 / count) + 0.5 / 40, "rectangles of one by two, and half a texel");
  }
  const std::vector<Clusters::Light> all = clusters.MakeLights(strengths, VTK_INT_MAX, 0.0).Lights;
  CheckEqual("all are lights", static_cast<double>(all.size()), 3.0 * 1600);
  CheckRelative("with all the light", SumLight(all).x, 0.5 * 3.5, 1e-6, "floats of the senders");
  CheckRelative("of their own area", all.back().Area, 1.0 / 1600, 1e-6, "floats of the senders");
  Check("no senders, no lights", Clusters().MakeLights(strengths, 256, 0.0).Lights.empty());
  Check("no light, no lights",
    clusters.MakeLights(std::vector<glm::dvec3>(3, glm::dvec3(0.0)), 256, 0.0).Lights.empty());
  // A dark map has no weight.
  const std::vector<Clusters::Light> one =
    clusters.MakeLights({ glm::dvec3(0.0), glm::dvec3(1.0), glm::dvec3(0.0) }, VTK_INT_MAX, 0.0)
      .Lights;
  CheckEqual("senders of one map of three", static_cast<double>(one.size()), 1600);
}

// Lights of a few texels each, of maps whose texels lie between those of the other maps, cover the
// surface once together. A texel's area for each would blur their light, and darken corners.
VTK_INDIRECT_TEST(ClustersCoverTheSurfaceOnce)
{
  constexpr int maps = 16;
  constexpr int edge = 10;
  std::vector<Clusters::Sender> senders;
  AddSquare(senders, edge, maps, 0.0, 1.0, glm::vec3(0.5f));
  for (Clusters::Sender& sender : senders)
  {
    const int part = (7 * sender.Map) % maps;
    sender.Position += glm::vec3((part % 4 - 1.5f), (part / 4 - 1.5f), 0.0f) / (4.0f * edge);
  }
  for (const int count : { 64, 256, 800 })
  {
    Clusters clusters;
    clusters.SetSenders(senders);
    double area = 0.0;
    const Clusters::LightTree tree =
      clusters.MakeLights(std::vector<glm::dvec3>(maps, glm::dvec3(1.0)), count, 0.0);
    for (const Clusters::Light& light : tree.Lights)
    {
      area += std::min(light.Area, light.Stretched);
    }
    // Divisions leave oblong clusters, and parts of texels at the rim.
    CheckRelative("area of " + std::to_string(tree.Lights.size()) + " lights", area, 1.0, 0.06,
      "found: 1.00 to 1.04");
  }
}

VTK_INDIRECT_TEST(ClustersKeepSidesApart)
{
  // A sheet, lit on both sides.
  std::vector<Clusters::Sender> senders;
  AddSquare(senders, 20, 1, 0.0, 1.0, glm::vec3(0.25f));
  AddSquare(senders, 20, 1, 0.0, -1.0, glm::vec3(0.75f));
  for (Clusters::Sender& sender : senders)
  {
    sender.Position *= 0.3f; // scene units: a part of the scene
  }
  Clusters clusters;
  clusters.SetSenders(senders);
  const std::vector<Clusters::Light> lights =
    clusters.MakeLights({ glm::dvec3(1.0) }, 64, 0.0).Lights;
  glm::dvec3 sides[2] = { glm::dvec3(0.0), glm::dvec3(0.0) };
  for (const Clusters::Light& light : lights)
  {
    sides[light.Normal.z > 0.0 ? 0 : 1] += light.DensityArea;
  }
  CheckRelative("light of the upper side", sides[0].x, 0.25, 1e-5, "floats of the senders");
  CheckRelative("light of the lower side", sides[1].x, 0.75, 1e-5, "floats of the senders");
}

// Ridges and furrows between them, with half as much area again, all facing up: the depth map of a
// light in a furrow would show little but the furrow.
VTK_INDIRECT_TEST(ClustersAreSeenFromInFront)
{
  std::vector<Clusters::Sender> senders;
  AddSquare(senders, 40, 1, 0.0, 1.0, glm::vec3(0.5f));
  for (Clusters::Sender& sender : senders)
  {
    sender.Position.z = std::fmod(sender.Position.x, 0.25f) < 0.15f ? -0.2f : 0.0f;
  }
  Clusters clusters;
  clusters.SetSenders(senders);
  for (const int count : { 1, 2, 4 })
  {
    int inFurrows = 0;
    for (const Clusters::Light& light : clusters.MakeLights({ glm::dvec3(1.0) }, count, 0.0).Lights)
    {
      inFurrows += light.Position.z < -0.01 ? 1 : 0;
    }
    CheckEqual("lights in furrows of " + std::to_string(count), inFurrows, 0);
  }
  // Otherwise a cluster stays in its middle.
  senders.clear();
  AddSquare(senders, 40, 1, 0.0, 1.0, glm::vec3(0.5f));
  clusters.SetSenders(senders);
  const Clusters::Light whole = clusters.MakeLights({ glm::dvec3(1.0) }, 1, 0.0).Lights.front();
  CheckAtMost("from the middle of a square",
    glm::length(whole.Position - glm::dvec3(0.5, 0.5, 0.0)), 1e-6,
    "its mean is within a texel of its middle one");
}

// A light has one depth map, which sees nothing of what another sheet lights.
VTK_INDIRECT_TEST(ClustersDivideSheetsFirst)
{
  constexpr int count = 4;
  constexpr double apart = 0.25;
  std::vector<Clusters::Sender> senders;
  for (int i = 0; i < count; ++i)
  {
    AddSquare(senders, 40, 1, apart * i, 1.0, glm::vec3(0.5f));
  }
  Clusters clusters;
  clusters.SetSenders(senders);
  std::vector<int> lights(count, 0);
  for (const Clusters::Light& light : clusters.MakeLights({ glm::dvec3(1.0) }, count, 0.0).Lights)
  {
    const double sheet = light.Position.z / apart;
    CheckAtMost(
      "distance from the next sheet", std::abs(sheet - std::round(sheet)), 1e-6, "floats");
    ++lights[static_cast<size_t>(std::lround(sheet))];
  }
  Check("a light on each sheet", lights == std::vector<int>(count, 1));
}

// Surfaces without receivers in front of them are no senders.
VTK_INDIRECT_TEST(ClustersLeaveOutTheOutside)
{
  // A floor of two sides, and a wall over its middle.
  std::vector<Clusters::Sender> senders;
  AddSquare(senders, 20, 1, 0.0, 1.0, glm::vec3(0.5f));
  AddSquare(senders, 20, 1, 0.0, -1.0, glm::vec3(0.5f));
  for (int side = -1; side <= 1; side += 2)
  {
    const size_t first = senders.size();
    AddSquare(senders, 20, 1, 0.5, 1.0, glm::vec3(0.5f));
    for (size_t i = first; i < senders.size(); ++i)
    {
      const glm::vec3 p = senders[i].Position;
      senders[i].Position = { 0.5f, p.y, p.x };
      senders[i].Normal = { static_cast<float>(side), 0.0f, 0.0f };
    }
  }
  std::vector<glm::vec3> places;
  for (const Clusters::Sender& sender : senders)
  {
    places.push_back(sender.Position);
  }
  vtkIndirectSenderTexels::RemoveOutermost(senders, places);
  CheckEqual("all but the floor's underside", static_cast<double>(senders.size()), 1200);
  Check("it is gone",
    std::none_of(senders.begin(), senders.end(),
      [](const Clusters::Sender& sender) { return sender.Normal.z < 0.0f; }));
  // A single box lights nothing.
  senders.resize(400);
  vtkIndirectSenderTexels::RemoveOutermost(
    senders, { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
  CheckEqual("of a floor alone", static_cast<double>(senders.size()), 0);
  // A small thing on a wide floor is farthest along the floor's normal alone.
  senders.clear();
  AddSquare(senders, 20, 1, 0.0, 1.0, glm::vec3(0.5f));
  const size_t floor = senders.size();
  vtkIndirectSenderTexels::RemoveOutermost(
    senders, { { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.5f, 0.5f, 0.01f } });
  CheckEqual("of a floor with a thing on it", static_cast<double>(senders.size()),
    static_cast<double>(floor));
}

// A cluster of bright and dim places would have its place in the bright part alone.
VTK_INDIRECT_TEST(ClustersKeepBrightAndDimApart)
{
  std::vector<Clusters::Sender> senders;
  AddSquare(senders, 80, 1, 0.0, 1.0, glm::vec3(0.8f));
  for (Clusters::Sender& sender : senders)
  {
    sender.Reflected *= sender.Position.x + sender.Position.y < 0.9f ? 1.0f : 0.1f;
  }
  Clusters clusters;
  clusters.SetSenders(senders);
  const std::vector<Clusters::Light> lights =
    clusters.MakeLights({ glm::dvec3(1.0) }, 400, 0.0).Lights;
  double mixed = 0.0;
  for (const Clusters::Light& light : lights)
  {
    const double density = light.DensityArea.x / light.Area;
    mixed += density > 0.09 && density < 0.79 ? light.Area : 0.0;
  }
  // Without radiosity clusters hold places of both sides on 0.079 of the area, with it on 0.016.
  CheckAtMost("area of lights that are bright and dim", mixed, 0.03, "");
}

VTK_INDIRECT_TEST(ClustersStay)
{
  std::vector<Clusters::Sender> senders;
  AddSquare(senders, 40, 2, 0.0, 1.0, glm::vec3(0.5f));
  Clusters clusters;
  clusters.SetSenders(senders);
  const std::vector<Clusters::Light> before =
    clusters.MakeLights({ glm::dvec3(1.0), glm::dvec3(1.0) }, 50, 0.0).Lights;
  const std::vector<Clusters::Light> brighter =
    clusters.MakeLights({ glm::dvec3(1e6), glm::dvec3(1.3e6) }, 50, 0.0).Lights;
  Check("where the sky changes by a part nothing moves", AreAtSamePlaces(before, brighter));
  CheckRelative("but the light", SumLight(brighter).x, 0.5 * 2.3e6, 1e-6, "floats of the senders");
  // The result does not depend on the order.
  const std::vector<Clusters::Light> other =
    clusters.MakeLights({ glm::dvec3(1.0), glm::dvec3(1.0) }, 30, 0.0).Lights;
  const std::vector<Clusters::Light> again =
    clusters.MakeLights({ glm::dvec3(1.0), glm::dvec3(1.0) }, 50, 0.0).Lights;
  Check("nothing depends on what was asked before",
    other.size() == 30 && AreAtSamePlaces(before, again));
}

// Steady lights are those of equal strengths, and other strengths change their light alone.
VTK_INDIRECT_TEST(SteadyLights)
{
  constexpr double error = 1e-3;
  Clusters clusters;
  clusters.SetSenders(MakeFacingSquares());
  vtkIndirectSteadyLights steady;
  steady.Make(clusters, NumberOfMaps, 64, true, Clusters::StandardNearness, 0, 0);
  Clusters other;
  other.SetSenders(MakeFacingSquares());
  const std::vector<glm::dvec3> equal(NumberOfMaps, glm::dvec3(1.0));
  const Clusters::LightTree expected = other.MakeLights(equal, 64, error);
  const std::vector<Clusters::Light> lights = steady.Relight(clusters, equal, error).Lights;
  CheckEqual("as many as of equal strengths", static_cast<double>(lights.size()),
    static_cast<double>(expected.Lights.size()));
  double distances = 0.0;
  double densities = 0.0;
  int divided = 0;
  for (size_t i = 0; i < std::min(lights.size(), expected.Lights.size()); ++i)
  {
    const Clusters::Light& light = expected.Lights[i];
    const glm::dvec3 ratio = lights[i].DensityArea / light.DensityArea - 1.0;
    densities = std::max({ densities, std::abs(ratio.x), std::abs(ratio.y), std::abs(ratio.z) });
    distances = std::max(distances, std::abs(lights[i].ChildDistance - light.ChildDistance));
    divided += light.ChildDistance > 0.0 ? 1 : 0;
  }
  Check("some are divided", divided > 0);
  Check("at the same places", AreAtSamePlaces(lights, expected.Lights));
  CheckAtMost("of the same light", densities, 1e-5, "sums of floats");
  CheckAtMost("divided within the same distances", distances, 1e-5, "sums of floats");

  // Other strengths move nothing, and no light is lost.
  const std::vector<glm::dvec3> strengths = { { 4, 1, 0 }, { 0, 0, 0 }, { 0.5, 0.25, 1 } };
  const Clusters::LightTree& again = steady.Relight(clusters, strengths, error);
  Check("lights stay",
    AreAtSamePlaces(lights, again.Lights) &&
      std::equal(lights.begin(), lights.end(), again.Lights.begin(),
        [](const Clusters::Light& a, const Clusters::Light& b) { return a.Area == b.Area; }));
  const glm::dvec3 sum = SumLight(again.Lights);
  CheckRelative("red light", sum.x, 0.5 * (4.0 + 2.0 * 0.5), 1e-5, "sums of floats");
  CheckRelative("green light", sum.y, 0.25 * (1.0 + 2.0 * 0.25), 1e-5, "sums of floats");
  CheckRelative("blue light", sum.z, 0.3 * 2.0, 1e-5, "sums of floats");
  std::vector<Clusters::Light> leaves;
  for (size_t i = 0; i < again.Branches.size(); ++i)
  {
    if (i % 9 != 0)
    {
      leaves.push_back(again.Branches[i]);
    }
  }
  CheckRelative(
    "of all leaves, which every child has", SumLight(leaves).x, sum.x, 1e-5, "sums of floats");
}

// Two squares of n clusters together: each cluster is s = sqrt(2 / n) wide, and its light has a
// root mean square distance of s / sqrt(6) from the mean. The clusters suffice where this distance
// is 0.3 of about sqrt(2) times the distance of the squares.
VTK_INDIRECT_TEST(ClustersAreNarrowFromNearbySurfaces)
{
  const std::vector<glm::dvec3> equal(NumberOfMaps, glm::dvec3(1.0));
  constexpr double anywhere = 10.0;
  auto count = [&](float distance, int narrow)
  {
    Clusters clusters;
    clusters.SetSenders(MakeFacingSquares(distance));
    return static_cast<double>(
      clusters.MakeLights(equal, 16, 1e-3, anywhere, 16, narrow).Lights.size());
  };
  CheckEqual("squares far from each other", count(0.5f, 1024), 16);
  const double near = count(0.08f, 1024);
  const double expected = 2.0 / (6.0 * 2.0 * std::pow(0.3 * 0.08, 2.0));
  CheckAtMost("squares near each other", near, 2.0 * expected, "the number grows by steps of 1.4");
  CheckAtLeast("squares near each other", near, 0.5 * expected, "the number grows by steps of 1.4");
  CheckEqual("no more than depth maps allow", count(0.08f, 64), 64);
  CheckEqual("a fixed number", count(0.08f, 0), 16);
}
