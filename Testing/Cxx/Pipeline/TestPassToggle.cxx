// SPDX-License-Identifier: BSD-3-Clause
// Switching the pass on and off repeatedly gives the same pictures, and resources do not
// accumulate.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"
#include "vtkIndirectDetails.h"
#include "vtkIndirectGLNames.h"

#include "vtkCellArray.h"
#include "vtkEnvironmentLight.h"
#include "vtkIndirectSplattingPass.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProxyAccumulationPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"

#include <cstdlib>
#include <fstream>
#include <unistd.h>

using namespace contract;

namespace
{
// A row of five spheres of one mapper.
struct RowOfSpheres
{
  vtkNew<vtkPolyData> Data;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkActor> Actor;

  RowOfSpheres()
  {
    vtkNew<vtkCellArray> cells;
    for (vtkIdType i = 0; i < 5; ++i)
    {
      this->Points->InsertNextPoint(0.1 + 0.2 * static_cast<double>(i), 0.2, 0.5);
      cells->InsertNextCell(1, &i);
    }
    this->Data->SetPoints(this->Points);
    this->Data->SetVerts(cells);
    vtkNew<vtkOpenGLSphereMapper> mapper;
    mapper->SetInputData(this->Data);
    mapper->SetRadius(0.1f);
    this->Actor->SetMapper(mapper);
  }
};

double GetResidentMegabytes()
{
  std::ifstream statm("/proc/self/statm");
  double total = 0.0;
  double resident = 0.0;
  statm >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20);
}

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
  for (const char* paths : { "compute=off", "compute=on" })
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
  for (const char* paths : { "compute=off", "compute=on" })
  {
    setenv("VTK_INDIRECT_PATHS", paths, 1);
    vtkNew<vtkProxyAccumulationPass> proxies;
    CheckToggle(proxies, sky);
  }
  unsetenv("VTK_INDIRECT_PATHS");
}

//------------------------------------------------------------------------------
// Moving spheres, which replace the sky's maps, leave no resources behind.
VTK_INDIRECT_TEST(ToggleSphereMotion)
{
  View view(160, 120);
  AddRoomSurfaces(view.Renderer);
  view.Renderer->RemoveAllViewProps();
  view.Renderer->AddActor(MakeQuad({ 0, 0, 1 }, { 1, 0, 1 }, { 0, 0, 0 }));
  RowOfSpheres row;
  view.Renderer->AddActor(row.Actor);
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
      row.Points->SetPoint(0, 0.1, 0.2 + 0.02 * frame, 0.5);
      row.Points->Modified();
      row.Data->Modified();
      view.Window->Render();
    }
    CONTRACT_CHECK(!Report(pass).FindReason("modelled", "sky by spheres").empty(), "no spheres");
    names[0] = CountNames(view.Window);
    // Without a sky its resources are released.
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
// Nor do spheres that block light between senders and receivers.
VTK_INDIRECT_TEST(ToggleSphereBlockers)
{
  View view(64, 48);
  AddRoom(view.Renderer);
  RowOfSpheres row;
  view.Renderer->AddActor(row.Actor);
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->SetVisibilityToVoxels();
  vtkNew<vtkRSMGatherPass> gather;
  pass->SetEstimator(gather);
  vtkNew<vtkInformation> keys;
  Names first[3];
  for (int turn = 0; turn < 4; ++turn)
  {
    Names names[3];
    view.Renderer->SetPass(pass);
    row.Actor->SetPropertyKeys(nullptr);
    view.Window->Render();
    CONTRACT_CHECK(Report(pass)
                     .FindReason("modelled", "visibility between sender and receiver")
                     .find("5 spheres of the data") != std::string::npos,
      "no spheres");
    names[0] = CountNames(view.Window);
    // The spheres are still drawn.
    keys->Set(vtkIndirectIlluminationPass::CASTS_SHADOWS(), 0);
    row.Actor->SetPropertyKeys(keys);
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
  }
  std::cout << first[0] << "\n" << first[1] << "\n" << first[2] << "\n";
  CONTRACT_CHECK(
    first[0].Textures - first[1].Textures == 2, "lists and spheres go with the spheres");
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ToggleMultiresolution)
{
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  CheckToggle(splatting);
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
// A new pass object at every turn. A destroyed pass leaves no resources behind, whether or not it
// was released before.
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
