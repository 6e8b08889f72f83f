// SPDX-License-Identifier: BSD-3-Clause
// Depth maps of virtual lights and of directions: what they hide, and when they are drawn again.
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkEnvironmentLight.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRSMReferencePass.h"
#include "vtkUniformLightSampler.h"

#include <cmath>

using namespace vtkIndirectTest;

namespace
{
const glm::dvec3 White(0.8);

// A box that is open towards the eye, with a sheet that keeps light from its right half.
void BuildRooms(Scene& scene)
{
  scene.AddQuad({ 0, 0, 1 }, { 2, 0, 1 }, { 0, 0, 0 }, White);
  scene.AddQuad({ 0, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, White);
  scene.AddQuad({ 0, 0, 1 }, { 0, 0, 0 }, { 0, 1, 1 }, { 0.8, 0.3, 0.2 });
  scene.AddQuad({ 2, 0, 0 }, { 2, 0, 1 }, { 2, 1, 0 }, White);
  scene.AddQuad({ 0, 1, 0 }, { 2, 1, 0 }, { 0, 1, 1 }, White);
  scene.AddQuad({ 1, 0, 0 }, { 1, 0, 0.8 }, { 1, 1, 0 }, White);
  scene.AddSpot({ 0.9, 0.8, 0.9 }, { 0.1, 0.2, 0.2 }, 25.0, 0.0, { 0, 0, 1 });
  scene.Sampler->SetNumberOfLights(256);
  scene.SetEye({ 1, 0.5, 3.5 }, { 1, 0.5, 0 }, { 0, 1, 0 }, 24, 0.1, 10);
}
}

VTK_INDIRECT_TEST(DepthMapsHideAsTrianglesDo)
{
  Scene scene(64, 48);
  BuildRooms(scene);
  vtkNew<vtkRSMReferencePass> reference;
  reference->SetModeToVirtualLights();
  scene.Pass->SetEstimator(reference);
  scene.Render();
  const Image open = scene.Copy("irradiance");
  reference->SetVisibilityToExact();
  scene.Render();
  const Image exact = scene.Copy("irradiance");
  const Image normal = scene.Copy("normal");
  const double without = FindRelativeError(open, exact, normal);

  scene.Gather->SetModeToVirtualLights();
  scene.Gather->InterpolationOff();
  scene.Pass->SetEstimator(scene.Gather);
  scene.Pass->SetVisibilityToMaps();
  scene.Render();
  const Image gathered = scene.Copy("irradiance");
  // Texels of 128 about a sender are 2.7 degrees wide ahead of it.
  CheckAtMost("RMS error of maps over the mean, by that of no visibility",
    FindRelativeError(gathered, exact, normal) / without, 0.15, "one tap a light, 128 texels");
  CheckRelative("mean with maps", gathered.Mean(), exact.Mean(), 0.05, "one tap a light");
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  splatting->SetPlaneThreshold(0.0);
  splatting->SetNormalThreshold(0.0);
  scene.Pass->SetEstimator(splatting);
  scene.Render();
  CheckAtMost("subsplats of one pixel see the same lights",
    FindRelativeError(scene.Copy("irradiance"), gathered, normal), 2e-3, "half floats");
  scene.Pass->SetVisibilityToNone();
  scene.Render();
  CheckAtMost("and without maps what the open sum says",
    FindRelativeError(scene.Copy("irradiance"), open, normal), 2e-3, "half floats");
}

VTK_INDIRECT_TEST(DepthMapsAreKept)
{
  Scene scene(48, 36);
  BuildRooms(scene);
  vtkActor* ball = scene.AddSphere({ 0.4, 0.2, 0.4 }, 0.1, 24, White);
  vtkNew<vtkEnvironmentLight> sky;
  scene.Pass->SetEnvironment(sky);
  scene.Gather->SetModeToVirtualLights();
  scene.Pass->SetVisibilityToMaps();
  scene.Render();
  const double first = scene.ReadReport("tiles_drawn");
  Check("each light and each direction has a tile", first > 256.0 && first <= 512.0);
  scene.Renderer->GetActiveCamera()->Azimuth(3.0);
  scene.Render();
  CheckEqual("a turned camera draws none", scene.ReadReport("tiles_drawn"), first);
  sky->SetRadiance(1.0, 0.5, 0.25);
  sky->SetUp(1.0, 1.0, 0.0);
  scene.Render();
  CheckEqual("nor does another sky", scene.ReadReport("tiles_drawn"), first);
  const Image before = scene.Copy("sky");
  ball->SetPosition(0.3, 0.1, 0.1);
  scene.Render();
  const double moved = scene.ReadReport("tiles_drawn") - first;
  Check("a moved ball is drawn again where it can be seen", moved >= 256.0);
  const Image after = scene.Copy("sky");
  scene.Pass->CachingOff();
  scene.Render();
  const Image anew = scene.Copy("sky");
  CheckEqual("with what all tiles drawn anew give", anew.Mean(), after.Mean());
  Check("which is another picture", std::abs(after.Mean() - before.Mean()) > 1e-6);
  scene.CheckBuffers(1);
}
