// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkIndirectSphereMotion.h"

#include "Proxies/vtkIndirectProxyKinds.h"
#include "Proxies/vtkIndirectProxyLight.h"
#include "Scene/vtkIndirectFrame.h"

#include <utility>

namespace
{
constexpr int LeastChanges = 2;
constexpr int MostIdle = 8; // half a second at 15 frames a second
// This many spheres take 0.8 of the time of maps, of which a frame in motion draws a few
// (Documentation/methods/sphere-proxies.md); with more spheres the tree over them dominates.
constexpr double MostSpheres = 100000.0;
}

//------------------------------------------------------------------------------
void vtkIndirectSphereMotion::Update(const vtkIndirectFrame& frame, bool hasSun, bool interactive)
{
  if (frame.IsFurtherPart())
  {
    return;
  }
  const double moved = this->FindMovedSpheres(frame);
  if (moved > 0.0)
  {
    ++this->Changes;
    this->Idle = 0;
  }
  else if (!interactive || ++this->Idle > MostIdle)
  {
    this->Changes = this->Idle = 0;
  }
  if (this->Changes < LeastChanges)
  {
    this->What.clear();
    this->WhyNot.clear();
    // When no moved prop is left, motion needs two frames to begin again.
    this->Moved = this->Moved && !this->Props.empty();
    return;
  }
  if (moved > 0.0)
  {
    this->What =
      std::to_string(static_cast<long long>(moved)) + " spheres have moved in frames on end";
  }
  this->WhyNot =
    hasSun ? "the environment has a sun, whose shadows they blur" : this->FindWhyNot(frame);
  this->Moved = this->WhyNot.empty();
}

//------------------------------------------------------------------------------
// Counts the moved spheres of props that were in the last frame already.
double vtkIndirectSphereMotion::FindMovedSpheres(const vtkIndirectFrame& frame)
{
  std::unordered_map<vtkProp*, Before> now;
  double moved = 0.0;
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    const auto found = this->Props.find(caster.Prop);
    if (found != this->Props.end() && found->second.Revision == caster.Revision)
    {
      now.emplace(caster.Prop, std::move(found->second));
      continue;
    }
    vtkIndirectProxyKinds::Kind kind = vtkIndirectProxyKinds::FindSpheres(caster.Prop);
    if (kind.NumberOfSpheres > 0.0)
    {
      moved += found != this->Props.end() && found->second.Places != kind.Places
        ? kind.NumberOfSpheres
        : 0.0;
      now[caster.Prop] = { caster.Revision, std::move(kind.Places) };
    }
  }
  this->Props = std::move(now);
  return moved;
}

//------------------------------------------------------------------------------
std::string vtkIndirectSphereMotion::FindWhyNot(const vtkIndirectFrame& frame)
{
  double spheres = 0.0;
  std::string why;
  size_t polygons = 0;
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    const vtkIndirectProxyKinds::Kind kind = vtkIndirectProxyKinds::Find(caster.Prop, this->Shapes);
    spheres += kind.NumberOfSpheres;
    polygons += kind.NumberOfPolygons;
    why = kind.Other.empty() ? why : kind.Other;
  }
  this->Shapes.Forget();
  const size_t most = vtkIndirectProxyLight::MostPolygons;
  return !why.empty()       ? why
    : polygons > most       ? "there are more than " + std::to_string(most) + " flat polygons"
    : spheres > MostSpheres ? "so many take as long as maps"
                            : "";
}

//------------------------------------------------------------------------------
void vtkIndirectSphereMotion::Forget()
{
  this->Props.clear();
  this->Changes = this->Idle = 0;
  this->Moved = false;
  this->What.clear();
  this->WhyNot.clear();
}
