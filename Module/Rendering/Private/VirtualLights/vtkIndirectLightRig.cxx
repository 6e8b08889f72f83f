// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualLights/vtkIndirectLightRig.h"

#include "vtkIndirectSettings.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{
// What a preset takes of the renderer's own lights, and what it makes good for.
struct Balance
{
  // The share that stays as VTK draws it: the least, in steps of 0.1, with which no more is nearly
  // black than in plain VTK and brightness is within 10 % of it, on all that
  // Testing/Benchmark/readability.py shows. Brightness decides: it varies with what objects hide of
  // the rest.
  double Kept;
  // What objects receive of the rest, from each other's surfaces too, over what they would if
  // nothing hid any of it: near the middle of what readability.py shows.
  double Openness;
  // The share of a concave part's hemispheres in which its surfaces see each other. Faces at a right
  // angle do in half of theirs at most, of a key that falls on both. A sky reaches less of what sees
  // other surfaces: 0.35 stands for the brightest pixels of white trays, corners, bowls and rooms.
  double Facing;
};

// Light from a kit, the renderer's or that of full: 0.61 (isosurfaces) to 0.99 (a part on a table).
// With 0.5 a quadric in a kit would be 12 % darker than plain VTK's.
constexpr Balance OfKit = { 0.6, 0.83, 0.5 };
constexpr Balance OfSkyFromKit = { 0.6, 0.83, 0.4 };

// Light from around the viewer: 0.74 (a molecule) to 0.97 (a part on a table). What the camera sees
// is open to where the camera is, so that less varies, and less has to be kept.
constexpr Balance OfSkyAtViewer = { 0.4, 0.86, 0.4 };

// What is convex has no bounces: so much darker than in plain VTK it may become, for what is
// concave not to burn out. Brightness is within 10 % of VTK's then, whatever the shape.
constexpr double Dimming = 0.08;

// Half of a lobe's radiance lies within 33 degrees of its middle: several of the directions that a
// sky is summed over, so that none of them is seen by itself.
constexpr double Exponent = 4.0;

// Radiance from everywhere over the irradiance of a ball, at least: no direction is dark, so that
// the maps of all are kept while the camera turns, and none is so bright that it gets finer ones.
constexpr double Everywhere = 0.15;

// In place of a headlight: a key and a fill beside the viewer, and rims. At the height of the
// viewer's eyes, because what faces up is dim in a headlight, too: from 50 degrees above, as that
// of vtkLightKit is, terrain and tables would be a third brighter than plain VTK's.
std::vector<vtkIndirectLamp> MakeKit(const glm::dvec3& color)
{
  auto lamp = [&color](double elevation, double azimuth, double strength)
  {
    return vtkIndirectLamp{ vtkIndirectLightRig::FromAngles(elevation, azimuth), strength * color };
  };
  return { lamp(5.0, -30.0, 0.6), lamp(0.0, 30.0, 0.4), lamp(0.0, 110.0, 0.2),
    lamp(0.0, -110.0, 0.2) };
}

double GetMean(const glm::dvec3& color)
{
  return (color.x + color.y + color.z) / 3.0;
}

bool IsHeadlight(const vtkIndirectLamp& lamp)
{
  return lamp.Direction == glm::dvec3(0.0, 0.0, 1.0);
}

// The same irradiance through a sphere, summed over all directions (scalar), and the same net one
// (vector) as the lamps: their first two bands of spherical harmonics, where a lobe and light from
// everywhere can have them. What is narrower than a lobe becomes one.
void SetSky(vtkIndirectLightRig& rig, const std::vector<vtkIndirectLamp>& lamps)
{
  glm::dvec3 scalar(0.0);
  glm::dmat3 vector(0.0); // a column a colour
  for (const vtkIndirectLamp& lamp : lamps)
  {
    scalar += lamp.Color;
    vector += glm::outerProduct(lamp.Direction, lamp.Color);
  }
  const glm::dvec3 sum = vector * glm::dvec3(1.0);
  const double length = glm::length(sum);
  // Lamps that balance each other come from everywhere.
  const glm::dvec3 direction =
    length > 1e-6 * GetMean(scalar) ? sum / length : glm::dvec3(0.0, 0.0, 1.0);
  const glm::dvec3 facing = glm::max(direction * vector, glm::dvec3(0.0));
  rig.Lobes.push_back({ { direction, facing }, Exponent });
  // A lobe's scalar irradiance is (p + 2) / (p + 1) of what faces it, light from everywhere has 4.
  rig.Ambient =
    glm::max((scalar - facing * ((Exponent + 2.0) / (Exponent + 1.0))) / 4.0, glm::dvec3(0.0));
}

