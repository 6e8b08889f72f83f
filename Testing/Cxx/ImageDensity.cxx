// SPDX-License-Identifier: BSD-3-Clause
// The debug view of what a light's map holds: the reflected density.
#include "vtkIndirectContractUtilities.h"
#include "vtkIndirectImageUtilities.h"

#include "vtkTesting.h"

int ImageDensity(int argc, char* argv[])
{
  if (!contract::PrepareImageTest())
  {
    return VTK_SKIP_RETURN_CODE;
  }
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(160, 160);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  contract::AddRoom(renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->SetReflectiveShadowMapResolution(160);
  pass->SetDebugView("rsm0.density");
  renderer->SetPass(pass);
  window->Render();
  return contract::CompareWithBaseline(argc, argv, window);
}
