// SPDX-License-Identifier: BSD-3-Clause
// Kinds of lights and their settings, in direct light with shadows.
#include "vtkIndirectContractUtilities.h"

#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkLightKit.h"
#include "vtkMatrix4x4.h"
#include "vtkRSMGatherPass.h"
#include "vtkRenderWindow.h"
#include "vtkSphereSource.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <functional>
#include <string>

using namespace contract;

namespace
{
// A plane, and a square over its middle, which casts a shadow from a light above.
struct Stage
{
  View Window{ 100, 100 };
  vtkNew<vtkIndirectIlluminationPass> Pass;
  vtkSmartPointer<vtkActor> Blocker;

  Stage()
  {
    this->Window.Renderer->AddActor(MakeQuad({ -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }));
    this->Blocker = MakeQuad({ -0.25, -0.25, 0.5 }, { 0.25, -0.25, 0.5 }, { -0.25, 0.25, 0.5 });
    this->Window.Renderer->AddActor(this->Blocker);
    this->Window.Renderer->AutomaticLightCreationOff();
    this->Window.Renderer->SetPass(this->Pass);
    // From the side, so that the blocker does not hide its shadow.
    vtkCamera* camera = this->Window.Renderer->GetActiveCamera();
    camera->SetPosition(0, -2.0, 0.8);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewUp(0, 0, 1);
    camera->SetViewAngle(60);
    camera->SetClippingRange(0.1, 10);
  }

  // Direct light at a point of the world.
  Vec3 At(const Floats& image, double x, double y, double z)
  {
    this->Window.Renderer->SetWorldPoint(x, y, z, 1.0);
    this->Window.Renderer->WorldToDisplay();
    double display[3];
    this->Window.Renderer->GetDisplayPoint(display);
    const int px = std::min(std::max(static_cast<int>(display[0]), 0), image.Width - 1);
    const int py = std::min(std::max(static_cast<int>(display[1]), 0), image.Height - 1);
    return { image.Get(px, py, 0), image.Get(px, py, 1), image.Get(px, py, 2) };
  }

  Floats Direct()
  {
    this->Window.Grab();
    return Read(this->Pass, "direct");
  }
  // Direct light at the plane's middle and near its corner.
  Vec3 Middle(const Floats& image) { return this->At(image, 0, 0, 0); }
  Vec3 Outside(const Floats& image) { return this->At(image, 0.7, 0, 0); }
  void Add(vtkLight* light) { this->Window.Renderer->AddLight(light); }
  // Adds a receiver of the plane's light.
  void AddWall()
  {
    this->Window.Renderer->AddActor(MakeQuad({ -1, 1, 0 }, { 1, 1, 0 }, { -1, 1, 1 }));
  }
};

bool IsNear(const Vec3& a, const Vec3& b, double tolerance = 2e-3)
{
  return std::abs(a[0] - b[0]) < tolerance && std::abs(a[1] - b[1]) < tolerance &&
    std::abs(a[2] - b[2]) < tolerance;
}

std::string Text(const Vec3& v)
{
  std::ostringstream os;
  os << "(" << v[0] << ", " << v[1] << ", " << v[2] << ")";
  return os.str();
}

#define CHECK_NEAR(found, expected, what)                                                          \
  CONTRACT_CHECK(IsNear(found, expected), what << ": " << Text(found) << " for " << Text(expected))
}

//------------------------------------------------------------------------------
// ShadowAttenuation is the share of a light that its shadows remove.
VTK_INDIRECT_TEST(LightShadowAttenuation)
{
  Stage stage;
  auto light = MakeLight(LightKind::Directional, { 0, 0, 1 }, { 0, 0, 0 });
  stage.Add(light);
  for (double attenuation : { 1.0, 0.5, 0.25, 0.0 })
  {
    light->SetShadowAttenuation(attenuation);
    const Floats image = stage.Direct();
    const double shadow = 0.8 * (1.0 - attenuation);
    CHECK_NEAR(stage.Middle(image), (Vec3{ shadow, shadow, shadow }), attenuation);
    CHECK_NEAR(stage.Outside(image), (Vec3{ 0.8, 0.8, 0.8 }), attenuation);
  }
}

