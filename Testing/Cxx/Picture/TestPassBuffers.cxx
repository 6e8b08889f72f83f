// SPDX-License-Identifier: BSD-3-Clause
// Buffers and reports are those of the last frame, whatever has been set since.
#include "vtkIndirectContractUtilities.h"

#include "vtkImageData.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkRenderWindow.h"
#include "vtkUniformLightSampler.h"

using namespace contract;

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(BuffersOfLastFrame)
{
  View view(160, 120);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  view.Renderer->SetPass(pass);
  vtkNew<vtkRSMGatherPass> gather;
  vtkNew<vtkUniformLightSampler> few;
  few->SetNumberOfLights(25);
  pass->SetSampler(few);
  vtkNew<vtkRadianceHintsPass> hints;
  hints->SetGridResolution(6, 5, 6);
  hints->SetInterpolationStep(4);
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  vtkNew<vtkRSMGatherPass> unused;
  vtkIndirectEstimatorPass* const other = unused;
  vtkIndirectEstimatorPass* const none = nullptr;

  const char* const names[] = { "irradiance", "indirect", "final", "direct" };
  for (vtkIndirectEstimatorPass* drawn :
    { static_cast<vtkIndirectEstimatorPass*>(gather), static_cast<vtkIndirectEstimatorPass*>(hints),
      static_cast<vtkIndirectEstimatorPass*>(splatting) })
  {
    pass->SetEstimator(drawn);
    pass->SetSampler(few);
    hints->SetInterpolationStep(4);
    view.Window->Render();
    const std::string report = pass->GetReport();
    std::vector<Floats> before;
    for (const char* name : names)
    {
      before.push_back(Read(pass, name));
    }
    const bool hasLights = drawn != hints;
    const Floats lights = hasLights ? Read(pass, "lights") : Floats();

    // Another estimator, another sampler, and a changed parameter of the estimator that has drawn.
    hints->SetInterpolationStep(1);
    pass->SetSampler(nullptr);
    for (vtkIndirectEstimatorPass* next : { none, other, drawn })
    {
      pass->SetEstimator(next);
      for (size_t i = 0; i < before.size(); ++i)
      {
        const Difference difference = Compare(before[i], Read(pass, names[i]));
        CONTRACT_CHECK(difference.Max == 0.0,
          drawn->GetClassName() << "'s " << names[i] << " with "
                                << (next ? next->GetClassName() : "none") << ": " << difference);
      }
      if (hasLights)
      {
        const Difference difference = Compare(lights, Read(pass, "lights"));
        CONTRACT_CHECK(difference.Max == 0.0, "lights of " << drawn->GetClassName());
      }
      CONTRACT_CHECK(pass->GetReport() == report, "the report of " << drawn->GetClassName());
    }
  }

  // The next frame uses the next estimator.
  hints->SetInterpolationStep(4);
  pass->SetEstimator(gather);
  view.Window->Render();
  const Floats gathered = Read(pass, "irradiance");
  pass->SetEstimator(hints);
  view.Window->Render();
  CONTRACT_CHECK(Compare(gathered, Read(pass, "irradiance")).Max > 0.0, "hints are no gather");

  // The frame's resources are released with the rest.
  pass->ReleaseGraphicsResources(view.Window);
  ExpectedErrors errors;
  vtkNew<vtkImageData> image;
  CONTRACT_CHECK(!pass->CopyBuffer("irradiance", image), "a buffer after release");
  CONTRACT_CHECK(errors.GetCount() == 1, errors.GetCount() << " errors: " << errors.GetText());
}
