// SPDX-License-Identifier: BSD-3-Clause
// Passes whose window closes, and orders of destruction.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkImageData.h"
#include "vtkIndirectSplattingPass.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkSmartPointer.h"

using namespace contract;

//------------------------------------------------------------------------------
// Finalize ends the context; rendering makes another one.
VTK_INDIRECT_TEST(Finalize)
{
  View view(160, 120);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->TimingOn();
  view.Renderer->SetPass(pass);
  const Pixels before = view.Grab();
  for (int i = 0; i < 3; ++i)
  {
    view.Window->Finalize();
    {
      ExpectedErrors errors;
      vtkNew<vtkImageData> image;
      CONTRACT_CHECK(!pass->CopyBuffer("final", image), "a buffer of a window that is closed");
      CONTRACT_CHECK(errors.GetCount() == 1, errors.GetCount() << " errors: " << errors.GetText());
      pass->GetReport();
      CONTRACT_CHECK(errors.GetCount() == 1, "the report of a closed window");
    }
    const Difference difference = Compare(before, view.Grab());
    CONTRACT_CHECK(difference.Max == 0.0, "context " << i + 2 << ": " << difference);
  }
}

//------------------------------------------------------------------------------
// Estimators that the pass no longer uses learn of their window's end. Later they neither draw with
// its names nor delete objects of the next context with the same names.
VTK_INDIRECT_TEST(FinalizeUnused)
{
  vtkNew<vtkIndirectIlluminationPass> pass;
  vtkNew<vtkRadianceHintsPass> hints;
  hints->SetGridResolution(6, 5, 6);
  vtkSmartPointer<vtkIndirectEstimatorPass> used[] = {
    vtkSmartPointer<vtkMultiresolutionSplattingPass>::New(),
    vtkSmartPointer<vtkMultiresolutionSplattingPass>::New(), hints.Get(),
    vtkSmartPointer<vtkRSMGatherPass>::New(), vtkSmartPointer<vtkIndirectSplattingPass>::New()
  };
  View view(160, 120);
  AddRoom(view.Renderer);
  view.Renderer->SetPass(pass);
  Pixels before;
  for (vtkIndirectEstimatorPass* estimator : used)
  {
    pass->SetEstimator(estimator);
    const Pixels shown = view.Grab();
    before = estimator == used[0] ? shown : before;
  }
  view.Window->Finalize();

  View other(160, 120);
  AddRoom(other.Renderer);
  vtkNew<vtkIndirectIlluminationPass> fresh;
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  fresh->SetEstimator(splatting);
  fresh->CachingOff();
  other.Renderer->SetPass(fresh);
  CONTRACT_CHECK(Compare(before, other.Grab()).Max == 0.0, "in a new window");
  pass->SetEstimator(nullptr);
  for (int i : { 0, 2, 3, 4 })
  {
    used[i] = nullptr;
    CONTRACT_CHECK(
      Compare(before, other.Grab()).Max == 0.0, "after estimator " << i << " was destroyed");
  }
  fresh->SetEstimator(used[1]);
  CONTRACT_CHECK(Compare(before, other.Grab()).Max == 0.0, "with one of the closed window's");
}

