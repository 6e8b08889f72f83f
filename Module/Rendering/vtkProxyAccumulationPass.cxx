// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkProxyAccumulationPass.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectKey.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Plan/vtkIndirectPlan.h"
#include "Plan/vtkIndirectReport.h"
#include "Plan/vtkIndirectSettingList.h"
#include "Plan/vtkIndirectStageTimer.h"
#include "Proxies/vtkIndirectProxyLight.h"
#include "Proxies/vtkIndirectProxyReach.h"
#include "Proxies/vtkIndirectProxyScene.h"
#include "Proxies/vtkIndirectProxyStep.h"
#include "Proxies/vtkIndirectProxySums.h"
#include "Proxies/vtkIndirectProxyTree.h"
#include "Scene/vtkIndirectFrame.h"
#include "Sums/vtkIndirectSum.h"
#include "vtkDataArray.h"
#include "vtkEnvironmentLight.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProp.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkProxyAccumulationPass);

namespace
{
const vtkIndirectChannels SkyChannels = {
  { "sky", "vtkiSky", "irradiance that comes directly from the environment", GL_RGBA32F, "-",
    "VTK irradiance" },
  { "bounce", "vtkiIrradiance", "irradiance that proxies send", GL_RGBA32F, "-", "VTK irradiance" },
};

// Clamps a scale to 0, or to a valid number of radii.
double ClampScale(double scale)
{
  return scale > 0.0
    ? std::min(std::max(scale, vtkIndirectProxyReach::Least), vtkIndirectProxyReach::Most)
    : 0.0;
}

class ProxySum : public vtkIndirectSum
{
public:
  explicit ProxySum(vtkProxyAccumulationPass& pass)
    : vtkIndirectSum(pass)
    , Set(pass)
  {
  }
  static ProxySum& Get(const vtkProxyAccumulationPass* pass)
  {
    return static_cast<ProxySum&>(vtkIndirectSum::Get(pass));
  }

  void AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const override;
  vtkIndirectAbilities GetAbilities(double tolerance) const override;
  vtkIndirectVisibilityNeeds GetVisibilityNeeds(const vtkIndirectPlan&) const override
  {
    return {};
  }
  vtkIndirectSampler::Pointer ChooseSampler(
    const vtkIndirectSampler::Pointer&, const vtkIndirectPlan&) override
  {
    return nullptr;
  }
  void AppendTo(vtkIndirectKey& key, const Input& input) const override;
  size_t GetMainMemoryBytes() const override;
  void AddToReport(vtkIndirectReport& report) const override;

  vtkIndirectProxyScene::Given Given;
  vtkIndirectProxyScene Scene;

protected:
  vtkIndirectEstimate Estimate(const Input& input) override;
  void ReleaseOwn(vtkWindow*) override
  {
    this->TreeFor.Clear();
    this->NeededFor.Clear();
  }

private:
  bool Sum(const Input& input);
  void FindReach(vtkEnvironmentLight* environment);
  std::string DescribeReach() const;

  vtkProxyAccumulationPass& Set;
  vtkIndirectProxyTree Tree;
  vtkIndirectProxySums Sums{ this };
  vtkIndirectTarget Sky{ this, SkyChannels, false };
  vtkIndirectKey TreeFor; // the inputs of the tree, but for the spheres; empty: there is none
  int Step = 0;           // step of the last frame
  // Radii within which a sphere hides and sends light, without groups.
  double Hides = 0.0;
  double Sends = 0.0;
  vtkIndirectProxyStep StepBySpheres;
  // Without groups an environment needs this reach, which was found for these inputs.
  vtkIndirectProxyReach Needed;
  vtkIndirectKey NeededFor;
};
}

//------------------------------------------------------------------------------
vtkProxyAccumulationPass::vtkProxyAccumulationPass()
  : vtkIndirectEstimatorPass(std::make_unique<ProxySum>(*this))
{
}

//------------------------------------------------------------------------------
void vtkProxyAccumulationPass::ApplyPreset()
{
  this->Settings = SettingsType();
  if (this->GetPreset() == PAPER)
  {
    this->Settings.Groups = false;
    this->Settings.InfluenceScale = 15.0;
    this->Settings.IndirectInfluenceScale = 4.0;
    this->Settings.IndirectLight = AVERAGED;
    this->Settings.ReceiverStep = 4;
    this->Settings.Upsampling = BILATERAL;
  }
}

//------------------------------------------------------------------------------
void vtkProxyAccumulationPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSpheres: " << this->GetNumberOfSpheres() << "\n";
  os << indent << "NumberOfPolygons: " << this->GetNumberOfPolygons() << "\n";
}

