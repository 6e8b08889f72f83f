// SPDX-License-Identifier: BSD-3-Clause
// A room lit by one spot: shadows, and colour that bleeds from the walls.
#include "vtkIndirectContractUtilities.h"
#include "vtkIndirectImageUtilities.h"

#include "vtkRSMGatherPass.h"
#include "vtkTesting.h"
#include "vtkUniformLightSampler.h"

int ImageRoom(int argc, char* argv[])
{
  if (!contract::PrepareImageTest())
  {
    return VTK_SKIP_RETURN_CODE;
  }
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(200, 200);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  contract::AddRoom(renderer);
  renderer->GetActiveCamera()->SetViewAngle(26);
  // Not the automatic choice, which may change.
  vtkNew<vtkIndirectIlluminationPass> pass;
  vtkNew<vtkRSMGatherPass> gather;
  vtkNew<vtkUniformLightSampler> sampler;
  pass->SetEstimator(gather);
  pass->SetSampler(sampler);
  renderer->SetPass(pass);
  window->Render();
  return contract::CompareWithBaseline(argc, argv, window);
}
