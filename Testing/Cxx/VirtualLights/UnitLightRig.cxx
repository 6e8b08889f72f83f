// SPDX-License-Identifier: BSD-3-Clause
// The lights of presets: what their skies send, against closed forms.
#include "VirtualLights/vtkIndirectLightRig.h"
#include "vtkIndirectSettings.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
// Irradiance of a surface with this normal that nothing hides the sky from: (1 / pi) times the
// integral of radiance and cosine, by rings around the normal.
glm::dvec3 FindIrradiance(const vtkIndirectLightRig& rig, const glm::dvec3& normal)
{
  const glm::dvec3 helper = std::abs(normal.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(helper, normal));
  const glm::dvec3 y = glm::cross(normal, x);
  constexpr int Rings = 256;
  constexpr int Sectors = 256;
  glm::dvec3 sum(0.0);
  for (int i = 0; i < Rings; ++i)
  {
    // Rings of equal projected area.
    const double s = std::sqrt((i + 0.5) / Rings);
    for (int k = 0; k < Sectors; ++k)
    {
      const double angle = 2.0 * vtkMath::Pi() * (k + 0.5) / Sectors;
      sum += rig.GetRadiance(
        s * (std::cos(angle) * x + std::sin(angle) * y) + std::sqrt(1.0 - s * s) * normal);
    }
  }
  return sum / static_cast<double>(Rings * Sectors);
}

const char* const Quadrature = "quadrature by 65536 directions";
}

VTK_INDIRECT_TEST(LightRigLobes)
{
  for (const double exponent : { 0.0, 1.0, 4.0, 16.0 })
  {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.3, -0.8, 0.5));
    vtkIndirectLightRig rig;
    rig.Lobes.push_back({ { direction, { 0.5, 1.0, 2.0 } }, exponent });
    const glm::dvec3 facing = FindIrradiance(rig, direction);
    const std::string name = "power " + std::to_string(static_cast<int>(exponent));
    CheckRelative(name + ", red", facing.x, 0.5, 1e-3, Quadrature);
    CheckRelative(name + ", green", facing.y, 1.0, 1e-3, Quadrature);
    CheckRelative(name + ", blue", facing.z, 2.0, 1e-3, Quadrature);
    CheckEqual(name + ", from behind", rig.GetRadiance(-direction).y, 0.0);
  }
  // A hemisphere of constant radiance: half of it is seen from the side.
  vtkIndirectLightRig half;
  half.Lobes.push_back({ { { 0, 0, 1 }, glm::dvec3(1.0) }, 0.0 });
  CheckRelative(
    "half a sky, from the side", FindIrradiance(half, { 1, 0, 0 }).x, 0.5, 5e-3, Quadrature);
  vtkIndirectLightRig everywhere;
  everywhere.Ambient = glm::dvec3(0.7);
  CheckRelative(
    "everywhere the same", FindIrradiance(everywhere, { 0, 1, 0 }).x, 0.7, 1e-12, "rounding");
}

VTK_INDIRECT_TEST(LightRigKit)
{
  std::vector<vtkIndirectLamp> kit = { { { 0, 0, 1 }, { 0.2, 0.2, 0.2 } },
    { { 0, 1, 0 }, { 0.9, 0.6, 0.3 } }, { { 1, 0, 0 }, { 0.0, 0.1, 0.4 } } };
  const vtkIndirectLightRig studio = vtkIndirectLightRig::Make(vtkIndirectLightingStudio, kit);
  CheckEqual("lobes of studio", static_cast<double>(studio.Lobes.size()), 2.0);
  Check("what comes from the viewer has no visible shadow", studio.Headlight.x > 0.0);
  Check("studio has no key", studio.Key.Color == glm::dvec3(0.0));
  const vtkIndirectLightRig full = vtkIndirectLightRig::Make(vtkIndirectLightingFull, kit);
  CheckEqual("lobes of full", static_cast<double>(full.Lobes.size()), 1.0);
  Check("the brightest is the key", full.Key.Direction == kit[1].Direction);
  for (const vtkIndirectLightRig& rig : { studio, full })
  {
    for (const auto& lobe : rig.Lobes)
    {
      const auto same = std::find_if(kit.begin(), kit.end(),
        [&](const vtkIndirectLamp& lamp) { return lamp.Direction == lobe.Lamp.Direction; });
      Check("a lobe is where a light of the kit is", same != kit.end());
      CheckAbsolute("its colour is that light's",
        glm::length(glm::cross(lobe.Lamp.Color, same->Color)), 0.0, 1e-12, "rounding");
    }
  }
  CheckRelative("the key keeps its ratio to the others",
    full.Key.Color.z / full.Lobes[0].Lamp.Color.z, 0.3 / 0.4, 1e-12, "rounding");

  // A headlight alone is no kit: only its strength counts.
  for (const int preset : { vtkIndirectLightingStudio, vtkIndirectLightingFull })
  {
    const vtkIndirectLightRig own = vtkIndirectLightRig::Make(preset, {});
    const vtkIndirectLightRig headlight = vtkIndirectLightRig::Make(preset, { kit[0] });
    CheckEqual("as many lobes", static_cast<double>(headlight.Lobes.size()),
      static_cast<double>(own.Lobes.size()));
    Check("the key's direction", own.Key.Direction == headlight.Key.Direction);
    CheckRelative(
      "ambient light", headlight.Ambient.x / own.Ambient.x, 0.2, 1e-12, "the headlight's strength");
    CheckAbsolute("key", headlight.Key.Color.x, 0.2 * own.Key.Color.x, 1e-12, "rounding");
  }
}

// All that is dark changes maps when it turns, and no direction is so bright that it is drawn by
// itself: skies have neither.
VTK_INDIRECT_TEST(LightRigSkies)
{
  for (const int preset : { vtkIndirectLightingSoft, vtkIndirectLightingFull,
         vtkIndirectLightingGentle, vtkIndirectLightingStudio })
  {
    const vtkIndirectLightRig rig = vtkIndirectLightRig::Make(preset, {});
    double least = 1e30;
    double most = 0.0;
    double sum = 0.0;
    constexpr int Count = 4096;
    Random random(5);
    for (int i = 0; i < Count; ++i)
    {
      const double radiance = rig.GetRadiance(random.NextDirection()).x;
      least = std::min(least, radiance);
      most = std::max(most, radiance);
      sum += radiance;
    }
    const std::string name = "preset " + std::to_string(preset);
    CheckAtLeast(name + ", least radiance", least, 0.01, "a map for each direction");
    CheckAtMost(name + ", largest over mean radiance", most * Count / sum, 256.0 / 32.0,
      "a 256th of the sky has less than a 32nd of its light");
  }
}
