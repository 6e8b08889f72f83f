// SPDX-License-Identifier: BSD-3-Clause
// Depth maps that arrive over several frames: with MapsFirst light is summed once, after all maps,
// and the picture equals the final one without it.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkEnvironmentLight.h"
#include "vtkRSMGatherPass.h"
#include "vtkUniformLightSampler.h"

using namespace contract;

namespace
{
// A light and a sky over a ball of so many triangles that a frame has time for the least number of
// depth maps, 64 (vtkIndirectPlan::FindTilesPerFrame).
struct MapsView : View
{
  vtkNew<vtkIndirectIlluminationPass> Pass;
  vtkNew<vtkRSMGatherPass> Gather;
  vtkNew<vtkUniformLightSampler> Sampler;
  vtkNew<vtkEnvironmentLight> Sky;
  int Frames = 0;

  explicit MapsView(bool first)
    : View(48, 40)
  {
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->AddActor(MakeQuad({ -2, 0, 2 }, { 2, 0, 2 }, { -2, 0, -2 }));
    this->Renderer->AddActor(MakeSphere({ 0.0, 0.6, 0.0 }, 0.5, { 0.8, 0.5, 0.3 }, 320));
    this->Renderer->AddLight(MakeLight(LightKind::Spot, { 1.0, 2.5, 1.5 }, { 0.0, 0.3, 0.0 }));
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 2.0, 4.5);
    camera->SetFocalPoint(0.0, 0.4, 0.0);
    this->Renderer->ResetCameraClippingRange(-2.5, 2.5, -0.5, 2.0, -2.5, 2.5);
    this->Sampler->SetNumberOfLights(100);
    this->Pass->SetEstimator(this->Gather);
    this->Pass->SetSampler(this->Sampler);
    this->Pass->SetVisibilityToMaps();
    this->Pass->SetNumberOfBounces(1);
    this->Pass->SetErrorTolerance(1.0); // 16 directions of the sky
    this->Pass->SetEnvironment(this->Sky);
    this->Pass->SetMapsFirst(first);
    this->Renderer->SetPass(this->Pass);
    this->Window->SetDesiredUpdateRate(0.9); // still, with little time
  }
  ~MapsView()
  {
    this->Pass->SetEnvironment(nullptr);
    this->Pass->SetEstimator(nullptr);
    this->Pass->SetSampler(nullptr);
  }
  long long Left() { return CountOf(this->Pass, "tiles_left"); }
  void Complete()
  {
    do
    {
      this->Window->Render();
      ++this->Frames;
    } while (this->Left() > 0 && this->Frames < 20);
  }
  std::string WhyLeftOut(const std::string& what)
  {
    return Report(this->Pass).FindReason("left_out", what);
  }
};
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(MapsFirst)
{
  MapsView waits(true);
  waits.Window->Render();
  CONTRACT_CHECK(waits.Left() > 0, "all maps are there after one frame, nothing can wait");
  CONTRACT_CHECK(CountOf(waits.Pass, "estimates") == 0, "light is summed with maps missing");
  CONTRACT_CHECK(waits.WhyLeftOut("indirect light").find("MapsFirst") != std::string::npos,
    waits.WhyLeftOut("indirect light"));
  waits.Complete();
  std::cout << waits.Frames + 1 << " frames\n";
  CONTRACT_CHECK(waits.Left() == 0, waits.Left() << " maps are missing");
  CONTRACT_CHECK(CountOf(waits.Pass, "estimates") == 1, CountOf(waits.Pass, "estimates"));
  CONTRACT_CHECK(waits.WhyLeftOut("indirect light").empty(), waits.WhyLeftOut("indirect light"));
  CONTRACT_CHECK(
    waits.WhyLeftOut("light from the sky").empty(), waits.WhyLeftOut("light from the sky"));

  MapsView goesOn(false);
  goesOn.Complete();
  CONTRACT_CHECK(CountOf(goesOn.Pass, "estimates") > 1, "there was nothing to wait for");
  for (const char* name : { "irradiance", "sky" })
  {
    const Floats expected = Read(goesOn.Pass, name);
    CONTRACT_CHECK(Mean(expected, 1) > 0.0, name << " is dark");
    // The same maps and the same sums, in another order of frames.
    const Difference difference = Compare(Read(waits.Pass, name), expected);
    CONTRACT_CHECK(difference.Max == 0.0, name << ": " << difference);
  }
}

//------------------------------------------------------------------------------
// Every frame of a moving camera has its light, and so has every frame without caching.
VTK_INDIRECT_TEST(MapsFirstNeverWaits)
{
  MapsView view(true);
  view.Window->SetDesiredUpdateRate(15.0);
  view.Window->Render();
  CONTRACT_CHECK(view.Left() > 0, "all maps are there after one frame");
  CONTRACT_CHECK(CountOf(view.Pass, "estimates") == 1, CountOf(view.Pass, "estimates"));
  view.Window->SetDesiredUpdateRate(0.9);
  view.Pass->CachingOff();
  view.Window->Render();
  CONTRACT_CHECK(view.Left() > 0, "all maps are there after one frame");
  CONTRACT_CHECK(CountOf(view.Pass, "estimates") == 2, CountOf(view.Pass, "estimates"));
}
