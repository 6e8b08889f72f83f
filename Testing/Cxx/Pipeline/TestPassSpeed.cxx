// SPDX-License-Identifier: BSD-3-Clause
// Bounds of a frame's work: unchanged things cause no work, numbers cause no new shader, the eye's
// view and each outdated map face are drawn once.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkGlyph3DMapper.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkRenderWindow.h"
#include "vtkSphereSource.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>

using namespace contract;

namespace
{
vtkIdType CountShaderBuilds(vtkIndirectIlluminationPass* pass)
{
  return static_cast<vtkIdType>(Report(pass).GetNumber("counters.shader_builds"));
}

// A mapper that counts its drawings.
class CountingMapper : public vtkOpenGLPolyDataMapper
{
public:
  static CountingMapper* New() { VTK_STANDARD_NEW_BODY(CountingMapper); }
  vtkTypeMacro(CountingMapper, vtkOpenGLPolyDataMapper);
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override
  {
    ++this->Count;
    this->Superclass::RenderPiece(renderer, actor);
  }
  int Count = 0;
};

struct Scene
{
  View Window{ 80, 60 };
  vtkNew<vtkIndirectIlluminationPass> Pass;
  vtkNew<CountingMapper> Mapper;
  vtkNew<vtkSphereSource> Ball;
  vtkSmartPointer<vtkActor> BallActor;

  Scene()
  {
    AddRoomSurfaces(this->Window.Renderer);
    this->Ball->SetCenter(0.75, 0.2, 0.6);
    this->Ball->SetRadius(0.1);
    this->Mapper->SetInputConnection(this->Ball->GetOutputPort());
    this->BallActor = vtkSmartPointer<vtkActor>::New();
    this->BallActor->SetMapper(this->Mapper);
    this->Window.Renderer->AddActor(this->BallActor);
    this->Window.Renderer->SetPass(this->Pass);
    this->Pass->SetReflectiveShadowMapResolution(64);
  }

  vtkSmartPointer<vtkLight> AddLight(LightKind kind, const Vec3& position)
  {
    auto light = MakeLight(kind, position, { 0.5, 0.0, 0.4 });
    this->Window.Renderer->AddLight(light);
    return light;
  }

  vtkIdType GetFaces() { return CountOf(this->Pass, "faces_drawn"); }
  vtkIdType GetBuilds() { return CountShaderBuilds(this->Pass); }

  struct Work
  {
    vtkIdType Faces;
    vtkIdType Estimates;
    vtkIdType Builds;
    int Draws;
  };

