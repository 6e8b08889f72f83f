// SPDX-License-Identifier: BSD-3-Clause
// Casters in the lights' maps, and the shadows that follow.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractRoom.h"

#include "vtkAssembly.h"
#include "vtkBoxRepresentation.h"
#include "vtkCellArray.h"
#include "vtkCubeAxesActor.h"
#include "vtkCubeSource.h"
#include "vtkEnvironmentLight.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLightKit.h"
#include "vtkLineSource.h"
#include "vtkOutlineSource.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <functional>

using namespace contract;

namespace
{
double Sum(const Floats& image, int component)
{
  return Mean(image, component) * image.Width * image.Height;
}
}

//------------------------------------------------------------------------------
// A lit tube, made of a line, without occluders: it does not shadow itself.
VTK_INDIRECT_TEST(PropsTubes)
{
  Room room;
  const Pixels plainWithout = room.Grab(false);
  vtkNew<vtkLineSource> line;
  line->SetPoint1(0.2, 0.6, 0.55);
  line->SetPoint2(0.7, 0.7, 0.55);
  auto tube = MakeActor(line, { 0.9, 0.6, 0.2 });
  tube->GetProperty()->SetLineWidth(10);
  tube->GetProperty()->RenderLinesAsTubesOn();
  room.GetRenderer()->AddActor(tube);
  const Pixels plain = room.Grab(false);
  room.Pass->SetIndirectScale(0.0);
  const Pixels image = room.Grab(true);
  size_t seen = 0;
  double worst = 0.0;
  for (size_t i = 0; i < plain.Values.size() / 4; ++i)
  {
    if (Differs(plain, plainWithout, i))
    {
      ++seen;
      worst = std::max(worst, Distance(plain, image, i));
    }
  }
  std::cout << seen << " pixels of tube, off by " << worst << "\n";
  CONTRACT_CHECK(seen > 200, "no tube");
  CONTRACT_CHECK(worst <= 1.0, "the tube is shadowed: " << worst);
}

//------------------------------------------------------------------------------
// A receiver behind all casters: a tube below the gap between two tables is lit, and in shadow
// below the tables.
VTK_INDIRECT_TEST(PropsBehindCasters)
{
  for (LightKind kind : { LightKind::Directional, LightKind::Spot, LightKind::Point })
  {
    View view(160, 120);
    view.Renderer->AddActor(MakeQuad({ -1, 0, -0.5 }, { -1, 0, 0.5 }, { -0.3, 0, -0.5 }));
    view.Renderer->AddActor(MakeQuad({ 0.3, 0, -0.5 }, { 0.3, 0, 0.5 }, { 1, 0, -0.5 }));
    vtkNew<vtkLineSource> line;
    line->SetPoint1(-0.9, -1, 0);
    line->SetPoint2(0.9, -1, 0);
    auto tube = MakeActor(line);
    tube->GetProperty()->SetLineWidth(12);
    tube->GetProperty()->RenderLinesAsTubesOn();
    view.Renderer->AddActor(tube);
    view.Renderer->AddLight(MakeLight(kind, { 0, 4, 0 }, { 0, 0, 0 }));
    vtkCamera* camera = view.Renderer->GetActiveCamera();
    camera->SetPosition(0, -0.5, 5);
    camera->SetFocalPoint(0, -0.5, 0);
    camera->SetViewAngle(30);
    view.Renderer->ResetCameraClippingRange();
    const Pixels plain = view.Grab();
    vtkNew<vtkIndirectIlluminationPass> pass;
    pass->SetIndirectScale(0.0);
    view.Renderer->SetPass(pass);
    const Pixels image = view.Grab();
    // The tube's upper, lit side.
    const int row = 60 - static_cast<int>(0.5 * 120 / (2 * 5 * std::tan(0.2618))) + 3;
    const auto red = [row](const Pixels& of, double x)
    { return of.Get(80 + static_cast<int>(x * 120 / (2 * 5 * std::tan(0.2618))), row, 0); };
    std::cout << GetName(kind) << ": middle " << int(red(plain, 0)) << " and " << int(red(image, 0))
              << ", below a table " << int(red(plain, 0.7)) << " and " << int(red(image, 0.7))
              << "\n";
    CONTRACT_CHECK(red(plain, 0) > 60 && red(plain, 0.7) > 60, "the tube is not lit");
    CONTRACT_CHECK(std::abs(red(plain, 0) - red(image, 0)) <= 1, "shadow of nothing");
    CONTRACT_CHECK(red(image, 0.7) < 10, "no shadow of the table");
  }
}

