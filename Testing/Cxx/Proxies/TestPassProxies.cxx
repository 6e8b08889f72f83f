// SPDX-License-Identifier: BSD-3-Clause
// vtkProxyAccumulationPass as users meet it: by itself on a renderer, its report, what it says of
// wrong input.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkCellArray.h"
#include "vtkEnvironmentLight.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProxyAccumulationPass.h"
#include "vtkSphereSource.h"

#include <limits>

using namespace contract;

namespace
{
struct ProxyView : View
{
  vtkNew<vtkProxyAccumulationPass> Proxies;
  vtkNew<vtkEnvironmentLight> Sky;
  vtkNew<vtkPolyData> Points;

  ProxyView()
    : View(80, 60)
  {
    AddRoomSurfaces(this->Renderer);
    this->Renderer->AutomaticLightCreationOff();
    this->Proxies->GetIlluminationPass()->SetEnvironment(this->Sky);
    this->Renderer->SetPass(this->Proxies);
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> sizes;
    sizes->SetName("size");
    vtkNew<vtkCellArray> cells;
    for (vtkIdType i = 0; i < 3; ++i)
    {
      points->InsertNextPoint(0.2 + 0.3 * static_cast<double>(i), 0.3, 0.5);
      sizes->InsertNextValue(0.1f);
      cells->InsertNextCell(1, &i);
    }
    this->Points->SetPoints(points);
    this->Points->SetVerts(cells);
    this->Points->GetPointData()->AddArray(sizes);
  }
  ~ProxyView() { this->Proxies->GetIlluminationPass()->SetEnvironment(nullptr); }

  vtkIndirectIlluminationPass* GetPass() { return this->Proxies->GetIlluminationPass(); }

  vtkSmartPointer<vtkActor> Add(vtkMapper* mapper)
  {
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    return actor;
  }
};
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ProxiesAlone)
{
  ProxyView view;
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(view.Points);
  mapper->SetScaleArray("size");
  view.Add(mapper);
  view.Grab();
  CONTRACT_CHECK(view.Proxies->GetNumberOfSpheres() == 4, view.Proxies->GetNumberOfSpheres());
  CONTRACT_CHECK(view.Proxies->GetNumberOfPolygons() >= 3, view.Proxies->GetNumberOfPolygons());
  const Report report(view.GetPass());
  CONTRACT_CHECK(report.Get("method") == "proxies", report.GetText());
  CONTRACT_CHECK(!report.FindReason("modelled", "what hides the sky").empty(), report.GetText());
  CONTRACT_CHECK(
    !report.FindReason("modelled", "one bounce of light from the sky").empty(), report.GetText());
  CONTRACT_CHECK(Mean(Read(view.GetPass(), "sky"), 0) > 0.1,
    "the sky gives " << Mean(Read(view.GetPass(), "sky"), 0));
  CONTRACT_CHECK(Mean(Read(view.GetPass(), "bounce"), 0) > 0.01, "nothing is reflected");
  // Without what hides it, all of it is there.
  const double hidden = Mean(Read(view.GetPass(), "sky"), 0);
  view.GetPass()->SetVisibilityToNone();
  view.Grab();
  CONTRACT_CHECK(Mean(Read(view.GetPass(), "sky"), 0) > 1.1 * hidden, "nothing hid the sky");
  // Without an environment there is nothing to sum.
  view.GetPass()->SetEnvironment(nullptr);
  vtkNew<vtkLight> light;
  view.Renderer->AddLight(light);
  view.Grab();
  const Report none(view.GetPass());
  CONTRACT_CHECK(
    none.FindReason("left_out", "indirect light").find("no environment") != std::string::npos,
    none.GetText());
}

//------------------------------------------------------------------------------
// The same three spheres, beside one of the room, by every mapper that draws such.
VTK_INDIRECT_TEST(ProxiesOfMappers)
{
  vtkNew<vtkOpenGLSphereMapper> spheres;
  spheres->SetRadius(0.1f);
  vtkNew<vtkGlyph3DMapper> glyphs;
  vtkNew<vtkSphereSource> source;
  source->SetRadius(0.05);
  source->SetThetaResolution(24);
  source->SetPhiResolution(24);
  glyphs->SetSourceConnection(source->GetOutputPort());
  glyphs->SetScaleFactor(20.0);
  glyphs->SetScaleArray("size");
  glyphs->SetScaleModeToScaleByMagnitude();
  vtkNew<vtkPointGaussianMapper> splats;
  splats->SetScaleFactor(1.0);
  splats->SetScaleArray("size");
  splats->EmissiveOff();
  splats->SetSplatShaderCode("//VTK::Color::Impl\n"
                             "float dist = dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy);\n"
                             "if (dist > 1.0) { discard; }\n");
  Floats first;
  int count = 0;
  for (vtkMapper* mapper : std::initializer_list<vtkMapper*>{ spheres, glyphs, splats })
  {
    ProxyView view;
    mapper->SetInputDataObject(view.Points);
    vtkSmartPointer<vtkActor> actor = view.Add(mapper);
    actor->SetPosition(0.0, 0.1, 0.0);
    view.Grab();
    CONTRACT_CHECK(view.Proxies->GetNumberOfSpheres() == 4,
      mapper->GetClassName() << ": " << view.Proxies->GetNumberOfSpheres());
    // On what is behind them all, in a corner of the picture.
    const Floats sky = Read(view.GetPass(), "sky");
    if (count++ == 0)
    {
      first = sky;
    }
    double off = 0.0;
    for (int y = 0; y < 12; ++y)
    {
      for (int x = 0; x < 80; ++x)
      {
        off = std::max(off, std::abs(static_cast<double>(sky.Get(x, y, 0)) - first.Get(x, y, 0)));
      }
    }
    CONTRACT_CHECK(off < 2e-3, mapper->GetClassName() << " differs by " << off);
    view.Renderer->RemoveActor(actor);
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ProxiesWrongInput)
{
  for (const float wrong :
    { -0.1f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity() })
  {
    ProxyView view;
    vtkNew<vtkOpenGLSphereMapper> mapper;
    mapper->SetInputData(view.Points);
    mapper->SetScaleArray("size");
    vtkSmartPointer<vtkActor> actor = view.Add(mapper);
    view.Grab();
    const Floats right = Read(view.GetPass(), "sky");
    auto* sizes = vtkFloatArray::SafeDownCast(view.Points->GetPointData()->GetArray("size"));
    sizes->SetValue(1, wrong);
    sizes->Modified();
    view.Points->Modified();
    {
      ExpectedErrors errors;
      view.Grab();
      view.Grab();
      CONTRACT_CHECK(errors.GetCount() == 1, errors.GetText());
      CONTRACT_CHECK(errors.GetText().find("1 spheres of") != std::string::npos, errors.GetText());
    }
    CONTRACT_CHECK(view.Proxies->GetNumberOfSpheres() == 3, view.Proxies->GetNumberOfSpheres());
    const Floats left = Read(view.GetPass(), "sky");
    CONTRACT_CHECK(IsFinite(left) && Compare(left, right).Max > 0.0, "the image suffers");
  }
  vtkNew<vtkProxyAccumulationPass> pass;
  vtkNew<vtkActor> actor;
  vtkNew<vtkPolyData> data;
  ExpectedErrors errors;
  pass->SetProxies(nullptr, data);
  pass->SetProxies(actor, data);
  CONTRACT_CHECK(errors.GetCount() == 2, errors.GetText());
  CONTRACT_CHECK(!pass->GetProxies(actor), "wrong spheres are kept");
}
