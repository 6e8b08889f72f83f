// SPDX-License-Identifier: BSD-3-Clause
// What the pass holds of OpenGL, when it lets go of it, and in which order things may be destroyed.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"
#include "vtkIndirectDetails.h"

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include "vtkCellArray.h"
#include "vtkEnvironmentLight.h"
#include "vtkImageData.h"
#include "vtkIndirectSplattingPass.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProxyAccumulationPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <unistd.h>

using namespace contract;

namespace
{
// Names of the current context that are in use, by probing.
struct Names
{
  int Textures = 0;
  int Framebuffers = 0;
  int Renderbuffers = 0;
  int Buffers = 0;
  int VertexArrays = 0;
  int Programs = 0;

  bool operator==(const Names& other) const
  {
    return this->Textures == other.Textures && this->Framebuffers == other.Framebuffers &&
      this->Renderbuffers == other.Renderbuffers && this->Buffers == other.Buffers &&
      this->VertexArrays == other.VertexArrays && this->Programs == other.Programs;
  }
};

std::ostream& operator<<(std::ostream& os, const Names& names)
{
  return os << names.Textures << " textures, " << names.Framebuffers << " framebuffers, "
            << names.Renderbuffers << " renderbuffers, " << names.Buffers << " buffers, "
            << names.VertexArrays << " vertex arrays, " << names.Programs << " programs";
}

// Of all but programs, which are the window's own cache's.
void CheckGivenBack(const Names& before, const Names& after)
{
  CONTRACT_CHECK(after.Textures == before.Textures, "textures");
  CONTRACT_CHECK(after.Framebuffers == before.Framebuffers, "framebuffers");
  CONTRACT_CHECK(after.Renderbuffers == before.Renderbuffers, "renderbuffers");
  CONTRACT_CHECK(after.Buffers == before.Buffers, "buffers");
  CONTRACT_CHECK(after.VertexArrays == before.VertexArrays, "vertex arrays");
}

Names CountNames(vtkRenderWindow* window)
{
  window->MakeCurrent();
  Names names;
  // Names are handed out from one on, and reused: far below this many are ever alive here.
  for (GLuint i = 1; i < 4000; ++i)
  {
    names.Textures += glIsTexture(i) ? 1 : 0;
    names.Framebuffers += glIsFramebuffer(i) ? 1 : 0;
    names.Renderbuffers += glIsRenderbuffer(i) ? 1 : 0;
    names.Buffers += glIsBuffer(i) ? 1 : 0;
    names.VertexArrays += glIsVertexArray(i) ? 1 : 0;
    names.Programs += glIsProgram(i) ? 1 : 0;
  }
  return names;
}

double GetResidentMegabytes()
{
  std::ifstream statm("/proc/self/statm");
  double total = 0.0;
  double resident = 0.0;
  statm >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}
}

//------------------------------------------------------------------------------
namespace
{
void CheckToggle(vtkIndirectEstimatorPass* estimator, vtkEnvironmentLight* environment = nullptr)
{
  View view(160, 120);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->SetEstimator(estimator);
  pass->SetEnvironment(environment);
  Names first[2];
  Pixels pictures[2];
  double memory = 0.0;
  for (int i = 0; i < 100; ++i)
  {
    view.Renderer->SetPass(pass);
    view.Window->Render();
    const Names on = CountNames(view.Window);
    const Pixels with = Grab(view.Window, false);
    view.Renderer->SetPass(nullptr);
    view.Window->Render();
    const Names off = CountNames(view.Window);
    const Pixels without = Grab(view.Window, false);
    if (i == 0)
    {
      pictures[0] = with;
      pictures[1] = without;
    }
    if (i == 1)
    {
      first[0] = on;
      first[1] = off;
    }
    if (i == 20)
    {
      memory = GetResidentMegabytes();
    }
    if (i > 1)
    {
      CONTRACT_CHECK(on == first[0], "on, turn " << i << ": " << on << " after " << first[0]);
      CONTRACT_CHECK(off == first[1], "off, turn " << i << ": " << off << " after " << first[1]);
    }
    CONTRACT_CHECK(Compare(with, pictures[0]).Max == 0.0, "picture with, turn " << i);
    CONTRACT_CHECK(Compare(without, pictures[1]).Max == 0.0, "picture without, turn " << i);
  }
  const double grown = GetResidentMegabytes() - memory;
  std::cout << "on: " << first[0] << "\noff: " << first[1] << "\nresident memory grew by " << grown
            << " MiB in 80 turns\n";
  CONTRACT_CHECK(grown < 4.0, grown << " MiB");
}
}