// Each lamp a lobe where it is, but of those that come from the viewer no shadow is visible.
void SetLobes(vtkIndirectLightRig& rig, const std::vector<vtkIndirectLamp>& lamps)
{
  for (const vtkIndirectLamp& lamp : lamps)
  {
    if (IsHeadlight(lamp))
    {
      rig.Fills.push_back(lamp);
    }
    else
    {
      rig.Lobes.push_back({ lamp, Exponent });
    }
  }
}

// Takes the brightest lamp of those that do not come from the viewer.
vtkIndirectLamp TakeKey(std::vector<vtkIndirectLamp>& lamps)
{
  const auto key = std::max_element(lamps.begin(), lamps.end(),
    [](const auto& a, const auto& b) {
      return (IsHeadlight(a) ? 0.0 : GetMean(a.Color)) < (IsHeadlight(b) ? 0.0 : GetMean(b.Color));
    });
  const vtkIndirectLamp found = *key;
  lamps.erase(key);
  return found;
}

void Scale(vtkIndirectLightRig& rig, double factor)
{
  rig.Ambient *= factor;
  rig.Key.Color *= factor;
  for (vtkIndirectLightRig::Lobe& lobe : rig.Lobes)
  {
    lobe.Lamp.Color *= factor;
  }
  for (vtkIndirectLamp& fill : rig.Fills)
  {
    fill.Color *= factor;
  }
}

// The share of the renderer's lights that gives way to others, and their strength.
struct Exchange
{
  double Share;
  double Strength;
};

Exchange FindExchange(
  const Balance& balance, double share, const vtkIndirectRigAlbedo& albedo, double most)
{
  Exchange found = { share, share / balance.Openness };
  const double gain = 1.0 / (1.0 - std::min(albedo.Mean, 1.0) * balance.Facing);
  const double brightest = albedo.Brightest * most;
  if (brightest <= 0.0)
  {
    return found;
  }
  // What plain VTK clips itself has no room, and needs none.
  const double room = std::max(1.0 / brightest - 1.0, 0.0);
  if (found.Strength * (gain - 1.0) > room + Dimming)
  {
    found.Strength = (room + Dimming) / (gain - 1.0);
  }
  found.Share = std::min(share, found.Strength + Dimming);
  found.Strength = std::min(found.Strength, (room + found.Share) / gain);
  return found;
}

