// SPDX-License-Identifier: BSD-3-Clause
// Resources are given back to a window, and only then.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkIndirectSplattingPass.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRSMReferencePass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkUniformLightSampler.h"

using namespace contract;

//------------------------------------------------------------------------------
// To release resources without a window loses nothing, before a frame and after it.
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
  // Stages alone. They leave the renderer's lights to VTK.
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
