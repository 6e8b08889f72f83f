// SPDX-License-Identifier: BSD-3-Clause
#include "Emitters/vtkIndirectPresetLights.h"

#include "vtkIndirectSettings.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{
// A preset divides the light between the renderer's own lights and its own by these numbers.
struct Balance
{
  // The share that stays as VTK draws it: the smallest one, in steps of 0.1, with which no more
  // pixels are nearly black than in plain VTK and brightness is within 10 % of plain VTK's, on all
  // scenes of Testing/Benchmark/readability.py. Brightness is decisive: it varies with how much of
  // the other light objects hide.
  double Kept;
  // The light that objects receive of the other share, including reflections, over the light that
  // they would receive if nothing hid any of it: near the middle of the scenes of readability.py.
  double Openness;
  // The least of them.
  double LeastOpenness;
};

// Light from a kit, the renderer's or that of the preset full: openness is 0.61 (isosurfaces) to
// 0.99 (a part on a table). With 0.5 a quadric in a kit would be 12 % darker than plain VTK's.
constexpr Balance OfKit = { 0.6, 0.83, 0.61 };

// Light from around the viewer: openness is 0.74 (a molecule) to 0.97 (a part on a table). Surfaces
// that the camera sees are open towards the camera, so openness varies less and a smaller share is
// kept.
constexpr Balance OfSkyAtViewer = { 0.4, 0.86, 0.74 };

// Objects of the least openness may become this much darker than in plain VTK, so that concave
// parts do not burn out. Others become less so.
constexpr double Dimming = 0.1;

// Half of a lobe's radiance lies within 33 degrees of its middle. A lobe covers several of the
// directions that a sky is summed over, so that no direction is visible by itself.
constexpr double Exponent = 4.0;

// The least radiance from everywhere, over the irradiance of a ball. No direction is dark, so that
// the maps of all directions are kept while the camera turns, and no direction is so bright that it
// gets finer maps.
constexpr double Everywhere = 0.15;

// The largest share of a sphere that a cavity is: that of a room without one of its six walls.
// Deeper ones show the camera little of their inside.
constexpr double Deepest = 5.0 / 6.0;

// The gain of bounces among colours of data and textures, which differ from place to place. With 1
// a molecule clips in 0.6 % of its pixels (Testing/Benchmark/worth.py), with 1.17 it is 10 % darker
// than in plain VTK.
constexpr double GainOfData = 1.07;

// Normals for which irradiance is bounded, 4 degrees apart: a cosine's maximum is met to 0.2 %.
constexpr int Normals = 1024;

// Directions of a sky by parallels of equal height about the vertical.
constexpr int Rows = 32;
constexpr int Columns = 32;

// Makes the kit that replaces a headlight: a key and a fill beside the viewer, and rims. They are
// at the height of the viewer's eyes, because surfaces that face up are dim in a headlight, too:
// with a key from 50 degrees above, like that of vtkLightKit, terrain and tables would be a third
// brighter than plain VTK's.
std::vector<vtkIndirectDistantLight> MakeKit(const glm::dvec3& color)
{
  auto lamp = [&color](double elevation, double azimuth, double strength)
  {
    return vtkIndirectDistantLight{ vtkIndirectPresetLights::FromAngles(elevation, azimuth),
      strength * color };
  };
  return { lamp(5.0, -30.0, 0.6), lamp(0.0, 30.0, 0.4), lamp(0.0, 110.0, 0.2),
    lamp(0.0, -110.0, 0.2) };
}

double GetMean(const glm::dvec3& color)
{
  return (color.x + color.y + color.z) / 3.0;
}

double GetMost(const glm::dvec3& color)
{
  return std::max({ color.x, color.y, color.z });
}

bool IsHeadlight(const vtkIndirectDistantLight& lamp)
{
  return lamp.Direction == glm::dvec3(0.0, 0.0, 1.0);
}

