// SPDX-License-Identifier: BSD-3-Clause
// The debug view of the normals, in world coordinates.
#include "vtkIndirectContractUtilities.h"
#include "vtkIndirectImageUtilities.h"

#include "vtkTesting.h"

int ImageNormal(int argc, char* argv[])
{
  if (!contract::PrepareImageTest())
  {
    return VTK_SKIP_RETURN_CODE;
  }
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(160, 120);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  contract::AddRoom(renderer);
  renderer->GetActiveCamera()->Azimuth(15);
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->SetDebugView("normal");
  renderer->SetPass(pass);
  window->Render();
  return contract::CompareWithBaseline(argc, argv, window);
}