//------------------------------------------------------------------------------
// After a change of data or mapper maps follow an actor in an assembly as one outside. Its bounds
// stay, so that they do not indicate the change.
VTK_INDIRECT_TEST(PropsChangeInAssemblies)
{
  Floats images[3][2][2]; // after changes, outside and inside, of two buffers
  for (int inside = 0; inside < 2; ++inside)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(-0.2, 0.5, 0.0);
    ball->SetRadius(0.4);
    ball->Update();
    vtkNew<vtkCubeSource> cube;
    cube->SetBounds(ball->GetOutput()->GetBounds());
    cube->Update();
    vtkNew<vtkPolyData> data;
    data->ShallowCopy(ball->GetOutput());
    vtkNew<vtkPolyDataMapper> mappers[2];
    mappers[0]->SetInputData(data);
    mappers[1]->SetInputConnection(ball->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mappers[0]);
    vtkNew<vtkAssembly> inner;
    inner->AddPart(actor);
    vtkNew<vtkAssembly> outer;
    outer->AddPart(inner);
    View view(64, 48);
    view.Renderer->AddActor(MakeQuad({ -1, 0, 1 }, { 1, 0, 1 }, { -1, 0, -1 }));
    view.Renderer->AddViewProp(inside ? static_cast<vtkProp*>(outer) : actor);
    view.Renderer->AddLight(MakeLight(LightKind::Spot, { 0.5, 3, 0.5 }, { 0, 0, 0 }));
    vtkCamera* camera = view.Renderer->GetActiveCamera();
    camera->SetPosition(0, 2, 3);
    camera->SetFocalPoint(0, 0.2, 0);
    view.Renderer->ResetCameraClippingRange(-1, 1, 0, 1, -1, 1);
    vtkNew<vtkIndirectIlluminationPass> pass;
    vtkNew<vtkEnvironmentLight> sky;
    pass->SetEnvironment(sky);
    view.Renderer->SetPass(pass);
    for (int change = 0; change < 3; ++change)
    {
      if (change == 1)
      {
        data->ShallowCopy(cube->GetOutput());
      }
      else if (change == 2)
      {
        actor->SetMapper(mappers[1]);
      }
      const long long before = CountOf(pass, "sky_tiles_drawn");
      view.Grab();
      const long long first = CountOf(pass, "sky_tiles_drawn");
      CONTRACT_CHECK(change == 0 || first > before, change << ": no map is drawn");
      // All maps are complete, and stay.
      view.Grab();
      view.Grab();
      CONTRACT_CHECK(CountOf(pass, "sky_tiles_drawn") == first, change << ": maps are drawn again");
      images[change][inside][0] = Read(pass, "direct");
      images[change][inside][1] = Read(pass, "sky");
    }
    pass->SetEnvironment(nullptr);
  }
  for (int change = 0; change < 3; ++change)
  {
    for (int i = 0; i < 2; ++i)
    {
      // Depths of the same triangles by other matrices, and pixels of a moved edge.
      const Difference off = Compare(images[change][0][i], images[change][1][i]);
      CONTRACT_CHECK(off.Max < 0.02, change << ", " << i << ": off by " << off.Max);
      CONTRACT_CHECK(
        change == 0 || Compare(images[change][0][i], images[change - 1][0][i]).Max > 0.05,
        change << ", " << i << ": nothing has changed");
    }
  }
}