VTK_INDIRECT_TEST(Toggle)
{
  CheckToggle(nullptr);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ToggleSplatting)
{
  vtkNew<vtkIndirectSplattingPass> splatting;
  for (const char* paths : { "splats=blend", "splats=tiles" })
  {
    setenv("VTK_INDIRECT_PATHS", paths, 1);
    CheckToggle(splatting);
  }
  unsetenv("VTK_INDIRECT_PATHS");
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ToggleProxies)
{
  vtkNew<vtkEnvironmentLight> sky;
  for (const char* paths : { "splats=blend", "splats=tiles" })
  {
    setenv("VTK_INDIRECT_PATHS", paths, 1);
    vtkNew<vtkProxyAccumulationPass> proxies;
    CheckToggle(proxies, sky);
  }
  unsetenv("VTK_INDIRECT_PATHS");
}

//------------------------------------------------------------------------------
// Spheres in place of the sky's maps, while they move, leave nothing behind.
VTK_INDIRECT_TEST(ToggleSphereMotion)
{
  View view(160, 120);
  AddRoomSurfaces(view.Renderer);
  view.Renderer->RemoveAllViewProps();
  view.Renderer->AddActor(MakeQuad({ 0, 0, 1 }, { 1, 0, 1 }, { 0, 0, 0 }));
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < 5; ++i)
  {
    points->InsertNextPoint(0.1 + 0.2 * static_cast<double>(i), 0.2, 0.5);
    cells->InsertNextCell(1, &i);
  }
  data->SetPoints(points);
  data->SetVerts(cells);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetRadius(0.1f);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  view.Renderer->AddActor(actor);
  vtkNew<vtkEnvironmentLight> sky;
  vtkNew<vtkIndirectIlluminationPass> pass;
  Names first[3];
  double bytes[2] = { 0.0, 0.0 };
  for (int turn = 0; turn < 6; ++turn)
  {
    Names names[3];
    view.Renderer->SetPass(pass);
    pass->SetEnvironment(sky);
    for (int frame = 0; frame < 4; ++frame)
    {
      points->SetPoint(0, 0.1, 0.2 + 0.02 * frame, 0.5);
      points->Modified();
      data->Modified();
      view.Window->Render();
    }
    CONTRACT_CHECK(!Report(pass).FindReason("modelled", "sky by spheres").empty(), "no spheres");
    names[0] = CountNames(view.Window);
    // Without a sky what was held for it is gone.
    pass->SetEnvironment(nullptr);
    view.Window->Render();
    names[1] = CountNames(view.Window);
    view.Renderer->SetPass(nullptr);
    view.Window->Render();
    names[2] = CountNames(view.Window);
    for (int i = 0; i < 3 && turn > 0; ++i)
    {
      first[i] = turn == 1 ? names[i] : first[i];
      CONTRACT_CHECK(names[i] == first[i],
        "turn " << turn << ", " << i << ": " << names[i] << " after " << first[i]);
    }
    bytes[turn > 0] = static_cast<double>(names[0].Textures - names[1].Textures);
  }
  std::cout << first[0] << "\n" << first[1] << "\n" << first[2] << "\n";
  CONTRACT_CHECK(bytes[1] >= 10.0, "only " << bytes[1] << " textures go with the sky");
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ToggleMultiresolution)
{
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  CheckToggle(splatting);
}

