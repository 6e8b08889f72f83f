// SPDX-License-Identifier: BSD-3-Clause
// The switches of a renderer that are reported to have no effect, and how often.
#include "vtkIndirectTestUtilities.h"

#include "Scene/vtkIndirectSwitches.h"
#include "vtkNew.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

using namespace vtkIndirectTest;

VTK_INDIRECT_TEST(SwitchesLeftOut)
{
  vtkNew<vtkRenderer> renderer;
  const vtkRenderState state(renderer);
  vtkIndirectSwitches switches;
  auto count = [&]
  {
    switches.Update(&state, false);
    int fresh = 0;
    for (const auto& entry : switches.GetLeftOut())
    {
      fresh += switches.IsNew(entry.first) ? 1 : 0;
    }
    return fresh;
  };
  CheckEqual("a renderer as it is made", count(), 0);
  renderer->UseSSAOOn();
  CheckEqual("UseSSAO, the first time", count(), 1);
  CheckEqual("then no more", count(), 0);
  renderer->UseShadowsOn();
  CheckEqual("UseShadows beside it", count(), 1);
  vtkNew<vtkTexture> cube;
  cube->CubeMapOn();
  renderer->UseImageBasedLightingOn();
  renderer->SetEnvironmentTexture(cube);
  CheckEqual("a cube map", count(), 1);
  CheckEqual("all are left out", static_cast<int>(switches.GetLeftOut().size()), 3);
  vtkNew<vtkTexture> image;
  renderer->SetEnvironmentTexture(image);
  CheckEqual("an image of latitudes and longitudes", count(), 0);
  CheckEqual("is not", static_cast<int>(switches.GetLeftOut().size()), 2);
  renderer->SetEnvironmentTexture(cube);
  CheckEqual("a cube map again", count(), 1);
}
