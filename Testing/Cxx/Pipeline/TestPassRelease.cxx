// SPDX-License-Identifier: BSD-3-Clause
// Resources are released to a window, and only then.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"
#include "vtkIndirectDetails.h"
#include "vtkIndirectGLNames.h"

#include "vtkIndirectSplattingPass.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRSMReferencePass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkUniformLightSampler.h"

#include <array>

using namespace contract;

//------------------------------------------------------------------------------
// Releasing resources without a window loses nothing, before a frame and after it.
VTK_INDIRECT_TEST(ReleaseWithoutWindow)
{
  vtkNew<vtkRSMGatherPass> gather;
  vtkNew<vtkRSMReferencePass> reference;
  vtkNew<vtkRadianceHintsPass> hints;
  hints->SetGridResolution(6, 5, 6);
  vtkNew<vtkMultiresolutionSplattingPass> multiresolution;
  vtkNew<vtkIndirectSplattingPass> splatting;
  for (vtkIndirectEstimatorPass* estimator : std::initializer_list<vtkIndirectEstimatorPass*>{
         gather, reference, hints, multiresolution, splatting })
  {
    View view(80, 60);
    AddRoom(view.Renderer);
    vtkNew<vtkIndirectIlluminationPass> pass;
    pass->SetReflectiveShadowMapResolution(32);
    pass->SetEstimator(estimator);
    vtkNew<vtkUniformLightSampler> sampler;
    pass->SetSampler(sampler);
    auto releaseAll = [&]
    {
      for (vtkRenderPass* stage :
        std::initializer_list<vtkRenderPass*>{ estimator, pass->GetReflectiveShadowMaps(), pass })
      {
        stage->ReleaseGraphicsResources(nullptr);
      }
      sampler->ReleaseGraphicsResources(nullptr);
    };
    releaseAll();
    view.Renderer->SetPass(pass);
    const Pixels picture = view.Grab();
    const Floats irradiance = Read(pass, "irradiance");
    const vtkIdType faces = CountOf(pass, "faces_drawn");
    const vtkIdType estimates = CountOf(pass, "estimates");
    releaseAll();
    const char* name = estimator->GetClassName();
    CONTRACT_CHECK(Compare(irradiance, Read(pass, "irradiance")).Max == 0.0, name);
    CONTRACT_CHECK(Compare(picture, view.Grab()).Max == 0.0, name);
    CONTRACT_CHECK(CountOf(pass, "faces_drawn") == faces, name << ": the maps were drawn again");
    CONTRACT_CHECK(CountOf(pass, "estimates") == estimates, name << ": estimated again");
  }
  // Single stages, which leave the renderer's lights to VTK.
  vtkNew<vtkReflectiveShadowMapPass> maps;
  View view(80, 60);
  AddRoom(view.Renderer);
  view.Window->Render();
  for (vtkRenderPass* stage : std::initializer_list<vtkRenderPass*>{ maps })
  {
    stage->ReleaseGraphicsResources(nullptr);
    view.Renderer->SetPass(stage);
    const Pixels before = view.Grab();
    stage->ReleaseGraphicsResources(nullptr);
    CONTRACT_CHECK(Compare(before, view.Grab()).Max == 0.0, stage->GetClassName());
  }
}

