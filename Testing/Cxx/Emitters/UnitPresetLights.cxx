// SPDX-License-Identifier: BSD-3-Clause
// The lights of presets: their skies' light, against closed forms.
#include "Emitters/vtkIndirectEmitterAccess.h"
#include "Emitters/vtkIndirectPresetLights.h"
#include "Pipeline/vtkIndirectLighting.h"
#include "vtkActor.h"
#include "vtkEnvironmentLight.h"
#include "vtkIndirectSettings.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace vtkIndirectTest;

namespace
{
// Irradiance of a surface with this normal under the unoccluded sky: (1 / pi) times the integral of
// radiance and cosine, by rings around the normal.
glm::dvec3 FindIrradiance(
  const vtkIndirectPresetLights& presetLights, const glm::dvec3& normal, const int count = 256)
{
  const glm::dvec3 helper = std::abs(normal.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(helper, normal));
  const glm::dvec3 y = glm::cross(normal, x);
  glm::dvec3 sum(0.0);
  for (int i = 0; i < count; ++i)
  {
    // Rings of equal projected area.
    const double s = std::sqrt((i + 0.5) / count);
    for (int k = 0; k < count; ++k)
    {
      const double angle = 2.0 * vtkMath::Pi() * (k + 0.5) / count;
      sum += presetLights.GetRadiance(
        s * (std::cos(angle) * x + std::sin(angle) * y) + std::sqrt(1.0 - s * s) * normal);
    }
  }
  return sum / static_cast<double>(count * count);
}

const char* const Quadrature = "quadrature by 65536 directions";

// Mean irradiance of a ball seen by a distant camera along z: over its disk, all lights but the sky
// by their cosines.
double FindIrradianceOfBall(const vtkIndirectPresetLights& presetLights, bool sky)
{
  constexpr int Rings = 12;
  constexpr int Sectors = 24;
  double sum = 0.0;
  for (int i = 0; i < Rings; ++i)
  {
    const double s = std::sqrt((i + 0.5) / Rings);
    for (int k = 0; k < Sectors; ++k)
    {
      const double angle = 2.0 * vtkMath::Pi() * (k + 0.5) / Sectors;
      const glm::dvec3 n(s * std::cos(angle), s * std::sin(angle), std::sqrt(1.0 - s * s));
      glm::dvec3 color = sky ? FindIrradiance(presetLights, n, 32) : glm::dvec3(0.0);
      color += std::max(glm::dot(n, presetLights.Key.Direction), 0.0) * presetLights.Key.Color;
      for (const vtkIndirectDistantLight& fill : presetLights.Fills)
      {
        color += std::max(glm::dot(n, fill.Direction), 0.0) * fill.Color;
      }
      sum += (color.x + color.y + color.z) / 3.0;
    }
  }
  return sum / (Rings * Sectors);
}

// The lights of vtkLightKit: a headlight, a key, a fill and two at the back.
std::vector<vtkIndirectDistantLight> MakeKit()
{
  auto lamp = [](double elevation, double azimuth, const glm::dvec3& color)
  {
    return vtkIndirectDistantLight{ vtkIndirectPresetLights::FromAngles(elevation, azimuth),
      color };
  };
  return { { { 0, 0, 1 }, glm::dvec3(0.25) }, lamp(50, 10, { 0.75, 0.729, 0.677 }),
    lamp(-75, 0, { 0.227, 0.233, 0.25 }), lamp(0, 110, glm::dvec3(0.214)),
    lamp(0, -110, glm::dvec3(0.214)) };
}

const std::pair<int, const char*> Presets[] = { { vtkIndirectLightingSoft, "soft" },
  { vtkIndirectLightingFull, "full" }, { vtkIndirectLightingGentle, "gentle" },
  { vtkIndirectLightingStudio, "studio" } };
}

