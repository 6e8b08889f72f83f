// SPDX-License-Identifier: BSD-3-Clause
// An estimator set on a renderer by itself draws the frame of a pass with that estimator.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkIndirectSplattingPass.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRSMReferencePass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkWeakPointer.h"

using namespace contract;

namespace
{
// Reduces the number of hints, because only two passes are compared.
void SetFew(vtkIndirectEstimatorPass* estimator)
{
  if (auto hints = vtkRadianceHintsPass::SafeDownCast(estimator))
  {
    hints->SetGridResolution(6, 5, 6);
  }
}

template <typename Estimator>
void CheckAlone()
{
  vtkNew<Estimator> expected;
  SetFew(expected);
  View view(80, 60);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->SetEstimator(expected);
  pass->SetReflectiveShadowMapResolution(64);
  view.Renderer->SetPass(pass);
  const Pixels picture = view.Grab();

  vtkNew<Estimator> alone;
  SetFew(alone);
  const char* name = alone->GetClassName();
  alone->GetIlluminationPass()->SetReflectiveShadowMapResolution(64);
  view.Renderer->SetPass(alone);
  CONTRACT_CHECK(Compare(picture, view.Grab()).Max == 0.0, name << " draws another picture");
  CONTRACT_CHECK(
    Report(alone->GetIlluminationPass()).Get("method") == std::string(alone->GetMethodName()),
    name);
  CONTRACT_CHECK(alone->GetNumberOfRenderedProps() == pass->GetNumberOfRenderedProps(),
    name << ": " << alone->GetNumberOfRenderedProps() << " props");
  // Properties of a frame are set on its pass.
  alone->GetIlluminationPass()->SetIndirectScale(0.0);
  CONTRACT_CHECK(Compare(picture, view.Grab()).Max > 0.0, name << " has no pass of its own");
  alone->GetIlluminationPass()->SetIndirectScale(1.0);
  // Releasing and drawing again, and moving into a pass and back.
  alone->ReleaseGraphicsResources(view.Window);
  CONTRACT_CHECK(Compare(picture, view.Grab()).Max == 0.0, name << " after its release");
  pass->SetEstimator(alone);
  view.Renderer->SetPass(pass);
  CONTRACT_CHECK(Compare(picture, view.Grab()).Max == 0.0, name << " in a pass");
  view.Renderer->SetPass(alone);
  CONTRACT_CHECK(Compare(picture, view.Grab()).Max == 0.0, name << " alone again");
}
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(EstimatorsAlone)
{
  CheckAlone<vtkRSMGatherPass>();
  CheckAlone<vtkRSMReferencePass>();
  CheckAlone<vtkMultiresolutionSplattingPass>();
  CheckAlone<vtkIndirectSplattingPass>();
  CheckAlone<vtkRadianceHintsPass>();
}

//------------------------------------------------------------------------------
// An estimator and its own pass hold each other so that both are destroyed with the last outside
// reference, in either order with the window.
VTK_INDIRECT_TEST(EstimatorsAloneEnd)
{
  for (const bool windowFirst : { false, true })
  {
    vtkWeakPointer<vtkIndirectEstimatorPass> estimator;
    vtkWeakPointer<vtkIndirectIlluminationPass> pass;
    {
      vtkSmartPointer<vtkRadianceHintsPass> hints = vtkSmartPointer<vtkRadianceHintsPass>::New();
      SetFew(hints);
      estimator = hints;
      pass = hints->GetIlluminationPass();
      vtkSmartPointer<vtkIndirectIlluminationPass> held = windowFirst ? pass.Get() : nullptr;
      {
        View view(80, 60);
        AddRoom(view.Renderer);
        view.Renderer->SetPass(hints);
        view.Grab();
        if (!windowFirst)
        {
          hints = nullptr;
          view.Renderer->SetPass(nullptr);
          CONTRACT_CHECK(!estimator && !pass, "they are kept");
        }
      }
      hints = nullptr;
      CONTRACT_CHECK(!estimator, "the estimator is kept");
      if (held)
      {
        // A pass that has lost its estimator continues with the automatic one.
        View view(80, 60);
        AddRoom(view.Renderer);
        view.Renderer->SetPass(held);
        view.Grab();
        CONTRACT_CHECK(Report(held).Get("method") == "multiresolution", Report(held).GetText());
      }
    }
    CONTRACT_CHECK(!estimator && !pass, "they are kept");
  }
}
