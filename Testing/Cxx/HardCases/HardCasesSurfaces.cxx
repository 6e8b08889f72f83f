// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of real data sets: coincident, degenerate, without normals or with wrong ones.
#include "vtkIndirectHardCase.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkMath.h"
#include "vtkProperty.h"
#include "vtkRSMReferencePass.h"

#include <algorithm>
#include <cmath>
#include <map>

using namespace vtkIndirectTest;

namespace
{
// Irradiance and direct light with each estimator.
using Results = std::map<std::string, Image>;

Results Render(HardCase& scene)
{
  Results results;
  scene.CheckEstimators(1,
    [&](const EstimatorEntry& estimator)
    {
      for (const char* name : { "irradiance", "direct", "normal" })
      {
        results[std::string(estimator.Name) + ", " + name] = scene.Copy(name);
      }
    });
  return results;
}

void CheckSame(Results& a, Results& b, double tolerance, double share, const std::string& origin)
{
  for (auto& result : a)
  {
    // Its samples are texels around a pixel's own place, which rounding may move to the next texel.
    const bool own = result.first.find("neighborhood") != std::string::npos;
    CheckAtMost(result.first + ": share of pixels that differ",
      GetShareOfDifferent(
        b[result.first], result.second, std::max(tolerance, GetRounding(result.first))),
      own ? 0.01 : share, origin);
  }
}

void AddLight(HardCase& scene)
{
  scene.AddSpot({ 0.613, 0.937, 0.713 }, { 0.357, 0, 0.411 }, 47, 1, { 0.2, 0, 1 });
}

// A tent over the floor: two triangles, with or without given normals.
enum NormalsType
{
  GIVEN,
  NONE,
  REVERSED, // normals against the winding
  FLIPPED   // winding and normals reversed
};
void AddTent(HardCase& scene, NormalsType kind, const glm::dvec3& color, double scale = 1.0)
{
  const std::vector<glm::dvec3> p = { scale * glm::dvec3(0.2, 0.1, 0.2),
    scale * glm::dvec3(0.2, 0.1, 0.7), scale * glm::dvec3(0.45, 0.4, 0.2),
    scale * glm::dvec3(0.45, 0.4, 0.7), scale * glm::dvec3(0.75, 0.15, 0.2),
    scale * glm::dvec3(0.75, 0.15, 0.7) };
  std::vector<glm::dvec3> points;
  std::vector<float> normals;
  std::vector<int> corners;
  for (int side = 0; side < 2; ++side)
  {
    const int i = 2 * side;
    const glm::dvec3 normal = glm::normalize(glm::cross(p[i + 1] - p[i], p[i + 2] - p[i]));
    const double sign = kind == REVERSED || kind == FLIPPED ? -1.0 : 1.0;
    const int order[2][6] = { { 0, 1, 2, 1, 3, 2 }, { 0, 2, 1, 1, 2, 3 } };
    for (int k = 0; k < 6; ++k)
    {
      corners.push_back(static_cast<int>(points.size()));
      points.push_back(p[i + order[kind == FLIPPED ? 1 : 0][k]]);
      for (int c = 0; c < 3 && kind != NONE; ++c)
      {
        normals.push_back(static_cast<float>(sign * normal[c]));
      }
    }
  }
  scene.AddTriangles(points, normals, corners, color);
}
}

VTK_INDIRECT_TEST(CoincidentSurfaces)
{
  HardCase once("a floor");
  once.AddCorner(Albedo);
  AddLight(once);
  Results expected = Render(once);
  {
    HardCase twice("the same floor and walls twice");
    twice.AddCorner(Albedo);
    twice.AddCorner(Albedo);
    AddLight(twice);
    Results results = Render(twice);
    CheckSame(expected, results, 1e-6, 0.0, "the same surface is drawn again");
  }
  {
    HardCase twice("a second floor, 1e-7 above the first");
    twice.AddCorner(Albedo);
    twice.AddQuad({ 0, 1e-7, 0 }, { 0, 1e-7, 1 }, { 1, 1e-7, 0 }, Albedo);
    AddLight(twice);
    Results results = Render(twice);
    CheckSame(expected, results, 1e-4, 1e-3, "positions move by 1e-7");
  }
  {
    // Degenerate triangles: a line, a point, and a line within a face of the corner.
    HardCase more("triangles without area");
    more.AddCorner(Albedo);
    const std::vector<glm::dvec3> points = { { 0.2, 0.3, 0.2 }, { 0.7, 0.3, 0.2 },
      { 0.4, 0.3, 0.2 }, { 0.1, 0, 0.1 }, { 0.9, 0, 0.9 } };
    std::vector<float> normals;
    for (size_t i = 0; i < points.size(); ++i)
    {
      normals.insert(normals.end(), { 0, 1, 0 });
    }
    more.AddTriangles(points, normals, { 0, 1, 2, 0, 0, 0, 3, 4, 4, 1, 0, 1 }, Albedo);
    AddLight(more);
    Results results = Render(more);
    CheckSame(expected, results, 1e-6, 0.0, "they cover no pixel");
  }
}

