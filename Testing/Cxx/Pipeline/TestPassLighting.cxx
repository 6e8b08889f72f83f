// SPDX-License-Identifier: BSD-3-Clause
// Presets of lights: their effect on the picture, with unchanged lights of the renderer.
#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractRoom.h"
#include "vtkProperty.h"

#include "vtkAxesActor.h"
#include "vtkEnvironmentLight.h"
#include "vtkLightCollection.h"
#include "vtkLightKit.h"
#include "vtkPropCollection.h"
#include "vtkPropPicker.h"
#include "vtkRenderWindow.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace contract;

namespace
{
using Pass = vtkIndirectIlluminationPass;

const int Presets[] = { Pass::SOFT, Pass::FULL, Pass::GENTLE, Pass::STUDIO };

// A ball on a floor, without lights.
struct Stage
{
  View Window{ 80, 60 };
  vtkNew<Pass> IndirectPass;

  Stage()
  {
    this->GetRenderer()->AddActor(MakeQuad({ -2, -1, 2 }, { 2, -1, 2 }, { -2, -1, -2 }));
    this->GetRenderer()->AddActor(MakeSphere({ 0, -0.4, 0 }, 0.6));
    this->GetRenderer()->SetPass(this->IndirectPass);
    vtkCamera* camera = this->GetRenderer()->GetActiveCamera();
    camera->SetPosition(1, 1.5, 5);
    camera->SetFocalPoint(0, -0.5, 0);
    camera->SetClippingRange(0.1, 20);
  }
  vtkRenderer* GetRenderer() { return this->Window.Renderer; }
  Pixels Grab(int lighting)
  {
    this->IndirectPass->SetLighting(lighting);
    return this->Window.Grab();
  }
};

void AddKit(vtkRenderer* renderer)
{
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(renderer);
}

// All properties of the renderer's lights.
std::vector<double> Describe(vtkRenderer* renderer)
{
  vtkLightCollection* lights = renderer->GetLights();
  std::vector<double> all = { static_cast<double>(reinterpret_cast<uintptr_t>(lights)),
    static_cast<double>(lights->GetMTime()), static_cast<double>(lights->GetNumberOfItems()) };
  for (int i = 0; i < lights->GetNumberOfItems(); ++i)
  {
    auto* light = vtkLight::SafeDownCast(lights->GetItemAsObject(i));
    double transformed[3];
    light->GetTransformedPosition(transformed);
    all.insert(all.end(), transformed, transformed + 3);
    light->GetTransformedFocalPoint(transformed);
    all.insert(all.end(), transformed, transformed + 3);
    all.insert(all.end(), light->GetDiffuseColor(), light->GetDiffuseColor() + 3);
    all.insert(all.end(),
      { static_cast<double>(reinterpret_cast<uintptr_t>(light)), light->GetIntensity(),
        static_cast<double>(light->GetSwitch()), static_cast<double>(light->GetMTime()),
        static_cast<double>(light->GetReferenceCount()) });
  }
  return all;
}
}

//------------------------------------------------------------------------------
// The picture changes and the lights do not; without the preset the picture is the former one, bit
// by bit.
VTK_INDIRECT_TEST(LightingComesAndGoes)
{
  const std::function<void(vtkRenderer*)> kinds[] = { AddKit,
    [](vtkRenderer* renderer) {
      renderer->AddLight(MakeLight(LightKind::Spot, { 2, 3, 2 }, { 0, -1, 0 }));
    },
    [](vtkRenderer* renderer) {
      renderer->AddLight(MakeLight(LightKind::Directional, { 2, 3, 2 }, { 0, -1, 0 }));
    },
    // VTK makes a light.
    [](vtkRenderer*) {} };
  for (size_t kind = 0; kind < 4; ++kind)
  {
    Stage stage;
    kinds[kind](stage.GetRenderer());
    const Pixels before = stage.Grab(Pass::SCENE);
    const std::vector<double> lights = Describe(stage.GetRenderer());
    const vtkMTimeType time = stage.GetRenderer()->GetMTime();
    std::vector<Pixels> pictures = { before };
    for (const int preset : Presets)
    {
      pictures.push_back(stage.Grab(preset));
      const Difference moved = Compare(pictures.back(), stage.Window.Grab());
      CONTRACT_CHECK(moved.Max == 0, "lighting " << preset << ", the second frame: " << moved);
      for (size_t i = 0; i + 1 < pictures.size(); ++i)
      {
        CONTRACT_CHECK(Compare(pictures[i], pictures.back()).Max > 10,
          "lighting " << preset << " looks like " << i << " of lights " << kind);
      }
      CONTRACT_CHECK(Describe(stage.GetRenderer()) == lights, "lights after " << preset);
      CONTRACT_CHECK(stage.GetRenderer()->GetMTime() == time, "the renderer after " << preset);
      const Difference after = Compare(before, stage.Grab(Pass::SCENE));
      CONTRACT_CHECK(after.Max == 0, "after lighting " << preset << ": " << after);
    }
  }
}