//------------------------------------------------------------------------------
// Each light's shadow removes only that light; lights that are off do not count.
VTK_INDIRECT_TEST(LightColors)
{
  Stage stage;
  auto red = MakeLight(LightKind::Directional, { 0, 0, 1 }, { 0, 0, 0 });
  red->SetColor(1.0, 0.2, 0.0);
  red->SetIntensity(0.5);
  auto off = MakeLight(LightKind::Point, { 0.3, 0.3, 2 }, { 0, 0, 0 });
  off->SwitchOff();
  auto blue = MakeLight(LightKind::Directional, { 0.8, 0, 0.6 }, { 0, 0, 0 });
  blue->SetColor(0.0, 0.0, 1.0);
  for (int order = 0; order < 2; ++order)
  {
    stage.Window.Renderer->RemoveAllLights();
    stage.Add(order ? blue : red);
    stage.Add(off);
    stage.Add(order ? red : blue);
    Floats image = stage.Direct();
    // The blue light's shadow lies at x = -2/3 of the blocker's height of 1/2.
    const double b = 0.6 * 0.8;
    CHECK_NEAR(stage.Middle(image), (Vec3{ 0, 0, b }), "in the red light's shadow");
    CHECK_NEAR(stage.At(image, -0.667, 0, 0), (Vec3{ 0.4, 0.08, 0 }), "in the blue light's shadow");
    CHECK_NEAR(stage.Outside(image), (Vec3{ 0.4, 0.08, b }), "out of both");
    red->SwitchOff();
    image = stage.Direct();
    CHECK_NEAR(stage.Middle(image), (Vec3{ 0, 0, b }), "red off");
    CHECK_NEAR(stage.At(image, -0.667, 0, 0), (Vec3{ 0, 0, 0 }), "red off");
    red->SwitchOn();
    red->SetIntensity(0.0);
    image = stage.Direct();
    CHECK_NEAR(stage.Outside(image), (Vec3{ 0, 0, b }), "red dark");
    CHECK_NEAR(stage.At(image, -0.667, 0, 0), (Vec3{ 0, 0, 0 }), "red dark");
    red->SetIntensity(0.5);
  }
}

