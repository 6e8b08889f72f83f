// SPDX-License-Identifier: BSD-3-Clause
// The report about light from the sky, which is absent without a sky.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkEnvironmentLight.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"

#include <cstdlib>

using namespace contract;

//------------------------------------------------------------------------------
// Surfaces reflect the sky's light without any vtkLight, with every estimator.
VTK_INDIRECT_TEST(SkyBounceReported)
{
  View view(60, 40);
  AddRoomSurfaces(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  vtkNew<vtkEnvironmentLight> sky;
  pass->SetEnvironment(sky);
  pass->SetNumberOfBounces(1); // later bounces have lights of their own
  view.Renderer->SetPass(pass);
  view.Renderer->AutomaticLightCreationOff();
  vtkNew<vtkRSMGatherPass> gather;
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  vtkNew<vtkRadianceHintsPass> hints;
  hints->SetGridResolution(6, 5, 6);
  for (vtkIndirectEstimatorPass* estimator :
    std::initializer_list<vtkIndirectEstimatorPass*>{ gather, splatting, hints })
  {
    pass->SetEstimator(estimator);
    view.Grab();
    const Report report(pass);
    const std::string name = estimator->GetClassName();
    CONTRACT_CHECK(report.Get("method") == estimator->GetMethodName(), report.GetText());
    CONTRACT_CHECK(!report.FindReason("modelled", "bounce of light from the sky").empty(),
      name << ": " << report.GetText());
    CONTRACT_CHECK(report.FindReason("left_out", "bounces of light from the sky").empty(),
      name << ": " << report.GetText());
    CONTRACT_CHECK(report.FindReason("left_out", "indirect light").empty(), report.GetText());
    // Hints sum over more lights than the frame's sampler has, as with lights' maps; the tree stops
    // at half its number if that is accurate enough.
    const double lights = report.GetNumber("virtual_lights");
    CONTRACT_CHECK(estimator == hints ? lights == 1024 : lights >= 128 && lights <= 256,
      name << ": " << report.Get("virtual_lights"));
    CONTRACT_CHECK(Mean(Read(pass, "bounce"), 0) > 0.01, name << " has no bounce");
  }

  // An estimator that reads the lights' maps has no other lights.
  gather->SetModeToNeighborhood();
  pass->SetEstimator(gather);
  view.Grab();
  CONTRACT_CHECK(!Report(pass).FindReason("modelled", "bounce of light from the sky").empty(),
    "without lights there are none");
  view.Renderer->AddLight(MakeLight(LightKind::Spot, { 0.5, 0.9, 0.5 }, { 0.5, 0.0, 0.5 }));
  view.Grab();
  const Report both(pass);
  CONTRACT_CHECK(
    both.FindReason("left_out", "bounces of light from the sky").find("maps") != std::string::npos,
    both.GetText());
  CONTRACT_CHECK(
    both.FindReason("modelled", "bounce of light from the sky").empty(), both.GetText());
  CONTRACT_CHECK(Mean(Read(pass, "bounce"), 0) > 0.0, "the light's own bounce");
  pass->SetEstimator(nullptr);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(SkyTakesNothingWhereItIsNot)
{
  View view(60, 40);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  view.Renderer->SetPass(pass);
  auto measure = [&]()
  {
    view.Grab();
    return Report(pass);
  };
  const Report without = measure();
  vtkNew<vtkEnvironmentLight> sky;
  pass->SetEnvironment(sky);
  const Report with = measure();
  CONTRACT_CHECK(with.GetNumber("bytes") > without.GetNumber("bytes"), with.Get("bytes"));
  // The reason begins with the number of lights. The lamps' own may change with the sky's bounces.
  const std::string reason = with.FindReason("modelled", "bounce of light from the sky");
  const int lights = std::atoi(reason.c_str());
  CONTRACT_CHECK(lights >= 128 && lights <= 256, reason);
  CONTRACT_CHECK(with.GetNumber("counters.faces_drawn") > 16, with.Get("counters.faces_drawn"));
  const double faces = with.GetNumber("counters.faces_drawn");

  pass->SetIndirectScale(0.0);
  const Report direct = measure();
  CONTRACT_CHECK(direct.GetNumber("bytes") < without.GetNumber("bytes"), direct.Get("bytes"));
  CONTRACT_CHECK(direct.GetNumber("counters.faces_drawn") == faces, "maps without use");
  pass->SetIndirectScale(1.0);
  sky->SetRadiance(0.0, 0.0, 0.0);
  const Report black = measure();
  CONTRACT_CHECK(black.GetNumber("bytes") == without.GetNumber("bytes"), black.Get("bytes"));
  CONTRACT_CHECK(black.GetNumber("counters.faces_drawn") == faces, "maps of a black sky");
  pass->SetEnvironment(nullptr);
  const Report again = measure();
  CONTRACT_CHECK(again.GetNumber("bytes") == without.GetNumber("bytes"), again.Get("bytes"));
}
