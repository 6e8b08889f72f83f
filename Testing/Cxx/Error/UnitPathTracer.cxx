// SPDX-License-Identifier: BSD-3-Clause
// Path tracing on the processor, against closed forms: an open and a half hidden sky, rectangles by
// their form factors, and closed rooms, whose surfaces absorb what a light sends.
#include "Error/vtkIndirectPathTracer.h"
#include "Senders/vtkIndirectSamplePattern.h"
#include "vtkIndirectSurfaceFrame.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkAreaLight.h"
#include "vtkEnvironmentLight.h"

#include <cmath>
#include <string>
#include <vector>

using namespace vtkIndirectTest;

namespace
{
using Place = vtkIndirectPathTracer::Place;
using Lights = std::vector<vtkSmartPointer<vtkAreaLight>>;
constexpr double Pi = 3.14159265358979323846;

std::vector<SurfaceFrame::Corners> MakeQuad(
  const glm::dvec3& origin, const glm::dvec3& edge1, const glm::dvec3& edge2)
{
  return { { origin, origin + edge1, origin + edge1 + edge2 },
    { origin, origin + edge1 + edge2, origin + edge2 } };
}

// The six walls of the unit cube.
std::vector<SurfaceFrame::Corners> MakeRoom()
{
  std::vector<SurfaceFrame::Corners> walls;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { 0.0, 1.0 })
    {
      glm::dvec3 origin(0.0);
      glm::dvec3 edges[2] = { glm::dvec3(0.0), glm::dvec3(0.0) };
      origin[axis] = side;
      edges[0][(axis + 1) % 3] = 1.0;
      edges[1][(axis + 2) % 3] = 1.0;
      const auto wall = MakeQuad(origin, edges[0], edges[1]);
      walls.insert(walls.end(), wall.begin(), wall.end());
    }
  }
  return walls;
}

Place MakePlace(const glm::dvec3& position, const glm::dvec3& normal)
{
  Place place;
  place.Position = position;
  place.Normal = place.FacetNormal = normal;
  return place;
}

// Mean over all walls of the unit cube.
double FindMeanInRoom(const vtkIndirectPathTracer& tracer)
{
  constexpr std::uint32_t places = 1536;
  double sum = 0.0;
  for (std::uint32_t i = 0; i < places; ++i)
  {
    const int axis = static_cast<int>(i % 3);
    const glm::dvec2 at = vtkIndirectSamplePattern::ScrambledPoint(i / 6, i % 6);
    glm::dvec3 position(0.0);
    glm::dvec3 normal(0.0);
    position[axis] = i % 6 < 3 ? 0.0 : 1.0;
    normal[axis] = i % 6 < 3 ? 1.0 : -1.0;
    position[(axis + 1) % 3] = at.x;
    position[(axis + 2) % 3] = at.y;
    sum += tracer.FindIrradiance(MakePlace(position, normal), 977u * i, 16).x;
  }
  return sum / places;
}

vtkIndirectLight MakeLamp()
{
  vtkIndirectLight lamp;
  lamp.Positional = true;
  lamp.PositionWC = { 0.4, 0.5, 0.6 };
  lamp.Color = glm::dvec3(1.0);
  lamp.Attenuation = { 0.0, 0.0, 1.0 };
  return lamp;
}
}

VTK_INDIRECT_TEST(PathTracerSky)
{
  vtkNew<vtkEnvironmentLight> sky;
  sky->SetRadiance(1.0, 0.5, 0.25);
  SurfaceFrame scene;
  scene.Add(MakeQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }), 0.5);
  vtkIndirectSurfaces surfaces;
  surfaces.Update(scene.Frame);
  const Place place = MakePlace({ 0.5, 0.5, 0.0 }, { 0, 0, 1 });
  const glm::dvec3 open =
    vtkIndirectPathTracer(scene.Frame, surfaces, sky, {}).FindIrradiance(place, 1u, 4096);
  CheckRelative("open, red", open.x, 1.0, 0.005, "4096 paths; cells of 1.4 degrees");
  CheckRelative("open, green", open.y, 0.5, 0.005, "4096 paths");
  CheckRelative("open, blue", open.z, 0.25, 0.005, "4096 paths");

  // A black square above hides its form factor of the sky.
  const std::vector<glm::dvec3> square = { { 0.1, 0.2, 0.3 }, { 0.9, 0.2, 0.3 }, { 0.9, 0.8, 0.3 },
    { 0.1, 0.8, 0.3 } };
  scene.Add(MakeQuad(square[0], square[1] - square[0], square[3] - square[0]), 0.0);
  surfaces.Update(scene.Frame);
  const double hidden =
    vtkIndirectPathTracer(scene.Frame, surfaces, sky, {}).FindIrradiance(place, 1u, 4096).x;
  const double share = PolygonFormFactor(place.Position, place.Normal, square);
  CheckAtLeast("the square hides some", share, 0.5, "the test's own power");
  CheckRelative("below a square", hidden, 1.0 - share, 0.02, "4096 paths of a third of the sky");
}