VTK_INDIRECT_TEST(PresetLightsLobes)
{
  for (const double exponent : { 0.0, 1.0, 4.0, 16.0 })
  {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.3, -0.8, 0.5));
    vtkIndirectPresetLights presetLights;
    presetLights.Lobes.push_back({ { direction, { 0.5, 1.0, 2.0 } }, exponent });
    const glm::dvec3 facing = FindIrradiance(presetLights, direction);
    const std::string name = "power " + std::to_string(static_cast<int>(exponent));
    CheckRelative(name + ", red", facing.x, 0.5, 1e-3, Quadrature);
    CheckRelative(name + ", green", facing.y, 1.0, 1e-3, Quadrature);
    CheckRelative(name + ", blue", facing.z, 2.0, 1e-3, Quadrature);
    CheckEqual(name + ", from behind", presetLights.GetRadiance(-direction).y, 0.0);
  }
  // A hemisphere of constant radiance, of which a vertical surface sees half.
  vtkIndirectPresetLights half;
  half.Lobes.push_back({ { { 0, 0, 1 }, glm::dvec3(1.0) }, 0.0 });
  CheckRelative(
    "half a sky, from the side", FindIrradiance(half, { 1, 0, 0 }).x, 0.5, 5e-3, Quadrature);
  vtkIndirectPresetLights everywhere;
  everywhere.Ambient = glm::dvec3(0.7);
  CheckRelative(
    "everywhere the same", FindIrradiance(everywhere, { 0, 1, 0 }).x, 0.7, 1e-12, "rounding");
}

// Goal of the presets: a ball is as bright as with the renderer's own lights, times a compensation
// for self-shadowing.
VTK_INDIRECT_TEST(PresetLightsBall)
{
  const char* const why = "quadrature by 288 normals and 1024 directions";
  Random random(11);
  std::vector<vtkIndirectDistantLight> three;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3 color(random.Next(), random.Next(), random.Next());
    three.push_back({ random.NextDirection(), color });
  }
  const std::pair<const char*, std::vector<vtkIndirectDistantLight>> sets[] = {
    { "a headlight", { { { 0, 0, 1 }, glm::dvec3(0.7) } } }, { "vtkLightKit", MakeKit() },
    { "a light from the side", { { { 0.8, 0, 0.6 }, { 1.0, 0.5, 0.2 } } } },
    { "three anywhere", three },
    { "two that balance each other",
      { { { 1, 0, 0 }, glm::dvec3(0.5) }, { { -1, 0, 0 }, glm::dvec3(0.5) } } }
  };
  for (const auto& [name, lamps] : sets)
  {
    vtkIndirectPresetLights own;
    own.Fills = lamps;
    const double plain = FindIrradianceOfBall(own, false);
    CheckRelative(std::string(name) + ", in closed form", own.GetIrradianceOfBall(), plain, 0.01,
      "quadrature by 288 normals");
    for (const auto& [preset, title] : Presets)
    {
      // Without a sky of its own a preset measures nothing: the share is fixed.
      const vtkIndirectPresetLights presetLights =
        vtkIndirectPresetLights::Make(preset, lamps, {}, false);
      CheckEqual(
        std::string(name) + ", " + title + ", nothing to measure", presetLights.MostReplaced, 0.0);
      const bool gentle = preset == vtkIndirectLightingGentle;
      const bool atViewer = (gentle || preset == vtkIndirectLightingSoft) && lamps.size() == 1 &&
        lamps[0].Direction.z == 1.0;
      const double rest = (atViewer ? 0.6 : 0.4) * (gentle ? 0.5 : 1.0);
      CheckRelative(std::string(name) + ", " + title, FindIrradianceOfBall(presetLights, true),
        (1.0 - rest + rest / (atViewer ? 0.86 : 0.83)) * plain, 0.01, why);
      double kept = 0.0;
      for (const vtkIndirectDistantLight& fill : presetLights.Fills)
      {
        kept += vtkIndirectPresetLights::GetIrradianceOfBall(fill);
      }
      // At least: in full the viewer's light has no lobe.
      CheckAtLeast(std::string(name) + ", " + title + ", without shadows",
        kept +
          (1.0 - presetLights.KeyShadow) *
            vtkIndirectPresetLights::GetIrradianceOfBall(presetLights.Key),
        (1.0 - rest) * own.GetIrradianceOfBall() * (1.0 - 1e-12), "rounding");
      if (gentle || preset == vtkIndirectLightingSoft)
      {
        CheckRelative(std::string(name) + ", " + title + ", what is kept", kept,
          (1.0 - rest) * own.GetIrradianceOfBall(), 1e-12, "rounding");
      }
      // With a sky of its own the frame measures how much of the lights the sky replaces: all of
      // them are there, and the sky alone is as bright.
      const vtkIndirectPresetLights measured = vtkIndirectPresetLights::Make(preset, lamps);
      const double most = preset == vtkIndirectLightingFull ? 0.0 : gentle ? 0.5 : 1.0;
      CheckEqual(std::string(name) + ", " + title + ", to measure", measured.MostReplaced, most);
      if (most > 0.0)
      {
        CheckRelative(std::string(name) + ", " + title + ", lights and sky",
          FindIrradianceOfBall(measured, true), 2.0 * plain, 0.01, why);
      }
    }
  }
}