//------------------------------------------------------------------------------
// A window that closes while the pass is in no renderer releases the pass's objects.
VTK_INDIRECT_TEST(FinalizeWithout)
{
  vtkNew<vtkIndirectIlluminationPass> pass;
  Pixels before;
  {
    View view(160, 120);
    AddRoom(view.Renderer);
    view.Renderer->SetPass(pass);
    before = view.Grab();
    view.Renderer->SetPass(nullptr);
    view.Window->Finalize();
    view.Renderer->SetPass(pass);
    CONTRACT_CHECK(Compare(before, view.Grab()).Max == 0.0, "in the new context");
    view.Renderer->SetPass(nullptr);
  }
  View other(160, 120);
  AddRoom(other.Renderer);
  other.Renderer->SetPass(pass);
  CONTRACT_CHECK(Compare(before, other.Grab()).Max == 0.0, "in a new window");
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(DestructionOrder)
{
  {
    // The window first.
    vtkNew<vtkIndirectIlluminationPass> pass;
    {
      View view(60, 40);
      AddRoom(view.Renderer);
      view.Renderer->SetPass(pass);
      view.Grab();
    }
    pass->GetReport();
    ExpectedErrors errors;
    vtkNew<vtkImageData> image;
    CONTRACT_CHECK(!pass->CopyBuffer("final", image), "a buffer of a window that is gone");
  }
  {
    // The pass first: only the renderer holds it.
    View view(60, 40);
    AddRoom(view.Renderer);
    {
      vtkNew<vtkIndirectIlluminationPass> pass;
      view.Renderer->SetPass(pass);
    }
    view.Grab();
    view.Renderer->SetPass(nullptr);
    view.Grab();
  }
  {
    // The renderer leaves its window, and returns.
    View view(60, 40);
    AddRoom(view.Renderer);
    vtkNew<vtkIndirectIlluminationPass> pass;
    view.Renderer->SetPass(pass);
    const Pixels before = view.Grab();
    view.Window->RemoveRenderer(view.Renderer);
    view.Grab();
    {
      ExpectedErrors errors;
      vtkNew<vtkImageData> image;
      pass->CopyBuffer("final", image);
      pass->GetReport();
    }
    view.Window->AddRenderer(view.Renderer);
    CONTRACT_CHECK(Compare(before, view.Grab()).Max == 0.0, "after the renderer came back");
  }
  {
    // Never rendered.
    vtkNew<vtkIndirectIlluminationPass> pass;
    pass->ReleaseGraphicsResources(nullptr);
    pass->GetReport();
  }
  {
    // Props that are destroyed while a pass knows them.
    View view(60, 40);
    AddRoom(view.Renderer);
    vtkNew<vtkIndirectIlluminationPass> pass;
    view.Renderer->SetPass(pass);
    view.Grab();
    view.Renderer->RemoveAllViewProps();
    view.Renderer->RemoveAllLights();
    pass->GetReport();
    Read(pass, "final");
    view.Grab();
    AddRoom(view.Renderer);
    view.Grab();
  }
}

//------------------------------------------------------------------------------
// Two windows share nothing, with a pass each; and one pass object goes from window to window.
VTK_INDIRECT_TEST(TwoWindows)
{
  Pixels alone;
  {
    View view(100, 80);
    AddRoom(view.Renderer);
    vtkNew<vtkIndirectIlluminationPass> pass;
    view.Renderer->SetPass(pass);
    alone = view.Grab();
  }
  View first(100, 80);
  View second(100, 80);
  AddRoom(first.Renderer);
  AddRoom(second.Renderer);
  vtkNew<vtkIndirectIlluminationPass> passes[2];
  first.Renderer->SetPass(passes[0]);
  second.Renderer->SetPass(passes[1]);
  for (int i = 0; i < 3; ++i)
  {
    CONTRACT_CHECK(Compare(alone, first.Grab()).Max == 0.0, "first window, frame " << i);
    CONTRACT_CHECK(Compare(alone, second.Grab()).Max == 0.0, "second window, frame " << i);
    // Reads one while the other is current.
    CONTRACT_CHECK(Compare(Read(passes[0], "final"), Read(passes[1], "final")).Max == 0.0,
      "buffers, frame " << i);
  }
  // One pass for both.
  second.Renderer->SetPass(nullptr);
  for (int i = 0; i < 3; ++i)
  {
    first.Renderer->SetPass(nullptr);
    second.Renderer->SetPass(passes[0]);
    CONTRACT_CHECK(Compare(alone, second.Grab()).Max == 0.0, "moved to the second, turn " << i);
    second.Renderer->SetPass(nullptr);
    first.Renderer->SetPass(passes[0]);
    CONTRACT_CHECK(Compare(alone, first.Grab()).Max == 0.0, "moved to the first, turn " << i);
  }
  // One pass in both at once: slow, but correct.
  second.Renderer->SetPass(passes[0]);
  for (int i = 0; i < 2; ++i)
  {
    CONTRACT_CHECK(Compare(alone, first.Grab()).Max == 0.0, "shared, first, turn " << i);
    CONTRACT_CHECK(Compare(alone, second.Grab()).Max == 0.0, "shared, second, turn " << i);
  }
}