VTK_INDIRECT_TEST(BadNormals)
{
  // A square whose four corners have the normals (0, 0, 0), NaN, much too long, and right.
  const std::vector<glm::dvec3> points = { { 0.2, 0.3, 0.2 }, { 0.2, 0.3, 0.6 }, { 0.6, 0.3, 0.2 },
    { 0.6, 0.3, 0.6 } };
  const struct
  {
    const char* Name;
    std::vector<float> Normal;
  } kinds[] = { { "normals of zero", { 0, 0, 0 } },
    { "normals that are no numbers", { 0, NAN, 0 } }, { "infinite normals", { 0, INFINITY, 0 } },
    { "normals of length 1e20", { 0, 1e20f, 0 } },
    { "normals of length 1e-20", { 0, 1e-20f, 0 } } };
  for (const auto& kind : kinds)
  {
    for (bool all : { true, false })
    {
      HardCase scene(std::string(all ? "only " : "one of the ") + kind.Name);
      scene.NormalsAreDefined = kind.Normal[1] > 1.0f && kind.Normal[1] < 1e30f;
      scene.AddCorner(Albedo);
      std::vector<float> normals;
      for (int i = 0; i < 4; ++i)
      {
        const std::vector<float> good = { 0, 1, 0 };
        const std::vector<float>& normal = all || i == 1 ? kind.Normal : good;
        normals.insert(normals.end(), normal.begin(), normal.end());
      }
      scene.AddTriangles(points, normals, { 0, 1, 2, 1, 3, 2 }, Albedo);
      AddLight(scene);
      const Image truth = scene.CheckEstimators(1);
      CheckAtLeast("mean irradiance", truth.Mean(), 1e-3, "the rest of the scene is lit");
    }
  }
}

VTK_INDIRECT_TEST(MissingNormals)
{
  HardCase with("a tent with normals");
  with.AddCorner(Albedo);
  AddTent(with, GIVEN, Albedo);
  AddLight(with);
  Results expected = Render(with);
  HardCase without("a tent without normals");
  without.AddCorner(Albedo);
  AddTent(without, NONE, Albedo);
  AddLight(without);
  Results results = Render(without);
  CheckSame(expected, results, 1e-3, 2e-3, "normals from derivatives, wrong in pixels on an edge");
  HardCase flipped("a tent turned inside out");
  flipped.AddCorner(Albedo);
  AddTent(flipped, FLIPPED, Albedo);
  AddLight(flipped);
  results = Render(flipped);
  CheckSame(expected, results, 1e-5, 0.0, "sheets have two sides");

  // VTK 9.1 itself takes such derivatives for zero.
  HardCase tiny("a tent without normals, 1e-9 in size");
  tiny.NormalsAreDefined = false;
  AddTent(tiny, NONE, Albedo, 1e-9);
  tiny.AddSpot(1e-9 * glm::dvec3(0.613, 0.937, 0.713), 1e-9 * glm::dvec3(0.357, 0, 0.411), 47, 1,
    { 0.2, 0, 1e18 });
  tiny.SetEye(1e-9 * glm::dvec3(2.2, 1.6, 2.3), 1e-9 * glm::dvec3(0.4, 0.3, 0.4), { 0, 1, 0 }, 32,
    0.5e-9, 6e-9);
  tiny.CheckEstimators(1);
}

// Normals against the winding: VTK turns them away from the eye, and from the light whose map is
// drawn, so such surfaces neither show light nor send it.
VTK_INDIRECT_TEST(ReversedNormals)
{
  HardCase scene("a tent with normals against the winding");
  AddTent(scene, REVERSED, Albedo);
  // Above the tent, so that it faces the light and the eye sees the same sides.
  scene.AddSpot({ 0.45, 1.6, 0.45 }, { 0.45, 0, 0.45 }, 40, 1, { 1, 0, 0 });
  scene.SetEye({ 0.45, 3.5, 0.45 }, { 0.45, 0, 0.45 }, { 0, 0, -1 }, 15, 0.5, 6);
  scene.CheckEstimators(1,
    [&](const EstimatorEntry&)
    {
      CheckEqual("brightest direct light", GetLargest(scene.Copy("direct")), 0.0);
      CheckEqual("largest density", GetLargest(scene.Copy("rsm0.density")), 0.0);
      CheckEqual("largest irradiance", GetLargest(scene.Copy("irradiance")), 0.0);
      CheckAtLeast("surface in view", GetLargest(scene.Copy("depth")), 1.0, "the test's own power");
    });
}