// The sky of soft has the same total light, and the same vector sum, as the lights that it
// replaces: both sums over all directions.
VTK_INDIRECT_TEST(PresetLightsSoftSky)
{
  const std::vector<vtkIndirectDistantLight> kit = MakeKit();
  const vtkIndirectPresetLights presetLights =
    vtkIndirectPresetLights::Make(vtkIndirectLightingSoft, kit);
  double scalar = 0.0;
  glm::dvec3 vector(0.0);
  for (const vtkIndirectDistantLight& lamp : kit)
  {
    scalar += lamp.Color.y;
    vector += lamp.Color.y * lamp.Direction;
  }
  double skyScalar = 0.0;
  glm::dvec3 skyVector(0.0);
  constexpr int Count = 200000;
  for (int i = 0; i < Count; ++i)
  {
    // A spiral from pole to pole, of equal areas.
    const double z = 1.0 - 2.0 * (i + 0.5) / Count;
    const double angle = vtkMath::Pi() * (3.0 - std::sqrt(5.0)) * i;
    const double r = std::sqrt(1.0 - z * z);
    const glm::dvec3 direction(r * std::cos(angle), r * std::sin(angle), z);
    const double radiance = presetLights.GetRadiance(direction).y * 4.0 / Count;
    skyScalar += radiance;
    skyVector += radiance * direction;
  }
  CheckRelative("vector over scalar irradiance", glm::length(skyVector) / skyScalar,
    glm::length(vector) / scalar, 0.01, "the lights' colours differ in direction");
  CheckAtLeast("cosine between the vectors",
    glm::dot(glm::normalize(skyVector), glm::normalize(vector)), 0.999,
    "the lights' colours differ in direction");
}

VTK_INDIRECT_TEST(PresetLightsKit)
{
  std::vector<vtkIndirectDistantLight> kit = { { { 0, 0, 1 }, { 0.2, 0.2, 0.2 } },
    { { 0, 1, 0 }, { 0.9, 0.6, 0.3 } }, { { 1, 0, 0 }, { 0.0, 0.1, 0.4 } } };
  const vtkIndirectPresetLights studio =
    vtkIndirectPresetLights::Make(vtkIndirectLightingStudio, kit);
  CheckEqual("lobes of studio", static_cast<double>(studio.Lobes.size()), 3.0);
  CheckEqual("all are kept", static_cast<double>(studio.Fills.size()), 3.0);
  for (size_t i = 0; i < kit.size(); ++i)
  {
    Check("they are kept as they are",
      studio.Fills[i].Direction == kit[i].Direction && studio.Fills[i].Color == kit[i].Color);
  }
  Check("studio has no key", studio.Key.Color == glm::dvec3(0.0));
  const vtkIndirectPresetLights full = vtkIndirectPresetLights::Make(vtkIndirectLightingFull, kit);
  CheckEqual("lobes of full", static_cast<double>(full.Lobes.size()), 1.0);
  CheckEqual("fills of full", static_cast<double>(full.Fills.size()), 2.0);
  Check("the light from the viewer is sharp, as no shadow of it is visible",
    full.Fills[0].Direction == kit[0].Direction && full.Fills[0].Color.x > 0.6 * 0.2);
  Check("the brightest is the key", full.Key.Direction == kit[1].Direction);
  CheckRelative("shadows leave of it what is kept of every light",
    (1.0 - full.KeyShadow) * full.Key.Color.x, 0.6 * 0.9, 1e-12, "rounding");
  for (const vtkIndirectPresetLights& presetLights : { studio, full })
  {
    for (const auto& lobe : presetLights.Lobes)
    {
      const auto same = std::find_if(kit.begin(), kit.end(),
        [&](const vtkIndirectDistantLight& lamp) { return lamp.Direction == lobe.Lamp.Direction; });
      Check("a lobe is where a light of the kit is", same != kit.end());
      CheckAbsolute("its colour is that light's",
        glm::length(glm::cross(lobe.Lamp.Color, same->Color)), 0.0, 1e-12, "rounding");
    }
  }
  CheckRelative("the key keeps its ratio to the others",
    full.KeyShadow * full.Key.Color.z / full.Lobes[0].Lamp.Color.z, 0.3 / 0.4, 1e-12, "rounding");

  // No lights count as a headlight, and everything scales with its strength.
  for (const auto& [preset, title] : Presets)
  {
    const std::string name = title;
    const vtkIndirectPresetLights own = vtkIndirectPresetLights::Make(preset, {});
    const vtkIndirectPresetLights dim = vtkIndirectPresetLights::Make(preset, { kit[0] });
    CheckEqual(name + ", lobes", static_cast<double>(dim.Lobes.size()),
      static_cast<double>(own.Lobes.size()));
    CheckRelative(name + ", ambient", dim.Ambient.x / own.Ambient.x, 0.2, 1e-12, "its strength");
    CheckRelative(name + ", fill", dim.Fills.at(0).Color.x / own.Fills.at(0).Color.x, 0.2, 1e-12,
      "its strength");
    CheckAbsolute(name + ", key", dim.Key.Color.x, 0.2 * own.Key.Color.x, 1e-12, "rounding");
    CheckEqual(name + ", shadow of the key", dim.KeyShadow, 1.0);
  }
}