//------------------------------------------------------------------------------
// Props without a surface keep the renderer's lights, and picking finds the same.
VTK_INDIRECT_TEST(LightingOfTheRest)
{
  Stage stage;
  vtkRenderer* renderer = stage.GetRenderer();
  auto light = MakeLight(LightKind::Directional, { 1, 1, 3 }, { 0, 0, 0 });
  light->SetColor(1.0, 0.5, 0.2);
  renderer->AddLight(light);
  auto glass = MakeQuad({ 0.9, 0.4, 0.5 }, { 1.5, 0.4, 0.5 }, { 0.9, 1.0, 0.5 });
  glass->GetProperty()->SetOpacity(0.6);
  renderer->AddActor(glass);
  vtkNew<vtkAxesActor> axes;
  axes->SetTotalLength(0.7, 0.7, 0.7);
  axes->AxisLabelsOff();
  axes->SetShaftTypeToCylinder();
  vtkNew<vtkTransform> place;
  place->Translate(-1.6, 0.2, 0.0);
  axes->SetUserTransform(place);
  renderer->AddActor(axes);
  stage.IndirectPass->AntialiasingOff();
  const Pixels before = stage.Grab(Pass::SCENE);
  const Floats surface = Read(stage.IndirectPass, "normal");
  const Floats depth = Read(stage.IndirectPass, "depth");
  for (const int preset : Presets)
  {
    const Pixels after = stage.Grab(preset);
    int others = 0;
    for (int y = 0; y < after.Height; ++y)
    {
      for (int x = 0; x < after.Width; ++x)
      {
        const float* n = surface.At(x, y);
        const bool background = before.Get(x, y, 0) == 0 && before.Get(x, y, 1) == 0;
        if (n[0] != 0.0f || n[1] != 0.0f || n[2] != 0.0f || background)
        {
          continue;
        }
        ++others;
        CONTRACT_CHECK(std::equal(before.At(x, y), before.At(x, y) + 3, after.At(x, y)),
          "lighting " << preset << " at " << x << ", " << y);
      }
    }
    CONTRACT_CHECK(others > 50, "there are " << others << " pixels without a surface");
    vtkNew<vtkPropPicker> picker;
    picker->PickProp(40, 25, renderer);
    CONTRACT_CHECK(picker->GetViewProp() == renderer->GetViewProps()->GetItemAsObject(1),
      "what is picked with lighting " << preset);
    const Difference again = Compare(after, stage.Window.Grab());
    CONTRACT_CHECK(again.Max == 0, "after picking: " << again);
  }
  CONTRACT_CHECK(IsFinite(depth), "depth");
}

//------------------------------------------------------------------------------
// A camera that turns draws no map of the sky and builds no shader; and skies turn with it.
VTK_INDIRECT_TEST(LightingTurns)
{
  for (const bool kit : { false, true })
  {
    for (const int preset : Presets)
    {
      View view(64, 64);
      view.Renderer->AddActor(MakeSphere({ 0, 0, 0 }, 1.0, { 0.8, 0.8, 0.8 }, 64));
      if (kit)
      {
        AddKit(view.Renderer);
      }
      vtkNew<Pass> pass;
      pass->SetLighting(preset);
      view.Renderer->SetPass(pass);
      view.Renderer->ResetCamera();
      view.Grab();
      const Floats before = Read(pass, "sky");
      const long long tiles = CountOf(pass, "sky_tiles_drawn");
      // The least number of directions of a sky beside lights that nothing hides is 64.
      CONTRACT_CHECK(tiles >= 64, "maps of lighting " << preset << ": " << tiles);
      view.Grab();
      const long long builds = CountOf(pass, "shader_builds");
      for (int i = 0; i < 8; ++i)
      {
        view.Renderer->GetActiveCamera()->Azimuth(17.0);
        view.Renderer->GetActiveCamera()->Elevation(7.0);
        view.Renderer->GetActiveCamera()->OrthogonalizeViewUp();
        view.Grab();
      }
      const Floats after = Read(pass, "sky");
      CONTRACT_CHECK(CountOf(pass, "sky_tiles_drawn") == tiles,
        "lighting " << preset << ": " << CountOf(pass, "sky_tiles_drawn") - tiles << " maps more");
      CONTRACT_CHECK(CountOf(pass, "shader_builds") == builds, "shaders of lighting " << preset);
      // A ball looks the same from all sides, within the error of 256 directions and of their maps
      // at grazing angles: measured 0.004 to 0.011 of the mean.
      const Difference difference = Compare(before, after);
      const double mean = Mean(after, 0);
      std::cout << "lighting " << preset << ": differs by " << difference.Mean / mean
                << " of the mean " << mean << "\n";
      CONTRACT_CHECK(difference.Mean < 0.03 * mean, difference);
      CONTRACT_CHECK(mean > 0.02, "the sky is dark: " << mean);
    }
  }
}

