// SPDX-License-Identifier: BSD-3-Clause
// Radiance hints on a ball far above the floor that lights it, drawn by each of VTK's ways to draw
// one, against the ball of plain polygons; and hints beside a wall of glyphs.
#include "vtkIndirectDetails.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLODProp3D.h"
#include "vtkLight.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRadianceHintsPass.h"
#include "vtkSphereSource.h"

#if __has_include("vtkOpenGLMoleculeMapper.h")
#define HAS_MOLECULES 1
#include "vtkMolecule.h"
#include "vtkOpenGLMoleculeMapper.h"
#else
#define HAS_MOLECULES 0
#endif

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace vtkIndirectTest;

namespace
{
constexpr double Radius = 0.3;
const double Center[3] = { 0.0, 0.0, 3.0 };
constexpr int Resolution = 96;

enum Kind
{
  Polygons,
  Glyphs,
  SphereImpostors,
  Atoms,
  LevelsOfDetail,
  Points,
  NumberOfKinds
};
const char* const Names[NumberOfKinds] = { "polygons", "glyphs", "sphere impostors", "atoms",
  "levels of detail", "points" };

vtkSmartPointer<vtkSphereSource> MakeBall(const double center[3])
{
  auto source = vtkSmartPointer<vtkSphereSource>::New();
  source->SetCenter(center[0], center[1], center[2]);
  source->SetRadius(Radius);
  source->SetThetaResolution(Resolution);
  source->SetPhiResolution(Resolution);
  return source;
}

// One point with a vertex, at the ball's centre.
vtkSmartPointer<vtkPolyData> MakePoint()
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(Center);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  data->SetPoints(points);
  data->SetVerts(vertices);
  return data;
}

vtkSmartPointer<vtkMapper> MakeMapper(Kind kind)
{
  const double origin[3] = { 0.0, 0.0, 0.0 };
  if (kind == Glyphs)
  {
    auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
    mapper->SetInputData(MakePoint());
    mapper->SetSourceConnection(MakeBall(origin)->GetOutputPort());
    mapper->ScalingOff();
    mapper->OrientOff();
    return mapper;
  }
  if (kind == SphereImpostors)
  {
    auto mapper = vtkSmartPointer<vtkOpenGLSphereMapper>::New();
    mapper->SetRadius(static_cast<float>(Radius));
    mapper->SetInputData(MakePoint());
    return mapper;
  }
#if HAS_MOLECULES
  if (kind == Atoms)
  {
    vtkNew<vtkMolecule> molecule;
    molecule->AppendAtom(6, Center[0], Center[1], Center[2]);
    auto mapper = vtkSmartPointer<vtkOpenGLMoleculeMapper>::New();
    mapper->SetInputData(molecule);
    mapper->SetAtomicRadiusTypeToUnitRadius();
    mapper->SetAtomicRadiusScaleFactor(static_cast<float>(Radius));
    mapper->RenderBondsOff();
    return mapper;
  }
#endif
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputConnection(MakeBall(Center)->GetOutputPort());
  return mapper;
}

// A lit floor and the ball, seen from the side and from below.
struct BallScene : Scene
{
  vtkNew<vtkRadianceHintsPass> Hints;

  BallScene(Kind kind, bool voxels)
    : Scene(64, 64)
  {
    this->Pass->SetEstimator(this->Hints);
    this->Pass->SetVisibility(
      voxels ? vtkIndirectIlluminationPass::AUTO : vtkIndirectIlluminationPass::NONE);
    this->Pass->SetReflectiveShadowMapResolution(128);
    this->AddQuad({ -2, -2, 0 }, { 2, -2, 0 }, { -2, 2, 0 }, glm::dvec3(0.8));
    // Makes bounds and grid equal for each kind: mappers report different bounds for a ball.
    this->AddQuad({ 1.9, 1.9, 4 }, { 2, 1.9, 4 }, { 1.9, 2, 4 }, glm::dvec3(0.8));
    // The ball is outside of the light's cone: only the floor sends light.
    this->AddSpot({ 0.7, 0.2, 2.0 }, { 0.2, 0.0, 0.0 }, 40.0, 0.0, { 1.0, 0.0, 0.0 });
    this->SetEye(
      { 0.0, -2.5, 1.5 }, { Center[0], Center[1], Center[2] }, { 0, 0, 1 }, 16.0, 0.5, 10.0);
    vtkNew<vtkProperty> property;
    property->SetColor(0.7, 0.7, 0.7);
    property->SetSpecular(0.0);
    const vtkSmartPointer<vtkMapper> mapper = MakeMapper(kind);
    if (kind == LevelsOfDetail)
    {
      vtkNew<vtkLODProp3D> prop;
      prop->AddLOD(mapper, property, 0.0);
      this->Renderer->AddViewProp(prop);
      return;
    }
    if (kind == Points)
    {
      property->SetRepresentationToPoints();
      property->SetPointSize(3.0);
    }
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->SetProperty(property);
    this->Renderer->AddActor(actor);
  }
  ~BallScene() { this->Pass->SetEstimator(nullptr); }
};
}