// The gain of bounces is that of the cavity which has most of them, by its light balance.
VTK_INDIRECT_TEST(PresetLightsGain)
{
  for (const double albedo : { 0.1, 0.5, 0.75, 0.9, 0.95, 1.0 })
  {
    double most = 1.0;
    for (double share = 0.001; share <= 5.0 / 6.0; share += 0.001)
    {
      // Each place sees the mean of what all places of the cavity reflect.
      const double direct = 1.0 - share;
      double mean = direct;
      for (int bounce = 0; bounce < 200; ++bounce)
      {
        mean = direct + albedo * share * mean;
      }
      most = std::max(most, 1.0 + albedo * share * mean);
    }
    CheckRelative("gain of albedo " + std::to_string(albedo),
      vtkIndirectPresetLights::FindGain(albedo), most, 1e-3, "shares in steps of 0.001");
  }
  CheckEqual("gain of black", vtkIndirectPresetLights::FindGain(0.0), 1.0);
}

// Concave parts of a light object, which reflect the light that falls on them, stay within the
// headroom between white and plain VTK's brightness, and convex parts are as bright as promised.
VTK_INDIRECT_TEST(PresetLightsHeadroom)
{
  const char* const why = "quadrature, and normals some degrees apart";
  const std::vector<vtkIndirectDistantLight> headlight = { { { 0, 0, 1 }, glm::dvec3(1.0) } };
  for (const auto& own : { headlight, MakeKit() })
  {
    double plain = 0.0;
    for (const vtkIndirectDistantLight& lamp : own)
    {
      plain += vtkIndirectPresetLights::GetIrradianceOfBall(lamp);
    }
    for (const auto& [preset, title] : Presets)
    {
      const double before =
        vtkIndirectPresetLights::Make(preset, own, {}, false).GetIrradianceOfBall() / plain;
      double last = before;
      for (const double albedo : { 0.3, 0.6, 0.9, 1.0, -1.0 }) // below 0: data
      {
        const std::string name = std::string(title) + ", " + std::to_string(own.size()) +
          " lights, albedo " + std::to_string(albedo);
        const vtkIndirectPresetLights presetLights = vtkIndirectPresetLights::Make(
          preset, own, { std::max(albedo, 0.0), albedo < 0.0 }, false);
        // The last of the renderer's lights is kept by the same share as all others.
        const double kept = presetLights.Fills.back().Color.x / own.back().Color.x;
        const double gain = albedo < 0.0 ? 1.07 : vtkIndirectPresetLights::FindGain(albedo);
        double most = 0.0;
        double brightest = 0.0;
        Random random(3);
        for (int i = 0; i < 1000; ++i)
        {
          const glm::dvec3 normal = random.NextDirection();
          glm::dvec3 vtk(0.0);
          for (const vtkIndirectDistantLight& lamp : own)
          {
            vtk += std::max(glm::dot(normal, lamp.Direction), 0.0) * lamp.Color;
          }
          glm::dvec3 all = FindIrradiance(presetLights, normal, 32);
          all +=
            std::max(glm::dot(normal, presetLights.Key.Direction), 0.0) * presetLights.Key.Color;
          for (const vtkIndirectDistantLight& fill : presetLights.Fills)
          {
            all += std::max(glm::dot(normal, fill.Direction), 0.0) * fill.Color;
          }
          const glm::dvec3 concave = kept * vtk + gain * (all - kept * vtk);
          most = std::max({ most, vtk.x, vtk.y, vtk.z });
          brightest = std::max({ brightest, concave.x, concave.y, concave.z });
        }
        const double white = 1.0 / std::abs(albedo);
        CheckAtMost(name + ", what is concave", brightest, std::max(white, most) * 1.01, why);
        const double total = presetLights.GetIrradianceOfBall() / plain;
        CheckAtLeast(name + ", what is convex", total, 0.92 - 1e-9, "the promise");
        CheckAtMost(
          name + ", no brighter than of unknown albedo", total, before + 1e-9, "rounding");
        if (albedo > 0.0)
        {
          CheckAtMost(name + ", no brighter than what is darker", total, last + 1e-9, "rounding");
          last = total;
        }
        if (albedo == 1.0)
        {
          // The strength uses the whole headroom.
          CheckAtLeast(name + ", what is concave", brightest, std::max(white, most) * 0.98, why);
        }
      }
    }
  }
}

