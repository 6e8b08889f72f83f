// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkProxyAccumulationPass.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Frame/vtkIndirectEstimate.h"
#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectPlan.h"
#include "Frame/vtkIndirectReport.h"
#include "Frame/vtkIndirectStageTimer.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Proxies/vtkIndirectProxyLight.h"
#include "Proxies/vtkIndirectProxyReach.h"
#include "Proxies/vtkIndirectProxyScene.h"
#include "Proxies/vtkIndirectProxyStep.h"
#include "Proxies/vtkIndirectProxySums.h"
#include "Proxies/vtkIndirectProxyTree.h"
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
const vtkIndirectChannel SkyChannels[] = {
  { "sky", "vtkiSky", "irradiance that comes directly from the environment", GL_RGBA32F, "-",
    "VTK irradiance" },
  { "bounce", "vtkiIrradiance", "irradiance that proxies send", GL_RGBA32F, "-", "VTK irradiance" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};

// 0, or a number of radii.
double ClampScale(double scale)
{
  return scale > 0.0
    ? std::min(std::max(scale, vtkIndirectProxyReach::Least), vtkIndirectProxyReach::Most)
    : 0.0;
}
}

//------------------------------------------------------------------------------
struct vtkProxyAccumulationPass::Internals
{
  vtkIndirectProxyScene::Given Given;
  vtkIndirectProxyScene Scene;
  vtkIndirectProxyTree Tree;
  vtkIndirectProxySums Sums;
  vtkIndirectTarget Sky{ SkyChannels, false };
  vtkMTimeType TreeTime = 0; // of this pass when the tree was built
  bool TreeIsThere = false;
  vtkIndirectProxyStep StepBySpheres;
  int Step = 0;          // of the last frame
  glm::dvec3 Eye{ 0.0 }; // of that, in scene units
  // Without groups: what an environment needs, and what is used.
  vtkIndirectProxyReach Needed;
  vtkEnvironmentLight* Environment = nullptr; // compared only
  vtkMTimeType EnvironmentTime = 0;
  bool IsOfMiddle = false;
  double Hides = 0.0;
  double Sends = 0.0;
};

//------------------------------------------------------------------------------
vtkProxyAccumulationPass::vtkProxyAccumulationPass()
  : Internal(new Internals)
{
}

vtkProxyAccumulationPass::~vtkProxyAccumulationPass() = default;

//------------------------------------------------------------------------------
void vtkProxyAccumulationPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  static const char* const levels[] = { "Off", "Middle", "Averaged", "Shadowed", "Exact" };
  os << indent << "ReceiverStep: " << this->Settings.ReceiverStep << "\n";
  os << indent << "Groups: " << (this->Settings.Groups ? "On" : "Off") << "\n";
  os << indent << "GroupAngle: " << this->Settings.GroupAngle << "\n";
  os << indent << "InfluenceScale: " << this->Settings.InfluenceScale << "\n";
  os << indent << "IndirectInfluenceScale: " << this->Settings.IndirectInfluenceScale << "\n";
  os << indent << "IndirectLight: " << levels[this->Settings.IndirectLight] << "\n";
  os << indent << "NumberOfSpheres: " << this->GetNumberOfSpheres() << "\n";
  os << indent << "NumberOfPolygons: " << this->GetNumberOfPolygons() << "\n";
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
  auto& given = this->Internal->Given;
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
  const auto known = this->Internal->Given.find(prop);
  return known == this->Internal->Given.end() ? nullptr : known->second.Get();
}

