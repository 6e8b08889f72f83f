// SPDX-License-Identifier: BSD-3-Clause
// Sizes of lights: accepted values, their effects and limits, redrawing of maps, and extreme cases.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkGlyph3DMapper.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <limits>

using namespace contract;
using Pass = vtkIndirectIlluminationPass;

namespace
{
// The room with a ball in it, and a light from above.
struct LampRoom
{
  View Window{ 96, 72 };
  vtkNew<vtkIndirectIlluminationPass> IlluminationPass;
  vtkSmartPointer<vtkLight> Light;

  explicit LampRoom(LightKind kind = LightKind::Spot, bool indirect = false)
  {
    AddRoomSurfaces(this->Window.Renderer);
    this->Light = MakeLight(kind, { 0.5, 0.9, 0.6 }, { 0.4, 0.0, 0.45 }, 50.0);
    this->Window.Renderer->AddLight(this->Light);
    this->Window.Renderer->SetPass(this->IlluminationPass);
    this->IlluminationPass->SetIndirectScale(indirect ? 1.0 : 0.0);
  }
  Pass* GetPass() { return this->IlluminationPass; }
};

double MeanDirect(LampRoom& room)
{
  room.Window.Grab();
  const Floats direct = Read(room.GetPass(), "direct");
  CONTRACT_CHECK(IsFinite(direct), "a number that is none");
  return Mean(direct, 0);
}
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(PenumbraSettings)
{
  vtkNew<vtkLight> light;
  CONTRACT_CHECK(
    Pass::GetLightRadius(light) == 0.0 && Pass::GetLightAngle(light) == 0.0, "default");
  Pass::SetLightRadius(light, 0.5);
  Pass::SetLightAngle(light, 0.27);
  CONTRACT_CHECK(Pass::GetLightRadius(light) == 0.5, Pass::GetLightRadius(light));
  CONTRACT_CHECK(Pass::GetLightAngle(light) == 0.27, Pass::GetLightAngle(light));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (double wrong : { -1.0, nan, -infinity })
  {
    Pass::SetLightRadius(light, 0.5);
    Pass::SetLightRadius(light, wrong);
    CONTRACT_CHECK(Pass::GetLightRadius(light) == 0.0, wrong);
    Pass::SetLightAngle(light, 0.27);
    Pass::SetLightAngle(light, wrong);
    CONTRACT_CHECK(Pass::GetLightAngle(light) == 0.0, wrong);
  }
  Pass::SetLightRadius(light, infinity);
  CONTRACT_CHECK(Pass::GetLightRadius(light) == VTK_DOUBLE_MAX, "a radius without an end");
  Pass::SetLightAngle(light, 100.0);
  CONTRACT_CHECK(Pass::GetLightAngle(light) == 90.0, Pass::GetLightAngle(light));
  // A copy is a different light.
  vtkNew<vtkLight> copy;
  copy->DeepCopy(light);
  Pass::SetLightRadius(copy, 3.0);
  CONTRACT_CHECK(Pass::GetLightRadius(light) == VTK_DOUBLE_MAX, "a copy's size is the light's");
  {
    ExpectedErrors errors;
    Pass::SetLightRadius(nullptr, 1.0);
    CONTRACT_CHECK(errors.GetCount() == 1, errors.GetText());
    CONTRACT_CHECK(Pass::GetLightRadius(nullptr) == 0.0, "of nothing");
    CONTRACT_CHECK(errors.GetCount() == 1, errors.GetText());
  }
}

//------------------------------------------------------------------------------
// A new light at the address of a destroyed one has no size.
VTK_INDIRECT_TEST(PenumbraLightDeleted)
{
  for (int i = 0; i < 100; ++i)
  {
    vtkNew<vtkLight> light;
    CONTRACT_CHECK(Pass::GetLightRadius(light) == 0.0, "the size of a light that is gone");
    Pass::SetLightRadius(light, 1.0);
  }
  LampRoom room;
  const double hard = MeanDirect(room);
  Pass::SetLightRadius(room.Light, 0.1);
  const double soft = MeanDirect(room);
  CONTRACT_CHECK(soft != hard, "a size changes nothing");
  room.Window.Renderer->RemoveLight(room.Light);
  room.Light = MakeLight(LightKind::Spot, { 0.5, 0.9, 0.6 }, { 0.4, 0.0, 0.45 }, 50.0);
  room.Window.Renderer->AddLight(room.Light);
  CONTRACT_CHECK(MeanDirect(room) == hard, "the new light is not hard");
}

//------------------------------------------------------------------------------
// Without a size nothing changes, bit for bit, and without occluders nothing changes with a size
// either.
VTK_INDIRECT_TEST(PenumbraNone)
{
  for (LightKind kind :
    { LightKind::Directional, LightKind::Spot, LightKind::WideSpot, LightKind::Point })
  {
    LampRoom room(kind, true);
    const Pixels before = room.Window.Grab();
    const Floats irradiance = Read(room.GetPass(), "irradiance");
    const double bytes = Report(room.GetPass()).GetNumber("bytes");
    // Sizes of the other kind of light are ignored.
    Pass::SetLightRadius(room.Light, kind == LightKind::Directional ? 0.3 : 0.0);
    Pass::SetLightAngle(room.Light, kind == LightKind::Directional ? 0.0 : 5.0);
    Difference difference = Compare(room.Window.Grab(), before);
    CONTRACT_CHECK(difference.Max == 0.0, GetName(kind) << ": " << difference);
    Pass::SetLightRadius(room.Light, 0.1);
    Pass::SetLightAngle(room.Light, 3.0);
    difference = Compare(room.Window.Grab(), before);
    CONTRACT_CHECK(difference.Max > 0.0, GetName(kind) << ": no penumbra");
    CONTRACT_CHECK(Report(room.GetPass()).GetNumber("bytes") > bytes, "maps take no memory");
    difference.Max = Compare(Read(room.GetPass(), "irradiance"), irradiance).Max;
    CONTRACT_CHECK(difference.Max == 0.0, GetName(kind) << ": bounces are of the centre");
    Pass::SetLightRadius(room.Light, 0.0);
    Pass::SetLightAngle(room.Light, 0.0);
    difference = Compare(room.Window.Grab(), before);
    CONTRACT_CHECK(difference.Max == 0.0, GetName(kind) << ", once more: " << difference);
    CONTRACT_CHECK(Report(room.GetPass()).GetNumber("bytes") == bytes, "maps are kept for nothing");
  }
  // A single plane, at all angles to the light.
  View view(96, 96);
  vtkNew<vtkIndirectIlluminationPass> pass;
  view.Renderer->SetPass(pass);
  view.Renderer->AddActor(MakeQuad({ -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }));
  view.Renderer->GetActiveCamera()->SetPosition(0.4, -1.9, 1.8);
  view.Renderer->GetActiveCamera()->SetViewUp(0, 0, 1);
  view.Renderer->ResetCamera();
  for (LightKind kind : { LightKind::Directional, LightKind::Spot, LightKind::Point })
  {
    for (double height : { 2.0, 0.5, 0.05 })
    {
      auto light = MakeLight(kind, { 1.3, 0.7, height }, { 0.0, 0.0, 0.0 }, 40.0);
      Pass::SetLightRadius(light, 0.2);
      Pass::SetLightAngle(light, 8.0);
      view.Renderer->AddLight(light);
      view.Grab();
      const Floats direct = Read(pass, "direct");
      pass->ShadowsOff();
      view.Grab();
      const Floats open = Read(pass, "direct");
      pass->ShadowsOn();
      view.Renderer->RemoveAllLights();
      const Difference difference = Compare(direct, open);
      // The mean of ones is one but for rounding.
      CONTRACT_CHECK(
        difference.Max < 1e-6, GetName(kind) << " at height " << height << ": " << difference);
    }
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(PenumbraCached)
{
  LampRoom room;
  Pass::SetLightRadius(room.Light, 0.1);
  room.Window.Grab();
  const long long first = CountOf(room.GetPass(), "tiles_drawn");
  const long long builds = CountOf(room.GetPass(), "shader_builds");
  CONTRACT_CHECK(first == 32, first);
  room.Window.Renderer->GetActiveCamera()->Azimuth(5.0);
  room.Light->SetIntensity(0.5);
  room.Window.Grab();
  CONTRACT_CHECK(CountOf(room.GetPass(), "tiles_drawn") == first, "drawn for another eye");
  Pass::SetLightRadius(room.Light, 0.2);
  room.Window.Grab();
  CONTRACT_CHECK(CountOf(room.GetPass(), "tiles_drawn") == 2 * first, "not drawn for another size");
  CONTRACT_CHECK(CountOf(room.GetPass(), "shader_builds") == builds, "a size builds shaders");
  room.GetPass()->CachingOff();
  const Pixels kept = room.Window.Grab();
  const Difference difference = Compare(room.Window.Grab(), kept);
  CONTRACT_CHECK(difference.Max == 0.0, difference);
  room.GetPass()->ShadowsOff();
  room.Window.Grab();
  room.GetPass()->SetIndirectScale(1.0);
  room.Window.Grab();
  CONTRACT_CHECK(
    Report(room.GetPass()).FindReason("left_out", "size of light 0") == "Shadows are off",
    Report(room.GetPass()).GetText());
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(PenumbraReport)
{
  LampRoom room;
  Pass::SetLightRadius(room.Light, 0.1);
  room.Window.Grab();
  const Report report(room.GetPass());
  const std::string what = report.FindReason("modelled", "penumbra of light 0");
  CONTRACT_CHECK(what.find("32 points") != std::string::npos, report.GetText());
  CONTRACT_CHECK(
    !report.FindReason("left_out", "size of light 0 beyond its shadows").empty(), report.GetText());
  // The eye sees the penumbrae of a headlight with a size.
  View view;
  AddRoomSurfaces(view.Renderer);
  vtkNew<vtkLight> headlight;
  headlight->SetLightTypeToHeadlight();
  Pass::SetLightAngle(headlight, 5.0);
  view.Renderer->AddLight(headlight);
  vtkNew<vtkIndirectIlluminationPass> pass;
  view.Renderer->SetPass(pass);
  view.Grab();
  CONTRACT_CHECK(!Report(pass).FindReason("modelled", "penumbra of light 0").empty(), "headlight");
  view.Renderer->GetActiveCamera()->Azimuth(10.0);
  view.Grab();
}

//------------------------------------------------------------------------------
// The same picture at any scale.
VTK_INDIRECT_TEST(PenumbraScales)
{
  for (LightKind kind : { LightKind::Directional, LightKind::Spot, LightKind::Point })
  {
    Floats unit;
    for (double scale : { 1.0, 1e-6, 1e6 })
    {
      View view(96, 96);
      vtkNew<vtkIndirectIlluminationPass> pass;
      pass->SetIndirectScale(0.0);
      view.Renderer->SetPass(pass);
      auto at = [&](double x, double y, double z) {
        return Vec3{ x * scale, y * scale, z * scale };
      };
      view.Renderer->AddActor(MakeQuad(at(-1, -1, 0), at(1, -1, 0), at(-1, 1, 0)));
      view.Renderer->AddActor(MakeSphere(at(-0.2, 0.1, 0.4), 0.2 * scale));
      auto light = MakeLight(kind, at(-0.9, 0.4, 1.6), at(0, 0, 0), 45.0);
      Pass::SetLightRadius(light, 0.1 * scale);
      Pass::SetLightAngle(light, 4.0);
      view.Renderer->AddLight(light);
      vtkCamera* camera = view.Renderer->GetActiveCamera();
      camera->SetPosition(0.0, -1.5 * scale, 2.5 * scale);
      camera->SetFocalPoint(0.0, 0.0, 0.0);
      camera->SetViewUp(0, 0, 1);
      camera->SetClippingRange(0.5 * scale, 6.0 * scale);
      view.Grab();
      const Floats direct = Read(pass, "direct");
      CONTRACT_CHECK(IsFinite(direct), GetName(kind) << " at scale " << scale);
      if (unit.Values.empty())
      {
        unit = direct;
        continue;
      }
      const Difference difference = Compare(direct, unit);
      std::cout << GetName(kind) << " at scale " << scale << ": " << difference << "\n";
      // Rounding moves the edges of a few points' shadows, a 32nd each, at a few pixels.
      CONTRACT_CHECK(difference.Mean < 1e-4 && difference.Max < 0.1, GetName(kind) << difference);
    }
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(PenumbraExtremes)
{
  const struct
  {
    Vec3 Position;
    double Radius;
  } cases[] = { { { 0.5, 0.9, 0.6 }, 1e-30 }, { { 0.5, 0.9, 0.6 }, 10.0 },
    { { 0.5, 0.9, 0.6 }, VTK_DOUBLE_MAX }, { { 0.5, 0.0, 0.5 }, 0.2 }, { { 0.0, 0.0, 0.0 }, 0.1 },
    { { 0.35, 0.2, 0.35 }, 0.05 }, { { 1e6, 1e6, 1e6 }, 1e5 }, { { 1e6, 1e6, 1e6 }, 1e-3 } };
  for (LightKind kind :
    { LightKind::Directional, LightKind::Spot, LightKind::WideSpot, LightKind::Point })
  {
    for (const auto& c : cases)
    {
      LampRoom room(kind);
      room.Light->SetPosition(c.Position.data());
      Pass::SetLightRadius(room.Light, c.Radius);
      Pass::SetLightAngle(room.Light, std::min(c.Radius, 90.0));
      const double soft = MeanDirect(room);
      room.GetPass()->ShadowsOff();
      room.GetPass()->SetIndirectScale(1e-6);
      const double open = MeanDirect(room);
      std::cout << GetName(kind) << " of radius " << c.Radius << ": " << soft << " of " << open
                << "\n";
      CONTRACT_CHECK(soft >= 0.0 && soft <= open * (1.0 + 1e-5),
        GetName(kind) << " of radius " << c.Radius << ": " << soft << " of " << open);
    }
  }
  // A light of this size is a point.
  LampRoom room;
  const double hard = MeanDirect(room);
  Pass::SetLightRadius(room.Light, 1e-30);
  const double soft = MeanDirect(room);
  // Maps of points have different texels from the centre's map.
  CONTRACT_CHECK(std::abs(soft - hard) < 0.01 * hard, soft << " and " << hard);
}

//------------------------------------------------------------------------------
// Many lights of all kinds, hard and soft ones, and everything that VTK draws.
VTK_INDIRECT_TEST(PenumbraKinds)
{
  View view(96, 72);
  AddKinds(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  view.Renderer->SetPass(pass);
  view.Renderer->ResetCamera();
  double bounds[6];
  view.Renderer->ComputeVisiblePropBounds(bounds);
  const Vec3 middle = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
    0.5 * (bounds[4] + bounds[5]) };
  const double size = bounds[1] - bounds[0];
  int i = 0;
  for (LightKind kind : { LightKind::Spot, LightKind::Directional, LightKind::Point,
         LightKind::WideSpot, LightKind::Spot, LightKind::Directional })
  {
    auto light = MakeLight(
      kind, { middle[0] + 0.3 * size * (i - 2), middle[1], middle[2] + size }, middle, 50.0);
    light->SetIntensity(0.2);
    if (i % 3 != 1)
    {
      Pass::SetLightRadius(light, 0.05 * size);
      Pass::SetLightAngle(light, 3.0);
    }
    view.Renderer->AddLight(light);
    ++i;
  }
  view.Grab();
  CONTRACT_CHECK(IsFinite(Read(pass, "direct")), "a number that is none");
  view.Renderer->GetActiveCamera()->ParallelProjectionOn();
  view.Grab();
  CONTRACT_CHECK(IsFinite(Read(pass, "direct")), "a number that is none");
}

//------------------------------------------------------------------------------
// Props that only mappers can draw cast the same penumbra as their polygons.
VTK_INDIRECT_TEST(PenumbraOfGlyphs)
{
  for (LightKind kind : { LightKind::Directional, LightKind::Spot, LightKind::Point })
  {
    Floats polygons;
    for (bool glyphs : { false, true })
    {
      View view(96, 96);
      vtkNew<vtkIndirectIlluminationPass> pass;
      pass->SetIndirectScale(0.0);
      view.Renderer->SetPass(pass);
      view.Renderer->AddActor(MakeQuad({ -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }));
      vtkNew<vtkSphereSource> ball;
      ball->SetRadius(0.2);
      ball->SetThetaResolution(32);
      ball->SetPhiResolution(32);
      vtkSmartPointer<vtkActor> actor = MakeActor(ball);
      vtkNew<vtkPlaneSource> places;
      vtkNew<vtkGlyph3DMapper> mapper;
      if (glyphs)
      {
        // A glyph on each corner of a square without an area.
        places->SetOrigin(0, 0, 0);
        places->SetPoint1(1e-4, 0, 0);
        places->SetPoint2(0, 1e-4, 0);
        mapper->SetInputConnection(places->GetOutputPort());
        mapper->SetSourceConnection(ball->GetOutputPort());
        mapper->ScalingOff();
        actor->SetMapper(mapper);
      }
      actor->SetPosition(-0.2, 0.1, 0.5);
      view.Renderer->AddActor(actor);
      auto light = MakeLight(kind, { -0.9, 0.4, 1.8 }, { 0, 0, 0 }, 45.0);
      Pass::SetLightRadius(light, 0.15);
      Pass::SetLightAngle(light, 6.0);
      view.Renderer->AddLight(light);
      vtkCamera* camera = view.Renderer->GetActiveCamera();
      camera->SetPosition(0.0, -1.5, 2.5);
      camera->SetFocalPoint(0.0, 0.0, 0.0);
      camera->SetViewUp(0, 0, 1);
      camera->SetClippingRange(0.5, 6.0);
      view.Grab();
      const Floats direct = Read(pass, "direct");
      if (!glyphs)
      {
        polygons = direct;
        continue;
      }
      const Difference difference = Compare(direct, polygons);
      std::cout << GetName(kind) << ": " << difference << "\n";
      // Outlines that lie 1e-4 apart, and pixels at them.
      CONTRACT_CHECK(difference.Mean < 2e-3, GetName(kind) << ": " << difference);
    }
  }
}