//------------------------------------------------------------------------------
// Edges of faces: a map has the faces without them, and they cast no shadows onto the faces.
VTK_INDIRECT_TEST(PropsEdges)
{
  Floats density[2];
  Floats depth[2];
  for (bool edges : { false, true })
  {
    View view(100, 100);
    auto box = MakeBox({ -0.5, -0.5, -0.5 }, { 0.5, 0.5, 0.5 }, { 0.9, 0.2, 0.2 });
    box->GetProperty()->SetEdgeVisibility(edges);
    box->GetProperty()->SetLineWidth(5);
    view.Renderer->AddActor(box);
    view.Renderer->AddLight(MakeLight(LightKind::Spot, { 1.5, 2, 3 }, { 0, 0, 0 }));
    vtkNew<vtkIndirectIlluminationPass> pass;
    view.Renderer->SetPass(pass);
    view.Renderer->GetActiveCamera()->SetPosition(3, 2, 4);
    view.Renderer->ResetCamera();
    view.Grab();
    density[edges] = Read(pass, "rsm0.density");
    depth[edges] = Read(pass, "rsm0.depth");
  }
  CONTRACT_CHECK(Sum(density[0], 0) > 1.0, "nothing in the map");
  CONTRACT_CHECK(Compare(density[0], density[1]).Max == 0.0, Compare(density[0], density[1]));
  CONTRACT_CHECK(Compare(depth[0], depth[1]).Max == 0.0, Compare(depth[0], depth[1]));

  // A single box has no shadow on it except on sides that face away from the light.
  View view(200, 200);
  auto box = MakeBox({ -0.5, -0.5, -0.5 }, { 0.5, 0.5, 0.5 }, { 0.9, 0.2, 0.2 });
  box->GetProperty()->EdgeVisibilityOn();
  box->GetProperty()->SetLineWidth(3);
  view.Renderer->AddActor(box);
  view.Renderer->GetActiveCamera()->SetPosition(3, 2, 4);
  view.Renderer->ResetCamera();
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(view.Renderer);
  const Pixels plain = view.Grab();
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->AntialiasingOff(); // the same pixels as without the pass
  pass->SetIndirectScale(0.0);
  view.Renderer->SetPass(pass);
  const Pixels image = view.Grab();
  size_t wrong = 0;
  size_t seen = 0;
  for (size_t i = 0; i < plain.Values.size() / 4; ++i)
  {
    seen += plain.Values[4 * i] > 60 ? 1 : 0;
    wrong += plain.Values[4 * i] > 60 && Distance(plain, image, i) > 1.0 ? 1 : 0;
  }
  std::cout << "faces: " << seen << " pixels, " << wrong << " shadowed\n";
  CONTRACT_CHECK(seen > 5000, "no box");
  CONTRACT_CHECK(wrong == 0, wrong << " pixels of faces are shadowed");
}

//------------------------------------------------------------------------------
// Outlines, axes, widgets, labels, lines and points do not change the lights' maps.
VTK_INDIRECT_TEST(PropsAnnotation)
{
  using Add = std::function<vtkSmartPointer<vtkProp>(vtkRenderer*)>;
  const std::vector<std::pair<const char*, Add>> kinds = {
    { "outline",
      [](vtkRenderer*)
      {
        vtkNew<vtkOutlineSource> source;
        source->SetBounds(0.2, 0.8, 0.05, 0.45, 0.2, 0.6);
        return vtkSmartPointer<vtkProp>(MakeActor(source, { 1, 1, 0 }));
      } },
    { "cube axes",
      [](vtkRenderer* renderer)
      {
        auto axes = vtkSmartPointer<vtkCubeAxesActor>::New();
        axes->SetBounds(0.2, 0.8, 0.05, 0.45, 0.2, 0.6);
        axes->SetCamera(renderer->GetActiveCamera());
        return vtkSmartPointer<vtkProp>(axes);
      } },
    { "widget",
      [](vtkRenderer* renderer)
      {
        auto box = vtkSmartPointer<vtkBoxRepresentation>::New();
        double bounds[6] = { 0.2, 0.8, 0.05, 0.5, 0.2, 0.7 };
        box->PlaceWidget(bounds);
        box->SetRenderer(renderer);
        box->BuildRepresentation();
        box->VisibilityOn();
        return vtkSmartPointer<vtkProp>(box);
      } },
    { "follower",
      [](vtkRenderer* renderer)
      {
        vtkSmartPointer<vtkProp3D> follower = MakeFollower(renderer, 0.3);
        follower->SetPosition(0.4, 0.4, 0.6);
        return vtkSmartPointer<vtkProp>(follower);
      } },
    { "wireframe",
      [](vtkRenderer*)
      {
        auto sphere = MakeSphere({ 0.5, 0.5, 0.5 }, 0.3);
        sphere->GetProperty()->SetRepresentationToWireframe();
        return vtkSmartPointer<vtkProp>(sphere);
      } },
    { "anchors",
      [](vtkRenderer*)
      {
        vtkNew<vtkPoints> points;
        points->InsertNextPoint(0.3, 0.5, 0.5);
        points->InsertNextPoint(0.6, 0.6, 0.4);
        vtkNew<vtkCellArray> vertices;
        vertices->InsertNextCell({ 0, 1 });
        vtkNew<vtkPolyData> data;
        data->SetPoints(points);
        data->SetVerts(vertices);
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(data);
        auto anchors = vtkSmartPointer<vtkActor>::New();
        anchors->SetMapper(mapper);
        anchors->GetProperty()->SetPointSize(20);
        return vtkSmartPointer<vtkProp>(anchors);
      } },
  };
  Room room;
  room.Grab(true);
  const Floats depth = Read(room.Pass, "rsm0.depth");
  const vtkIdType faces = CountOf(room.Pass, "faces_drawn");
  for (const auto& kind : kinds)
  {
    vtkSmartPointer<vtkProp> prop = kind.second(room.GetRenderer());
    room.GetRenderer()->AddViewProp(prop);
    const Pixels plain = room.Grab(false);
    const Pixels image = room.Grab(true);
    CONTRACT_CHECK(
      Compare(depth, Read(room.Pass, "rsm0.depth")).Max == 0.0, kind.first << " is in the map");
    CONTRACT_CHECK(
      CountOf(room.Pass, "faces_drawn") == faces, kind.first << " had the map drawn anew");
    CheckReported(room.Pass, prop->GetClassName());
    room.GetRenderer()->RemoveViewProp(prop);
    CONTRACT_CHECK(Compare(plain, room.Grab(false)).Pixels > 20, kind.first << " is not seen");
  }
}

