// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkIndirectIlluminationPass.h"

#include "OpenGL/vtkIndirectContextGuard.h"
#include "Picture/vtkIndirectComposite.h"
#include "Pipeline/vtkIndirectIdleFrames.h"
#include "Pipeline/vtkIndirectLighting.h"
#include "Pipeline/vtkIndirectPipeline.h"
#include "Plan/vtkIndirectPlan.h"
#include "Plan/vtkIndirectReport.h"
#include "Plan/vtkIndirectSettingList.h"
#include "Scene/vtkIndirectDelegateGuard.h"
#include "Scene/vtkIndirectLightScope.h"
#include "Scene/vtkIndirectPointSpheres.h"
#include "Scene/vtkIndirectPropKind.h"
#include "Scene/vtkIndirectRendererWork.h"
#include "Scene/vtkIndirectSwitches.h"
#include "Sums/vtkIndirectSum.h"
#include "vtkAreaLight.h"
#include "vtkCommand.h"
#include "vtkEnvironmentLight.h"
#include "vtkHiddenLineRemovalPass.h"
#include "vtkImageData.h"
#include "vtkIndirectEstimatorPass.h"
#include "vtkLightsPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"

#include <algorithm>
#include <optional>
#include <vector>

vtkStandardNewMacro(vtkIndirectIlluminationPass);
vtkCxxSetObjectMacro(vtkIndirectIlluminationPass, Estimator, vtkIndirectEstimatorPass);
vtkCxxSetObjectMacro(vtkIndirectIlluminationPass, Environment, vtkEnvironmentLight);
vtkCxxSetObjectMacro(vtkIndirectIlluminationPass, Sampler, vtkVirtualLightSampler);

//------------------------------------------------------------------------------
struct vtkIndirectIlluminationPass::Internals
{
  vtkIndirectPipeline Pipeline;
  vtkIndirectLighting Lighting;
  vtkIndirectIdleFrames Idle;
  vtkNew<vtkSequencePass> DefaultDelegate;
  vtkNew<vtkHiddenLineRemovalPass> HiddenLines; // replaces it if the renderer removes hidden lines
  vtkIndirectSwitches Switches;
  std::string RefusedAround; // the reason that an error has reported

  vtkRenderPass* FindDelegate(const vtkRenderState* s, vtkRenderPass* users)
  {
    return users                                   ? users
      : vtkIndirectSwitches::RemovesHiddenLines(s) ? static_cast<vtkRenderPass*>(this->HiddenLines)
                                                   : this->DefaultDelegate;
  }
  vtkIndirectDelegateGuard Delegate;
  vtkIndirectEstimatorPass* Borrowed = nullptr;
  vtkIndirectRendererWork Work;
  std::string ReportedError;

  // Releases everything when the window's context ends or the pass moves to another window: VTK
  // notifies a pass only when it is in a renderer of that window.
  vtkNew<vtkIndirectContextGuard> Guard;
  vtkIndirectSettingList FrameSettings; // in force in the last frame
};

//------------------------------------------------------------------------------
vtkIndirectIlluminationPass::vtkIndirectIlluminationPass()
  : Internal(new Internals)
{
  this->ReflectiveShadowMaps = this->Internal->Pipeline.MapsPass;
  this->Internal->Guard->Release = [this](vtkWindow* window) { this->LetGo(window); };
  vtkNew<vtkRenderPassCollection> passes;
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  passes->AddItem(lights);
  passes->AddItem(opaque);
  this->Internal->DefaultDelegate->SetPasses(passes);
}