//------------------------------------------------------------------------------
// Shading follows VTK's for every setting by which light code is shortened: a shader built for one
// must not serve another.
VTK_INDIRECT_TEST(LightSettings)
{
  std::vector<std::string> names;
  auto render = [&names](bool indirect)
  {
    Stage stage;
    auto spot = MakeLight(LightKind::Spot, { 0.2, 1.0, 1.2 }, { 0, 0, 0 });
    spot->SetIntensity(0.3);
    spot->SetExponent(1.0);
    auto other = MakeLight(LightKind::Point, { -0.6, -0.5, 1.5 }, { 0, 0, 0 });
    other->SetIntensity(0.3);
    stage.Add(spot);
    stage.Add(other);
    stage.Pass->ShadowsOff();
    stage.Pass->AntialiasingOff();
    // A light too weak to be seen, so that the capture draws.
    stage.Pass->SetIndirectScale(1e-9);
    if (!indirect)
    {
      stage.Window.Renderer->SetPass(nullptr);
    }
    vtkProperty* material = stage.Blocker->GetProperty();
    material->SetSpecularPower(5.0);
    const std::pair<const char*, std::function<void()>> changes[] = {
      { "as made", [] {} },
      { "exponent 8", [&] { spot->SetExponent(8.0); } },
      { "exponent 0", [&] { spot->SetExponent(0.0); } },
      { "exponent 1", [&] { spot->SetExponent(1.0); } },
      { "narrow cone", [&] { spot->SetConeAngle(12.0); } },
      { "no cone", [&] { spot->SetConeAngle(90.0); } },
      { "cone of 30 degrees", [&] { spot->SetConeAngle(30.0); } },
      { "specular", [&] { material->SetSpecular(0.7); } },
      { "matt", [&] { material->SetSpecular(0.0); } },
      { "specular again", [&] { material->SetSpecular(0.4); } },
      { "lobe of no colour", [&] { material->SetSpecularColor(0.0, 0.0, 0.0); } },
      { "cone of the other", [&] { other->SetConeAngle(20.0); } },
      { "point again", [&] { other->SetConeAngle(90.0); } },
      { "falloff", [&] { other->SetAttenuationValues(1.0, 0.3, 0.2); } },
      { "directional", [&] { other->PositionalOff(); } },
      { "positional", [&] { other->PositionalOn(); } },
      { "first light off", [&] { spot->SwitchOff(); } },
      { "first light on", [&] { spot->SwitchOn(); } },
    };
    std::vector<Pixels> images;
    names.clear();
    for (const auto& change : changes)
    {
      change.second();
      names.emplace_back(change.first);
      images.push_back(stage.Window.Grab());
    }
    return images;
  };
  const std::vector<Pixels> found = render(true);
  const std::vector<Pixels> expected = render(false);
  for (size_t i = 0; i < names.size(); ++i)
  {
    // Two steps of a byte: rounding, and pixels on a cone's edge.
    const Difference difference = Compare(found[i], expected[i]);
    CONTRACT_CHECK(difference.Max <= 2, names[i] << ": " << difference);
    CONTRACT_CHECK(i == 0 || Compare(expected[i], expected[i - 1]).Max > 2,
      names[i] << " is not seen: the test has no power");
  }
}

//------------------------------------------------------------------------------
// A headlight alone needs no map; with another light both have one.
VTK_INDIRECT_TEST(LightHeadlight)
{
  Stage stage;
  stage.AddWall();
  vtkNew<vtkLight> head;
  head->SetLightTypeToHeadlight();
  stage.Add(head);
  // By default its light is that of directions around its own, wherever surfaces are.
  Floats image = stage.Direct();
  const std::string report = stage.Pass->GetReport();
  CONTRACT_CHECK(
    report.find("bounces of lights that follow the camera") != std::string::npos, report);
  CONTRACT_CHECK(report.find("senders outside the view") == std::string::npos, report);
  CONTRACT_CHECK(Mean(Read(stage.Pass, "irradiance"), 0) > 1e-4, "no indirect light");
  // Other samplers take the surfaces that the eye sees.
  vtkNew<vtkUniformLightSampler> even;
  stage.Pass->SetSampler(even);
  image = stage.Direct();
  CONTRACT_CHECK(stage.Outside(image)[0] > 0.1, "headlight");
  CONTRACT_CHECK(
    stage.Pass->GetReport().find("a headlight, from the geometry buffer") != std::string::npos,
    stage.Pass->GetReport());
  CONTRACT_CHECK(Mean(Read(stage.Pass, "irradiance"), 0) > 1e-4, "no indirect light");
  {
    ExpectedErrors errors;
    vtkNew<vtkImageData> buffer;
    CONTRACT_CHECK(!stage.Pass->CopyBuffer("rsm0.depth", buffer), "a map");
    CONTRACT_CHECK(errors.GetCount() == 1, errors.GetText());
  }
  const Vec3 headOutside = stage.Outside(image);
  const Vec3 headMiddle = stage.Middle(image);
  stage.Add(MakeLight(LightKind::Directional, { 0, 0, 1 }, { 0, 0, 0 }));
  image = stage.Direct();
  CHECK_NEAR(stage.Outside(image),
    (Vec3{ headOutside[0] + 0.8, headOutside[1] + 0.8, headOutside[2] + 0.8 }), "out of shadows");
  // A headlight casts no visible shadow.
  CHECK_NEAR(stage.Middle(image), headMiddle, "in the other light's shadow");
  Read(stage.Pass, "rsm0.depth");
  Read(stage.Pass, "rsm1.depth");
}

