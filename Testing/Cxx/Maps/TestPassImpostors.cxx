// SPDX-License-Identifier: BSD-3-Clause
// Spheres drawn by a shader cast shadows and send light as spheres of triangles do.
#include "vtkIndirectContractUtilities.h"

#include "vtkCellArray.h"
#include "vtkEnvironmentLight.h"
#include "vtkGlyph3DMapper.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

#include <cmath>

using namespace contract;

VTK_INDIRECT_TEST(ImpostorsSendAsMeshes)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.06);
  ball->SetThetaResolution(48);
  ball->SetPhiResolution(48);
  vtkNew<vtkEnvironmentLight> sky;
  for (const bool lamp : { false, true })
  {
    double bounce[2] = { 0.0, 0.0 };
    for (const bool mesh : { false, true })
    {
      View view(80, 60);
      view.Renderer->AutomaticLightCreationOff();
      view.Renderer->AddActor(MakeQuad({ -1, 0, 1 }, { 1, 0, 1 }, { -1, 0, -1 }, { 0, 0, 0 }));
      vtkNew<vtkPoints> points;
      vtkNew<vtkCellArray> cells;
      for (vtkIdType i = 0; i < 49; ++i)
      {
        points->InsertNextPoint(-0.6 + 0.2 * static_cast<double>(i % 7),
          0.2 + 0.05 * static_cast<double>(i % 3), -0.6 + 0.2 * static_cast<double>(i / 7));
        cells->InsertNextCell(1, &i);
      }
      vtkNew<vtkPolyData> data;
      data->SetPoints(points);
      data->SetVerts(cells);
      vtkNew<vtkOpenGLSphereMapper> impostors;
      impostors->SetRadius(0.06f);
      impostors->SetInputData(data);
      vtkNew<vtkGlyph3DMapper> glyphs;
      glyphs->SetSourceConnection(ball->GetOutputPort());
      glyphs->SetInputData(data);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mesh ? static_cast<vtkMapper*>(glyphs) : impostors);
      view.Renderer->AddActor(actor);
      if (lamp)
      {
        view.Renderer->AddLight(MakeLight(LightKind::Spot, { 0.5, 1.5, 1.0 }, { 0.0, 0.2, 0.0 }));
      }
      view.Renderer->GetActiveCamera()->SetPosition(0.0, 1.2, 2.6);
      view.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.2, 0.0);
      view.Renderer->ResetCameraClippingRange();
      vtkNew<vtkIndirectIlluminationPass> pass;
      pass->SetNumberOfBounces(1);
      pass->SetVisibilityToNone();
      pass->SetEnvironment(lamp ? nullptr : sky.Get());
      view.Renderer->SetPass(pass);
      view.Grab();
      bounce[mesh] = Mean(Read(pass, "bounce"), 0);
      pass->SetEnvironment(nullptr);
    }
    std::cout << (lamp ? "lamp: " : "sky: ") << bounce[0] << " of impostors, " << bounce[1]
              << " of meshes\n";
    // 256 lights of a few texels a sphere. Slopes across discarded pixels of impostors would give
    // 15 times as much.
    CONTRACT_CHECK(bounce[1] > 1e-3 && std::abs(bounce[0] / bounce[1] - 1.0) < 0.1,
      bounce[0] << " in place of " << bounce[1]);
  }
}

//------------------------------------------------------------------------------
// Bounds of VTK's mappers hold the points of impostors alone: here a single point. Around it the
// ground is as dark as around a mesh.
VTK_INDIRECT_TEST(ImpostorsCastAsMeshes)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.3);
  ball->SetThetaResolution(96);
  ball->SetPhiResolution(96);
  vtkNew<vtkEnvironmentLight> sky;
  Floats seen[2];
  for (const bool mesh : { false, true })
  {
    View view(80, 60);
    view.Renderer->AutomaticLightCreationOff();
    view.Renderer->AddActor(MakeQuad({ -1, 0, 1 }, { 1, 0, 1 }, { -1, 0, -1 }, { 1, 1, 1 }));
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.0, 0.0, 0.0);
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({ 0 });
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetVerts(cells);
    vtkNew<vtkOpenGLSphereMapper> spheres;
    spheres->SetRadius(0.3f);
    spheres->SetInputData(data);
    vtkNew<vtkPolyDataMapper> triangles;
    triangles->SetInputConnection(ball->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mesh ? static_cast<vtkMapper*>(triangles) : spheres);
    actor->SetPosition(0.0, 0.31, 0.0);
    view.Renderer->AddActor(actor);
    view.Renderer->AddLight(MakeLight(LightKind::Spot, { 0.5, 2.0, 1.0 }, { 0.0, 0.2, 0.0 }));
    view.Renderer->GetActiveCamera()->SetPosition(0.0, 1.2, 2.6);
    view.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.2, 0.0);
    view.Renderer->ResetCameraClippingRange(-1, 1, 0, 1, -1, 1);
    vtkNew<vtkIndirectIlluminationPass> pass;
    pass->SetEnvironment(sky);
    view.Renderer->SetPass(pass);
    view.Grab();
    seen[mesh] = Read(pass, "sky");
    const Floats direct = Read(pass, "direct");
    for (size_t i = 0; i < direct.Values.size(); ++i)
    {
      seen[mesh].Values.push_back(direct.Values[i]);
    }
    pass->SetEnvironment(nullptr);
  }
  double off = 0.0;
  double sum = 0.0;
  for (size_t i = 0; i < seen[0].Values.size(); ++i)
  {
    off += std::abs(seen[0].Values[i] - seen[1].Values[i]);
    sum += seen[1].Values[i];
  }
  std::cout << off / sum << " of all light is elsewhere\n";
  // Pixels at silhouettes; maps that end at the point give 0.09.
  CONTRACT_CHECK(off < 0.02 * sum, off / sum);
}
