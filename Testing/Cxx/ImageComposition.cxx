// SPDX-License-Identifier: BSD-3-Clause
// Two lights, a gradient behind, glass in front and text over it all.
#include "vtkIndirectContractUtilities.h"
#include "vtkIndirectImageUtilities.h"

#include "vtkRSMGatherPass.h"
#include "vtkTesting.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkUniformLightSampler.h"

int ImageComposition(int argc, char* argv[])
{
  if (!contract::PrepareImageTest())
  {
    return VTK_SKIP_RETURN_CODE;
  }
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(240, 180);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  renderer->SetBackground(0.1, 0.1, 0.2);
  renderer->SetBackground2(0.5, 0.6, 0.8);
  renderer->GradientBackgroundOn();

  renderer->AddActor(contract::MakeQuad({ -2, 0, -2 }, { -2, 0, 2 }, { 2, 0, -2 }));
  renderer->AddActor(contract::MakeBox({ -1.2, 0, -1 }, { -0.4, 0.9, 0 }, { 0.9, 0.3, 0.2 }));
  renderer->AddActor(contract::MakeSphere({ 0.6, 0.5, -0.3 }, 0.5, { 0.9, 0.8, 0.3 }, 48));
  auto glass = contract::MakeBox({ -0.3, 0, 0.3 }, { 0.4, 0.7, 1.0 }, { 0.3, 0.8, 0.6 });
  glass->GetProperty()->SetOpacity(0.4);
  renderer->AddActor(glass);
  auto sun = contract::MakeLight(contract::LightKind::Directional, { -1, 2, 1.5 }, { 0, 0, 0 });
  sun->SetIntensity(0.5);
  renderer->AddLight(sun);
  auto bulb = contract::MakeLight(contract::LightKind::Point, { 1.0, 1.6, 1.0 }, { 0, 0, 0 });
  bulb->SetColor(1.0, 0.8, 0.6);
  bulb->SetIntensity(0.7);
  renderer->AddLight(bulb);
  vtkNew<vtkTextActor> text;
  text->SetInput("two lights");
  text->GetTextProperty()->SetFontSize(18);
  text->GetTextProperty()->SetColor(1, 1, 1);
  text->SetPosition(10, 10);
  renderer->AddActor(text);

  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.5, 2.2, 4.5);
  camera->SetFocalPoint(0, 0.35, 0);
  renderer->ResetCameraClippingRange();
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