// A sheet sends light from its lit side, and receives light on its visible side.
VTK_INDIRECT_TEST(Sheet)
{
  for (bool front : { true, false })
  {
    HardCase scene(front ? "a sheet, seen from its lit side" : "a sheet, seen from its dark side");
    scene.AddQuad({ -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }, Albedo);
    // A small plate on the eye's side faces the sheet and away from the eye's light.
    const double side = front ? 1.0 : -1.0;
    scene.AddQuad(
      { -0.2, -0.2, 0.5 * side }, { 0.2, -0.2, 0.5 * side }, { -0.2, 0.2, 0.5 * side }, Albedo);
    scene.Radiance = Albedo.x;
    // The light passes beside the plate.
    scene.AddSpot({ 0.9, 0, 1.5 }, { 0.6, 0, 0 }, 12, 1, { 1, 0, 0 });
    scene.SetEye({ 0.3, 1.7, 0.22 * side }, { 0.1, 0, 0.25 * side }, { 0, 0, side }, 40, 0.3, 4);
    scene.CheckEstimators(1,
      [&](const EstimatorEntry& estimator)
      {
        const Image irradiance = scene.Copy("irradiance");
        const Image normal = scene.Copy("normal");
        double onPlate = 0.0;
        double onSheet = 0.0;
        for (size_t i = 0; i < irradiance.Values.size(); i += 3)
        {
          const bool plate = normal.Values[i + 2] * side < -0.5;
          (plate ? onPlate : onSheet) =
            std::max(plate ? onPlate : onSheet, double(irradiance.Values[i]));
        }
        if (front && estimator.Name != std::string("gather, neighborhood"))
        {
          CheckAtLeast("largest irradiance of the plate", onPlate, 1e-3, "it faces the lit side");
        }
        if (!front)
        {
          CheckEqual("largest irradiance of the plate", onPlate, 0.0);
        }
        CheckAtMost("largest irradiance of the sheet", onSheet, std::max(1e-7, estimator.Blur),
          "nothing else is lit: rounding of positions to 1e-7, 1e-3 apart");
      });
  }
}

VTK_INDIRECT_TEST(Albedos)
{
  const auto irradiance = [](HardCase& scene) { return GetLargest(scene.Copy("irradiance")); };
  {
    HardCase scene("black surfaces");
    scene.AddCorner(glm::dvec3(0.0));
    AddLight(scene);
    scene.CheckEstimators(
      1, [&](const EstimatorEntry&) { CheckEqual("largest irradiance", irradiance(scene), 0.0); });
  }
  HardCase white("white surfaces");
  white.AddCorner(glm::dvec3(1.0));
  AddLight(white);
  Results expected = Render(white);
  vtkNew<vtkRSMReferencePass> reference;
  white.Pass->SetEstimator(reference);
  white.Render();
  // att d^2 <= 1 in the spot's cone: the reflected flux is at most its solid angle.
  CheckAtMost("reflected flux", white.GetReflectedFlux().x,
    2.0 * vtkMath::Pi() * (1.0 - std::cos(vtkMath::RadiansFromDegrees(47.0))), "albedo 1");
  {
    HardCase scene("a black ball among white surfaces");
    scene.AddCorner(glm::dvec3(1.0));
    scene.AddSphere({ 0.5, 0.2, 0.5 }, 0.1, 32, glm::dvec3(0.0));
    AddLight(scene);
    scene.CheckEstimators(1,
      [&](const EstimatorEntry&)
      {
        const Image light = scene.Copy("indirect");
        const Image albedo = scene.Copy("albedo");
        const Image received = scene.Copy("irradiance");
        double sent = 0.0;
        double largest = 0.0;
        for (size_t i = 0; i < light.Values.size(); ++i)
        {
          if (albedo.Values[i] == 0.0f)
          {
            sent = std::max(sent, double(light.Values[i]));
            largest = std::max(largest, double(received.Values[i]));
          }
        }
        CheckEqual("indirect light from black", sent, 0.0);
        CheckAtLeast("irradiance of black", largest, 1e-3, "it does not depend on the albedo");
      });
  }
  {
    // VTK's ambient coefficient does not count as reflectance.
    HardCase scene("white surfaces that also glow");
    scene.AddCorner(glm::dvec3(1.0));
    vtkActorCollection* actors = scene.Renderer->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
    {
      actor->GetProperty()->SetAmbient(0.3);
    }
    AddLight(scene);
    Results results = Render(scene);
    for (auto& result : expected)
    {
      if (result.first.find("irradiance") != std::string::npos)
      {
        CheckAtMost(result.first + ": share of pixels that differ",
          GetShareOfDifferent(results[result.first], result.second, 1e-6), 0.0,
          "it does not change what is sent");
      }
    }
  }
  {
    // VTK adds its specular term to diffuse reflection, without reducing that.
    HardCase scene("white surfaces that also shine");
    scene.AddCorner(glm::dvec3(1.0));
    vtkActorCollection* actors = scene.Renderer->GetActors();
    actors->InitTraversal();
    while (vtkActor* actor = actors->GetNextActor())
    {
      actor->GetProperty()->SetSpecular(0.7);
    }
    AddLight(scene);
    Results results = Render(scene);
    for (auto& result : expected)
    {
      if (result.first.find("irradiance") != std::string::npos)
      {
        const Image& shining = results[result.first];
        double least = 0.0;
        for (size_t i = 0; i < shining.Values.size(); ++i)
        {
          least = std::min(least, static_cast<double>(shining.Values[i]) - result.second.Values[i]);
        }
        CheckAtLeast(result.first + ": what specular senders add, least", least,
          -4e-3 * result.second.Mean(), "half floats");
      }
    }
  }
}
