// SPDX-License-Identifier: BSD-3-Clause
// Props that are no plain surfaces: what they take part in, and what they leave as it was.
#include "vtkIndirectContractUtilities.h"

#include "vtkAxesActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkBoxRepresentation.h"
#include "vtkCellArray.h"
#include "vtkCubeAxesActor.h"
#include "vtkCubeSource.h"
#include "vtkFollower.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLightKit.h"
#include "vtkLineSource.h"
#include "vtkOutlineSource.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkRenderWindow.h"
#include "vtkSkybox.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkVectorText.h"
#include "vtkVolume.h"

#include <algorithm>
#include <functional>

using namespace contract;

namespace
{
// A sky whose colour changes with the height.
vtkSmartPointer<vtkTexture> MakeSky()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 32, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < 32; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      pixel[0] = 90;
      pixel[1] = 110;
      pixel[2] = static_cast<unsigned char>(7 * y);
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->MipmapOn();
  return texture;
}

// The room with something more, and all irradiance summed at every pixel: then nothing of it
// depends on what the neighbouring pixels show.
struct Room
{
  View Window{ 160, 120 };
  vtkNew<vtkIndirectIlluminationPass> Pass;
  vtkNew<vtkRSMGatherPass> Gather;

  Room()
  {
    AddRoom(this->Window.Renderer);
    this->Gather->InterpolationOff();
    this->Pass->SetEstimator(this->Gather);
  }
  vtkRenderer* GetRenderer() { return this->Window.Renderer; }
  Pixels Grab(bool indirect)
  {
    this->GetRenderer()->SetPass(indirect ? this->Pass.Get() : nullptr);
    return this->Window.Grab();
  }
};

bool Differs(const Pixels& a, const Pixels& b, size_t pixel)
{
  return !std::equal(&a.Values[4 * pixel], &a.Values[4 * pixel] + 3, &b.Values[4 * pixel]);
}

double Distance(const Pixels& a, const Pixels& b, size_t pixel)
{
  double distance = 0.0;
  for (size_t c = 4 * pixel; c < 4 * pixel + 3; ++c)
  {
    distance = std::max(distance, std::abs(double(a.Values[c]) - double(b.Values[c])));
  }
  return distance;
}

double Sum(const Floats& image, int component)
{
  return Mean(image, component) * image.Width * image.Height;
}

void CheckReported(vtkIndirectIlluminationPass* pass, const std::string& what)
{
  const std::string report = pass->GetReport();
  CONTRACT_CHECK(report.find(what) != std::string::npos, "no '" << what << "' in " << report);
}
}

//------------------------------------------------------------------------------
// The sky writes its colour alone. It is what VTK draws, the same in every frame, and no surface.
CONTRACT_TEST(PropsSky)
{
  Room room;
  vtkNew<vtkSkybox> sky;
  sky->SetProjectionToSphere();
  sky->SetTexture(MakeSky());
  room.GetRenderer()->AddActor(sky);
  // Physically based: VTK's environment light needs it, and such scenes are where skies are used.
  vtkActor* sphere = room.GetRenderer()->GetActors()->GetItemAsObject(5)
    ? vtkActor::SafeDownCast(room.GetRenderer()->GetActors()->GetItemAsObject(5))
    : nullptr;
  CONTRACT_CHECK(sphere, "no sphere");
  sphere->GetProperty()->SetInterpolationToPBR();
  room.GetRenderer()->UseImageBasedLightingOn();
  room.GetRenderer()->SetEnvironmentTexture(sky->GetTexture());
  room.GetRenderer()->GetActiveCamera()->SetPosition(1.6, 0.9, 3.4);
  const Pixels plain = room.Grab(false);
  const Pixels first = room.Grab(true);
  const Floats depth = Read(room.Pass, "depth");
  const Floats normal = Read(room.Pass, "normal");
  const Floats albedo = Read(room.Pass, "albedo");
  CONTRACT_CHECK(Compare(first, room.Grab(true)).Max == 0.0, "the second frame differs");
  room.Pass->CachingOff();
  CONTRACT_CHECK(Compare(first, room.Grab(true)).Max == 0.0, "the third frame differs");
  size_t seen = 0;
  double worst = 0.0;
  double surface = 0.0;
  for (size_t i = 0; i < depth.Values.size(); ++i)
  {
    if (depth.Values[i] == 0.0f)
    {
      ++seen;
      worst = std::max(worst, Distance(plain, first, i));
      for (size_t c = 3 * i; c < 3 * i + 3; ++c)
      {
        surface = std::max(surface, std::abs(double(normal.Values[c])) + albedo.Values[c]);
      }
    }
  }
  std::cout << seen << " pixels of sky, off by " << worst << "\n";
  CONTRACT_CHECK(seen > 3000, "no sky");
  CONTRACT_CHECK(worst <= 1.0, "the sky is not VTK's: " << worst);
  CONTRACT_CHECK(surface == 0.0, "the sky has a surface: " << surface);
  CheckReported(room.Pass, "vtkOpenGLSkybox");
  CheckReported(room.Pass, "environment light");
}