// Dark parts of a sky would change its maps when it turns, and bright directions would be drawn
// separately: the presets' skies have neither.
VTK_INDIRECT_TEST(PresetLightsSkies)
{
  for (const auto& [preset, title] : Presets)
  {
    const vtkIndirectPresetLights presetLights = vtkIndirectPresetLights::Make(preset, {});
    double least = 1e30;
    double most = 0.0;
    double sum = 0.0;
    constexpr int Count = 4096;
    Random random(5);
    for (int i = 0; i < Count; ++i)
    {
      const double radiance = presetLights.GetRadiance(random.NextDirection()).x;
      least = std::min(least, radiance);
      most = std::max(most, radiance);
      sum += radiance;
    }
    const std::string name = title;
    CheckAtLeast(name + ", least radiance", least, 0.01, "a map for each direction");
    CheckAtMost(name + ", largest over mean radiance", most * Count / sum, 256.0 / 32.0,
      "a 256th of the sky has less than a 32nd of its light");
  }
}

// Presets ask the same reader of albedo as rays and voxels do: PBR has VTK's diffuse coefficient,
// too.
VTK_INDIRECT_TEST(PresetAlbedoOfPBR)
{
  const auto find = [](int interpolation, double color, double diffuse, double metallic)
  {
    vtkNew<vtkPlaneSource> plane;
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    mapper->Update();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetInterpolation(interpolation);
    actor->GetProperty()->SetColor(color, color, color);
    actor->GetProperty()->SetDiffuse(diffuse);
    actor->GetProperty()->SetMetallic(metallic);
    vtkNew<vtkRenderer> renderer;
    renderer->AddActor(actor);
    vtkNew<vtkLight> light;
    light->SetLightTypeToHeadlight();
    renderer->AddLight(light);
    vtkIndirectSettings settings;
    settings.Lighting = vtkIndirectLightingFull;
    vtkIndirectLighting lighting;
    lighting.Update(renderer, settings, nullptr);
    glm::dvec3 sum(0.0);
    for (const vtkIndirectEmitterAccess::Cell& cell :
      vtkIndirectEmitterAccess::GetCells(lighting.GetEnvironment()))
    {
      sum += glm::dvec3(cell.Light[0], cell.Light[1], cell.Light[2]);
    }
    return sum.x;
  };
  const double phong = find(VTK_PHONG, 0.9, 0.5, 0.0);
  CheckRelative("sky over PBR of half the coefficient", find(VTK_PBR, 0.9, 0.5, 0.0), phong, 1e-9,
    "the same albedo");
  CheckRelative("sky over PBR that is half a metal", find(VTK_PBR, 0.9, 1.0, 0.5), phong, 1e-9,
    "the same albedo");
  CheckAtLeast("sky over the whole coefficient: difference",
    std::abs(find(VTK_PHONG, 0.9, 1.0, 0.0) - phong) / phong, 0.01, "the test's own power");
}
