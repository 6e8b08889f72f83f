// SPDX-License-Identifier: BSD-3-Clause
// Scenes of any size and at any place: measures scale with the scene, and its light stays.
#include "vtkIndirectHardCase.h"

#include "vtkActor.h"

#include <algorithm>
#include <cstdio>
#include <map>

using namespace vtkIndirectTest;

namespace
{
enum LightKind
{
  SPOT,
  POINT,
  DIRECTIONAL
};
const char* const LightNames[] = { "spot", "point", "directional" };

enum Placing
{
  POINTS, // coordinates of the points
  MATRIX  // points about the origin, and a matrix for each actor
};

using Buffers = std::map<std::string, Image>; // by estimator and buffer

// A corner and a ball in it, by `scale` and `place`, with normals. No number here is round: edges
// through the centre of a pixel or texel would be decided by rounding.
Buffers RenderAt(LightKind kind, double scale, const glm::dvec3& place, Placing placing)
{
  HardCase scene(LightNames[kind], 48, 36);
  const glm::dvec3 offset = placing == POINTS ? place : glm::dvec3(0.0);
  auto here = [&](double x, double y, double z) { return offset + scale * glm::dvec3(x, y, z); };
  auto at = [&](double x, double y, double z) { return place + scale * glm::dvec3(x, y, z); };
  const glm::dvec3 albedo(0.75, 0.5, 0.25);
  vtkActor* const actors[] = {
    scene.AddQuad(here(0, 0, 0), here(0, 0, 1.013), here(1.037, 0, 0), albedo),
    scene.AddQuad(here(0, 0, 0), here(0, 0.981, 0), here(0, 0, 1.013), albedo),
    scene.AddQuad(here(0, 0, 0), here(1.037, 0, 0), here(0, 0.981, 0), albedo),
    scene.AddSphere(here(0.6123, 0.2571, 0.5317), 0.2013 * scale, 48, albedo),
  };
  for (vtkActor* actor : actors)
  {
    const glm::dvec3 moved = placing == MATRIX ? place : glm::dvec3(0.0);
    actor->SetPosition(moved.x, moved.y, moved.z);
  }
  const glm::dvec3 attenuation(0.5, 0.3 / scale, 0.7 / (scale * scale));
  if (kind == POINT)
  {
    scene.AddPoint(at(0.7171, 0.8317, 0.8071), attenuation);
  }
  else if (kind == SPOT)
  {
    scene.AddSpot(at(0.7171, 0.9317, 0.8071), at(0.31, 0.117, 0.2311), 43.7, 1, attenuation);
  }
  else
  {
    scene.AddDirectional({ -0.4173, -0.7331, -0.5719 });
  }
  scene.SetEye(at(2.213, 1.617, 2.331), at(0.417, 0.313, 0.433), { 0, 1, 0 }, 32, scale, 6 * scale);
  Buffers buffers;
  for (const EstimatorEntry& estimator : GetEstimators())
  {
    estimator.Install(scene.Pass, 64);
    scene.Render();
    scene.CheckBuffers(1);
    for (const char* name : { "final", "direct", "irradiance" })
    {
      buffers[std::string(estimator.Name) + ": " + name] = scene.Copy(name);
    }
    if (estimator.Sum == EstimatorEntry::LIGHTS)
    {
      buffers[std::string(estimator.Name) + ": lights"] = scene.Copy("lights");
    }
  }
  for (const char* name :
    { "albedo", "normal", "depth", "rsm0.depth", "rsm0.normal", "rsm0.density" })
  {
    buffers[name] = scene.Copy(name);
  }
  return buffers;
}

void Compare(const std::string& what, LightKind kind, Buffers& buffers, Buffers& unscaled,
  double scale, const glm::dvec3& place)
{
  for (auto& buffer : buffers)
  {
    const std::string& name = buffer.first;
    const Image& expected = unscaled[name];
    const std::string text = what + ", " + name + ": share off by more than 1e-3 or storage rounds";
    const double tolerance = std::max(1e-3, GetRounding(name));
    Comparison how;
    if (name.find("lights") == std::string::npos)
    {
      if (name.find("depth") != std::string::npos)
      {
        how.Factor = scale;
      }
      else if (name.find("density") != std::string::npos && kind != DIRECTIONAL)
      {
        how.Factor = scale * scale; // albedo times falloff times squared distance
      }
      CheckAtMost(text, GetShareOfDifferent(buffer.second, expected, tolerance, how),
        GetRounding(name) > 0.0 ? 5e-3 : 4e-3,
        "a silhouette may fall to the other side of a pixel or texel, a subsplat of four pixels be "
        "split or not, a facet be told from its normal or not (2.9e-3)");
      continue;
    }
    // One row each of positions with areas, of normals, of B A.
    Image rows[3];
    Image expectedRows[3];
    for (int k = 0; k < 3; ++k)
    {
      for (int i = 0; i < expected.Height; ++i)
      {
        const float* values = buffer.second.At(k, i);
        const float* wanted = expected.At(k, i);
        rows[k].Values.insert(rows[k].Values.end(), values, values + 4);
        expectedRows[k].Values.insert(expectedRows[k].Values.end(), wanted, wanted + 4);
        for (int c = 0; c < 3 && k == 0; ++c)
        {
          rows[0].Values[4 * i + c] -= static_cast<float>(place[c]);
        }
      }
      rows[k].Components = expectedRows[k].Components = 4;
    }
    const double most = 1.0 / expected.Height;
    const char* const origin = "one light may fall to the other side of an edge";
    how.Factor = scale;
    // The buffer holds floats in world coordinates: rounding of the position itself.
    how.Least = 1e3 * 1.2e-7 * glm::length(place);
    CheckAtMost(
      text + " (places)", GetShareOfDifferent(rows[0], expectedRows[0], 1e-3, how), most, origin);
    how.Least = 0.0;
    how.Factor = 1.0;
    CheckAtMost(
      text + " (normals)", GetShareOfDifferent(rows[1], expectedRows[1], 1e-3, how), most, origin);
    how.Factor = scale * scale;
    CheckAtMost(
      text + " (B A)", GetShareOfDifferent(rows[2], expectedRows[2], 1e-3, how), most, origin);
    how.FirstComponent = how.LastComponent = 3;
    CheckAtMost(
      text + " (areas)", GetShareOfDifferent(rows[0], expectedRows[0], 1e-3, how), most, origin);
  }
}
}