//------------------------------------------------------------------------------
// Multiresolution splatting lets go of its pyramids, buffers and programs whatever its settings
// were, is the same after it, after a resize, and in a second window.
VTK_INDIRECT_TEST(ReleaseMultiresolution)
{
  View view(160, 120);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  pass->SetEstimator(splatting);
  view.Renderer->UseFXAAOn(); // VTK's own quad: it keeps the buffer of its first one
  view.Window->Render();
  const Names before = CountNames(view.Window);
  Pixels first;
  for (int turn = 0; turn < 3; ++turn)
  {
    view.Renderer->SetPass(pass);
    SET_DETAIL(splatting, HalfFloats, false);
    const double lighting = splatting->GetDetails().LightingThreshold;
    SET_DETAIL(splatting, LightingThreshold, 0.0);
    splatting->SetFinestLevelToHalfResolution();
    view.Window->Render();
    SET_DETAIL(splatting, HalfFloats, true);
    SET_DETAIL(splatting, LightingThreshold, lighting);
    splatting->SetFinestLevelToFullResolution();
    // Fewer levels, then more.
    for (const auto& size : { std::array<int, 2>{ 41, 1 }, { 321, 203 }, { 160, 120 } })
    {
      view.Window->SetSize(size[0], size[1]);
      view.Window->Render();
    }
    const Pixels picture = Grab(view.Window, false);
    first = turn == 0 ? picture : first;
    CONTRACT_CHECK(Compare(picture, first).Max == 0.0, "picture of turn " << turn);
    const Names during = CountNames(view.Window);
    pass->ReleaseGraphicsResources(view.Window);
    view.Renderer->SetPass(nullptr);
    view.Window->Render();
    const Names after = CountNames(view.Window);
    std::cout << "before: " << before << "\nduring: " << during << "\nafter: " << after << "\n";
    CONTRACT_CHECK(during.Textures > before.Textures + 16, "nothing was allocated");
    CONTRACT_CHECK(during.Buffers > before.Buffers + 1, "no lights, no lists");
    CheckGivenBack(before, after);
  }
  View other(160, 120);
  AddRoom(other.Renderer);
  vtkNew<vtkIndirectIlluminationPass> fresh;
  vtkNew<vtkMultiresolutionSplattingPass> freshSplatting;
  fresh->SetEstimator(freshSplatting);
  view.Renderer->SetPass(pass);
  other.Renderer->SetPass(fresh);
  other.Renderer->UseFXAAOn();
  for (int i = 0; i < 2; ++i)
  {
    CONTRACT_CHECK(Compare(first, other.Grab()).Max == 0.0, "other window, turn " << i);
    CONTRACT_CHECK(Compare(first, view.Grab()).Max == 0.0, "this window, turn " << i);
  }
}

//------------------------------------------------------------------------------
// Radiance hints hold more than other estimators: fields, tables and voxels.
VTK_INDIRECT_TEST(ToggleHints)
{
  View view(160, 120);
  AddRoom(view.Renderer);
  view.Window->Render();
  const Names before = CountNames(view.Window);
  vtkNew<vtkIndirectIlluminationPass> pass;
  vtkNew<vtkRadianceHintsPass> hints;
  hints->SetGridResolution(6, 5, 6);
  pass->SetEstimator(hints);
  pass->SetNumberOfBounces(2);
  Names first[2];
  Pixels picture;
  for (int i = 0; i < 12; ++i)
  {
    view.Renderer->SetPass(pass);
    hints->SetOrder(i % 2 ? 2 : 3);
    view.Window->Render();
    hints->SetOrder(2);
    SET_DETAIL(hints, FromHints, true);
    view.Window->Render();
    SET_DETAIL(hints, FromHints, false);
    view.Window->Render();
    const Names on = CountNames(view.Window);
    const Pixels with = Grab(view.Window, false);
    view.Renderer->SetPass(nullptr);
    pass->ReleaseGraphicsResources(view.Window);
    view.Window->Render();
    const Names off = CountNames(view.Window);
    CONTRACT_CHECK(off.Textures == before.Textures && off.Framebuffers == before.Framebuffers,
      "released, turn " << i << ": " << off << " after " << before);
    if (i == 0)
    {
      picture = with;
    }
    if (i == 2)
    {
      // By now the window's shader cache holds every variant.
      first[0] = on;
      first[1] = off;
    }
    if (i > 2)
    {
      CONTRACT_CHECK(on == first[0], "on, turn " << i << ": " << on << " after " << first[0]);
      CONTRACT_CHECK(off == first[1], "off, turn " << i << ": " << off << " after " << first[1]);
    }
    CONTRACT_CHECK(Compare(with, picture).Max == 0.0, "picture with, turn " << i);
  }
  std::cout << "on: " << first[0] << "\noff: " << first[1] << "\n";
}