//------------------------------------------------------------------------------
// A camera light is equivalent to a scene light at its place, with its shadow.
VTK_INDIRECT_TEST(LightOfCamera)
{
  Stage stage;
  vtkCamera* camera = stage.Window.Renderer->GetActiveCamera();
  auto light = MakeLight(LightKind::Spot, { 0.2, 0.6, 0.4 }, { 0, 0, 0 }, 60.0);
  light->SetLightTypeToCameraLight();
  stage.Add(light);
  for (double azimuth : { 0.0, 20.0, 40.0 })
  {
    camera->Azimuth(azimuth);
    const Floats found = stage.Direct();
    double position[3];
    double focal[3];
    light->GetTransformedPosition(position);
    light->GetTransformedFocalPoint(focal);
    Stage other;
    other.Window.Renderer->GetActiveCamera()->DeepCopy(camera);
    other.Add(MakeLight(LightKind::Spot, { position[0], position[1], position[2] },
      { focal[0], focal[1], focal[2] }, 60.0));
    const Difference difference = Compare(found, other.Direct());
    CONTRACT_CHECK(Mean(found, 0) > 0.05, "nothing lit");
    CONTRACT_CHECK(difference.Mean < 1e-3, azimuth << ": " << difference);
  }
}

//------------------------------------------------------------------------------
// VTK's kit of five lights, one of them a headlight.
VTK_INDIRECT_TEST(LightKit)
{
  Stage stage;
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(stage.Window.Renderer);
  const Floats shadowed = stage.Direct();
  const Floats irradiance = Read(stage.Pass, "irradiance");
  // Surfaces reflect light of fixed directions, so that maps hold depths alone.
  CONTRACT_CHECK(stage.Pass->GetReport().find("\"light 4\"") != std::string::npos, "five maps");
  {
    ExpectedErrors errors;
    vtkNew<vtkImageData> buffer;
    CONTRACT_CHECK(!stage.Pass->CopyBuffer("rsm0.density", buffer), "a map of senders");
    CONTRACT_CHECK(
      errors.GetText().find("hold depths alone") != std::string::npos, errors.GetText());
  }
  stage.Pass->ShadowsOff();
  const Floats lit = stage.Direct();
  const Floats unshadowed = Read(stage.Pass, "irradiance");
  CONTRACT_CHECK(Compare(unshadowed, irradiance).Max == 0.0, "indirect light without shadows");
  for (size_t i = 0; i < lit.Values.size(); ++i)
  {
    CONTRACT_CHECK(shadowed.Values[i] <= lit.Values[i] + 1e-5f, "shadows add light");
  }
  CONTRACT_CHECK(Mean(lit, 0) > Mean(shadowed, 0) + 1e-3, "no shadow at all");
  // The ground receives light of the square above it: 8e-4 with all texels as virtual lights.
  CONTRACT_CHECK(Mean(irradiance, 0) > 3e-4, "no indirect light");
  stage.Window.Renderer->GetActiveCamera()->Azimuth(10);
  stage.Direct();
}

