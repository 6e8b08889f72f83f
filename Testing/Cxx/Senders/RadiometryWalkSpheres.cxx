// SPDX-License-Identifier: BSD-3-Clause
// Impostors and glyphs in a random walk: they occlude and send as the same shapes do as meshes.
#include "vtkIndirectWalkScene.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMath.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <cmath>
#include <vector>

using namespace vtkIndirectTest;

namespace
{
vtkSmartPointer<vtkPolyData> MakePoints(const std::vector<glm::dvec3>& places)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const glm::dvec3& place : places)
  {
    const vtkIdType id = points->InsertNextPoint(place.x, place.y, place.z);
    cells->InsertNextCell(1, &id);
  }
  data->SetPoints(points);
  data->SetVerts(cells);
  return data;
}

vtkSmartPointer<vtkActor> MakeBalls(
  const std::vector<glm::dvec3>& places, double radius, const glm::dvec3& color)
{
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(MakePoints(places));
  mapper->SetRadius(static_cast<float>(radius));
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.x, color.y, color.z);
  return actor;
}

const std::vector<glm::dvec3> Places = { { 0.3, 0.15, 0.3 }, { 0.5, 0.5, 0.2 }, { 0.7, 0.2, 0.6 },
  { 0.2, 0.4, 0.7 } };

// A corner of walls with an object under a light; its flux for a number of bounces.
struct WalkCorner : WalkScene
{
  WalkCorner()
  {
    this->AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0.8, 0.8, 0.8 });
    this->AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.3, 0.6, 0.9 });
    this->AddPoint({ 0.8, 0.9, 0.8 }, { 0, 0, 1 });
    this->SetEye({ 2.2, 1.6, 2.3 }, { 0.4, 0.3, 0.4 }, { 0, 1, 0 }, 36, 0.5, 6);
    this->Gather->SpecularTransportOff();
  }
  glm::dvec3 FindFlux(int bounces)
  {
    this->UseWalk(16384, bounces);
    return this->GetReflectedFlux();
  }
};

void Compare(const std::string& what, WalkCorner& scene, WalkCorner& meshes, double tolerance,
  const std::string& source)
{
  for (const int bounces : { 1, 4 })
  {
    const glm::dvec3 flux = scene.FindFlux(bounces);
    const glm::dvec3 expected = meshes.FindFlux(bounces);
    for (int c = 0; c < 3; ++c)
    {
      CheckRelative(what + ", " + std::to_string(bounces) + " bounces", flux[c], expected[c],
        tolerance, source);
    }
  }
  CheckRelative(what + ": irradiance", scene.Copy("bounce").Mean(), meshes.Copy("bounce").Mean(),
    3.0 * tolerance, "the same, and kernels of other lights");
}
}

