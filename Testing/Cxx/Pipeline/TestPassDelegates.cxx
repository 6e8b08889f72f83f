// SPDX-License-Identifier: BSD-3-Clause
// Passes in the place of the default delegate: supported ones, and refused ones.
#include "vtkIndirectContractUtilities.h"

#include "vtkCameraPass.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkToneMappingPass.h"

#include <algorithm>
#include <cstdlib>

using namespace contract;

namespace
{
vtkSmartPointer<vtkSequencePass> MakeSequence(std::initializer_list<vtkRenderPass*> passes)
{
  vtkNew<vtkRenderPassCollection> collection;
  for (vtkRenderPass* pass : passes)
  {
    collection->AddItem(pass);
  }
  auto sequence = vtkSmartPointer<vtkSequencePass>::New();
  sequence->SetPasses(collection);
  return sequence;
}

// Three frames end in one error that contains `text`, and in the picture of the delegate alone.
void CheckRefused(vtkRenderPass* delegate, const std::string& text)
{
  View view(120, 90);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> alone;
  alone->SetDelegatePass(delegate);
  alone->SetIndirectScale(0.0);
  alone->ShadowsOff();
  view.Renderer->SetPass(alone);
  const Pixels expected = view.Grab();
  CONTRACT_CHECK(Mean(expected, 0) > 10.0, text << ": the delegate draws nothing");

  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->SetDelegatePass(delegate);
  view.Renderer->SetPass(pass);
  {
    ExpectedErrors errors;
    for (int frame = 0; frame < 3; ++frame)
    {
      const Difference difference = Compare(expected, view.Grab());
      CONTRACT_CHECK(difference.Max == 0.0, text << ", frame " << frame << ": " << difference);
    }
    CONTRACT_CHECK(errors.GetCount() == 1, text << ": " << errors.GetText());
    CONTRACT_CHECK(errors.GetText().find(text) != std::string::npos, errors.GetText());
    CONTRACT_CHECK(
      errors.GetText().find(delegate->GetClassName()) != std::string::npos, errors.GetText());
  }
  CONTRACT_CHECK(pass->GetReport().find("the delegate alone") != std::string::npos,
    text << ": " << pass->GetReport());
  // Another delegate starts afresh.
  pass->SetDelegatePass(nullptr);
  CONTRACT_CHECK(Mean(view.Grab(), 0) > Mean(expected, 0), text << ": no light with the default");
  view.Renderer->SetPass(nullptr);
  delegate->ReleaseGraphicsResources(view.Window);
}
}

//------------------------------------------------------------------------------
// Passes that draw the props into their own framebuffer.
VTK_INDIRECT_TEST(DelegateRedirects)
{
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(MakeSequence({ lights, opaque }));
  vtkNew<vtkSSAOPass> occlusion;
  occlusion->SetDelegatePass(camera);
  CheckRefused(occlusion, "framebuffer of its own");
  vtkNew<vtkToneMappingPass> toneMapping;
  toneMapping->SetDelegatePass(camera);
  CheckRefused(toneMapping, "framebuffer of its own");
}

//------------------------------------------------------------------------------
// A pass as its own delegate, directly and further down.
VTK_INDIRECT_TEST(DelegateItself)
{
  View view(120, 90);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  view.Renderer->SetPass(pass);
  const Pixels expected = view.Grab();
  {
    ExpectedErrors errors;
    pass->SetDelegatePass(pass);
    CONTRACT_CHECK(errors.GetCount() == 1, errors.GetText());
    CONTRACT_CHECK(
      errors.GetText().find("cannot be its own delegate") != std::string::npos, errors.GetText());
  }
  CONTRACT_CHECK(!pass->GetDelegatePass(), "the delegate has changed");
  CONTRACT_CHECK(Compare(expected, view.Grab()).Max == 0.0, "the picture");

  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  pass->SetDelegatePass(MakeSequence({ lights, opaque, pass }));
  {
    ExpectedErrors errors;
    for (int frame = 0; frame < 3; ++frame)
    {
      CONTRACT_CHECK(Mean(view.Grab(), 0) > 10.0, "nothing is drawn");
    }
    CONTRACT_CHECK(errors.GetCount() == 1, errors.GetText());
    CONTRACT_CHECK(
      errors.GetText().find("contains this very pass") != std::string::npos, errors.GetText());
  }
  pass->SetDelegatePass(nullptr); // breaks the cycle of references
  CONTRACT_CHECK(Compare(expected, view.Grab()).Max == 0.0, "the picture afterwards");
}

//------------------------------------------------------------------------------
// Sequences of VTK's own passes draw the same as the default.
VTK_INDIRECT_TEST(DelegateSteps)
{
  View view(120, 90);
  AddRoom(view.Renderer);
  view.Renderer->SetBackground(0.1, 0.2, 0.3);
  auto glass = MakeSphere({ 0.7, 0.5, 0.8 }, 0.15, { 0.2, 0.4, 0.9 });
  glass->GetProperty()->SetOpacity(0.4);
  view.Renderer->AddActor(glass);
  vtkNew<vtkIndirectIlluminationPass> pass;
  view.Renderer->SetPass(pass);
  const Pixels expected = view.Grab();
  const Floats irradiance = Read(pass, "irradiance");

  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  pass->SetDelegatePass(MakeSequence({ lights, opaque }));
  const Difference sequence = Compare(expected, view.Grab());
  CONTRACT_CHECK(sequence.Max <= 1.0, "lights and opaque: " << sequence);

  // All steps of a renderer: translucent props are drawn with the opaque ones.
  vtkNew<vtkRenderStepsPass> steps;
  pass->SetDelegatePass(steps);
  pass->RemainingGeometryOff();
  const Pixels image = view.Grab();
  const Difference light = Compare(irradiance, Read(pass, "irradiance"));
  // The surface behind the glass is as bright as beside it: indirect light is added last.
  size_t off = 0;
  for (size_t i = 0; i < image.Values.size(); i += 4)
  {
    const bool same = std::equal(&image.Values[i], &image.Values[i] + 3, &expected.Values[i],
      [](int a, int b) { return std::abs(a - b) <= 1; });
    off += same ? 0 : 1;
  }
  std::cout << "all steps: " << off << " pixels off; irradiance: " << light << "\n";
  CONTRACT_CHECK(off < 900, "more than the glass differs: " << off << " pixels");
  CONTRACT_CHECK(light.Max < 1e-3, "all steps: " << light);
}