VTK_INDIRECT_TEST(Scale)
{
  for (LightKind kind : { SPOT, POINT, DIRECTIONAL })
  {
    Buffers unscaled = RenderAt(kind, 1.0, glm::dvec3(0.0), POINTS);
    CheckAtLeast(std::string(LightNames[kind]) + ": mean irradiance",
      unscaled["gather, all texels: irradiance"].Mean(), 1e-3, "the test's own power");
    for (double scale : { 1e-9, 1e-3, 1e3, 1e9 })
    {
      char what[64];
      std::snprintf(what, sizeof(what), "%s, %g times the size", LightNames[kind], scale);
      Buffers buffers = RenderAt(kind, scale, glm::dvec3(0.0), POINTS);
      Compare(what, kind, buffers, unscaled, scale, glm::dvec3(0.0));
    }
  }
}

VTK_INDIRECT_TEST(Place)
{
  const glm::dvec3 place(1e6, -0.6e6, 0.3e6);
  for (LightKind kind : { SPOT, POINT, DIRECTIONAL })
  {
    Buffers unmoved = RenderAt(kind, 1.0, glm::dvec3(0.0), POINTS);
    for (Placing placing : { POINTS, MATRIX })
    {
      const std::string what = std::string(LightNames[kind]) + ", a million sizes away by " +
        (placing == MATRIX ? "matrix" : "points");
      Buffers buffers = RenderAt(kind, 1.0, place, placing);
      Compare(what, kind, buffers, unmoved, 1.0, place);
    }
  }
}