VTK_INDIRECT_TEST(PathTracerRectangles)
{
  SurfaceFrame scene;
  scene.Add(MakeQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }), 0.0);
  vtkIndirectSurfaces surfaces;
  surfaces.Update(scene.Frame);
  for (const bool skewed : { false, true })
  {
    const glm::dvec3 origin(0.3, 0.3, 0.2);
    const glm::dvec3 edge1(0.0, 0.4, 0.0);
    const glm::dvec3 edge2(0.5, skewed ? 0.2 : 0.0, 0.0);
    vtkNew<vtkAreaLight> light; // faces down
    light->SetOrigin(&origin[0]);
    light->SetPoint1(&(origin + edge1)[0]);
    light->SetPoint2(&(origin + edge2)[0]);
    light->SetRadiance(2.0, 1.0, 0.5);
    const vtkIndirectPathTracer tracer(scene.Frame, surfaces, nullptr, Lights{ light.Get() });
    for (const double depth : { 0.0, 0.15, 0.199 })
    {
      const Place place = MakePlace({ 0.45, 0.5, depth }, { 0, 0, 1 });
      const double expected = 2.0 *
        PolygonFormFactor(place.Position, place.Normal,
          { origin, origin + edge1, origin + edge1 + edge2, origin + edge2 });
      const double found = tracer.FindIrradiance(place, 3u, 1024).x;
      // By the area the variance grows with the inverse distance squared.
      const double tolerance = !skewed ? 0.005 : depth > 0.19 ? 1.0 : 0.05;
      CheckRelative(std::string(skewed ? "parallelogram" : "rectangle") + " at distance " +
          std::to_string(0.2 - depth),
        found, expected, tolerance, "1024 paths");
    }
    CheckEqual("behind it",
      tracer.FindIrradiance(MakePlace({ 0.45, 0.5, 0.3 }, { 0, 0, -1 }), 3u, 64).x, 0.0);
  }
}

// The walls of a closed room absorb what the lamp sends, so that they receive 1 / (1 - albedo) of
// it, a share of the albedo by bounces.
VTK_INDIRECT_TEST(PathTracerRooms)
{
  const double sent = 4.0 * Pi / 6.0; // over the walls' area
  for (const double albedo : { 0.5, 0.9 })
  {
    SurfaceFrame scene;
    vtkActor* const room = scene.Add(MakeRoom(), albedo);
    scene.Frame.Lights.push_back(MakeLamp());
    vtkIndirectSurfaces surfaces;
    surfaces.Update(scene.Frame);
    const std::string of = " of albedo " + std::to_string(albedo);
    CheckRelative("all bounces" + of,
      FindMeanInRoom(vtkIndirectPathTracer(scene.Frame, surfaces, nullptr, {})),
      sent * albedo / (1.0 - albedo), 0.03, "1536 places of 16 paths");
    CheckRelative("two bounces" + of,
      FindMeanInRoom(vtkIndirectPathTracer(scene.Frame, surfaces, nullptr, {}, 2)),
      sent * albedo * (1.0 + albedo), 0.03, "1536 places of 16 paths");
    // VTK's PBR divides light of a lamp by pi, and no other light.
    room->GetProperty()->SetInterpolationToPBR();
    scene.Frame.Casters.front().Revision += 100;
    surfaces.Update(scene.Frame);
    CheckRelative("all bounces, physically based," + of,
      FindMeanInRoom(vtkIndirectPathTracer(scene.Frame, surfaces, nullptr, {})),
      sent / Pi * albedo / (1.0 - albedo), 0.03, "1536 places of 16 paths");
  }
}

// Light without shadows is not reflected, and two estimates of other seeds are independent.
VTK_INDIRECT_TEST(PathTracerFillAndSeeds)
{
  SurfaceFrame scene;
  scene.Add(MakeRoom(), 0.5);
  scene.Frame.Lights.push_back(MakeLamp());
  vtkIndirectSurfaces surfaces;
  surfaces.Update(scene.Frame);
  const vtkIndirectPathTracer tracer(scene.Frame, surfaces, nullptr, {});
  const Place place = MakePlace({ 0.5, 0.5, 0.0 }, { 0, 0, 1 });
  const double first = tracer.FindIrradiance(place, 1u, 16).x;
  CheckEqual("the same seed", tracer.FindIrradiance(place, 1u, 16).x, first);
  Check("another seed", tracer.FindIrradiance(place, 2u, 16).x != first);
  scene.Frame.Lights.front().Fill = true;
  CheckEqual("a light without shadows",
    vtkIndirectPathTracer(scene.Frame, surfaces, nullptr, {}).FindIrradiance(place, 1u, 16).x, 0.0);
}