// Gives the sky the lamps' irradiance through a sphere, summed over all directions (scalar), and
// their net irradiance (vector): the first two bands of spherical harmonics, as far as a lobe and
// light from everywhere can have them. Light narrower than a lobe becomes a lobe.
void SetSky(
  vtkIndirectPresetLights& presetLights, const std::vector<vtkIndirectDistantLight>& lamps)
{
  glm::dvec3 scalar(0.0);
  glm::dmat3 vector(0.0); // a column a colour
  for (const vtkIndirectDistantLight& lamp : lamps)
  {
    scalar += lamp.Color;
    vector += glm::outerProduct(lamp.Direction, lamp.Color);
  }
  const glm::dvec3 sum = vector * glm::dvec3(1.0);
  const double length = glm::length(sum);
  // Lamps that cancel out come from everywhere.
  const glm::dvec3 direction =
    length > 1e-6 * GetMean(scalar) ? sum / length : glm::dvec3(0.0, 0.0, 1.0);
  const glm::dvec3 facing = glm::max(direction * vector, glm::dvec3(0.0));
  presetLights.Lobes.push_back({ { direction, facing }, Exponent });
  // A lobe's scalar irradiance is (p + 2) / (p + 1) times that of a surface facing it; light from
  // everywhere has 4 times its radiance.
  presetLights.Ambient =
    glm::max((scalar - facing * ((Exponent + 2.0) / (Exponent + 1.0))) / 4.0, glm::dvec3(0.0));
}

// Makes each lamp a lobe in its direction. Beside a sharp key a lamp from the viewer stays sharp,
// too, because its shadows are not visible.
void SetLobes(
  vtkIndirectPresetLights& presetLights, const std::vector<vtkIndirectDistantLight>& lamps)
{
  const bool sharp = presetLights.Key.Color != glm::dvec3(0.0);
  for (const vtkIndirectDistantLight& lamp : lamps)
  {
    if (sharp && IsHeadlight(lamp))
    {
      presetLights.Fills.push_back(lamp);
    }
    else
    {
      presetLights.Lobes.push_back({ lamp, Exponent });
    }
  }
}

// Takes the brightest lamp of those that do not come from the viewer.
vtkIndirectDistantLight TakeKey(std::vector<vtkIndirectDistantLight>& lamps)
{
  const auto key = std::max_element(lamps.begin(), lamps.end(),
    [](const auto& a, const auto& b) {
      return (IsHeadlight(a) ? 0.0 : GetMean(a.Color)) < (IsHeadlight(b) ? 0.0 : GetMean(b.Color));
    });
  const vtkIndirectDistantLight found = *key;
  lamps.erase(key);
  return found;
}

void Scale(vtkIndirectPresetLights& presetLights, double factor)
{
  presetLights.Ambient *= factor;
  presetLights.Key.Color *= factor;
  for (vtkIndirectPresetLights::Lobe& lobe : presetLights.Lobes)
  {
    lobe.Lamp.Color *= factor;
  }
  for (vtkIndirectDistantLight& fill : presetLights.Fills)
  {
    fill.Color *= factor;
  }
}

// The share of the renderer's lights that is replaced, and the strength of the light that replaces
// it.
struct Exchange
{
  double Share;
  double Strength;
};

// Returns the light of the sky as lamps: each direction's radiance over pi, times its solid angle,
// is the VTK irradiance of a surface that faces it.
std::vector<vtkIndirectDistantLight> MakeLampsOfSky(const vtkIndirectPresetLights& presetLights)
{
  std::vector<vtkIndirectDistantLight> lamps;
  for (int j = 0; j < Rows; ++j)
  {
    const double y = 2.0 * (j + 0.5) / Rows - 1.0;
    const double r = std::sqrt(1.0 - y * y);
    for (int i = 0; i < Columns; ++i)
    {
      const double angle = 2.0 * vtkMath::Pi() * (i + 0.5) / Columns;
      const glm::dvec3 direction(r * std::cos(angle), y, r * std::sin(angle));
      lamps.push_back(
        { direction, presetLights.GetRadiance(direction) * (4.0 / (Rows * Columns)) });
    }
  }
  return lamps;
}

glm::dvec3 FindIrradiance(
  const std::vector<vtkIndirectDistantLight>& lamps, const glm::dvec3& normal)
{
  glm::dvec3 sum(0.0);
  for (const vtkIndirectDistantLight& lamp : lamps)
  {
    sum += std::max(glm::dot(normal, lamp.Direction), 0.0) * lamp.Color;
  }
  return sum;
}