//------------------------------------------------------------------------------
// Lit annotation in front of surfaces: VTK's own picture there, the same light as ever elsewhere.
CONTRACT_TEST(PropsColorOnly)
{
  Room room;
  const Pixels plainWithout = room.Grab(false);
  const Pixels without = room.Grab(true);
  vtkNew<vtkAxesActor> axes;
  axes->SetTotalLength(0.7, 0.7, 0.7);
  axes->SetShaftTypeToCylinder();
  axes->SetCylinderRadius(0.1);
  axes->AxisLabelsOff();
  room.GetRenderer()->AddActor(axes);
  const Pixels plain = room.Grab(false);
  const Pixels image = room.Grab(true);
  const Floats irradiance = Read(room.Pass, "irradiance");
  size_t seen = 0;
  double worst = 0.0;
  double elsewhere = 0.0;
  double light = 0.0;
  for (size_t i = 0; i < plain.Values.size() / 4; ++i)
  {
    if (!Differs(plain, plainWithout, i))
    {
      elsewhere = std::max(elsewhere, Distance(image, without, i));
      continue;
    }
    ++seen;
    worst = std::max(worst, Distance(plain, image, i));
    light += irradiance.Values[3 * i];
  }
  std::cout << seen << " pixels of axes, off by " << worst << ", others by " << elsewhere << "\n";
  CONTRACT_CHECK(seen > 300, "no axes");
  // One step of a byte: floats are rounded to it where VTK's own picture is blended in bytes.
  CONTRACT_CHECK(worst <= 1.0, "axes are not VTK's: " << worst);
  CONTRACT_CHECK(light == 0.0, "axes receive light: " << light);
  // Where the axes have a surface's own colour they are not among those seen: a few pixels.
  size_t changed = 0;
  for (size_t i = 0; i < plain.Values.size() / 4; ++i)
  {
    changed += !Differs(plain, plainWithout, i) && Distance(image, without, i) > 1.0 ? 1 : 0;
  }
  CONTRACT_CHECK(changed <= seen / 20, changed << " pixels beside the axes changed");
}

//------------------------------------------------------------------------------
// A label that turns to the camera turns to no light, whether maps are drawn in a frame or not.
CONTRACT_TEST(PropsBillboard)
{
  Room room;
  vtkNew<vtkBillboardTextActor3D> label;
  label->SetInput("label");
  label->SetPosition(0.2, 0.5, 0.5);
  label->GetTextProperty()->SetFontSize(24);
  label->GetTextProperty()->SetColor(1, 1, 0);
  room.GetRenderer()->AddActor(label);
  room.GetRenderer()->SetPass(room.Pass);
  const Pixels drawn = room.Window.Grab();
  const vtkIdType faces = room.Pass->GetReflectiveShadowMaps()->GetNumberOfFacesDrawn();
  const Pixels cached = room.Window.Grab();
  CONTRACT_CHECK(
    faces > 0 && faces == room.Pass->GetReflectiveShadowMaps()->GetNumberOfFacesDrawn(),
    "maps were to be drawn once, in the first frame");
  CONTRACT_CHECK(Compare(drawn, cached).Max == 0.0, Compare(drawn, cached));
  size_t yellow = 0;
  for (size_t i = 0; i < drawn.Values.size(); i += 4)
  {
    yellow += drawn.Values[i] > 100 && drawn.Values[i + 1] > 100 && drawn.Values[i + 2] < 30;
  }
  CONTRACT_CHECK(yellow > 50, "no label: " << yellow);
}