VTK_INDIRECT_TEST(HintsReceivers)
{
  for (const bool voxels : { false, true })
  {
    const std::string how = voxels ? ", with voxels" : "";
    BallScene polygons(Polygons, voxels);
    polygons.Render();
    const Image expected = polygons.Copy("irradiance");
    const std::vector<Scene::Receiver> places = polygons.GetReceivers();
    const int skipped =
      polygons.Hints->GetNumberOfHints() - polygons.Hints->GetNumberOfActiveHints();
    CheckAtLeast("hints that polygons alone leave out" + how, skipped,
      0.3 * polygons.Hints->GetNumberOfHints(), "most of the space is far from all surfaces");
    for (int kind = Glyphs; kind < NumberOfKinds; ++kind)
    {
      if (kind == Atoms && !HAS_MOLECULES)
      {
        std::cout << "  no atoms: this VTK has no VTK::DomainsChemistryOpenGL2\n";
        continue;
      }
      const std::string what = Names[kind] + how;
      BallScene scene(static_cast<Kind>(kind), voxels);
      scene.Render();
      const Image found = scene.Copy("irradiance");
      const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
      double sum = 0.0;
      double reference = 0.0;
      std::vector<double> errors;
      int dark = 0;
      for (size_t i = 0; i < receivers.size(); ++i)
      {
        // The lower half: for all of it the floor is below the horizon.
        if (receivers[i].Lit && places[i].Lit &&
          std::max(receivers[i].Normal.z, places[i].Normal.z) < -0.2)
        {
          const double e = found.Values[found.Components * i];
          const double r = expected.Values[expected.Components * i];
          sum += e;
          reference += r;
          errors.push_back(std::abs(e / r - 1.0));
          dark += !(e > 0.0);
        }
      }
      const bool same = kind == Glyphs || kind == LevelsOfDetail;
      CheckAtLeast(
        what + ": pixels", static_cast<double>(errors.size()), 200, "the test's own power");
      CheckEqual(what + ": pixels without light", dark, 0);
      CheckRelative(what + ": light over that on polygons", sum, reference, same ? 1e-3 : 0.02,
        same ? "the same triangles; with voxels theirs hide a little from hints"
             : "other pixels at the silhouette; sprites are flat");
      CheckAtMost(what + ": 90th percentile of a pixel's difference", Percentile(errors, 0.9),
        kind == Points    ? 0.25
          : kind == Atoms ? 0.1
                          : 0.01,
        kind == Points    ? "sprites of 3 pixels on a ball of 47 are flat over 7 degrees and more"
          : kind == Atoms ? "a coarser grid of other hints"
                          : "a ball of 96 facets; as above");
    }
  }
}