//------------------------------------------------------------------------------
// Multiresolution splatting releases its pyramids, buffers and programs under all settings, and
// draws the same afterwards, after a resize, and in a second window.
VTK_INDIRECT_TEST(ReleaseMultiresolution)
{
  View view(160, 120);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  pass->SetEstimator(splatting);
  view.Renderer->UseFXAAOn(); // VTK's own quad: it keeps the buffer of its first one
  view.Window->Render();
  const Names before = CountNames(view.Window);
  Pixels first;
  for (int turn = 0; turn < 3; ++turn)
  {
    view.Renderer->SetPass(pass);
    SET_DETAIL(splatting, HalfFloats, false);
    const double lighting = DetailsOf(splatting).LightingThreshold;
    SET_DETAIL(splatting, LightingThreshold, 0.0);
    splatting->SetFinestLevelToHalfResolution();
    view.Window->Render();
    SET_DETAIL(splatting, HalfFloats, true);
    SET_DETAIL(splatting, LightingThreshold, lighting);
    splatting->SetFinestLevelToFullResolution();
    // Fewer levels, then more.
    for (const auto& size : { std::array<int, 2>{ 41, 1 }, { 321, 203 }, { 160, 120 } })
    {
      view.Window->SetSize(size[0], size[1]);
      view.Window->Render();
    }
    const Pixels picture = Grab(view.Window, false);
    first = turn == 0 ? picture : first;
    CONTRACT_CHECK(Compare(picture, first).Max == 0.0, "picture of turn " << turn);
    const Names during = CountNames(view.Window);
    pass->ReleaseGraphicsResources(view.Window);
    view.Renderer->SetPass(nullptr);
    view.Window->Render();
    const Names after = CountNames(view.Window);
    std::cout << "before: " << before << "\nduring: " << during << "\nafter: " << after << "\n";
    CONTRACT_CHECK(during.Textures > before.Textures + 16, "nothing was allocated");
    CONTRACT_CHECK(during.Buffers > before.Buffers + 1, "no lights, no lists");
    CheckGivenBack(before, after);
  }
  View other(160, 120);
  AddRoom(other.Renderer);
  vtkNew<vtkIndirectIlluminationPass> fresh;
  vtkNew<vtkMultiresolutionSplattingPass> freshSplatting;
  fresh->SetEstimator(freshSplatting);
  view.Renderer->SetPass(pass);
  other.Renderer->SetPass(fresh);
  other.Renderer->UseFXAAOn();
  for (int i = 0; i < 2; ++i)
  {
    CONTRACT_CHECK(Compare(first, other.Grab()).Max == 0.0, "other window, turn " << i);
    CONTRACT_CHECK(Compare(first, view.Grab()).Max == 0.0, "this window, turn " << i);
  }
}

//------------------------------------------------------------------------------
// ReleaseGraphicsResources releases all textures, framebuffers and buffers; programs belong to the
// window's cache.
VTK_INDIRECT_TEST(Release)
{
  View view(160, 120);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  // Uses everything that allocates.
  vtkNew<vtkRSMGatherPass> gather;
  vtkNew<vtkUniformLightSampler> sampler;
  pass->SetEstimator(gather);
  pass->SetSampler(sampler);
  view.Renderer->UseFXAAOn();
  view.Window->Render();
  const Names before = CountNames(view.Window);
  for (int turn = 0; turn < 3; ++turn)
  {
    view.Renderer->SetPass(pass);
    for (int mode : { vtkRSMGatherPass::VIRTUAL_LIGHTS, vtkRSMGatherPass::NEIGHBORHOOD })
    {
      gather->SetMode(mode);
      gather->SetNumberOfSamples(16);
      view.Window->Render();
      for (const char* name : { "final", "rsm0.density", "depth" })
      {
        Read(pass, name);
      }
    }
    pass->SetDebugView("normal");
    view.Window->Render();
    pass->SetDebugView("");
    const Names during = CountNames(view.Window);
    pass->ReleaseGraphicsResources(view.Window);
    // VTK's own rendering uses some names.
    view.Renderer->SetPass(nullptr);
    view.Window->Render();
    const Names after = CountNames(view.Window);
    std::cout << "before: " << before << "\nduring: " << during << "\nafter: " << after << "\n";
    CONTRACT_CHECK(during.Textures > before.Textures + 8, "nothing was allocated");
    CheckGivenBack(before, after);
  }
  view.Renderer->SetPass(pass);

  // The pass works again.
  view.Renderer->UseFXAAOff();
  const Pixels again = view.Grab();
  View other(160, 120);
  AddRoom(other.Renderer);
  vtkNew<vtkIndirectIlluminationPass> fresh;
  vtkNew<vtkRSMGatherPass> freshGather;
  freshGather->SetModeToNeighborhood();
  freshGather->SetNumberOfSamples(16);
  fresh->SetEstimator(freshGather);
  other.Renderer->SetPass(fresh);
  const Difference difference = Compare(again, other.Grab());
  CONTRACT_CHECK(difference.Max == 0.0, "after release: " << difference);
}
