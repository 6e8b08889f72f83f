// SPDX-License-Identifier: BSD-3-Clause
// Durations decide no picture: a busy machine draws the same as an idle one.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkAreaLight.h"
#include "vtkEnvironmentLight.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkRadianceHintsPass.h"
#include "vtkSphereSource.h"
#include "vtkUniformLightSampler.h"

#include <chrono>
#include <functional>
#include <thread>
#include <vector>

using namespace contract;

namespace
{
// A mapper that delays each drawing, also into depth maps.
class SlowMapper : public vtkOpenGLPolyDataMapper
{
public:
  static SlowMapper* New() { VTK_STANDARD_NEW_BODY(SlowMapper); }
  vtkTypeMacro(SlowMapper, vtkOpenGLPolyDataMapper);
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override
  {
    std::this_thread::sleep_for(this->Delay);
    this->Superclass::RenderPiece(renderer, actor);
  }
  std::chrono::microseconds Delay{ 0 };
};

struct Shot
{
  Pixels Picture;
  long long Tiles;
  long long SkyTiles;
  long long Estimates;
};

// Pictures of a user's session: drag, release, move an object, wait.
std::vector<Shot> Play(vtkIndirectEstimatorPass* estimator, bool busy)
{
  View view(48, 36);
  AddRoomSurfaces(view.Renderer);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.12);
  vtkNew<SlowMapper> mapper;
  mapper->Delay = std::chrono::microseconds(busy ? 500 : 0);
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(0.7, 0.2, 0.6);
  view.Renderer->AddActor(actor);
  view.Renderer->AddLight(MakeLight(LightKind::Spot, { 0.5, 0.95, 0.5 }, { 0.5, 0.0, 0.4 }));
  vtkNew<vtkEnvironmentLight> sky;
  sky->SetRadiance(0.4, 0.5, 0.6);
  vtkNew<vtkAreaLight> lamp;
  lamp->SetOrigin(0.3, 0.97, 0.3);
  lamp->SetPoint1(0.6, 0.97, 0.3);
  lamp->SetPoint2(0.3, 0.97, 0.6);
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->SetReflectiveShadowMapResolution(64);
  vtkNew<vtkUniformLightSampler> sampler;
  sampler->SetNumberOfLights(100);
  pass->SetSampler(sampler);
  pass->SetEstimator(estimator);
  pass->SetEnvironment(sky);
  pass->AddAreaLight(lamp);
  pass->SetNumberOfBounces(2);
  view.Renderer->SetPass(pass);

  std::vector<Shot> shots;
  auto render = [&](bool moving, int frames, const std::function<void()>& step)
  {
    view.Window->SetDesiredUpdateRate(moving ? 15.0 : 1e-4);
    for (int i = 0; i < frames; ++i)
    {
      step();
      Pixels picture = view.Grab();
      shots.push_back({ std::move(picture), CountOf(pass, "tiles_drawn"),
        CountOf(pass, "sky_tiles_drawn"), CountOf(pass, "estimates") });
    }
  };
  auto turn = [&]() { view.Renderer->GetActiveCamera()->Azimuth(2.0); };
  auto move = [&]() { actor->AddPosition(-0.01, 0.0, 0.0); };
  auto wait = []() {};
  render(true, 2, turn);
  render(false, 2, wait);
  render(true, 1, move);
  render(false, 1, wait);
  return shots;
}
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(BusyMachineSame)
{
  vtkNew<vtkRadianceHintsPass> hints;
  hints->SetGridResolution(6, 6, 6);
  vtkNew<vtkMultiresolutionSplattingPass> multiresolution;
  for (vtkIndirectEstimatorPass* estimator :
    std::vector<vtkIndirectEstimatorPass*>{ multiresolution, hints })
  {
    const std::vector<Shot> idle = Play(estimator, false);
    const std::vector<Shot> busy = Play(estimator, true);
    CONTRACT_CHECK(idle.back().Tiles > 0, estimator->GetClassName() << " has drawn no maps");
    for (size_t i = 0; i < idle.size(); ++i)
    {
      const std::string name = estimator->GetClassName() + (", frame " + std::to_string(i));
      CONTRACT_CHECK(idle[i].Tiles == busy[i].Tiles && idle[i].SkyTiles == busy[i].SkyTiles,
        name << ": " << idle[i].Tiles << " and " << idle[i].SkyTiles << " maps, busy "
             << busy[i].Tiles << " and " << busy[i].SkyTiles);
      CONTRACT_CHECK(idle[i].Estimates == busy[i].Estimates,
        name << ": " << idle[i].Estimates << " estimates, busy " << busy[i].Estimates);
      const Difference difference = Compare(idle[i].Picture, busy[i].Picture);
      CONTRACT_CHECK(difference.Max == 0.0, name << ": " << difference);
    }
  }
}