// Adds a share of the lamps as they are. What is in the same place becomes one light.
void Keep(vtkIndirectLightRig& rig, const std::vector<vtkIndirectLamp>& lamps, double share)
{
  for (const vtkIndirectLamp& lamp : lamps)
  {
    const vtkIndirectLamp kept = { lamp.Direction, share * lamp.Color };
    const auto same = std::find_if(rig.Fills.begin(), rig.Fills.end(),
      [&kept](const vtkIndirectLamp& fill) { return fill.Direction == kept.Direction; });
    if (same != rig.Fills.end())
    {
      same->Color += kept.Color;
    }
    else if (rig.Key.Color != glm::dvec3(0.0) && rig.Key.Direction == kept.Direction)
    {
      rig.KeyShadow = GetMean(rig.Key.Color) / GetMean(rig.Key.Color + kept.Color);
      rig.Key.Color += kept.Color;
    }
    else
    {
      rig.Fills.push_back(kept);
    }
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
double vtkIndirectLightRig::GetIrradianceOfBall(const vtkIndirectLamp& lamp)
{
  const double cosine = vtkMath::ClampValue(lamp.Direction.z, -1.0, 1.0);
  const double angle = std::acos(cosine);
  return GetMean(lamp.Color) * 2.0 / (3.0 * vtkMath::Pi()) *
    (std::sin(angle) + (vtkMath::Pi() - angle) * cosine);
}

//------------------------------------------------------------------------------
double vtkIndirectLightRig::GetIrradianceOfBall() const
{
  double sum = this->Key.Color != glm::dvec3(0.0) ? GetIrradianceOfBall(this->Key) : 0.0;
  for (const vtkIndirectLamp& fill : this->Fills)
  {
    sum += GetIrradianceOfBall(fill);
  }
  // Of the sky by parallels of equal height about the vertical.
  constexpr int Rows = 64;
  constexpr int Columns = 64;
  for (int j = 0; j < Rows; ++j)
  {
    const double y = 2.0 * (j + 0.5) / Rows - 1.0;
    const double r = std::sqrt(1.0 - y * y);
    for (int i = 0; i < Columns; ++i)
    {
      const double angle = 2.0 * vtkMath::Pi() * (i + 0.5) / Columns;
      const glm::dvec3 direction(r * std::cos(angle), y, r * std::sin(angle));
      // Radiance over pi is irradiance of what faces it.
      sum += GetIrradianceOfBall({ direction, this->GetRadiance(direction) }) * 4.0 /
        static_cast<double>(Rows * Columns);
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
double vtkIndirectLightRig::FindMostIrradiance(const std::vector<vtkIndirectLamp>& lamps)
{
  // A surface that has most faces the sum of the lamps that it sees, weighted by what they give:
  // from each lamp's direction on, turning to that sum never loses, and few turns settle it.
  double most = 0.0;
  for (const vtkIndirectLamp& first : lamps)
  {
    glm::dvec3 normal = first.Direction;
    for (int turn = 0; turn < 16; ++turn)
    {
      glm::dvec3 sum(0.0);
      for (const vtkIndirectLamp& lamp : lamps)
      {
        sum += glm::dot(lamp.Direction, normal) > 0.0 ? GetMean(lamp.Color) * lamp.Direction
                                                      : glm::dvec3(0.0);
      }
      const double length = glm::length(sum);
      most = std::max(most, length);
      normal = length > 0.0 ? sum / length : normal;
    }
  }
  return most;
}

//------------------------------------------------------------------------------
vtkIndirectLightRig vtkIndirectLightRig::Make(
  int preset, std::vector<vtkIndirectLamp> lamps, const vtkIndirectRigAlbedo& albedo)
{
  if (lamps.empty())
  {
    lamps.push_back({ { 0.0, 0.0, 1.0 }, glm::dvec3(1.0) });
  }
  const bool headlight = std::all_of(lamps.begin(), lamps.end(), IsHeadlight);
  const bool gentle = preset == vtkIndirectLightingGentle;
  const bool sky = gentle || preset == vtkIndirectLightingSoft;
  const Balance balance = !sky ? OfKit : headlight ? OfSkyAtViewer : OfSkyFromKit;
  const Exchange rest = FindExchange(
    balance, (gentle ? 0.5 : 1.0) * (1.0 - balance.Kept), albedo, FindMostIrradiance(lamps));
  vtkIndirectLightRig rig;
  if (sky)
  {
    SetSky(rig, lamps);
  }
  else
  {
    glm::dvec3 color(0.0);
    for (const vtkIndirectLamp& lamp : lamps)
    {
      color += lamp.Color;
    }
    std::vector<vtkIndirectLamp> kit = headlight ? MakeKit(color) : lamps;
    if (preset == vtkIndirectLightingFull)
    {
      rig.Key = TakeKey(kit);
    }
    SetLobes(rig, kit);
  }
  double plain = 0.0;
  for (const vtkIndirectLamp& lamp : lamps)
  {
    plain += GetIrradianceOfBall(lamp);
  }
  rig.Ambient = glm::max(rig.Ambient, glm::dvec3(Everywhere * plain));
  const double own = rig.GetIrradianceOfBall();
  Scale(rig, own > 0.0 ? rest.Strength * plain / own : 0.0);
  Keep(rig, lamps, 1.0 - rest.Share);
  return rig;
}