  // Counts the work of the next frame.
  Work Frame()
  {
    const vtkIdType faces = this->GetFaces();
    const vtkIdType estimates = CountOf(this->Pass, "estimates");
    const vtkIdType builds = this->GetBuilds();
    this->Mapper->Count = 0;
    this->Window.Window->Render();
    return { this->GetFaces() - faces, CountOf(this->Pass, "estimates") - estimates,
      this->GetBuilds() - builds, this->Mapper->Count };
  }
};

void CheckWork(const Scene::Work& work, vtkIdType faces, vtkIdType estimates, const char* what)
{
  CONTRACT_CHECK(work.Faces == faces,
    what << ": " << work.Faces << " faces were drawn, " << faces << " were out of date");
  CONTRACT_CHECK(work.Estimates == estimates,
    what << ": " << work.Estimates << " estimates, expected " << estimates);
  CONTRACT_CHECK(work.Builds == 0, what << ": " << work.Builds << " shader sources");
}

// Shadow look-ups need other sources: each prop's is rebuilt once, without other work.
void CheckSources(const Scene::Work& work, const char* what)
{
  CONTRACT_CHECK(work.Faces == 0 && work.Estimates == 0,
    what << ": " << work.Faces << " faces, " << work.Estimates << " estimates");
  CONTRACT_CHECK(work.Builds > 0, what << ": no shader source was built");
}
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(WorkNothingChanged)
{
  Scene scene;
  scene.AddLight(LightKind::Spot, { 0.5, 0.95, 0.5 });
  scene.AddLight(LightKind::Directional, { 1.0, 2.0, 3.0 });
  scene.AddLight(LightKind::Point, { 0.5, 0.9, 0.6 });
  const Scene::Work first = scene.Frame();
  CONTRACT_CHECK(first.Faces == 8, "first frame: " << first.Faces << " faces");
  CONTRACT_CHECK(first.Estimates == 1, "first frame: " << first.Estimates);
  for (int i = 0; i < 3; ++i)
  {
    CheckWork(scene.Frame(), 0, 0, "nothing changed");
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(WorkChanges)
{
  Scene scene;
  vtkRenderer* renderer = scene.Window.Renderer;
  vtkCamera* camera = renderer->GetActiveCamera();
  auto spot = scene.AddLight(LightKind::Spot, { 0.5, 0.95, 0.5 });
  spot->SetExponent(3.0);
  auto sun = scene.AddLight(LightKind::Directional, { 1.0, 2.0, 3.0 });
  auto bulb = scene.AddLight(LightKind::Point, { 0.5, 0.9, 0.6 });
  scene.Frame();

  camera->Azimuth(5);
  CheckWork(scene.Frame(), 0, 1, "camera moved");
  camera->Elevation(5);
  camera->Zoom(1.5);
  CheckWork(scene.Frame(), 0, 1, "camera zoomed");
  camera->SetClippingRange(0.5, 9.0);
  CheckWork(scene.Frame(), 0, 1, "clipping range");
  renderer->SetBackground(0.3, 0.1, 0.1);
  CheckWork(scene.Frame(), 0, 0, "background");

  spot->SetPosition(0.4, 0.95, 0.5);
  CheckWork(scene.Frame(), 1, 1, "spot moved");
  sun->SetPosition(1.0, 2.0, 2.0);
  CheckWork(scene.Frame(), 1, 1, "sun moved");
  bulb->SetPosition(0.5, 0.85, 0.6);
  CheckWork(scene.Frame(), 6, 1, "bulb moved");
  // Maps hold reflectance; strength and falloff are multiplied when they are sampled.
  spot->SetExponent(2.0);
  CheckWork(scene.Frame(), 0, 1, "exponent");
  // Exponents of 0 and 1 need no power; with them light code is another source.
  spot->SetExponent(1.0);
  const Scene::Work linear = scene.Frame();
  CONTRACT_CHECK(linear.Faces == 0 && linear.Estimates == 1 && linear.Builds > 0,
    "exponent 1: " << linear.Faces << " faces, " << linear.Estimates << " estimates, "
                   << linear.Builds << " sources");
  bulb->SetAttenuationValues(1, 0, 0.5);
  CheckWork(scene.Frame(), 0, 1, "attenuation");

  sun->SetIntensity(0.3);
  CheckWork(scene.Frame(), 0, 1, "intensity");
  spot->SetDiffuseColor(1.0, 0.5, 0.2);
  CheckWork(scene.Frame(), 0, 1, "colour");

  // Everything in a map's view is drawn into it again.
  scene.BallActor->SetPosition(0.01, 0, 0);
  const Scene::Work moved = scene.Frame();
  std::cout << "actor moved: " << moved.Faces << " faces\n";
  CONTRACT_CHECK(moved.Faces >= 3 && moved.Faces < 8, "actor moved: " << moved.Faces);
  CONTRACT_CHECK(moved.Estimates == 1, "actor moved");
  scene.Ball->SetRadius(0.11);
  const Scene::Work grown = scene.Frame();
  CONTRACT_CHECK(grown.Faces >= 3 && grown.Faces < 8, "actor grown: " << grown.Faces);
  CONTRACT_CHECK(grown.Estimates == 1, "actor grown");
  scene.BallActor->GetProperty()->SetColor(1, 0, 0);
  CONTRACT_CHECK(scene.Frame().Faces >= 3, "actor coloured");
  CheckWork(scene.Frame(), 0, 0, "nothing changed");

  // Estimator and sampler.
  vtkNew<vtkRSMGatherPass> gather;
  vtkNew<vtkUniformLightSampler> sampler;
  scene.Pass->SetEstimator(gather);
  scene.Pass->SetSampler(sampler);
  CheckWork(scene.Frame(), 0, 1, "estimator");
  sampler->SetNumberOfLights(100);
  CheckWork(scene.Frame(), 0, 1, "number of lights");
  sampler->SetPatternToJittered();
  CheckWork(scene.Frame(), 0, 1, "pattern");
  gather->SetInterpolationStep(5);
  CheckWork(scene.Frame(), 0, 1, "interpolation");
  gather->SetInterpolationStep(8);
  CheckWork(scene.Frame(), 0, 1, "step");
  // Only the composite depends on this.
  scene.Pass->SetIndirectScale(0.5);
  CheckWork(scene.Frame(), 0, 0, "indirect scale");
  scene.Pass->SetDebugView("normal");
  CheckWork(scene.Frame(), 0, 0, "debug view");
  scene.Pass->SetDebugView("");
  scene.Pass->ShadowsOff();
  CheckSources(scene.Frame(), "shadows off");
  scene.Pass->ShadowsOn();
  CheckSources(scene.Frame(), "shadows on");

  // Without caching every frame does everything.
  scene.Pass->CachingOff();
  CheckWork(scene.Frame(), 8, 1, "caching off");
  scene.Pass->CachingOn();
  CheckWork(scene.Frame(), 0, 0, "caching on");
}

//------------------------------------------------------------------------------
// A light that moves with the camera is drawn again if the camera moves, others are not.
VTK_INDIRECT_TEST(WorkCameraLight)
{
  Scene scene;
  auto spot = scene.AddLight(LightKind::Spot, { 0.5, 0.95, 0.5 });
  auto flash = scene.AddLight(LightKind::Spot, { 0.1, 0.1, 1.0 });
  flash->SetLightTypeToCameraLight();
  scene.Frame();
  CheckWork(scene.Frame(), 0, 0, "nothing changed");
  scene.Window.Renderer->GetActiveCamera()->Azimuth(3);
  CheckWork(scene.Frame(), 1, 1, "camera moved");
}

//------------------------------------------------------------------------------
// One drawing for the eye, and one for each outdated face that sees the prop.
VTK_INDIRECT_TEST(WorkDraws)
{
  Scene scene;
  scene.Pass->SetVisibilityToNone(); // maps of virtual lights are Radiometry.DepthMapsAreKept's
  auto spot = scene.AddLight(LightKind::Spot, { 0.5, 0.95, 0.5 });
  scene.AddLight(LightKind::Directional, { 1.0, 2.0, 3.0 });
  CONTRACT_CHECK(scene.Frame().Draws == 3, "first frame");
  CONTRACT_CHECK(scene.Frame().Draws == 1, "nothing changed");
  scene.Window.Renderer->GetActiveCamera()->Azimuth(5);
  CONTRACT_CHECK(scene.Frame().Draws == 1, "camera moved");
  spot->SetPosition(0.45, 0.95, 0.5);
  CONTRACT_CHECK(scene.Frame().Draws == 2, "light moved");
  scene.Ball->SetRadius(0.12);
  CONTRACT_CHECK(scene.Frame().Draws == 3, "prop changed");
  // With a headlight the eye's view is also its map.
  scene.Window.Renderer->RemoveAllLights();
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  scene.Window.Renderer->AddLight(head);
  scene.Frame();
  scene.Window.Renderer->GetActiveCamera()->Azimuth(5);
  const Scene::Work work = scene.Frame();
  CONTRACT_CHECK(work.Draws == 1 && work.Faces == 0, "headlight: " << work.Draws);
}

//------------------------------------------------------------------------------
// A thousand actors, a parallel map and a perspective eye: motion compiles nothing.
VTK_INDIRECT_TEST(ShaderBuilds)
{
  View view(120, 100);
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(6);
  source->SetPhiResolution(6);
  source->SetRadius(0.4);
  constexpr int actors = 200;
  for (int i = 0; i < actors; ++i)
  {
    auto actor = MakeActor(source, { 0.3 + 0.7 * (i % 7) / 7.0, 0.6, 0.5 });
    actor->SetPosition(i % 10, (i / 10) % 10, i / 100);
    if (i % 3 == 0)
    {
      actor->GetProperty()->SetInterpolationToPBR();
    }
    view.Renderer->AddActor(actor);
  }
  auto sun = MakeLight(LightKind::Directional, { 3, 5, 9 }, { 0, 0, 0 });
  auto spot = MakeLight(LightKind::Spot, { 5, 15, 5 }, { 5, 5, 5 });
  view.Renderer->AddLight(sun);
  view.Renderer->AddLight(spot);
  view.Renderer->ResetCamera();
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->SetReflectiveShadowMapResolution(64);
  view.Renderer->SetPass(pass);
  vtkCamera* camera = view.Renderer->GetActiveCamera();
  for (bool parallel : { false, true })
  {
    camera->SetParallelProjection(parallel);
    view.Window->Render();
    view.Window->Render();
    const vtkIdType builds = CountShaderBuilds(pass);
    CONTRACT_CHECK(builds >= actors, "every actor is asked for at least once: " << builds);
    double worst = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      camera->Azimuth(3);
      sun->SetPosition(3 + i, 5, 9);
      spot->SetPosition(5 + 0.1 * i, 15, 5);
      spot->SetIntensity(0.5 + 0.1 * i);
      sun->SetDiffuseColor(1.0, 0.9 - 0.1 * i, 0.5);
      pass->SetIndirectScale(1.0 + i);
      const auto start = std::chrono::steady_clock::now();
      view.Window->Render();
      worst = std::max(worst,
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
          .count());
    }
    const vtkIdType after = CountShaderBuilds(pass);
    std::cout << (parallel ? "parallel" : "perspective") << " eye: " << builds << " builds before, "
              << after - builds << " while moving, slowest frame " << worst << " ms\n";
    CONTRACT_CHECK(after == builds, after - builds << " shader sources were built");
  }
}

//------------------------------------------------------------------------------
// OpenGL on the processor gets uniforms as flat varyings if triangles cover enough pixels. Images
// equal those of a GPU's shaders, and small changes of the number of triangles rebuild nothing.
VTK_INDIRECT_TEST(FlatUniforms)
{
  struct Result
  {
    Pixels Image;
    std::vector<vtkIdType> Builds;
  };
  const std::string renderer = []
  {
    View view(8, 8);
    view.Grab();
    return std::string(view.Window->ReportCapabilities());
  }();
  const bool onProcessor = renderer.find("llvmpipe") != std::string::npos;
  auto render = [](bool keep, int estimator)
  {
    keep ? setenv("VTK_INDIRECT_PATHS", "uniforms=plain", 1) : unsetenv("VTK_INDIRECT_PATHS");
    View view(240, 180);
    AddRoomSurfaces(view.Renderer);
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(0.75, 0.2, 0.6);
    ball->SetRadius(0.1);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    view.Renderer->AddActor(actor);
    view.Renderer->AddLight(MakeLight(LightKind::Spot, { 0.5, 0.9, 0.8 }, { 0.5, 0.0, 0.4 }));
    view.Renderer->AddLight(MakeLight(LightKind::Point, { 0.2, 0.8, 0.8 }, { 0.5, 0.0, 0.4 }));
    vtkNew<vtkIndirectIlluminationPass> pass;
    pass->SetReflectiveShadowMapResolution(64);
    if (estimator == 1)
    {
      vtkNew<vtkRadianceHintsPass> hints;
      hints->SetGridResolution(6, 6, 6); // tests the shaders, not the hints
      pass->SetEstimator(hints);
    }
    view.Renderer->SetPass(pass);
    Result result;
    result.Image = view.Grab();
    // 43200 pixels; with the room's, 2000, 3600, 16000 and 30000 triangles: switched on below
    // 10800, off from 21600 on.
    for (int resolution : { 8, 30, 85, 120, 85, 8 })
    {
      ball->SetThetaResolution(resolution);
      ball->SetPhiResolution(resolution);
      view.Grab();
      result.Builds.push_back(CountShaderBuilds(pass));
    }
    return result;
  };
  for (int estimator = 0; estimator < 2; ++estimator)
  {
    const Result kept = render(true, estimator);
    const Result moved = render(false, estimator);
    // Rounding of sums in another order.
    const Difference difference = Compare(kept.Image, moved.Image);
    CONTRACT_CHECK(difference.Max <= 1, "estimator " << estimator << ": " << difference);
    const auto& builds = moved.Builds;
    CONTRACT_CHECK(kept.Builds.front() == kept.Builds.back(), "uniforms rebuilt shaders");
    CONTRACT_CHECK(builds[1] == builds[0] && builds[2] == builds[1] && builds[4] == builds[3],
      "few triangles more or less rebuilt shaders");
    CONTRACT_CHECK((builds[3] > builds[2]) == onProcessor && (builds[5] > builds[4]) == onProcessor,
      "many triangles, then few: " << builds[2] << ", " << builds[3] << ", " << builds[5]
                                   << " builds");
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(GlyphsArriveOverFrames)
{
  // Depth maps of a million triangles take seconds: a frame draws few of them, whether one mesh has
  // the triangles or glyphs of a small one.
  long long drawn[2] = {};
  for (const int count : { 1, 2500 })
  {
    View view(64, 48);
    AddRoomSurfaces(view.Renderer);
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(0.01);
    ball->SetThetaResolution(20);
    ball->SetPhiResolution(12);
    vtkNew<vtkPoints> places;
    for (int i = 0; i < count; ++i)
    {
      places->InsertNextPoint(0.3 + 0.008 * (i % 50), 0.3, 0.3 + 0.008 * (i / 50));
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(places);
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetSourceConnection(ball->GetOutputPort());
    vtkNew<vtkActor> glyphs;
    glyphs->SetMapper(mapper);
    view.Renderer->AddActor(glyphs);
    vtkNew<vtkIndirectIlluminationPass> pass;
    view.Renderer->SetPass(pass);
    view.Window->SetDesiredUpdateRate(0.5); // else a window off screen draws all of them
    view.Window->Render();
    drawn[count > 1] = static_cast<long long>(Report(pass).GetNumber("counters.tiles_drawn"));
    const double left = Report(pass).GetNumber("counters.tiles_left");
    CONTRACT_CHECK((left > 0.0) == (count > 1), count << " glyphs: maps left " << left);
    view.Window->SetDesiredUpdateRate(0.0001);
    view.Window->Render();
    CONTRACT_CHECK(Report(pass).GetNumber("counters.tiles_left") == 0.0,
      "a picture that nobody sees come is not whole");
  }
  CONTRACT_CHECK(drawn[1] > 0 && drawn[1] < drawn[0],
    "maps in the first frame, of one glyph and of 2500: " << drawn[0] << ", " << drawn[1]);
}

//------------------------------------------------------------------------------
// Forty spots have more uniforms than fit into varyings, and their maps have programs of their own,
// built in the first frame: where all spots stand at one place, direct light is that of one spot of
// their sum, and so is indirect light but for the choice of virtual lights.
VTK_INDIRECT_TEST(ManySpots)
{
  std::vector<vtkIdType> counts;
  auto render = [&counts](int spots)
  {
    View view(120, 90);
    AddRoomSurfaces(view.Renderer);
    view.Renderer->AutomaticLightCreationOff();
    for (int i = 0; i < spots; ++i)
    {
      auto spot = MakeLight(LightKind::Spot, { 0.5, 0.9, 0.8 }, { 0.5, 0.0, 0.4 });
      spot->SetIntensity(0.5 / spots);
      view.Renderer->AddLight(spot);
    }
    vtkNew<vtkIndirectIlluminationPass> pass;
    pass->SetReflectiveShadowMapResolution(64);
    pass->SetLightingToScene();
    view.Renderer->SetPass(pass);
    view.Grab();
    const vtkIdType builds = CountShaderBuilds(pass);
    CONTRACT_CHECK(CountOf(pass, "faces_drawn") == spots,
      spots << " spots: " << CountOf(pass, "faces_drawn") << " faces");
    view.Grab();
    CONTRACT_CHECK(CountShaderBuilds(pass) == builds, "the second frame built shaders");
    std::cout << spots << " spots: " << builds << " shader builds\n";
    counts.push_back(builds);
    return std::make_pair(Read(pass, "direct"), Read(pass, "bounce"));
  };
  const auto one = render(1);
  const auto many = render(40);
  render(80);
  // Maps have programs of their own, without the light of all lights at each of their texels.
  CONTRACT_CHECK(counts[1] > counts[0], "40 spots have no programs for maps");
  CONTRACT_CHECK(counts[1] == counts[2], "80 spots build other programs than 40");
  const Difference direct = Compare(one.first, many.first);
  const double bounce = Mean(many.second, 0) / Mean(one.second, 0);
  std::cout << "40 spots as one: direct " << direct << ", bounce " << bounce << "\n";
  // Sums of forty floats, stored as half floats.
  CONTRACT_CHECK(direct.Max < 2e-3, direct);
  CONTRACT_CHECK(std::abs(bounce - 1.0) < 0.05, bounce);
}