//------------------------------------------------------------------------------
void ProxySum::AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const
{
  static const char* const levels[] = { "Off", "Middle", "Averaged", "Shadowed", "Exact" };
  static const char* const upsampling[] = { "Planes", "Bilateral", "Bilinear" };
  this->vtkIndirectSum::AddSettings(list, plan);
  list.Add("ReceiverStep", plan ? this->Step : this->Set.GetReceiverStep())
    .Add("Upsampling", vtkIndirectSettingList::Choice{ upsampling[this->Set.GetUpsampling()] })
    .Add("Groups", this->Set.GetGroups())
    .Add("GroupAngle", this->Set.GetGroupAngle())
    .Add("InfluenceScale", plan ? this->Hides : this->Set.GetInfluenceScale())
    .Add("IndirectInfluenceScale", plan ? this->Sends : this->Set.GetIndirectInfluenceScale())
    .Add("IndirectLight", vtkIndirectSettingList::Choice{ levels[this->Set.GetIndirectLight()] });
}

//------------------------------------------------------------------------------
void vtkProxyAccumulationPass::SetInfluenceScale(double scale)
{
  const double clamped = ClampScale(scale);
  if (this->Settings.InfluenceScale != clamped)
  {
    this->Settings.InfluenceScale = clamped;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkProxyAccumulationPass::SetIndirectInfluenceScale(double scale)
{
  const double clamped = ClampScale(scale);
  if (this->Settings.IndirectInfluenceScale != clamped)
  {
    this->Settings.IndirectInfluenceScale = clamped;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkProxyAccumulationPass::SetProxies(vtkProp* prop, vtkPolyData* spheres)
{
  auto& given = ProxySum::Get(this).Given;
  if (!prop)
  {
    vtkErrorMacro("Spheres need a prop to stand for.");
    return;
  }
  if (!spheres)
  {
    if (given.erase(prop) > 0)
    {
      this->Modified();
    }
    return;
  }
  vtkDataArray* radii = spheres->GetPointData()->GetArray("Radius");
  if (!radii || radii->GetNumberOfComponents() != 1)
  {
    vtkErrorMacro(
      "Spheres need point data 'Radius' of one component, as vtkSphereProxyFilter makes "
      "it; nothing is changed.");
    return;
  }
  if (given[prop] != spheres)
  {
    given[prop] = spheres;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPolyData* vtkProxyAccumulationPass::GetProxies(vtkProp* prop)
{
  const auto known = ProxySum::Get(this).Given.find(prop);
  return known == ProxySum::Get(this).Given.end() ? nullptr : known->second.Get();
}

//------------------------------------------------------------------------------
void vtkProxyAccumulationPass::RemoveAllProxies()
{
  if (!ProxySum::Get(this).Given.empty())
  {
    ProxySum::Get(this).Given.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkProxyAccumulationPass::GetNumberOfSpheres() const
{
  return static_cast<int>(ProxySum::Get(this).Scene.GetSpheres().size());
}

//------------------------------------------------------------------------------
int vtkProxyAccumulationPass::GetNumberOfPolygons() const
{
  return static_cast<int>(ProxySum::Get(this).Scene.GetPolygons().size());
}

//------------------------------------------------------------------------------
vtkIndirectAbilities ProxySum::GetAbilities(double tolerance) const
{
  vtkIndirectAbilities abilities = this->vtkIndirectSum::GetAbilities(tolerance);
  abilities.TakesSampler = false;
  abilities.SumsSky = true;
  return abilities;
}

//------------------------------------------------------------------------------
void ProxySum::AppendTo(vtkIndirectKey& key, const Input& input) const
{
  this->vtkIndirectSum::AppendTo(key, input);
  key.Add("sky", input.Environment);
}

//------------------------------------------------------------------------------
vtkIndirectEstimate ProxySum::Estimate(const Input& input)
{
  if (!this->Sum(input))
  {
    return {};
  }
  vtkIndirectEstimate result;
  result.State = vtkIndirectEstimate::CONVERGED;
  for (int i = 0; i < this->Sky.GetNumberOfChannels(); ++i)
  {
    result.Contributions.push_back(
      { i == 0 ? vtkIndirectContribution::SKY : vtkIndirectContribution::BOUNCE, &this->Sky, i });
  }
  return result;
}

//------------------------------------------------------------------------------
void ProxySum::FindReach(vtkEnvironmentLight* environment)
{
  this->Hides = this->Set.GetGroups() ? 0.0 : this->Set.GetInfluenceScale();
  this->Sends = this->Set.GetGroups() ? 0.0 : this->Set.GetIndirectInfluenceScale();
  if (!this->Set.GetGroups() && environment && (this->Hides <= 0.0 || this->Sends <= 0.0))
  {
    const bool middle = this->Set.GetIndirectLight() == vtkProxyAccumulationPass::MIDDLE;
    vtkIndirectKey key("environment", environment);
    if (this->NeededFor.Take(key.Add("middle", middle)))
    {
      this->Needed =
        vtkIndirectProxyReach::Find(vtkIndirectProxyLight::Project(environment), middle);
    }
    this->Hides = this->Hides > 0.0 ? this->Hides : this->Needed.Hides;
    this->Sends = this->Sends > 0.0 ? this->Sends : this->Needed.Sends;
  }
}

//------------------------------------------------------------------------------
bool ProxySum::Sum(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  vtkIndirectFullScreenState kernelState(frame.Window);
  const auto stage = input.Plan.SkySource == vtkIndirectPlan::SKY_BY_ESTIMATOR
    ? vtkIndirectStageTimer::Estimate
    : vtkIndirectStageTimer::Sky;

  input.Timer.Begin(vtkIndirectStageTimer::Lights);
  const bool moved = this->Scene.Update(frame, this->Given, &this->Set);
  this->FindReach(input.Environment);
  vtkIndirectKey key("settings", &this->Set);
  bool done = true;
  if (this->TreeFor.Take(key.Add("reach", this->Hides)) || moved)
  {
    this->Tree.Build(this->Scene.GetSpheres(),
      this->Set.GetGroups() ? this->Set.GetGroupAngle() : 0.0, this->Hides);
    done = this->Sums.Update(frame.Window, this->Tree, this->Scene.GetPolygons());
    this->TreeFor = done ? key : vtkIndirectKey();
  }
  this->Sums.SetEnvironment(frame.Window, input.Environment);
  input.Timer.End(vtkIndirectStageTimer::Lights);

  this->Sky.SetNumberOfChannels(
    this->Set.GetIndirectLight() == vtkProxyAccumulationPass::OFF ? 1 : 2);
  vtkIndirectProxySums::Input sums = { frame, input.Geometry };
  this->Step = this->Set.GetReceiverStep();
  if (this->Step == 0)
  {
    this->Step = this->StepBySpheres.Find(frame, this->Scene.GetSpheres());
  }
  else
  {
    this->StepBySpheres.Forget();
  }
  sums.Step = this->Step;
  sums.Upsampling = this->Set.GetUpsampling();
  sums.Hides = input.Plan.SkyIsShadowed;
  sums.Middle = this->Set.GetIndirectLight() == vtkProxyAccumulationPass::MIDDLE;
  sums.Exact = this->Set.GetIndirectLight() == vtkProxyAccumulationPass::EXACT;
  sums.Shadowed = this->Set.GetIndirectLight() == vtkProxyAccumulationPass::SHADOWED;
  sums.LightReach = this->Sends;
  sums.EyeIsInside = this->Scene.Contains(glm::dvec3(frame.ViewToScene[3]));
  input.Timer.Begin(stage);
  done = done && this->Sums.Sum(sums, this->Sky);
  input.Timer.End(stage);
  return done;
}

//------------------------------------------------------------------------------
size_t ProxySum::GetMainMemoryBytes() const
{
  return this->Scene.GetSpheres().size() * sizeof(vtkIndirectProxySphere) +
    this->Tree.GetEntries().size() * sizeof(vtkIndirectProxyTree::Entry);
}

//------------------------------------------------------------------------------
std::string ProxySum::DescribeReach() const
{
  auto describe = [](double used, bool chosen)
  {
    return vtkIndirectReport::Number(std::round(10.0 * used) / 10.0) + " radii (" +
      (chosen ? "chosen: beyond, one takes at most 1/256 of the open sky's largest irradiance)"
              : "as set)");
  };
  std::string text =
    "each sphere within " + describe(this->Hides, this->Set.GetInfluenceScale() <= 0.0);
  if (this->Set.GetIndirectLight() != vtkProxyAccumulationPass::OFF)
  {
    text +=
      ", its light within " + describe(this->Sends, this->Set.GetIndirectInfluenceScale() <= 0.0);
  }
  if (this->Set.GetInfluenceScale() <= 0.0)
  {
    text += ", where the sky is at most " +
      vtkIndirectReport::Number(std::round(100.0 * this->Needed.Contrast) / 100.0) +
      " times as bright as that irradiance";
  }
  return text;
}

//------------------------------------------------------------------------------
void ProxySum::AddToReport(vtkIndirectReport& report) const
{
  if (report.Method == "off") // spheres may stand beside another estimator
  {
    report.Method = this->Set.GetMethodName();
  }
  this->Scene.AddToReport(report);
  const size_t most = vtkIndirectProxyLight::MostPolygons;
  if (this->Scene.GetPolygons().size() > most)
  {
    report.LeftOut.emplace_back(
      std::to_string(this->Scene.GetPolygons().size() - most) + " flat polygons",
      "the " + std::to_string(most) + " largest count; the result is too bright");
  }
  const int step = this->Step;
  report.Modelled.emplace_back("light from the sky",
    "spherical harmonics of order 4, " +
      (this->Set.GetGroups() ? "groups of spheres that are seen under a sine of " +
            vtkIndirectReport::Number(this->Set.GetGroupAngle()) + " or less as one"
                             : this->DescribeReach()) +
      (step > 1 ? ", a receiver in " + std::to_string(step * step) + " pixels"
                : ", at every pixel"));
  if (this->Set.GetIndirectLight() == vtkProxyAccumulationPass::OFF)
  {
    report.LeftOut.emplace_back("bounces of light from the sky", "IndirectLight is off");
  }
  else
  {
    report.Modelled.emplace_back("one bounce of light from the sky",
      this->Set.GetIndirectLight() == vtkProxyAccumulationPass::SHADOWED
        ? "spheres send what of it falls on them"
        : "spheres send it as if nothing hid it from them; the result is too bright where they are "
          "close to each other");
  }
}