//------------------------------------------------------------------------------
// A new pass object at every turn. A pass that is destroyed leaves nothing behind, whether it was
// released before or not.
VTK_INDIRECT_TEST(ToggleNewPass)
{
  View view(160, 120);
  AddRoom(view.Renderer);
  view.Window->Render();
  Names reference;
  for (int i = 0; i < 10; ++i)
  {
    {
      vtkNew<vtkIndirectIlluminationPass> pass;
      view.Renderer->SetPass(pass);
      view.Window->Render();
      if (i % 2)
      {
        pass->ReleaseGraphicsResources(view.Window);
      }
      view.Renderer->SetPass(nullptr);
    }
    view.Window->Render();
    const Names names = CountNames(view.Window);
    if (i == 1)
    {
      reference = names;
    }
    CONTRACT_CHECK(
      i < 2 || names == reference, "turn " << i << ": " << names << " after " << reference);
  }
  std::cout << reference << "\n";
}

//------------------------------------------------------------------------------
// ReleaseGraphicsResources gives back all textures, framebuffers and buffers; programs are the
// window's own cache's.
VTK_INDIRECT_TEST(Release)
{
  View view(160, 120);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  // All that could be allocated.
  vtkNew<vtkRSMGatherPass> gather;
  vtkNew<vtkUniformLightSampler> sampler;
  pass->SetEstimator(gather);
  pass->SetSampler(sampler);
  view.Renderer->UseFXAAOn();
  view.Window->Render();
  const Names before = CountNames(view.Window);
  for (int turn = 0; turn < 3; ++turn)
  {
    view.Renderer->SetPass(pass);
    for (int mode : { vtkRSMGatherPass::VIRTUAL_LIGHTS, vtkRSMGatherPass::NEIGHBORHOOD })
    {
      gather->SetMode(mode);
      gather->SetNumberOfSamples(16);
      view.Window->Render();
      for (const char* name : { "final", "rsm0.density", "depth" })
      {
        Read(pass, name);
      }
    }
    pass->SetDebugView("normal");
    view.Window->Render();
    pass->SetDebugView("");
    const Names during = CountNames(view.Window);
    pass->ReleaseGraphicsResources(view.Window);
    // VTK's own rendering has some names of its own in use.
    view.Renderer->SetPass(nullptr);
    view.Window->Render();
    const Names after = CountNames(view.Window);
    std::cout << "before: " << before << "\nduring: " << during << "\nafter: " << after << "\n";
    CONTRACT_CHECK(during.Textures > before.Textures + 8, "nothing was allocated");
    CheckGivenBack(before, after);
  }
  view.Renderer->SetPass(pass);

  // It works again.
  view.Renderer->UseFXAAOff();
  const Pixels again = view.Grab();
  View other(160, 120);
  AddRoom(other.Renderer);
  vtkNew<vtkIndirectIlluminationPass> fresh;
  vtkNew<vtkRSMGatherPass> freshGather;
  freshGather->SetModeToNeighborhood();
  freshGather->SetNumberOfSamples(16);
  fresh->SetEstimator(freshGather);
  other.Renderer->SetPass(fresh);
  const Difference difference = Compare(again, other.Grab());
  CONTRACT_CHECK(difference.Max == 0.0, "after release: " << difference);
}

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
// Estimators that the pass has exchanged for another know when their window closes. Later they
// neither draw with its names nor delete what the next context calls by them.
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
// A window that is closed while the pass is not in any renderer takes what the pass holds along.
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
    // The pass first: the renderer holds it, the program does not.
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
    // The renderer leaves its window, and comes back.
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
    // Props that die while a pass knows them.
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
    // Reading one while the other is current.
    CONTRACT_CHECK(Compare(Read(passes[0], "final"), Read(passes[1], "final")).Max == 0.0,
      "buffers, frame " << i);
  }
  // Now one for both.
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
  // In both at once: slow, and right.
  second.Renderer->SetPass(passes[0]);
  for (int i = 0; i < 2; ++i)
  {
    CONTRACT_CHECK(Compare(alone, first.Grab()).Max == 0.0, "shared, first, turn " << i);
    CONTRACT_CHECK(Compare(alone, second.Grab()).Max == 0.0, "shared, second, turn " << i);
  }
}