// A wall of a glyph hides light and reflects it, of all bounces, as the same wall of a mesh does.
VTK_INDIRECT_TEST(HintsGlyphsBesideMeshes)
{
  enum Wall
  {
    NONE,
    MESH,
    GLYPH
  };
  const auto measure = [](Wall wall)
  {
    Scene scene(64, 48);
    vtkNew<vtkRadianceHintsPass> hints;
    scene.Pass->SetEstimator(hints);
    scene.Pass->SetVisibilityToAuto();
    scene.Pass->SetNumberOfBounces(3);
    scene.Pass->SetReflectiveShadowMapResolution(128);
    scene.AddQuad({ -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }, glm::dvec3(0.8));
    scene.AddQuad({ -1, 1, 0 }, { 1, 1, 0 }, { -1, 1, 1.5 }, glm::dvec3(0.8, 0.4, 0.4));
    scene.AddSpot({ 0.7, -0.2, 1.3 }, { 0.6, 0.6, 0.0 }, 30.0, 0.0, { 1.0, 0.0, 0.0 });
    scene.SetEye({ 0.0, -3.0, 1.5 }, { 0, 0, 0.3 }, { 0, 0, 1 }, 40.0, 0.5, 10.0);
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(0.1);
    cube->SetYLength(1.5);
    cube->SetZLength(1.0);
    vtkNew<vtkPolyData> place;
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.0, 0.2, 0.5);
    place->SetPoints(points);
    vtkNew<vtkGlyph3DMapper> glyph;
    glyph->SetInputData(place);
    glyph->SetSourceConnection(cube->GetOutputPort());
    glyph->ScalingOff();
    vtkNew<vtkPolyDataMapper> mesh;
    mesh->SetInputConnection(cube->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->GetProperty()->SetColor(0.2, 0.8, 0.4);
    if (wall == GLYPH)
    {
      actor->SetMapper(glyph);
    }
    else
    {
      actor->SetMapper(mesh);
      actor->SetPosition(0.0, 0.2, 0.5);
    }
    actor->SetVisibility(wall != NONE);
    scene.Renderer->AddActor(actor);
    scene.Render();
    const Image found = scene.Copy("irradiance");
    scene.Pass->SetEstimator(nullptr);
    return found;
  };
  const auto compare = [](const Image& a, const Image& b)
  {
    double sum = 0.0;
    for (size_t i = 0; i < a.Values.size(); ++i)
    {
      sum += std::pow(double(a.Values[i]) - b.Values[i], 2.0);
    }
    return std::sqrt(sum / static_cast<double>(a.Values.size())) / b.Mean();
  };
  const Image mesh = measure(MESH);
  CheckAtLeast("light that a wall changes, RMS over the mean", compare(measure(NONE), mesh), 0.1,
    "the test's own power");
  CheckAtMost("a glyph's over a mesh's, RMS over the mean", compare(measure(GLYPH), mesh), 0.01,
    "the same triangles; glyphs' colours are bytes");
}

// A table of rays that is too long for a texture with the usual rows: 262144 hints of 400 rays make
// 25600 rows of 1024 texels, those of 256 rays 16384. A sheet before a wall hides as much of the
// lit floor by the one as by the other, for hints at the far end of the table.
VTK_INDIRECT_TEST(HintsManyRays)
{
  double hidden[2];
  double open = 0.0;
  for (const bool blocked : { false, true })
  {
    Scene scene(48, 48);
    vtkNew<vtkRadianceHintsPass> hints;
    scene.Pass->SetEstimator(hints);
    scene.Pass->SetVisibilityToAuto();
    hints->SetGridResolution(64, 64, 64);
    scene.Pass->SetReflectiveShadowMapResolution(128);
    // At large values of the last axis; the rest of the space is empty.
    const double z = 7.2;
    scene.AddQuad({ 0, 0, 0 }, { 0.01, 0, 0 }, { 0, 0.01, 0 }, glm::dvec3(0.8));
    scene.AddQuad({ 6, 6.5, z }, { 7, 6.5, z }, { 6, 7.5, z }, glm::dvec3(0.8));
    scene.AddQuad({ 7.7, 6.8, z }, { 7.7, 7.2, z }, { 7.7, 6.8, z + 0.3 }, glm::dvec3(0.8));
    scene.AddQuad({ 7.9, 7.9, 8 }, { 8, 7.9, 8 }, { 7.9, 8, 8 }, glm::dvec3(0.8));
    if (blocked)
    {
      scene.AddQuad({ 7.1, 6.3, z - 0.2 }, { 7.1, 7.7, z - 0.2 }, { 7.1, 6.3, 8 }, glm::dvec3(0.0));
    }
    scene.AddSpot({ 6.4, 7, z + 0.6 }, { 6.4, 7, z }, 25.0, 0.0, { 1.0, 0.0, 0.0 });
    scene.SetEye({ 7.2, 7, z + 0.15 }, { 7.7, 7, z + 0.15 }, { 0, 0, 1 }, 30.0, 0.05, 3.0);
    for (const int rays : { 256, 400 })
    {
      SET_DETAIL(hints, NumberOfRays, rays);
      scene.Render();
      (blocked ? hidden[rays == 400] : open) = scene.Copy("irradiance").Mean();
    }
    scene.Pass->SetEstimator(nullptr);
  }
  CheckAtLeast("light that nothing hides", open, 1e-3, "the wall sees the lit floor");
  CheckAtMost("share of it behind a wall, 256 rays", hidden[0] / open, 0.02, "the requirement");
  CheckAtMost("share of it behind a wall, 400 rays", hidden[1] / open, 0.02, "the requirement");
}