// Finds the strength at which no surface becomes brighter than white, or than plain VTK's
// brightest where that clips: 1 - r + s G of the two kinds of light, for each normal and channel.
Exchange FindExchange(const Balance& balance, double share, const vtkIndirectPresetAlbedo& albedo,
  const std::vector<vtkIndirectDistantLight>& lamps, const vtkIndirectPresetLights& presetLights)
{
  std::vector<vtkIndirectDistantLight> own = MakeLampsOfSky(presetLights);
  own.push_back(presetLights.Key);
  own.insert(own.end(), presetLights.Fills.begin(), presetLights.Fills.end());
  std::vector<glm::dvec3> plain;
  std::vector<glm::dvec3> replacing;
  double most = 0.0;
  for (int i = 0; i < Normals; ++i)
  {
    // A spiral from pole to pole, of equal areas.
    const double y = 1.0 - 2.0 * (i + 0.5) / Normals;
    const double r = std::sqrt(1.0 - y * y);
    const double angle = vtkMath::Pi() * (3.0 - std::sqrt(5.0)) * i;
    const glm::dvec3 normal(r * std::cos(angle), y, r * std::sin(angle));
    plain.push_back(FindIrradiance(lamps, normal));
    replacing.push_back(FindIrradiance(own, normal));
    most = std::max(most, GetMost(plain.back()));
  }
  const auto shareOf = [&](double strength)
  { return std::min(share, strength * balance.LeastOpenness + Dimming); };
  const auto fits = [&](double strength, double brightest, double gain)
  {
    const double kept = 1.0 - shareOf(strength);
    double found = 0.0;
    for (int i = 0; i < Normals; ++i)
    {
      found = std::max(found, GetMost(kept * plain[i] + strength * gain * replacing[i]));
    }
    return brightest * found <= std::max(1.0, brightest * most) * (1.0 + 1e-9);
  };
  const double gain = vtkIndirectPresetLights::FindGain(albedo.Brightest);
  const auto fit = [&](double strength)
  {
    return fits(strength, albedo.Brightest, gain) &&
      (!albedo.OfData || fits(strength, 1.0, GainOfData));
  };
  Exchange found = { share, share / balance.Openness };
  if (!fit(found.Strength))
  {
    // The brightest is a convex function of the strength, and fits where that is 0.
    double low = 0.0;
    for (int i = 0; i < 24; ++i)
    {
      const double middle = 0.5 * (low + found.Strength);
      (fit(middle) ? low : found.Strength) = middle;
    }
    found.Strength = low;
    found.Share = shareOf(low);
  }
  return found;
}

// Adds a share of the lamps unchanged. Lamps in the same direction become one light.
void Keep(vtkIndirectPresetLights& presetLights, const std::vector<vtkIndirectDistantLight>& lamps,
  double share)
{
  for (const vtkIndirectDistantLight& lamp : lamps)
  {
    const vtkIndirectDistantLight kept = { lamp.Direction, share * lamp.Color };
    const auto same = std::find_if(presetLights.Fills.begin(), presetLights.Fills.end(),
      [&kept](const vtkIndirectDistantLight& fill) { return fill.Direction == kept.Direction; });
    if (same != presetLights.Fills.end())
    {
      same->Color += kept.Color;
    }
    else if (presetLights.Key.Color != glm::dvec3(0.0) &&
      presetLights.Key.Direction == kept.Direction)
    {
      presetLights.KeyShadow =
        GetMean(presetLights.Key.Color) / GetMean(presetLights.Key.Color + kept.Color);
      presetLights.Key.Color += kept.Color;
    }
    else
    {
      presetLights.Fills.push_back(kept);
    }
  }
}
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectPresetLights::FromAngles(double elevation, double azimuth)
{
  const double e = vtkMath::RadiansFromDegrees(elevation);
  const double a = vtkMath::RadiansFromDegrees(azimuth);
  return { std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a) };
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectPresetLights::GetRadiance(const glm::dvec3& direction) const
{
  glm::dvec3 radiance = this->Ambient;
  for (const Lobe& lobe : this->Lobes)
  {
    const double cosine = glm::dot(direction, lobe.Lamp.Direction);
    if (cosine > 0.0)
    {
      // A surface that faces radiance cos^p has the irradiance 2 / (p + 2).
      radiance += lobe.Lamp.Color * (0.5 * (lobe.Exponent + 2.0) * std::pow(cosine, lobe.Exponent));
    }
  }
  return radiance;
}