//------------------------------------------------------------------------------
void vtkProxyAccumulationPass::RemoveAllProxies()
{
  if (!this->Internal->Given.empty())
  {
    this->Internal->Given.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkProxyAccumulationPass::GetNumberOfSpheres() const
{
  return static_cast<int>(this->Internal->Scene.GetSpheres().size());
}

//------------------------------------------------------------------------------
int vtkProxyAccumulationPass::GetNumberOfPolygons() const
{
  return static_cast<int>(this->Internal->Scene.GetPolygons().size());
}

//------------------------------------------------------------------------------
int vtkProxyAccumulationPass::GetActiveReceiverStep() const
{
  return this->Internal->Step;
}

//------------------------------------------------------------------------------
double vtkProxyAccumulationPass::GetActiveInfluenceScale() const
{
  return this->Internal->Hides;
}

//------------------------------------------------------------------------------
double vtkProxyAccumulationPass::GetActiveIndirectInfluenceScale() const
{
  return this->Internal->Sends;
}

//------------------------------------------------------------------------------
vtkIndirectVisibilityNeeds vtkProxyAccumulationPass::GetVisibilityNeeds(
  const vtkIndirectPlan&) const
{
  return {};
}

//------------------------------------------------------------------------------
std::shared_ptr<vtkIndirectSampler> vtkProxyAccumulationPass::ChooseSampler(
  const std::shared_ptr<vtkIndirectSampler>&, const vtkIndirectPlan&)
{
  return nullptr;
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkProxyAccumulationPass::Estimate(const Input& input)
{
  if (!this->Sum(input))
  {
    return {};
  }
  vtkIndirectEstimate result = this->MakeResult();
  result.Sky = &this->Internal->Sky;
  result.Irradiance = nullptr;
  result.SkyBounce = this->Settings.IndirectLight == OFF ? nullptr : &this->Internal->Sky;
  result.SkyBounceChannel = 1;
  return result;
}

//------------------------------------------------------------------------------
// Returns whether spheres hide light within other radii than before.
bool vtkProxyAccumulationPass::FindReach(vtkEnvironmentLight* environment)
{
  Internals& in = *this->Internal;
  const SettingsType& settings = this->Settings;
  const double before = in.Hides;
  in.Hides = settings.Groups ? 0.0 : settings.InfluenceScale;
  in.Sends = settings.Groups ? 0.0 : settings.IndirectInfluenceScale;
  if (!settings.Groups && environment && (in.Hides <= 0.0 || in.Sends <= 0.0))
  {
    const bool middle = settings.IndirectLight == MIDDLE;
    if (environment != in.Environment || environment->GetMTime() != in.EnvironmentTime ||
      middle != in.IsOfMiddle)
    {
      in.Needed = vtkIndirectProxyReach::Find(vtkIndirectProxyLight::Project(environment), middle);
      in.Environment = environment;
      in.EnvironmentTime = environment->GetMTime();
      in.IsOfMiddle = middle;
    }
    in.Hides = in.Hides > 0.0 ? in.Hides : in.Needed.Hides;
    in.Sends = in.Sends > 0.0 ? in.Sends : in.Needed.Sends;
  }
  return in.Hides != before;
}

//------------------------------------------------------------------------------
bool vtkProxyAccumulationPass::Sum(const Input& input)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkIndirectFullScreenState kernelState(frame.Window);
  const auto stage = input.Plan.SkySource == vtkIndirectPlan::SKY_BY_ESTIMATOR
    ? vtkIndirectStageTimer::Estimate
    : vtkIndirectStageTimer::Sky;

  input.Timer.Begin(vtkIndirectStageTimer::Lights);
  const bool moved = in.Scene.Update(frame, in.Given, this);
  in.Eye = glm::dvec3(frame.ViewToScene[3]);
  const bool reaches = this->FindReach(input.Environment);
  const bool rebuilds = moved || reaches || !in.TreeIsThere || in.TreeTime != this->GetMTime();
  bool done = true;
  if (rebuilds)
  {
    in.Tree.Build(
      in.Scene.GetSpheres(), this->Settings.Groups ? this->Settings.GroupAngle : 0.0, in.Hides);
    done = in.Sums.Update(frame.Window, in.Tree, in.Scene.GetPolygons());
    in.TreeIsThere = done;
    in.TreeTime = this->GetMTime();
  }
  in.Sums.SetEnvironment(frame.Window, input.Environment);
  input.Timer.End(vtkIndirectStageTimer::Lights);

  in.Sky.SetNumberOfChannels(this->Settings.IndirectLight == OFF ? 1 : 2);
  vtkIndirectProxySums::Input sums = { frame, input.Geometry };
  in.Step = this->Settings.ReceiverStep;
  if (in.Step == 0)
  {
    in.Step = in.StepBySpheres.Find(frame, in.Scene.GetSpheres());
  }
  else
  {
    in.StepBySpheres.Forget();
  }
  sums.Step = in.Step;
  sums.Hides = input.Plan.SkyIsShadowed;
  sums.Middle = this->Settings.IndirectLight == MIDDLE;
  sums.Exact = this->Settings.IndirectLight == EXACT;
  sums.Shadowed = this->Settings.IndirectLight == SHADOWED;
  sums.LightReach = in.Sends;
  input.Timer.Begin(stage);
  done = done && in.Sums.Sum(sums, in.Sky);
  input.Timer.End(stage);
  return done;
}

//------------------------------------------------------------------------------
size_t vtkProxyAccumulationPass::GetBytes() const
{
  const Internals& in = *this->Internal;
  return this->Superclass::GetBytes() + in.Sky.GetBytes() + in.Sums.GetBytes();
}

//------------------------------------------------------------------------------
size_t vtkProxyAccumulationPass::GetMainMemoryBytes() const
{
  const Internals& in = *this->Internal;
  return in.Scene.GetSpheres().size() * sizeof(vtkIndirectProxySphere) +
    in.Tree.GetEntries().size() * sizeof(vtkIndirectProxyTree::Entry);
}

//------------------------------------------------------------------------------
std::string vtkProxyAccumulationPass::DescribeReach() const
{
  const Internals& in = *this->Internal;
  auto describe = [](double used, bool chosen)
  {
    return vtkIndirectReport::Number(std::round(10.0 * used) / 10.0) + " radii (" +
      (chosen ? "chosen: beyond, one takes at most 1/256 of the open sky's largest irradiance)"
              : "as set)");
  };
  std::string text =
    "each sphere within " + describe(in.Hides, this->Settings.InfluenceScale <= 0.0);
  if (this->Settings.IndirectLight != OFF)
  {
    text +=
      ", its light within " + describe(in.Sends, this->Settings.IndirectInfluenceScale <= 0.0);
  }
  if (this->Settings.InfluenceScale <= 0.0)
  {
    text += ", where the sky is at most " +
      vtkIndirectReport::Number(std::round(100.0 * in.Needed.Contrast) / 100.0) +
      " times as bright as that irradiance";
  }
  return text;
}

//------------------------------------------------------------------------------
void vtkProxyAccumulationPass::AddToReport(vtkIndirectReport& report) const
{
  const Internals& in = *this->Internal;
  in.Scene.AddToReport(report);
  const size_t around = in.Scene.CountAround(in.Eye);
  if (around > 0)
  {
    report.LeftOut.emplace_back("the inside of bodies",
      "the camera is within " + std::to_string(around) +
        " of the spheres, which stand for what is seen from outside: there it is too bright. Other "
        "methods take it as it is");
  }
  const size_t most = vtkIndirectProxyLight::MostPolygons;
  if (in.Scene.GetPolygons().size() > most)
  {
    report.LeftOut.emplace_back(
      std::to_string(in.Scene.GetPolygons().size() - most) + " flat polygons",
      "the " + std::to_string(most) + " largest count; the result is too bright");
  }
  const int step = in.Step;
  report.Modelled.emplace_back("light from the sky",
    "spherical harmonics of order 4, " +
      (this->Settings.Groups ? "groups of spheres that are seen under a sine of " +
            vtkIndirectReport::Number(this->Settings.GroupAngle) + " or less as one"
                             : this->DescribeReach()) +
      (step > 1 ? ", a receiver in " + std::to_string(step * step) + " pixels"
                : ", at every pixel"));
  if (this->Settings.IndirectLight == OFF)
  {
    report.LeftOut.emplace_back("bounces of light from the sky", "IndirectLight is off");
  }
  else
  {
    report.Modelled.emplace_back("one bounce of light from the sky",
      this->Settings.IndirectLight == SHADOWED
        ? "spheres send what of it falls on them"
        : "spheres send it as if nothing hid it from them; the result is too bright where they are "
          "close to each other");
  }
}

//------------------------------------------------------------------------------
void vtkProxyAccumulationPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!this->CanBeOf(window))
  {
    return;
  }
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& in = *this->Internal;
  in.Sky.Release(window);
  in.Sums.Release(window);
  in.TreeIsThere = false;
  in.Environment = nullptr;
}
