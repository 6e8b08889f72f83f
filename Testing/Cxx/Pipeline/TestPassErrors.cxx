// SPDX-License-Identifier: BSD-3-Clause
// Wrong input: one clear error, and the picture is still drawn.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"
#include "vtkIndirectDetails.h"

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderWindow.h"
#include "vtkSequencePass.h"

#include <algorithm>
#include <functional>
#include <limits>

using namespace contract;

namespace
{
// Returns the report, which must be valid and have all keys of its schema.
std::string CheckReport(vtkIndirectIlluminationPass* pass)
{
  return Report(pass).GetText();
}

// The picture of a scene that the pass leaves to its delegate: VTK's own, bit for bit; the report
// gives the reason.
void CheckDelegate(const std::function<void(vtkRenderer*)>& setUp, const std::string& why)
{
  View view(80, 60);
  view.Renderer->SetBackground(0.1, 0.3, 0.2);
  setUp(view.Renderer);
  view.Window->Render();
  const Pixels plain = view.Grab();
  vtkNew<vtkIndirectIlluminationPass> pass;
  view.Renderer->SetPass(pass);
  const Difference difference = Compare(plain, view.Grab());
  CONTRACT_CHECK(difference.Max == 0.0, why << ": " << difference);
  const std::string report = CheckReport(pass);
  CONTRACT_CHECK(report.find(why) != std::string::npos, "no '" << why << "' in " << report);
}
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(DebugViewUnknown)
{
  View view(80, 60);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  view.Renderer->SetPass(pass);
  const Pixels expected = view.Grab();
  {
    ExpectedErrors errors;
    pass->SetDebugView("no such channel");
    for (int i = 0; i < 3; ++i)
    {
      CONTRACT_CHECK(Compare(expected, view.Grab()).Max == 0.0, "the picture");
    }
    CONTRACT_CHECK(errors.GetCount() == 1, errors.GetCount() << " errors: " << errors.GetText());
    CONTRACT_CHECK(errors.GetText().find("rsm<i>.density") != std::string::npos,
      "no names in: " << errors.GetText());
    // A map that does not exist, then an existing name.
    pass->SetDebugView("rsm7.depth");
    view.Grab();
    view.Grab();
    CONTRACT_CHECK(errors.GetCount() == 2, errors.GetCount() << " errors: " << errors.GetText());
  }
  pass->SetDebugView("normal");
  CONTRACT_CHECK(Compare(expected, view.Grab()).Max > 0.0, "a debug view");
  pass->SetDebugView("");
  CONTRACT_CHECK(Compare(expected, view.Grab()).Max == 0.0, "the picture again");
  // A repeated mistake is reported again.
  ExpectedErrors errors;
  pass->SetDebugView("rsm7.depth");
  view.Grab();
  CONTRACT_CHECK(errors.GetCount() == 1, errors.GetCount() << " errors: " << errors.GetText());
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(CopyBufferWrong)
{
  vtkNew<vtkIndirectIlluminationPass> pass;
  vtkNew<vtkImageData> image;
  {
    ExpectedErrors errors;
    CONTRACT_CHECK(!pass->CopyBuffer("final", image), "before the first frame");
    CONTRACT_CHECK(errors.GetCount() == 1, errors.GetText());
    CONTRACT_CHECK(
      errors.GetText().find("no frame has been rendered") != std::string::npos, errors.GetText());
  }
  CheckReport(pass);
  View view(80, 60);
  AddRoom(view.Renderer);
  view.Renderer->SetPass(pass);
  view.Grab();
  const char* const wrong[] = { "", "Final", "final ", "rsm", "rsm0", "rsm.depth", "rsm1.depth",
    "rsm0.depths", "rsm-1.depth", "rsm99999999999.depth", "lights2", "%s%n" };
  for (const char* name : wrong)
  {
    ExpectedErrors errors;
    CONTRACT_CHECK(!pass->CopyBuffer(name, image), "'" << name << "'");
    CONTRACT_CHECK(errors.GetCount() == 1, "'" << name << "': " << errors.GetText());
  }
  {
    ExpectedErrors errors;
    CONTRACT_CHECK(!pass->CopyBuffer("final", nullptr), "no image");
    CONTRACT_CHECK(errors.GetCount() == 1, errors.GetText());
    CONTRACT_CHECK(errors.GetText().find("needs an image to copy 'final' to") != std::string::npos,
      errors.GetText());
  }
  // None of these errors affects later calls.
  for (const char* name : { "final", "direct", "indirect", "irradiance", "glossy", "albedo",
         "normal", "depth", "rsm0.depth", "rsm0.normal", "rsm0.density", "lights" })
  {
    Read(pass, name);
  }
}

//------------------------------------------------------------------------------
// Maps can be drawn alone, without messages.
VTK_INDIRECT_TEST(StagesAlone)
{
  View view(80, 60);
  AddRoom(view.Renderer);
  view.Window->Render();
  vtkNew<vtkReflectiveShadowMapPass> maps;
  view.Renderer->SetPass(maps);
  view.Grab();
  view.Renderer->SetPass(nullptr);
  maps->ReleaseGraphicsResources(view.Window);
  view.Grab();
}

//------------------------------------------------------------------------------
// The resolution is clamped.
VTK_INDIRECT_TEST(ResolutionLimits)
{
  View view(80, 60);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->SetReflectiveShadowMapResolution(100000);
  CONTRACT_CHECK(pass->GetReflectiveShadowMapResolution() == 16384, "clamped");
  pass->SetReflectiveShadowMapResolution(128);
  view.Renderer->SetPass(pass);
  const Pixels expected = view.Grab();
  pass->SetReflectiveShadowMapResolution(-5);
  CONTRACT_CHECK(pass->GetReflectiveShadowMapResolution() == 1, "clamped");
  for (int resolution : { 1, 2, 3, 127 })
  {
    pass->SetReflectiveShadowMapResolution(resolution);
    view.Grab();
    Read(pass, "irradiance");
    const Floats map = Read(pass, "rsm0.depth");
    CONTRACT_CHECK(map.Width == resolution && map.Height == resolution, resolution);
  }
  pass->SetReflectiveShadowMapResolution(128);
  CONTRACT_CHECK(Compare(expected, view.Grab()).Max == 0.0, "back again");
}

//------------------------------------------------------------------------------
// Maps that OpenGL cannot hold: one error for each new attempt, and the delegate's picture.
VTK_INDIRECT_TEST(MapsTooMany)
{
  View view(80, 60);
  AddRoom(view.Renderer);
  view.Renderer->SetBackground(0.2, 0.4, 0.6);
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->SetReflectiveShadowMapResolution(1);
  view.Renderer->SetPass(pass);
  const Pixels expected = view.Grab();
  int layers = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &layers);
  if (layers > 10000)
  {
    Skip("this OpenGL holds " + std::to_string(layers) + " layers");
  }
  // VTK 9.1's lights have seven uniforms each, and its mapper crashes when a program does not link.
  int components = 0;
  glGetIntegerv(GL_MAX_FRAGMENT_UNIFORM_COMPONENTS, &components);
  if (components < 7 * 4 * (layers / 6))
  {
    Skip("this OpenGL links no program of VTK's with " + std::to_string(layers / 6) + " lights");
  }
  // VTK compiles shaders with all lights in them, which takes minutes for hundreds: the delegate
  // draws nothing in place of opaque props.
  vtkNew<vtkSequencePass> nothing;
  vtkNew<vtkRenderPassCollection> none;
  nothing->SetPasses(none);
  const vtkSmartPointer<vtkLight> spot =
    vtkLight::SafeDownCast(view.Renderer->GetLights()->GetItemAsObject(0));
  for (int turn = 0; turn < 2; ++turn)
  {
    pass->SetDelegatePass(nothing);
    std::vector<vtkSmartPointer<vtkLight>> lights;
    for (int i = 0; i < layers / 6 + 1 + turn; ++i)
    {
      lights.push_back(MakeLight(LightKind::Point, { 0.5, 0.5, 0.5 + 1e-3 * i }, { 0, 0, 0 }));
      view.Renderer->AddLight(lights.back());
    }
    {
      ExpectedErrors errors;
      for (int i = 0; i < 3; ++i)
      {
        const Pixels image = view.Grab();
        CONTRACT_CHECK(image.Get(40, 30, 0) == 51 && image.Get(40, 30, 2) == 153, "background");
      }
      CONTRACT_CHECK(errors.GetCount() == 1, errors.GetCount() << " errors: " << errors.GetText());
    }
    CheckReport(pass);
    pass->SetDelegatePass(nullptr);
    view.Renderer->GetLights()->RemoveAllItems();
    view.Renderer->AddLight(spot);
    CONTRACT_CHECK(Compare(expected, view.Grab()).Max == 0.0, "back to maps that fit");
  }
}

//------------------------------------------------------------------------------
// More rays of hints than a table may have entries: one error for each new attempt, direct light
// alone, and a reason in the report.
VTK_INDIRECT_TEST(HintsTooMany)
{
  View view(80, 60);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  vtkNew<vtkRadianceHintsPass> hints;
  pass->SetEstimator(hints);
  pass->SetIndirectScale(0.0);
  view.Renderer->SetPass(pass);
  const Pixels direct = view.Grab();
  pass->SetIndirectScale(1.0);
  const Pixels expected = view.Grab();
  CONTRACT_CHECK(Compare(direct, expected).Max > 0.0, "no indirect light");
  for (int grids : { 1, 2 })
  {
    hints->SetNumberOfGrids(grids);
    hints->SetGridResolution(64, 64, 64);
    SET_DETAIL(hints, NumberOfRays, 4096);
    {
      ExpectedErrors errors;
      for (int i = 0; i < 3; ++i)
      {
        CONTRACT_CHECK(Compare(direct, view.Grab()).Max == 0.0, "direct light alone");
      }
      CONTRACT_CHECK(errors.GetCount() == 1, errors.GetCount() << " errors: " << errors.GetText());
      CONTRACT_CHECK(
        errors.GetText().find("GridResolution") != std::string::npos, errors.GetText());
    }
    CONTRACT_CHECK(!Report(pass).FindReason("left_out", "indirect light").empty(), "left out");
    hints->SetNumberOfGrids(1);
    hints->SetGridResolution(0, 0, 0);
    SET_DETAIL(hints, NumberOfRays, 400);
    CONTRACT_CHECK(Compare(expected, view.Grab()).Max == 0.0, "back to what fits");
  }
}

//------------------------------------------------------------------------------
// Too many blocks of maps: 44 lights of six faces make 264 times 128 squared.
VTK_INDIRECT_TEST(HintsTooManyBlocks)
{
  View view(80, 60);
  AddRoomSurfaces(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  vtkNew<vtkRadianceHintsPass> hints;
  pass->SetEstimator(hints);
  pass->SetReflectiveShadowMapResolution(1);
  // Replaces VTK's opaque props, whose shaders would have all lights in them.
  vtkNew<vtkSequencePass> nothing;
  vtkNew<vtkRenderPassCollection> none;
  nothing->SetPasses(none);
  pass->SetDelegatePass(nothing);
  for (int i = 0; i < 44; ++i)
  {
    view.Renderer->AddLight(MakeLight(LightKind::Point, { 0.5, 0.5, 0.5 + 1e-3 * i }, { 0, 0, 0 }));
  }
  view.Renderer->SetPass(pass);
  view.Grab();
  int longest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &longest);
  if (longest >= 264 * 128 * 128 / 256)
  {
    Skip("this OpenGL holds textures of " + std::to_string(longest) + " rows");
  }
  SET_DETAIL(hints, BlocksPerEdge, 128);
  ExpectedErrors errors;
  for (int i = 0; i < 3; ++i)
  {
    view.Grab();
  }
  CONTRACT_CHECK(errors.GetCount() == 1, errors.GetCount() << " errors: " << errors.GetText());
  CONTRACT_CHECK(errors.GetText().find("fewer lights") != std::string::npos, errors.GetText());
}

//------------------------------------------------------------------------------
// Scenes that cannot reflect light.
VTK_INDIRECT_TEST(NothingToDo)
{
  CheckDelegate([](vtkRenderer*) {}, "nothing opaque is visible");
  CheckDelegate(
    [](vtkRenderer* renderer)
    {
      AddRoomSurfaces(renderer);
      renderer->AutomaticLightCreationOff();
    },
    "no light is on");
  CheckDelegate(
    [](vtkRenderer* renderer)
    {
      AddRoom(renderer);
      renderer->AutomaticLightCreationOff();
      vtkLight::SafeDownCast(renderer->GetLights()->GetItemAsObject(0))->SwitchOff();
    },
    "no light is on");
  CheckDelegate(
    [](vtkRenderer* renderer)
    {
      AddRoom(renderer);
      vtkPropCollection* props = renderer->GetViewProps();
      for (int i = 0; i < props->GetNumberOfItems(); ++i)
      {
        vtkProp::SafeDownCast(props->GetItemAsObject(i))->VisibilityOff();
      }
    },
    "nothing opaque is visible");
  CheckDelegate(
    [](vtkRenderer* renderer)
    {
      AddRoom(renderer);
      renderer->RemoveAllViewProps();
      auto glass = MakeSphere({ 0.5, 0.5, 0.5 }, 0.3);
      glass->GetProperty()->SetOpacity(0.5);
      renderer->AddActor(glass);
    },
    "nothing opaque is visible");
}

//------------------------------------------------------------------------------
// Actors without data, without mapper, with bounds of NaN.
VTK_INDIRECT_TEST(BadActors)
{
  auto addEmpty = [](vtkRenderer* renderer)
  {
    vtkNew<vtkPolyData> nothing;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(nothing);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
    vtkNew<vtkActor> without;
    renderer->AddActor(without);
  };
  auto addUndefined = [](vtkRenderer* renderer)
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->InsertNextPoint(0, 0, 0);
    points->InsertNextPoint(1, 0, nan);
    points->InsertNextPoint(nan, 1, std::numeric_limits<double>::infinity());
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({ 0, 1, 2 });
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
    // VTK leaves undefined points out of an actor's bounds, but not an undefined position.
    auto nowhere = MakeSphere({ 0, 0, 0 }, 0.5);
    nowhere->SetPosition(nan, 0, 0);
    renderer->AddActor(nowhere);
  };
  CheckDelegate(
    [&](vtkRenderer* renderer)
    {
      AddRoom(renderer);
      renderer->RemoveAllViewProps();
      auto nowhere = MakeSphere({ 0, 0, 0 }, 0.5);
      nowhere->SetScale(std::numeric_limits<double>::infinity(), 1.0, 1.0);
      renderer->AddActor(nowhere);
    },
    "not finite");
  CheckDelegate(
    [&](vtkRenderer* renderer)
    {
      AddRoom(renderer);
      renderer->RemoveAllViewProps();
      addEmpty(renderer);
    },
    "");

  // Beside good actors they change nothing.
  View view(80, 60);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  view.Renderer->SetPass(pass);
  const Pixels expected = view.Grab();
  addEmpty(view.Renderer);
  CONTRACT_CHECK(Compare(expected, view.Grab()).Max == 0.0, "with empty actors");
  addUndefined(view.Renderer);
  const Pixels image = view.Grab();
  size_t far = 0;
  const Difference difference = Compare(expected, image);
  for (size_t i = 0; i < expected.Values.size(); ++i)
  {
    far += std::abs(int(expected.Values[i]) - int(image.Values[i])) > 2 ? 1 : 0;
  }
  std::cout << "beside undefined points: " << difference << "\n";
  CONTRACT_CHECK(far == 0, "with undefined points: " << difference);
  for (const char* name : { "final", "irradiance", "depth", "rsm0.density" })
  {
    Read(pass, name);
  }
  CheckReport(pass);
}