//------------------------------------------------------------------------------
double vtkIndirectPresetLights::GetIrradianceOfBall(const vtkIndirectDistantLight& lamp)
{
  const double cosine = vtkMath::ClampValue(lamp.Direction.z, -1.0, 1.0);
  const double angle = std::acos(cosine);
  return GetMean(lamp.Color) * 2.0 / (3.0 * vtkMath::Pi()) *
    (std::sin(angle) + (vtkMath::Pi() - angle) * cosine);
}

//------------------------------------------------------------------------------
double vtkIndirectPresetLights::GetIrradianceOfBall() const
{
  double sum = this->Key.Color != glm::dvec3(0.0) ? GetIrradianceOfBall(this->Key) : 0.0;
  for (const vtkIndirectDistantLight& fill : this->Fills)
  {
    sum += GetIrradianceOfBall(fill);
  }
  for (const vtkIndirectDistantLight& lamp : MakeLampsOfSky(*this))
  {
    sum += GetIrradianceOfBall(lamp);
  }
  return sum;
}

//------------------------------------------------------------------------------
double vtkIndirectPresetLights::FindGain(double albedo)
{
  // Places of a cavity that is a share f of a sphere see one another alike, and receive on average
  // 1 - f of the light that a surface facing it would receive. Such a surface receives
  // 1 + a f (1 - f) / (1 - a f), which is greatest where f = (1 - sqrt(1 - a)) / a.
  const double a = vtkMath::ClampValue(albedo, 0.0, 1.0);
  if (a == 0.0)
  {
    return 1.0;
  }
  const double f = std::min((1.0 - std::sqrt(1.0 - a)) / a, Deepest);
  return 1.0 + a * f * (1.0 - f) / (1.0 - a * f);
}

//------------------------------------------------------------------------------
vtkIndirectPresetLights vtkIndirectPresetLights::Make(int preset,
  std::vector<vtkIndirectDistantLight> lamps, const vtkIndirectPresetAlbedo& albedo, bool hasOwnSky)
{
  if (lamps.empty())
  {
    lamps.push_back({ { 0.0, 0.0, 1.0 }, glm::dvec3(1.0) });
  }
  const bool headlight = std::all_of(lamps.begin(), lamps.end(), IsHeadlight);
  const bool gentle = preset == vtkIndirectLightingGentle;
  const bool sky = gentle || preset == vtkIndirectLightingSoft;
  const Balance balance = sky && headlight ? OfSkyAtViewer : OfKit;
  vtkIndirectPresetLights presetLights;
  if (sky)
  {
    SetSky(presetLights, lamps);
  }
  else
  {
    glm::dvec3 color(0.0);
    for (const vtkIndirectDistantLight& lamp : lamps)
    {
      color += lamp.Color;
    }
    std::vector<vtkIndirectDistantLight> kit = headlight ? MakeKit(color) : lamps;
    if (preset == vtkIndirectLightingFull)
    {
      presetLights.Key = TakeKey(kit);
    }
    SetLobes(presetLights, kit);
  }
  double plain = 0.0;
  for (const vtkIndirectDistantLight& lamp : lamps)
  {
    plain += GetIrradianceOfBall(lamp);
  }
  presetLights.Ambient = glm::max(presetLights.Ambient, glm::dvec3(Everywhere * plain));
  const double own = presetLights.GetIrradianceOfBall();
  Scale(presetLights, own > 0.0 ? plain / own : 0.0);
  if (hasOwnSky && preset != vtkIndirectLightingFull)
  {
    // The frame measures the share and the strength: vtkIndirectLightBalance.
    presetLights.MostReplaced = gentle ? 0.5 : 1.0;
    Keep(presetLights, lamps, 1.0);
    return presetLights;
  }
  const Exchange rest =
    FindExchange(balance, (gentle ? 0.5 : 1.0) * (1.0 - balance.Kept), albedo, lamps, presetLights);
  Scale(presetLights, rest.Strength);
  Keep(presetLights, lamps, 1.0 - rest.Share);
  return presetLights;
}