//------------------------------------------------------------------------------
// A lit tube, made of a line, that nothing stands before: it does not shadow itself.
CONTRACT_TEST(PropsTubes)
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
// Behind all that casts shadows: a tube below the gap between two tables is lit, and in shadow
// below the tables.
CONTRACT_TEST(PropsBehindCasters)
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
    // The tube's upper side: what is lit there.
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
// Edges of faces: a map has the faces without them, and they put no shadows onto the faces.
CONTRACT_TEST(PropsEdges)
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

  // A box alone has no shadow on it but where it turns away from a light anyway.
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
// Outlines, axes, widgets, labels, lines and points leave the lights' maps as they are.
CONTRACT_TEST(PropsAnnotation)
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
        vtkNew<vtkVectorText> text;
        text->SetText("F");
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputConnection(text->GetOutputPort());
        auto follower = vtkSmartPointer<vtkFollower>::New();
        follower->SetMapper(mapper);
        follower->SetCamera(renderer->GetActiveCamera());
        follower->SetScale(0.3);
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
  const vtkIdType faces = room.Pass->GetReflectiveShadowMaps()->GetNumberOfFacesDrawn();
  for (const auto& kind : kinds)
  {
    vtkSmartPointer<vtkProp> prop = kind.second(room.GetRenderer());
    room.GetRenderer()->AddViewProp(prop);
    const Pixels plain = room.Grab(false);
    const Pixels image = room.Grab(true);
    CONTRACT_CHECK(
      Compare(depth, Read(room.Pass, "rsm0.depth")).Max == 0.0, kind.first << " is in the map");
    CONTRACT_CHECK(room.Pass->GetReflectiveShadowMaps()->GetNumberOfFacesDrawn() == faces,
      kind.first << " had the map drawn anew");
    CheckReported(room.Pass, prop->GetClassName());
    room.GetRenderer()->RemoveViewProp(prop);
    CONTRACT_CHECK(Compare(plain, room.Grab(false)).Pixels > 20, kind.first << " is not seen");
  }
}

//------------------------------------------------------------------------------
// The two keys, of a sphere in the room and by a headlight.
CONTRACT_TEST(PropsKeys)
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

  // Where the sphere was in the map it sends nothing; elsewhere all is as it was.
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

  // A headlight needs no map of its own, unless something is not to send.
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

