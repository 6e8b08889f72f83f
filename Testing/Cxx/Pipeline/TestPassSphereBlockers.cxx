// SPDX-License-Identifier: BSD-3-Clause
// Spheres between senders and receivers: errors are reported once, and the report lists the
// spheres' sources and other props.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkMolecule.h"
#include "vtkMoleculeMapper.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRSMGatherPass.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace contract;

namespace
{
// A ground, a light, and a prop drawn from points.
struct BlockerView : View
{
  vtkNew<vtkIndirectIlluminationPass> Pass;
  vtkNew<vtkRSMGatherPass> Gather;
  vtkNew<vtkActor> Actor;

  BlockerView()
    : View(64, 48)
  {
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->AddActor(MakeQuad({ -2, 0, 2 }, { 2, 0, 2 }, { -2, 0, -2 }));
    this->Renderer->AddActor(MakeQuad({ -2, 0, -2 }, { 2, 0, -2 }, { -2, 2, -2 }));
    this->Renderer->AddActor(this->Actor);
    this->Renderer->AddLight(MakeLight(LightKind::Spot, { 1.0, 2.5, 1.5 }, { 0.0, 0.3, 0.0 }));
    this->Pass->SetEstimator(this->Gather);
    this->Pass->SetVisibilityToVoxels();
    this->Renderer->SetPass(this->Pass);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 2.0, 4.5);
    camera->SetFocalPoint(0.0, 0.4, 0.0);
    camera->SetViewAngle(32.0);
    this->Renderer->ResetCameraClippingRange(-2.5, 2.5, -0.5, 2.0, -2.5, 2.5);
  }
  ~BlockerView() { this->Pass->SetEstimator(nullptr); }

  std::string GetWhat()
  {
    return Report(this->Pass).FindReason("modelled", "visibility between sender and receiver");
  }
};
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(SphereBlockersWrongRadii)
{
  BlockerView view;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> sizes;
  sizes->SetName("size");
  vtkNew<vtkCellArray> cells;
  const float radii[] = { 0.2f, 0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(), 0.3f };
  for (vtkIdType i = 0; i < 5; ++i)
  {
    points->InsertNextPoint(0.5 * static_cast<double>(i) - 1.0, 0.4, 0.0);
    sizes->InsertNextValue(radii[i]);
    cells->InsertNextCell(1, &i);
  }
  data->SetPoints(points);
  data->SetVerts(cells);
  data->GetPointData()->AddArray(sizes);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScaleArray("size");
  view.Actor->SetMapper(mapper);
  {
    ExpectedErrors errors;
    view.Grab();
    view.Renderer->GetActiveCamera()->Azimuth(1.0);
    view.Grab();
    CONTRACT_CHECK(errors.GetCount() == 1, errors.GetCount() << " errors: " << errors.GetText());
    CONTRACT_CHECK(errors.GetText().find(
                     "2 spheres of vtkOpenGLActor (vtkOpenGLSphereMapper of vtkPolyData) have "
                     "radii that are negative or not finite") != std::string::npos,
      errors.GetText());
  }
  CONTRACT_CHECK(
    view.GetWhat().find("and segments against 2 spheres of the data") != std::string::npos,
    view.GetWhat());
  data->Initialize();
  view.Grab();
  CONTRACT_CHECK(view.GetWhat().find("spheres") == std::string::npos, view.GetWhat());
}

//------------------------------------------------------------------------------
// Atoms, and spheres inside of bonds.
VTK_INDIRECT_TEST(SphereBlockersOfMolecules)
{
  BlockerView view;
  vtkNew<vtkMolecule> molecule;
  for (int i = 0; i < 4; ++i)
  {
    molecule->AppendAtom(6, 0.5 * i - 0.75, 0.5, 0.0);
    if (i > 0)
    {
      molecule->AppendBond(static_cast<vtkIdType>(i - 1), static_cast<vtkIdType>(i), 1);
    }
  }
  auto mapper = vtkSmartPointer<vtkMoleculeMapper>::New();
  mapper->SetInputData(molecule);
  mapper->SetBondRadius(0.05f);
  mapper->SetAtomicRadiusTypeToUnitRadius();
  mapper->SetAtomicRadiusScaleFactor(0.1f);
  view.Actor->SetMapper(mapper);
  view.Grab();
  // Half a bond is 0.25 long: five spheres a radius apart, for each of two halves.
  CONTRACT_CHECK(
    view.GetWhat().find("4 spheres of the data, 30 spheres of sticks") != std::string::npos,
    view.GetWhat());
  mapper->RenderBondsOff();
  view.Grab();
  CONTRACT_CHECK(
    view.GetWhat().find("4 spheres of the data, in") != std::string::npos, view.GetWhat());
  // An assembly of other props is still named.
  CONTRACT_CHECK(
    Report(view.Pass).FindReason("left_out", "vtkOpenGLActor").empty(), "its atoms block light");
}