// Overlapping balls enclose a light without a gap: all their light falls on them again, so that
// bounce n has rho^n of the light's flux.
VTK_INDIRECT_TEST(WalkFurnaceOfSpheres)
{
  constexpr int count = 300;
  std::vector<glm::dvec3> places;
  for (int i = 0; i < count; ++i)
  {
    // Evenly on a sphere, along a spiral.
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double angle = i * vtkMath::Pi() * (3.0 - std::sqrt(5.0));
    const double r = std::sqrt(1.0 - z * z);
    places.push_back(glm::dvec3(r * std::cos(angle), r * std::sin(angle), z));
  }
  const glm::dvec3 albedo = glm::dvec3(191, 128, 64) / 255.0; // VTK truncates colours to bytes
  WalkScene scene;
  // The nearest balls are 0.2 apart, and gaps between three of them 0.12 wide.
  scene.Renderer->AddActor(MakeBalls(places, 0.2, albedo + 1e-4));
  scene.AddPoint(glm::dvec3(0.0), { 0, 0, 1 });
  scene.SetEye({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 90, 0.1, 10);
  for (const int bounces : { 1, 2, 8 })
  {
    glm::dvec3 sum(0.0);
    glm::dvec3 term(1.0);
    for (int i = 0; i < bounces; ++i)
    {
      term *= albedo;
      sum += term;
    }
    scene.UseWalk(8192, bounces);
    const glm::dvec3 flux = scene.GetReflectedFlux();
    for (int c = 0; c < 3; ++c)
    {
      CheckRelative(std::to_string(bounces) + " bounces", flux[c], 4.0 * vtkMath::Pi() * sum[c],
        0.01, "whether a path goes on is chance for all but its brightest colour");
    }
  }
}

VTK_INDIRECT_TEST(WalkSpheresBesideMeshes)
{
  for (const bool physical : { false, true })
  {
    WalkCorner scene;
    WalkCorner meshes;
    vtkSmartPointer<vtkActor> balls = MakeBalls(Places, 0.15, { 0.8, 0.6, 0.2 });
    const auto look = [physical](vtkProperty* property)
    {
      property->SetDiffuse(0.7);
      if (physical)
      {
        property->SetInterpolationToPBR();
        property->SetMetallic(0.25);
      }
    };
    look(balls->GetProperty());
    scene.Renderer->AddActor(balls);
    for (const glm::dvec3& place : Places)
    {
      look(meshes.AddSphere(place, 0.15, 64, { 0.8, 0.6, 0.2 })->GetProperty());
    }
    Compare(physical ? "physically based" : "Phong", scene, meshes, 0.01,
      "colours are bytes, facets of spheres 0.2 %, paths that differ");
  }
}

// Rotated and scaled glyphs, each of one of two shapes.
VTK_INDIRECT_TEST(WalkGlyphsBesideMeshes)
{
  WalkCorner scene;
  WalkCorner meshes;
  vtkSmartPointer<vtkPolyData> points = MakePoints(Places);
  vtkNew<vtkFloatArray> sizes;
  sizes->SetName("size");
  vtkNew<vtkFloatArray> ways;
  ways->SetName("way");
  ways->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> kinds;
  kinds->SetName("kind");
  for (int i = 0; i < 4; ++i)
  {
    sizes->InsertNextValue(0.2f + 0.05f * static_cast<float>(i));
    ways->InsertNextTuple3(0, i % 2 ? 1 : 0, i % 2 ? 0 : 1);
    kinds->InsertNextValue(static_cast<float>(i / 2));
  }
  points->GetPointData()->AddArray(sizes);
  points->GetPointData()->AddArray(ways);
  points->GetPointData()->AddArray(kinds);
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(1.0);
  cube->SetYLength(0.4);
  cube->SetZLength(0.6);
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.2, 0.0, 0.0);
  ball->SetThetaResolution(12);
  ball->SetPhiResolution(12);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(points);
  mapper->SetSourceConnection(0, cube->GetOutputPort());
  mapper->SetSourceConnection(1, ball->GetOutputPort());
  mapper->SetSourceIndexing(true);
  mapper->SetSourceIndexArray("kind");
  mapper->SetRange(0.0, 10.0); // unused here
  mapper->SetScaleArray("size");
  mapper->SetScaleModeToScaleByMagnitude();
  mapper->SetOrientationArray("way");
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.8, 0.6, 0.2);
  scene.Renderer->AddActor(actor);
  for (int i = 0; i < 4; ++i)
  {
    // Maps the x axis to y or to z, by half a turn about the middle between them.
    const double size = 0.2 + 0.05 * i;
    const glm::dvec3 half =
      0.5 * size * (i % 2 ? glm::dvec3(0.4, 1.0, 0.6) : glm::dvec3(0.6, 0.4, 1.0));
    if (i < 2)
    {
      meshes.AddBox(Places[i] - half, Places[i] + half, { 0.8, 0.6, 0.2 });
      continue;
    }
    const glm::dvec3 off = 0.2 * size * (i % 2 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1));
    meshes.AddSphere(Places[i] + off, 0.5 * size, 12, { 0.8, 0.6, 0.2 });
  }
  scene.CompareWithMaps("glyphs as VTK draws them", 1);
  Compare("glyphs", scene, meshes, 0.01, "colours are bytes; a ball's poles lie otherwise");
}