//------------------------------------------------------------------------------
vtkIndirectIlluminationPass::~vtkIndirectIlluminationPass()
{
  this->SetEstimator(nullptr);
  this->SetSampler(nullptr);
  this->SetEnvironment(nullptr);
  this->SetDelegatePass(nullptr);
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Estimator: " << this->Estimator << (this->Estimator ? "" : " (automatic)")
     << "\n";
  os << indent << "Sampler: " << this->Sampler << (this->Sampler ? "" : " (automatic)") << "\n";
  os << indent << "Environment: " << this->Environment << "\n";
  os << indent << "NumberOfAreaLights: " << this->GetNumberOfAreaLights() << "\n";
  os << indent << "DelegatePass: " << this->DelegatePass << "\n";
  vtkIndirectSettingList settings;
  this->Internal->Pipeline.AddSettings(settings, this->Settings, nullptr);
  settings.Add("DebugView", this->DebugView).Print(os, indent);
  os << indent << "Buffers:\n";
  vtkIndirectComposite::PrintChannels(os, indent.GetNextIndent());
  os << indent << "ReflectiveShadowMaps:\n";
  this->ReflectiveShadowMaps->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::SetDelegatePass(vtkRenderPass* delegate)
{
  if (delegate == this)
  {
    vtkErrorMacro("A pass cannot be its own delegate; the delegate stays as it was.");
    return;
  }
  vtkSetObjectBodyMacro(DelegatePass, vtkRenderPass, delegate);
}

//------------------------------------------------------------------------------
vtkIndirectEstimatorPass* vtkIndirectIlluminationPass::GetActiveEstimator()
{
  const Internals& in = *this->Internal;
  return this->Estimator ? this->Estimator
    : in.Borrowed        ? in.Borrowed
                         : in.Pipeline.DefaultEstimator.Get();
}

//------------------------------------------------------------------------------
vtkVirtualLightSampler* vtkIndirectIlluminationPass::GetActiveSampler()
{
  vtkVirtualLightSampler* preset = this->GetActiveEstimator()->GetSamplerOfPreset();
  return this->Sampler ? this->Sampler
    : preset           ? preset
                       : this->Internal->Pipeline.Samplers.Default.Get();
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::BorrowEstimator(vtkIndirectEstimatorPass* estimator)
{
  this->Internal->Borrowed = estimator;
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::AddSampler(vtkVirtualLightSampler* sampler)
{
  auto& samplers = this->Internal->Pipeline.Samplers.Others;
  if (sampler && std::find(samplers.begin(), samplers.end(), sampler) == samplers.end())
  {
    samplers.emplace_back(sampler);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::RemoveSampler(vtkVirtualLightSampler* sampler)
{
  auto& samplers = this->Internal->Pipeline.Samplers.Others;
  samplers.erase(std::remove(samplers.begin(), samplers.end(), sampler), samplers.end());
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::AddCoarseLevel(vtkProp* actor, vtkPolyData* level, double error)
{
  const std::string why = this->Internal->Pipeline.Levels.Add(actor, level, error);
  if (!why.empty())
  {
    vtkErrorMacro("The coarse level is not taken: " << why << ".");
    return;
  }
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::RemoveCoarseLevels(vtkProp* actor)
{
  this->Internal->Pipeline.Levels.Remove(actor);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::AddAreaLight(vtkAreaLight* light)
{
  auto& lights = this->Internal->Pipeline.AreaLights;
  if (!light)
  {
    vtkErrorMacro("There is no area light to add.");
  }
  else if (std::find(lights.begin(), lights.end(), light) == lights.end())
  {
    lights.emplace_back(light);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::RemoveAreaLight(vtkAreaLight* light)
{
  auto& lights = this->Internal->Pipeline.AreaLights;
  lights.erase(std::remove(lights.begin(), lights.end(), light), lights.end());
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::RemoveAllAreaLights()
{
  this->Internal->Pipeline.AreaLights.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkIndirectIlluminationPass::GetNumberOfAreaLights()
{
  return static_cast<int>(this->Internal->Pipeline.AreaLights.size());
}

//------------------------------------------------------------------------------
vtkAreaLight* vtkIndirectIlluminationPass::GetAreaLight(int index)
{
  return index >= 0 && index < this->GetNumberOfAreaLights()
    ? this->Internal->Pipeline.AreaLights[static_cast<size_t>(index)].Get()
    : nullptr;
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::SetReflectiveShadowMapResolution(int texels)
{
  const vtkMTimeType before = this->ReflectiveShadowMaps->GetMTime();
  this->ReflectiveShadowMaps->SetResolution(texels);
  if (this->ReflectiveShadowMaps->GetMTime() != before)
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkIndirectIlluminationPass::GetReflectiveShadowMapResolution()
{
  return this->ReflectiveShadowMaps->GetResolution();
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::SetTiming(bool timing)
{
  if (timing != this->Internal->Pipeline.Timer.Enabled)
  {
    this->Internal->Pipeline.Timer.Enabled = timing;
    this->Internal->Pipeline.Timer.Reset();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectIlluminationPass::GetTiming()
{
  return this->Internal->Pipeline.Timer.Enabled;
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::Render(const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  this->NumberOfRenderedProps = 0;
  vtkRenderer* renderer = s->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!window)
  {
    vtkErrorMacro("vtkIndirectIlluminationPass needs an OpenGL render window.");
    return;
  }
  if (in.Delegate.IsDrawing())
  {
    this->RefuseDelegate("contains this very pass");
    return;
  }
  in.Guard->SetContext(window);
  window->MakeCurrent();
  if (renderer->GetSelector())
  {
    // Selection draws identifiers instead of colours; the renderer's own path does this.
    this->UpdateCamera(renderer);
    this->UpdateLightGeometry(renderer);
    this->UpdateLights(renderer);
    this->UpdateGeometry(renderer, s->GetFrameBuffer());
    return;
  }

  vtkOpenGLClearErrorMacro();
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);

  in.Pipeline.Timer.BeginFrame(window);
  vtkIndirectPipeline::Request request;
  request.DepthCleared = in.Work.Begin(s);
  request.Settings = this->Settings;
  request.Circumstances.OwnDelegate = this->DelegatePass != nullptr;
  request.Circumstances.UpdateRate = window->GetDesiredUpdateRate();
  request.Circumstances.OffScreen = window->GetOffScreenRendering() != 0;
  request.Circumstances.IdleFrames =
    this->Settings.IdleFrames && vtkIndirectIdleFrames::CanFollow(window);
  request.Circumstances.IsIdleFrame = in.Idle.IsOwnFrame();
  request.Circumstances.OtherAntialiasing =
    vtkIndirectRendererWork::FindAntialiasing(s, this->Settings.RemainingGeometry);
  if (in.Delegate.IsRefused(this->DelegatePass))
  {
    request.Circumstances.DelegateIsRefused = vtkIndirectDelegateGuard::Why;
  }
  const std::string around = vtkIndirectSwitches::FindRefusal(s);
  if (!around.empty())
  {
    request.Circumstances.DelegateIsRefused = around;
  }
  this->Say(s, around);
  request.Estimator = this->GetActiveEstimator();
  request.HoldEstimator = request.Estimator != in.Borrowed;
  request.Sampler = this->GetActiveSampler();
  request.Delegate = in.FindDelegate(s, this->DelegatePass);
  request.DepthOfSamples = request.Delegate == in.DefaultDelegate;
  in.Lighting.Update(renderer, this->Settings, this->Environment);
  request.Environment = in.Lighting.GetEnvironment();
  request.MostReplaced = in.Lighting.GetMostReplaced();
  request.Circumstances.EnvironmentTurns = in.Lighting.HasOwnSky();
  // A picture of the delegate alone has the renderer's lights.
  std::optional<vtkIndirectLightScope> lights(std::in_place, renderer, in.Lighting.GetLights());
  request.ReplacedLights = lights->GetReplaced();
  std::optional<vtkIndirectPointSpheres::Scope> spheres(std::in_place, in.Pipeline.PointSpheres,
    renderer, !vtkIndirectPlan::IsInteractive(request.Circumstances.UpdateRate));
  in.Pipeline.Prepare(s, request);
  std::string why = in.Pipeline.GetPlan().WhyDelegate;
  in.Delegate.Begin();
  if (why.empty() && !in.Pipeline.DrawSurfaces(s, request))
  {
    why = "OpenGL could not hold the frame's textures";
    if (this->DelegatePass && in.Pipeline.IsRedirected())
    {
      this->RefuseDelegate(
        "draws into a framebuffer of its own, where surfaces cannot be captured");
    }
  }
  // Drawing with the delegate may have refused it, too.
  if (why.empty() && in.Delegate.IsRefused(this->DelegatePass))
  {
    why = vtkIndirectDelegateGuard::Why;
  }
  if (why.empty())
  {
    this->NumberOfRenderedProps += in.Pipeline.GetNumberOfRenderedProps();
    in.Pipeline.DrawLight(request);
    this->ShowDebugView();
    spheres.reset();
    lights.reset();
    this->NumberOfRenderedProps += vtkIndirectRendererWork::RenderFlat(s);
  }
  else
  {
    spheres.reset();
    lights.reset();
    this->RenderDelegate(
      s, in.Delegate.IsRefused(this->DelegatePass) ? vtkIndirectDelegateGuard::Why : why);
  }
  in.Delegate.End();
  if (this->Settings.RemainingGeometry)
  {
    this->NumberOfRenderedProps += in.Work.RenderRemaining(s);
  }
  in.Pipeline.Timer.EndFrame();
  in.Idle.EndFrame(window, this->Settings.IdleFrames ? in.Pipeline.CountWorkLeft() : 0);
  in.FrameSettings = this->CollectSettings();
  vtkOpenGLCheckErrorMacro("failed after indirect illumination");
  this->InvokeEvent(vtkCommand::EndEvent);
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::RenderDelegate(const vtkRenderState* s, const std::string& why)
{
  Internals& in = *this->Internal;
  in.Pipeline.Forget(why);
  in.Pipeline.Timer.Begin(vtkIndirectStageTimer::Delegate);
  vtkRenderPass* delegate = in.FindDelegate(s, this->DelegatePass);
  // Props that catch light show nothing of themselves.
  std::vector<vtkProp*> props(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount());
  props.erase(
    std::remove_if(props.begin(), props.end(), vtkIndirectPropKind::CatchesLight), props.end());
  vtkRenderState shown(s->GetRenderer());
  shown.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  shown.SetFrameBuffer(s->GetFrameBuffer());
  shown.SetRequiredKeys(s->GetRequiredKeys());
  delegate->Render(&shown);
  this->NumberOfRenderedProps += delegate->GetNumberOfRenderedProps();
  in.Pipeline.Timer.End(vtkIndirectStageTimer::Delegate);
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::Say(const vtkRenderState* s, const std::string& around)
{
  Internals& in = *this->Internal;
  if (!around.empty() && around != in.RefusedAround)
  {
    vtkErrorMacro(<< around << ": the picture is without indirect light.");
  }
  in.RefusedAround = around;
  in.Switches.Update(s, this->DelegatePass != nullptr);
  for (const auto& entry : in.Switches.GetLeftOut())
  {
    if (in.Switches.IsNew(entry.first))
    {
      vtkWarningMacro("Left out: " << entry.first << ": " << entry.second << ".");
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::RefuseDelegate(const std::string& reason)
{
  if (this->Internal->Delegate.Refuse(this->DelegatePass))
  {
    vtkErrorMacro("The delegate " << this->DelegatePass->GetClassName() << ' ' << reason
                                  << ": its picture is shown without indirect light.");
  }
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::ShowDebugView()
{
  Internals& in = *this->Internal;
  if (this->DebugView.empty() || in.Pipeline.ShowChannel(this->DebugView))
  {
    in.ReportedError.clear();
  }
  else if (in.ReportedError != this->DebugView)
  {
    in.ReportedError = this->DebugView;
    vtkErrorMacro("DebugView '" << this->DebugView << "' is no channel of this frame; known are "
                                << this->GetChannelNames() << ".");
  }
}

//------------------------------------------------------------------------------
vtkIndirectEstimatorPass* vtkIndirectIlluminationPass::GetFrameEstimator()
{
  vtkIndirectEstimatorPass* last = this->Internal->Pipeline.GetEstimator();
  return last ? last : this->GetActiveEstimator();
}

//------------------------------------------------------------------------------
std::string vtkIndirectIlluminationPass::GetChannelNames()
{
  std::string names = vtkIndirectComposite::GetChannelNames();
  for (const std::string& name : vtkIndirectSum::Get(this->GetFrameEstimator()).GetChannelNames())
  {
    names += ", " + name;
  }
  return names;
}

//------------------------------------------------------------------------------
bool vtkIndirectIlluminationPass::CopyBuffer(const std::string& name, vtkImageData* image)
{
  int map = 0;
  int channel = 0;
  const std::vector<std::string> own =
    vtkIndirectSum::Get(this->GetFrameEstimator()).GetChannelNames();
  const bool estimators = std::find(own.begin(), own.end(), name) != own.end();
  const bool known = name == "lights" || name == "branches" || name == "lobes" ||
    vtkIndirectComposite::FindChannel(name) >= 0 ||
    vtkIndirectComposite::ParseMapChannel(name, map, channel) || estimators;
  if (!image)
  {
    vtkErrorMacro("CopyBuffer needs an image to copy '" << name << "' to.");
    return false;
  }
  if (!known)
  {
    vtkErrorMacro("'" << name << "' is no buffer; known are " << this->GetChannelNames()
                      << ", lights, branches.");
    return false;
  }
  const std::string why = this->Internal->Pipeline.CopyChannel(name, image);
  if (!why.empty())
  {
    vtkErrorMacro("There is no buffer '" << name << "': " << why << ".");
  }
  return why.empty();
}

//------------------------------------------------------------------------------
vtkIndirectSettingList vtkIndirectIlluminationPass::CollectSettings()
{
  Internals& in = *this->Internal;
  vtkIndirectSettingList settings;
  // An estimator's setting hides the frame's setting of the same name.
  const vtkIndirectPlan* const plan = in.Pipeline.HasBuffers() ? &in.Pipeline.GetPlan() : nullptr;
  const vtkIndirectSum& sum = vtkIndirectSum::Get(this->GetFrameEstimator());
  sum.AddSettings(settings, plan);
  if (sum.GetAbilities(this->Settings.ErrorTolerance).TakesSampler)
  {
    vtkIndirectSampler::Get(this->GetActiveSampler())->AddSettings(settings, plan);
  }
  in.Pipeline.AddSettings(settings, this->Settings, plan);
  settings.Add("DebugView", this->DebugView);
  return settings;
}

//------------------------------------------------------------------------------
std::string vtkIndirectIlluminationPass::GetReport(bool estimatesError)
{
  Internals& in = *this->Internal;
  if (estimatesError)
  {
    in.Pipeline.EstimateError();
  }
  vtkIndirectReport report;
  report.Settings = in.Pipeline.HasBuffers() ? in.FrameSettings : this->CollectSettings();
  in.Pipeline.AddToReport(report);
  report.LeftOut.insert(
    report.LeftOut.end(), in.Switches.GetLeftOut().begin(), in.Switches.GetLeftOut().end());
  if (in.Pipeline.HasBuffers())
  {
    in.Lighting.AddToReport(report);
  }
  return report.ToJSON(in.Pipeline.Timer);
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::ReleaseGraphicsResources(vtkWindow* window)
{
  // A renderer that leaves a window does not make that window's context current.
  if (window && this->Internal->Guard->CanBeOf(window))
  {
    this->Internal->Guard->LetGo(window);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::LetGo(vtkWindow* window)
{
  Internals& in = *this->Internal;
  in.Idle.Stop();
  this->Superclass::ReleaseGraphicsResources(window);
  auto release = [window](auto* users)
  {
    if (users)
    {
      users->ReleaseGraphicsResources(window);
    }
  };
  release(this->Estimator);
  release(this->Sampler);
  release(this->DelegatePass);
  in.Pipeline.Release(window);
  in.DefaultDelegate->ReleaseGraphicsResources(window);
  in.HiddenLines->ReleaseGraphicsResources(window);
  in.Work.Release(window);
}