//------------------------------------------------------------------------------
// The two keys, for a sphere in the room, and with a headlight.
VTK_INDIRECT_TEST(PropsKeys)
{
  Room room;
  auto* sphere = vtkActor::SafeDownCast(room.GetRenderer()->GetActors()->GetItemAsObject(5));
  vtkNew<vtkInformation> keys;
  sphere->SetPropertyKeys(keys);
  room.Grab(true);
  const Floats depth = Read(room.Pass, "rsm0.depth");
  const Floats density = Read(room.Pass, "rsm0.density");

  keys->Set(vtkIndirectIlluminationPass::SENDS_LIGHT(), 0);
  room.Grab(true);
  const Floats silent = Read(room.Pass, "rsm0.density");
  CONTRACT_CHECK(
    Compare(depth, Read(room.Pass, "rsm0.depth")).Max == 0.0, "it still casts shadows");

  keys->Remove(vtkIndirectIlluminationPass::SENDS_LIGHT());
  keys->Set(vtkIndirectIlluminationPass::CASTS_SHADOWS(), 0);
  room.Grab(true);
  const Floats withoutDepth = Read(room.Pass, "rsm0.depth");
  CheckReported(room.Pass, "CASTS_SHADOWS");
  keys->Remove(vtkIndirectIlluminationPass::CASTS_SHADOWS());
  sphere->VisibilityOff();
  room.Grab(true);
  CONTRACT_CHECK(Compare(withoutDepth, Read(room.Pass, "rsm0.depth")).Max == 0.0,
    "without shadows it is not in the map");
  sphere->VisibilityOn();

  // The sphere's texels of the map send nothing; others are unchanged.
  size_t of = 0;
  double sent = 0.0;
  double others = 0.0;
  for (size_t i = 0; i < depth.Values.size(); ++i)
  {
    const bool isSphere = depth.Values[i] != withoutDepth.Values[i];
    of += isSphere ? 1 : 0;
    for (size_t c = 3 * i; c < 3 * i + 3; ++c)
    {
      sent += isSphere ? silent.Values[c] : 0.0;
      others = isSphere ? others
                        : std::max(others, std::abs(double(silent.Values[c]) - density.Values[c]));
    }
  }
  CONTRACT_CHECK(of > 1000, "no sphere in the map");
  CONTRACT_CHECK(sent == 0.0, "it sends " << sent);
  CONTRACT_CHECK(others == 0.0, "others send other light: " << others);

  // A headlight needs no map of its own, unless a prop must not send.
  View view(100, 100);
  AddRoomSurfaces(view.Renderer);
  vtkNew<vtkLight> headlight;
  headlight->SetLightTypeToHeadlight();
  view.Renderer->AddLight(headlight);
  vtkNew<vtkIndirectIlluminationPass> pass;
  view.Renderer->SetPass(pass);
  view.Grab();
  const double all = Mean(Read(pass, "irradiance"), 0);
  CONTRACT_CHECK(pass->GetReflectiveShadowMaps()->GetNumberOfMaps() == 0, "a map for a headlight");
  vtkActorCollection* actors = view.Renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    vtkNew<vtkInformation> off;
    off->Set(vtkIndirectIlluminationPass::SENDS_LIGHT(), 0);
    vtkActor::SafeDownCast(actors->GetItemAsObject(i))->SetPropertyKeys(off);
  }
  view.Grab();
  CONTRACT_CHECK(all > 0.01, "nothing is lit by the headlight");
  CONTRACT_CHECK(Mean(Read(pass, "irradiance"), 0) == 0.0, "what is not to send does");
}
