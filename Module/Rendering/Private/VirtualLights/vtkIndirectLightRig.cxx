// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualLights/vtkIndirectLightRig.h"

#include "vtkIndirectSettings.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{
// Strengths are those for which the pictures of Testing/Benchmark/readability.py in VTK's light kit
// (molecule, isosurfaces, brain, machine part, terrain) are as bright in the mean as plain VTK's,
// with the least deviation of any of them: 11 %. Without some light that comes from the viewer, and
// therefore has no shadows that are seen, molecules would be a third darker than smooth objects.
struct Strengths
{
  double Ambient;   // radiance
  double Front;     // of a lobe around the viewer, and above
  double Headlight; // beside that of a kit
  double Kit;       // factor on a kit's lights
};
constexpr Strengths Soft = { 0.41, 0.33, 0.265, 0.0 };
constexpr Strengths Gentle = { 0.2, 0.16, 0.62, 0.0 }; // half of the sky
constexpr Strengths Full = { 0.25, 0.0, 0.33, 0.45 };
constexpr Strengths Studio = { 0.1, 0.0, 0.23, 0.72 };

// How much brighter than in VTK's kit the molecule, the isosurfaces and the brain are in its
// headlight: 1.11, 1.07 and 1.11. What faces up, as terrain, is darker there than in any preset.
constexpr double HeadlightOverKit = 1.1;

// What faces up is brighter than what faces down.
constexpr double FrontElevation = 30.0;
constexpr double FrontExponent = 1.0;
// Half of a lobe's radiance lies within 33 degrees of its middle: several of the directions that a
// sky is summed over, so that none of them is seen by itself.
constexpr double KitExponent = 4.0;

// vtkLightKit's directions and ratios, in white.
std::vector<vtkIndirectLamp> MakeKit()
{
  constexpr double key = 0.75;
  auto lamp = [](double elevation, double azimuth, double strength)
  {
    return vtkIndirectLamp{ vtkIndirectLightRig::FromAngles(elevation, azimuth),
      glm::dvec3(strength) };
  };
  return { lamp(50.0, 10.0, key), lamp(-75.0, 0.0, key / 3.0), lamp(0.0, 110.0, key / 3.5),
    lamp(0.0, -110.0, key / 3.5), lamp(0.0, 0.0, key / 3.0) };
}

double GetStrength(const vtkIndirectLamp& lamp)
{
  return std::max({ lamp.Color.x, lamp.Color.y, lamp.Color.z });
}

double SumStrengths(const std::vector<vtkIndirectLamp>& lamps)
{
  double sum = 0.0;
  for (const vtkIndirectLamp& lamp : lamps)
  {
    sum += GetStrength(lamp);
  }
  return sum;
}

const Strengths& FindStrengths(int preset)
{
  switch (preset)
  {
    case vtkIndirectLightingSoft:
      return Soft;
    case vtkIndirectLightingGentle:
      return Gentle;
    case vtkIndirectLightingFull:
      return Full;
    default:
      return Studio;
  }
}
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectLightRig::FromAngles(double elevation, double azimuth)
{
  const double e = vtkMath::RadiansFromDegrees(elevation);
  const double a = vtkMath::RadiansFromDegrees(azimuth);
  return { std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a) };
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectLightRig::GetRadiance(const glm::dvec3& direction) const
{
  glm::dvec3 radiance = this->Ambient;
  for (const Lobe& lobe : this->Lobes)
  {
    const double cosine = glm::dot(direction, lobe.Lamp.Direction);
    if (cosine > 0.0)
    {
      // The irradiance of a surface that faces radiance cos^p is 2 / (p + 2).
      radiance += lobe.Lamp.Color * (0.5 * (lobe.Exponent + 2.0) * std::pow(cosine, lobe.Exponent));
    }
  }
  return radiance;
}

//------------------------------------------------------------------------------
vtkIndirectLightRig vtkIndirectLightRig::Make(int preset, const std::vector<vtkIndirectLamp>& kit)
{
  const Strengths& strengths = FindStrengths(preset);
  const std::vector<vtkIndirectLamp> standard = MakeKit();
  // As bright as the renderer's lights are for a kit, or for a headlight.
  const double unit = IsKit(kit) ? SumStrengths(kit) / SumStrengths(standard)
                                 : HeadlightOverKit * (kit.empty() ? 1.0 : SumStrengths(kit));
  vtkIndirectLightRig rig;
  rig.Ambient = glm::dvec3(unit * strengths.Ambient);
  rig.Headlight = glm::dvec3(unit * strengths.Headlight);
  if (strengths.Front > 0.0)
  {
    rig.Lobes.push_back(
      { { FromAngles(FrontElevation, 0.0), glm::dvec3(unit * strengths.Front) }, FrontExponent });
  }
  if (strengths.Kit == 0.0)
  {
    return rig;
  }
  std::vector<vtkIndirectLamp> lamps = IsKit(kit) ? kit : standard;
  for (vtkIndirectLamp& lamp : lamps)
  {
    lamp.Color *= strengths.Kit * (IsKit(kit) ? 1.0 : unit);
  }
  if (preset == vtkIndirectLightingFull)
  {
    const auto key = std::max_element(lamps.begin(), lamps.end(),
      [](const auto& a, const auto& b) { return GetStrength(a) < GetStrength(b); });
    rig.Key = *key;
    lamps.erase(key);
  }
  for (const vtkIndirectLamp& lamp : lamps)
  {
    if (lamp.Direction == glm::dvec3(0.0, 0.0, 1.0))
    {
      rig.Headlight += lamp.Color;
    }
    else
    {
      rig.Lobes.push_back({ lamp, KitExponent });
    }
  }
  return rig;
}