//------------------------------------------------------------------------------
// Splats: emissive ones add their light to the picture and change nothing else; others hide what
// lies behind them, and are in no map.
CONTRACT_TEST(PropsSplats)
{
  auto makeSplats = []
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.3, 0.5, 0.6);
    points->InsertNextPoint(0.7, 0.6, 0.6);
    points->InsertNextPoint(1.2, 0.9, 0.6);
    vtkNew<vtkCellArray> vertices;
    vertices->InsertNextCell({ 0, 1, 2 });
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetVerts(vertices);
    vtkNew<vtkPointGaussianMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetScaleFactor(0.06);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.2, 0.3, 0.4);
    return actor;
  };
  Room room;
  room.GetRenderer()->SetBackground(0.1, 0.2, 0.3);
  const Pixels plainWithout = room.Grab(false);
  const Pixels without = room.Grab(true);
  const Floats irradiance = Read(room.Pass, "irradiance");
  const Floats depth = Read(room.Pass, "rsm0.depth");
  auto splats = makeSplats();
  auto* mapper = vtkPointGaussianMapper::SafeDownCast(splats->GetMapper());
  mapper->EmissiveOn();
  room.GetRenderer()->AddActor(splats);
  const Pixels plain = room.Grab(false);
  const Pixels image = room.Grab(true);
  // The scene's bounds have grown by the splats, to which positions are relative: rounding.
  const Difference same = Compare(irradiance, Read(room.Pass, "irradiance"));
  CONTRACT_CHECK(same.Max < 1e-4, "the light on surfaces: " << same);
  CONTRACT_CHECK(
    Compare(depth, Read(room.Pass, "rsm0.depth")).Max < 1e-5, "emissive splats are in the map");
  size_t seen = 0;
  double worst = 0.0;
  for (size_t i = 0; i < image.Values.size(); ++i)
  {
    if (i % 4 == 3)
    {
      continue; // alpha, by which what lies behind would be less
    }
    const int added = int(plain.Values[i]) - plainWithout.Values[i];
    seen += added > 5 ? 1 : 0;
    if (image.Values[i] < 255 && plain.Values[i] < 255)
    {
      worst = std::max(worst, std::abs(double(image.Values[i]) - without.Values[i] - added));
    }
  }
  std::cout << "emissive: " << seen << " values, off by " << worst << "\n";
  CONTRACT_CHECK(seen > 1000, "no splats");
  // Two roundings to bytes: of VTK's sum, splat by splat, and of ours.
  CONTRACT_CHECK(worst <= 2.0, "emissive splats add something else than VTK's: " << worst);

  mapper->EmissiveOff();
  room.Grab(true);
  CONTRACT_CHECK(Compare(depth, Read(room.Pass, "rsm0.depth")).Max < 1e-5, "splats are in the map");
  CheckReported(room.Pass, "splats have no surface");
  // Hidden where they are more than half opaque, and else as before.
  const Floats hidden = Read(room.Pass, "irradiance");
  size_t dark = 0;
  double changed = 0.0;
  for (size_t i = 0; i < hidden.Values.size(); i += 3)
  {
    const bool isDark = hidden.Values[i] == 0.0f && irradiance.Values[i] > 0.0f;
    dark += isDark ? 1 : 0;
    changed = isDark
      ? changed
      : std::max(changed, std::abs(double(hidden.Values[i]) - double(irradiance.Values[i])));
  }
  std::cout << "opaque: hide " << dark << " pixels, others change by " << changed << "\n";
  CONTRACT_CHECK(dark > 100 && dark < 2000, dark << " pixels hidden");
  CONTRACT_CHECK(changed < 1e-4, "beside splats: " << changed);
}

//------------------------------------------------------------------------------
// What takes no part is said, with how many there are of it.
CONTRACT_TEST(PropsLeftOut)
{
  Room room;
  for (int i = 0; i < 3; ++i)
  {
    auto glass = MakeSphere({ 0.3 + 0.2 * i, 0.7, 0.5 }, 0.08);
    glass->GetProperty()->SetOpacity(0.5);
    room.GetRenderer()->AddActor(glass);
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  image->SetSpacing(0.1, 0.1, 0.1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  image->GetPointData()->GetScalars()->Fill(100);
  vtkNew<vtkSmartVolumeMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  room.GetRenderer()->AddVolume(volume);
  room.Grab(true);
  CheckReported(room.Pass, "volumes neither send nor receive");
  CheckReported(room.Pass, "\"vtkOpenGLActor, 3 props\", \"why\": \"translucent geometry");
}

//------------------------------------------------------------------------------
// Unlit lines receive no light: they cost radiance hints nothing. Tubes are lit, and no polygons
// tell where.
CONTRACT_TEST(PropsHints)
{
  vtkIdType active[3];
  for (int kind : { 0, 1, 2 })
  {
    Room room;
    vtkNew<vtkRadianceHintsPass> hints;
    room.Pass->SetEstimator(hints);
    vtkNew<vtkOutlineSource> source;
    source->SetBounds(0.2, 0.8, 0.05, 0.45, 0.2, 0.6);
    auto outline = MakeActor(source, { 1, 1, 0 });
    outline->GetProperty()->SetLineWidth(4);
    outline->GetProperty()->SetRenderLinesAsTubes(kind == 2);
    outline->SetVisibility(kind > 0);
    room.GetRenderer()->AddActor(outline);
    room.Grab(true);
    active[kind] = hints->GetNumberOfActiveHints();
  }
  std::cout << "active hints: " << active[0] << ", with an outline " << active[1] << ", with tubes "
            << active[2] << "\n";
  CONTRACT_CHECK(active[0] > 0, "no hints");
  CONTRACT_CHECK(active[1] == active[0], "an outline has hints");
  CONTRACT_CHECK(active[2] > active[0], "tubes have no hints");
}