//------------------------------------------------------------------------------
// Shadows follow changed data and moved actors, and vanish with invisible ones.
VTK_INDIRECT_TEST(ShadowFollows)
{
  Stage stage;
  stage.Add(MakeLight(LightKind::Directional, { 0, 0, 1 }, { 0, 0, 0 }));
  CHECK_NEAR(stage.Middle(stage.Direct()), (Vec3{ 0, 0, 0 }), "blocker");
  stage.Blocker->VisibilityOff();
  CHECK_NEAR(stage.Middle(stage.Direct()), (Vec3{ 0.8, 0.8, 0.8 }), "invisible");
  vtkNew<vtkSphereSource> source;
  source->SetRadius(0.1);
  source->SetThetaResolution(32);
  source->SetPhiResolution(32);
  auto ball = MakeActor(source);
  ball->SetPosition(-0.3, 0, 0.6);
  stage.Window.Renderer->AddActor(ball);
  Floats image = stage.Direct();
  CHECK_NEAR(stage.At(image, -0.3, 0, 0), (Vec3{ 0, 0, 0 }), "a ball");
  CHECK_NEAR(stage.At(image, -0.3, 0.2, 0), (Vec3{ 0.8, 0.8, 0.8 }), "beside it");
  source->SetRadius(0.3);
  image = stage.Direct();
  CHECK_NEAR(stage.At(image, -0.3, 0.2, 0), (Vec3{ 0, 0, 0 }), "under the larger ball");
  ball->SetPosition(0.4, 0, 0.6);
  image = stage.Direct();
  CHECK_NEAR(stage.At(image, -0.3, 0, 0), (Vec3{ 0.8, 0.8, 0.8 }), "where the ball was");
  CHECK_NEAR(stage.At(image, 0.4, 0, 0), (Vec3{ 0, 0, 0 }), "where it is");
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 3, -0.8);
  ball->SetUserMatrix(matrix);
  image = stage.Direct();
  CHECK_NEAR(stage.At(image, -0.4, 0, 0), (Vec3{ 0, 0, 0 }), "moved by its matrix");
  matrix->SetElement(0, 3, 0.0);
  matrix->Modified();
  image = stage.Direct();
  CHECK_NEAR(stage.At(image, 0.4, 0, 0), (Vec3{ 0, 0, 0 }), "and back");
  stage.Window.Renderer->RemoveActor(ball);
  CHECK_NEAR(stage.At(stage.Direct(), 0.4, 0, 0), (Vec3{ 0.8, 0.8, 0.8 }), "removed");
}

//------------------------------------------------------------------------------
// Props out of view cast shadows and reflect light.
VTK_INDIRECT_TEST(ShadowFromOutside)
{
  for (LightKind kind : { LightKind::Directional, LightKind::Spot, LightKind::Point })
  {
    Stage stage;
    stage.Pass->SetNumberOfBounces(1); // the plane is white
    stage.Add(MakeLight(kind, { 0, 0, 2 }, { 0, 0, 0 }, 45.0));
    // A red prop out of view, between the light and the plane's edge.
    stage.Window.Renderer->AddActor(
      MakeQuad({ -0.2, 0.4, 0.2 }, { 0.2, 0.4, 0.2 }, { -0.2, 0.7, 1.2 }, { 1, 0, 0 }));
    Floats image = stage.Direct();
    CHECK_NEAR(stage.Middle(image), (Vec3{ 0, 0, 0 }), GetName(kind));
    // Looks straight down from under the blocker.
    vtkCamera* camera = stage.Window.Renderer->GetActiveCamera();
    camera->SetPosition(0, 0, 0.3);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewUp(0, 1, 0);
    camera->SetViewAngle(20);
    camera->SetClippingRange(0.01, 0.5);
    image = stage.Direct();
    CONTRACT_CHECK(Mean(image, 0) < 1e-6, GetName(kind) << ": " << Mean(image, 0));
    const Floats indirect = Read(stage.Pass, "indirect");
    CONTRACT_CHECK(Mean(indirect, 0) > 1e-4 && Mean(indirect, 0) > 2.0 * Mean(indirect, 1),
      GetName(kind) << ": no red light from outside: " << Mean(indirect, 0) << ", "
                    << Mean(indirect, 1));
  }
}