//------------------------------------------------------------------------------
// The kept share of the renderer's lights casts no shadow: it is the same at all values, at least a
// half in gentle and exactly 0.6 in full in the shadow of its key, beside which the key counts
// fully.
VTK_INDIRECT_TEST(LightingKept)
{
  // The geometry buffer holds square roots of albedos to 1 / 1023 and normals to 15 bits.
  constexpr double packing = 2e-3;
  Stage stage;
  vtkRenderer* renderer = stage.GetRenderer();
  auto key = MakeLight(LightKind::Directional, { 1.0, 1.5, 0.8 }, { 0, 0, 0 });
  key->SetIntensity(0.7);
  auto other = MakeLight(LightKind::Directional, { -1.0, 0.3, 0.4 }, { 0, 0, 0 });
  other->SetIntensity(0.2);
  for (vtkLight* light : { key.Get(), other.Get() })
  {
    light->SetLightTypeToCameraLight();
    renderer->AddLight(light);
  }
  auto direct = [&stage](int lighting, bool shadows)
  {
    stage.IndirectPass->SetShadows(shadows);
    stage.Grab(lighting);
    return Read(stage.IndirectPass, "direct");
  };
  const Floats open = direct(Pass::SCENE, false);
  const Floats gentle = direct(Pass::GENTLE, true);
  const Floats whole = direct(Pass::FULL, false);
  const Floats full = direct(Pass::FULL, true);
  // Single precision through a few dozen operations; measured 2e-7.
  constexpr double rounding = 1e-4;
  double least = 1.0;
  double most = 0.0;
  int lit = 0;
  int hidden = 0;
  for (size_t i = 0; i < open.Values.size(); ++i)
  {
    const double kept = 0.6 * open.Values[i];
    if (kept < 0.05)
    {
      continue;
    }
    const double share = gentle.Values[i] / open.Values[i];
    least = std::min(least, share);
    most = std::max(most, share);
    CONTRACT_CHECK(full.Values[i] > kept * (1.0 - rounding), full.Values[i] << " of " << kept);
    CONTRACT_CHECK(full.Values[i] < whole.Values[i] * (1.0 + rounding), whole.Values[i]);
    const bool both = whole.Values[i] > 1.1 * kept;
    lit += both && full.Values[i] > whole.Values[i] * (1.0 - rounding) ? 1 : 0;
    hidden += both && full.Values[i] < kept * (1.0 + rounding) ? 1 : 0;
  }
  std::cout << "gentle keeps " << least << " to " << most << "; " << lit << " values lit, "
            << hidden << " hidden\n";
  CONTRACT_CHECK(most - least < packing, "gentle: " << least << " to " << most);
  CONTRACT_CHECK(least > 0.5 - packing && most < 1.0, "gentle: " << least << " to " << most);
  CONTRACT_CHECK(lit > 500 && hidden > 100, lit << " values lit, " << hidden << " hidden");
  // A kept light has no map to draw.
  stage.Grab(Pass::SOFT);
  const long long faces = CountOf(stage.IndirectPass, "faces_drawn");
  renderer->GetActiveCamera()->Azimuth(20.0);
  stage.Window.Grab();
  CONTRACT_CHECK(CountOf(stage.IndirectPass, "faces_drawn") == faces, "maps of soft");
  stage.Grab(Pass::FULL);
  CONTRACT_CHECK(CountOf(stage.IndirectPass, "faces_drawn") == faces + 1, "maps of full");

  renderer->RemoveAllLights();
  vtkNew<vtkLight> headlight;
  headlight->SetLightTypeToHeadlight();
  renderer->AddLight(headlight);
  // Light colours would keep more, because they clip.
  vtkActorCollection* actors = renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    vtkActor::SafeDownCast(actors->GetItemAsObject(i))->GetProperty()->SetColor(0.5, 0.5, 0.5);
  }
  const Floats own = direct(Pass::SCENE, false);
  const Floats less = direct(Pass::GENTLE, true);
  CONTRACT_CHECK(Mean(own, 0) > 0.1, "a headlight lights " << Mean(own, 0));
  for (size_t i = 0; i < own.Values.size(); ++i)
  {
    CONTRACT_CHECK(std::abs(less.Values[i] - 0.5 * own.Values[i]) < packing * own.Values[i] + 1e-6,
      less.Values[i] << " of " << own.Values[i]);
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(LightingReport)
{
  Stage stage;
  AddKit(stage.GetRenderer());
  Pass* pass = stage.IndirectPass;
  stage.Grab(Pass::SCENE);
  CONTRACT_CHECK(Report(pass).GetText().find("lighting") == std::string::npos, "lighting scene");
  const std::pair<int, const char*> names[] = { { Pass::SOFT, "lighting soft" },
    { Pass::FULL, "lighting full" }, { Pass::GENTLE, "lighting gentle" },
    { Pass::STUDIO, "lighting studio" } };
  for (const auto& [preset, name] : names)
  {
    stage.Grab(preset);
    const std::string why = Report(pass).FindReason("modelled", name);
    CONTRACT_CHECK(why.find("a sky of radiance") != std::string::npos &&
        why.find("in place of 5 lights of the renderer") != std::string::npos,
      name << ": " << why);
  }
  // The user's own settings take precedence.
  vtkNew<vtkEnvironmentLight> sky;
  sky->SetRadiance(0.25, 0.5, 0.75);
  pass->SetEnvironment(sky);
  stage.Grab(Pass::SOFT);
  const std::string why = Report(pass).FindReason("modelled", "lighting soft");
  CONTRACT_CHECK(why.find("the environment that is set") != std::string::npos, why);
  const Floats irradiance = Read(pass, "sky");
  const int top = irradiance.Height / 8; // a row of the floor with an unoccluded sky
  CONTRACT_CHECK(std::abs(irradiance.Get(5, top, 2) / irradiance.Get(5, top, 0) - 3.0f) < 0.01f,
    irradiance.Get(5, top, 2) << " " << irradiance.Get(5, top, 0));
  pass->SetEnvironment(nullptr);
  // Without indirect light there is no sky.
  pass->SetIndirectScale(0.0);
  const Pixels plain = stage.Grab(Pass::SCENE);
  const Pixels preset = stage.Grab(Pass::FULL);
  CONTRACT_CHECK(Compare(plain, preset).Max == 0, "lighting full without a sky");
  CONTRACT_CHECK(
    !Report(pass).FindReason("left_out", "lighting full").empty(), Report(pass).GetText());
}

//------------------------------------------------------------------------------
// Renderers with unusual lights.
VTK_INDIRECT_TEST(LightingHardCases)
{
  const std::pair<const char*, std::function<void(Stage&)>> cases[] = {
    { "no lights", [](Stage& s) { s.GetRenderer()->AutomaticLightCreationOff(); } },
    { "no lights on",
      [](Stage& s)
      {
        s.GetRenderer()->AutomaticLightCreationOff();
        auto light = MakeLight(LightKind::Point, { 1, 1, 1 }, { 0, 0, 0 });
        light->SwitchOff();
        s.GetRenderer()->AddLight(light);
      } },
    { "one light",
      [](Stage& s) {
        s.GetRenderer()->AddLight(MakeLight(LightKind::Point, { 1, 1, 1 }, { 0, 0, 0 }));
      } },
    { "a black kit",
      [](Stage& s)
      {
        AddKit(s.GetRenderer());
        vtkLightCollection* lights = s.GetRenderer()->GetLights();
        for (int i = 0; i < lights->GetNumberOfItems(); ++i)
        {
          vtkLight::SafeDownCast(lights->GetItemAsObject(i))->SetIntensity(0.0);
        }
      } },
    { "no shadows", [](Stage& s) { s.IndirectPass->ShadowsOff(); } },
    { "no visibility", [](Stage& s) { s.IndirectPass->SetVisibilityToNone(); } },
    { "parallel projection",
      [](Stage& s) { s.GetRenderer()->GetActiveCamera()->ParallelProjectionOn(); } },
    { "a camera that looks down",
      [](Stage& s)
      {
        s.GetRenderer()->GetActiveCamera()->SetPosition(0, 5, 0);
        s.GetRenderer()->GetActiveCamera()->SetFocalPoint(0, 0, 0);
        s.GetRenderer()->GetActiveCamera()->SetViewUp(0, 0, -1);
      } },
    { "no props", [](Stage& s) { s.GetRenderer()->RemoveAllViewProps(); } },
  };
  for (const auto& [name, change] : cases)
  {
    for (const int preset : Presets)
    {
      Stage stage;
      change(stage);
      const Pixels picture = stage.Grab(preset);
      if (stage.GetRenderer()->GetViewProps()->GetNumberOfItems() == 0)
      {
        CONTRACT_CHECK(Mean(picture, 0) == 0.0, name << ", lighting " << preset);
        continue;
      }
      const Floats final = Read(stage.IndirectPass, "final");
      CONTRACT_CHECK(IsFinite(final), name << ", lighting " << preset);
      CONTRACT_CHECK(Mean(final, 0) > 0.03, name << ", lighting " << preset << ": black");
      for (const float value : final.Values)
      {
        CONTRACT_CHECK(value >= 0.0f, name << ", lighting " << preset << ": " << value);
      }
    }
  }
}
