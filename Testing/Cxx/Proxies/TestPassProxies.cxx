// SPDX-License-Identifier: BSD-3-Clause
// vtkProxyAccumulationPass in use: by itself on a renderer, its report, its messages about wrong
// input.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkEnvironmentLight.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkProxyAccumulationPass.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

using namespace contract;

namespace
{
struct ProxyView : View
{
  vtkNew<vtkProxyAccumulationPass> Proxies;
  vtkNew<vtkEnvironmentLight> Sky;
  vtkNew<vtkPolyData> Points;

  explicit ProxyView(int width = 80, int height = 60)
    : View(width, height)
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
  // Without visibility the whole sky counts.
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
// Without groups the environment determines the spheres' reach, unless it is set.
VTK_INDIRECT_TEST(ProxiesReachOfTheSky)
{
  ProxyView view;
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(view.Points);
  mapper->SetScaleArray("size");
  view.Add(mapper);
  const auto hides = [&view]()
  { return Report(view.GetPass()).GetNumber("settings.InfluenceScale"); };
  const auto sends = [&view]()
  { return Report(view.GetPass()).GetNumber("settings.IndirectInfluenceScale"); };
  CONTRACT_CHECK(view.Proxies->GetInfluenceScale() == 0.0, view.Proxies->GetInfluenceScale());
  view.Grab();
  CONTRACT_CHECK(hides() == 0.0, "groups end nowhere");
  view.Proxies->GroupsOff();
  view.Grab();
  const double uniform = hides();
  CONTRACT_CHECK(uniform > 16.0 && uniform < 17.5, uniform);
  CONTRACT_CHECK(sends() > 16.0, sends());
  const std::string chosen = Report(view.GetPass()).FindReason("modelled", "light from the sky");
  CONTRACT_CHECK(chosen.find("chosen") != std::string::npos, chosen);
  const Floats before = Read(view.GetPass(), "sky");
  // A brighter sky has the same reach; one with a sun has another.
  view.Sky->SetScale(3.0);
  view.Grab();
  CONTRACT_CHECK(std::abs(hides() - uniform) < 1e-2, hides());
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 8, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  for (vtkIdType i = 0; i < 16 * 8 * 3; ++i)
  {
    static_cast<float*>(image->GetScalarPointer())[i] = i / 3 == 16 * 6 + 5 ? 100.0f : 0.1f;
  }
  view.Sky->SetImage(image);
  view.Grab();
  CONTRACT_CHECK(hides() > 1.2 * uniform, hides());
  // The paper's reach.
  view.Sky->SetImage(nullptr);
  view.Sky->SetScale(1.0);
  view.Proxies->SetInfluenceScale(15.0);
  view.Proxies->SetIndirectInfluenceScale(4.0);
  view.Grab();
  CONTRACT_CHECK(hides() == 15.0 && sends() == 4.0, "what is set is not used");
  const std::string set = Report(view.GetPass()).FindReason("modelled", "light from the sky");
  CONTRACT_CHECK(set.find("15 radii (as set)") != std::string::npos, set);
  view.Proxies->SetInfluenceScale(0.0);
  view.Grab();
  CONTRACT_CHECK(Compare(Read(view.GetPass(), "sky"), before).Max < 1e-6, "it is not as before");
  view.Proxies->SetInfluenceScale(1.0);
  CONTRACT_CHECK(view.Proxies->GetInfluenceScale() == 2.0, view.Proxies->GetInfluenceScale());
}

//------------------------------------------------------------------------------
// The same three spheres, beside one of the room, by every mapper that draws spheres.
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
    // The surface behind all spheres, in a corner of the picture.
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

//------------------------------------------------------------------------------
// An open sheet has no spheres: it hides nothing, and one warning reports it.
VTK_INDIRECT_TEST(ProxiesRefuseSheets)
{
  ProxyView view;
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(16, 16);
  plane->Update();
  vtkNew<vtkPolyData> hills;
  hills->DeepCopy(plane->GetOutput());
  for (vtkIdType i = 0; i < hills->GetNumberOfPoints(); ++i)
  {
    double p[3];
    hills->GetPoint(i, p);
    hills->GetPoints()->SetPoint(
      i, p[0] + 0.5, 0.2 + 0.1 * std::sin(9.0 * p[0]) * std::sin(7.0 * p[1]), 0.5 - p[1]);
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(hills);
  vtkSmartPointer<vtkActor> actor = view.Add(mapper);
  {
    ExpectedErrors errors;
    view.Grab();
    actor->GetProperty()->SetColor(0.5, 0.6, 0.7);
    view.Grab();
    CONTRACT_CHECK(errors.GetCount() == 1, errors.GetText());
    CONTRACT_CHECK(errors.GetText().find("open sheets") != std::string::npos, errors.GetText());
  }
  CONTRACT_CHECK(Report(view.GetPass()).FindReason("left_out", "a mesh of vtkOpenGLActor") != "",
    "the report does not say so");
}

//------------------------------------------------------------------------------
// Neither the sky nor senders around a body reach a camera inside the body, whether compute shaders
// or blended rectangles sum.
VTK_INDIRECT_TEST(ProxiesAreDarkInsideABody)
{
  for (const char* paths : { "compute=on", "compute=off" })
  {
    setenv("VTK_INDIRECT_PATHS", paths, 1);
    ProxyView view;
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(0.5, 0.5, 0.5);
    ball->SetRadius(0.3);
    ball->SetThetaResolution(24);
    ball->SetPhiResolution(24);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    view.Add(mapper);
    view.Grab();
    CONTRACT_CHECK(Mean(Read(view.GetPass(), "bounce"), 0) > 0.01, "outside, " << paths);
    vtkCamera* camera = view.Renderer->GetActiveCamera();
    camera->SetPosition(0.5, 0.55, 0.6);
    camera->SetFocalPoint(0.5, 0.5, 0.0);
    camera->SetClippingRange(0.01, 10.0);
    view.Grab();
    for (const char* light : { "sky", "bounce" })
    {
      const double mean = Mean(Read(view.GetPass(), light), 0);
      CONTRACT_CHECK(mean < 0.001, light << ", " << paths << ": " << mean << " of the open sky");
    }
  }
  unsetenv("VTK_INDIRECT_PATHS");
}

//------------------------------------------------------------------------------
// Receivers are closer if spheres are small; a camera that oscillates about that limit keeps one
// step.
VTK_INDIRECT_TEST(ProxiesStepIsSteady)
{
  ProxyView view(256, 192);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(view.Points);
  mapper->SetScaleArray("size");
  view.Add(mapper);
  vtkCamera* camera = view.Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.5, 0.3, 0.5);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetViewAngle(30.0);
  constexpr double distance = 1.5;
  const auto renderFrom = [&](double share)
  {
    camera->SetPosition(0.5, 0.3, 0.5 + share * distance);
    view.Grab();
    return static_cast<int>(Report(view.GetPass()).GetNumber("settings.ReceiverStep"));
  };
  // Receivers of 2 pixels: at this size there is one in every second pixel, or in every pixel.
  const double pixel = 2.0 * distance * std::tan(vtkMath::RadiansFromDegrees(15.0)) / 192.0;
  auto* sizes = vtkFloatArray::SafeDownCast(view.Points->GetPointData()->GetArray("size"));
  sizes->FillValue(static_cast<float>(2.0 * pixel));
  sizes->Modified();
  view.Points->Modified();
  const int first = renderFrom(1.05);
  CONTRACT_CHECK(first == 1, "spheres below 2 pixels have " << first);
  for (const double share : { 0.95, 1.05, 0.97, 1.02, 0.92 })
  {
    const int step = renderFrom(share);
    CONTRACT_CHECK(step == 1, "from " << share << " of the distance the step is " << step);
  }
  const int near = renderFrom(0.7);
  CONTRACT_CHECK(near == 2, "nearby the step is " << near);
  for (const double share : { 1.05, 0.95, 1.1 })
  {
    const int step = renderFrom(share);
    CONTRACT_CHECK(step == 2, "back at " << share << " of the distance the step is " << step);
  }
  const int far = renderFrom(1.4);
  CONTRACT_CHECK(far == 1, "far off the step is " << far);
}