//------------------------------------------------------------------------------
// A square plate close to a point light: its shadow crosses the seams of the cube's faces unbroken.
VTK_INDIRECT_TEST(ShadowSeams)
{
  // The faces of the cube meet along the diagonals of a floor.
  for (LightKind kind : { LightKind::Point, LightKind::WideSpot })
  {
    View view(200, 200);
    vtkRenderer* renderer = view.Renderer;
    renderer->AddActor(MakeQuad({ -3, -3, 0 }, { 3, -3, 0 }, { -3, 3, 0 }));
    // The corners of the plate's shadow lie beyond the 45 degrees where the faces meet.
    renderer->AddActor(
      MakeQuad({ -0.35, -0.35, 0.75 }, { 0.35, -0.35, 0.75 }, { -0.35, 0.35, 0.75 }));
    renderer->AddLight(MakeLight(kind, { 0, 0, 1 }, { 0, 0, 0 }));
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(2.0);
    // From below the plate only the floor is visible.
    camera->SetPosition(0, 0, 0.5);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewUp(0, 1, 0);
    camera->SetClippingRange(0.1, 1.0);
    vtkNew<vtkIndirectIlluminationPass> pass;
    pass->SetReflectiveShadowMapResolution(512);
    renderer->SetPass(pass);
    view.Grab();
    const Floats direct = Read(pass, "direct");
    // The shadow's edge is at 1.4; the seam, for a light one above the floor, at 1.
    size_t wrong = 0;
    for (int y = 0; y < 200; ++y)
    {
      for (int x = 0; x < 200; ++x)
      {
        const double px = std::abs((x + 0.5) * 0.02 - 2.0);
        const double py = std::abs((y + 0.5) * 0.02 - 2.0);
        const double far = std::max(px, py);
        if (std::abs(far - 1.4) > 0.03)
        {
          wrong += (direct.Get(x, y, 0) > 0.0f) != (far > 1.4) ? 1 : 0;
        }
      }
    }
    CONTRACT_CHECK(wrong == 0, GetName(kind) << ": " << wrong << " pixels");
  }
}

//------------------------------------------------------------------------------
// A parallel eye with perspective maps, a perspective eye with parallel ones, and both mixed.
VTK_INDIRECT_TEST(ParallelEye)
{
  double positional = 0.0;
  for (LightKind kind :
    { LightKind::Directional, LightKind::Spot, LightKind::WideSpot, LightKind::Point })
  {
    double walls[2] = { 0, 0 };
    for (bool parallel : { true, false })
    {
      Stage stage;
      stage.AddWall();
      // With all texels as senders only the geometry of maps and eye matters.
      vtkNew<vtkRSMGatherPass> gather;
      gather->SetModeToAllTexels();
      stage.Pass->SetEstimator(gather);
      stage.Pass->SetReflectiveShadowMapResolution(24);
      stage.Add(MakeLight(kind, { 0, 0, 2 }, { 0, 0, 0 }, 45.0));
      stage.Add(MakeLight(LightKind::Directional, { 0.01, 0, 1 }, { 0, 0, 0 }));
      vtkCamera* camera = stage.Window.Renderer->GetActiveCamera();
      camera->SetParallelProjection(parallel);
      camera->SetParallelScale(1.2);
      Floats image = stage.Direct();
      CHECK_NEAR(stage.Middle(image), (Vec3{ 0, 0, 0 }), GetName(kind));
      CONTRACT_CHECK(stage.Outside(image)[0] > 0.8, GetName(kind) << Text(stage.Outside(image)));
      // The plane fills half of a wall's view; both lights light it from above.
      const Floats irradiance = Read(stage.Pass, "irradiance");
      const Vec3 wall = stage.At(irradiance, 0, 1, 0.2);
      std::cout << GetName(kind) << (parallel ? ", parallel" : ", perspective")
                << ": irradiance on the wall " << wall[0] << "\n";
      CONTRACT_CHECK(wall[0] > 0.2 && wall[0] < 0.8, GetName(kind) << ": " << wall[0]);
      walls[parallel] = wall[0];
    }
    // The two eyes see different points of the wall, up to 0.01 apart.
    CONTRACT_CHECK(std::abs(walls[0] - walls[1]) < 0.02,
      GetName(kind) << ": " << walls[0] << ", parallel " << walls[1]);
    // The narrowest cone contains everything that these lights reach.
    if (kind == LightKind::Spot)
    {
      positional = walls[0];
    }
    CONTRACT_CHECK(kind == LightKind::Directional || std::abs(walls[0] - positional) < 0.02,
      GetName(kind) << ": " << walls[0] << ", spot " << positional);
  }
}
