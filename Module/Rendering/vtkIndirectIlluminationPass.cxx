// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGL.h"

#include "vtkIndirectIlluminationPass.h"

#include "vtkGeometryBufferPass.h"
#include "vtkImageData.h"
#include "vtkIndirectCompositePass.h"
#include "vtkIndirectContextGuard.h"
#include "vtkIndirectDelegateGuard.h"
#include "vtkIndirectFrame.h"
#include "vtkIndirectLightMap.h"
#include "vtkIndirectOccupancyVolume.h"
#include "vtkIndirectPaths.h"
#include "vtkIndirectReport.h"
#include "vtkIndirectStageTimer.h"
#include "vtkIndirectTarget.h"
#include "vtkIndirectView.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkLightsPass.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSequencePass.h"
#include "vtkSmartPointer.h"
#include "vtkSurfaceCapturePass.h"
#include "vtkUniformLightSampler.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkIndirectIlluminationPass);
vtkCxxSetObjectMacro(vtkIndirectIlluminationPass, Estimator, vtkIndirectEstimatorPass);
vtkCxxSetObjectMacro(vtkIndirectIlluminationPass, Sampler, vtkVirtualLightSampler);
vtkInformationKeyMacro(vtkIndirectIlluminationPass, CASTS_SHADOWS, Integer);
vtkInformationKeyMacro(vtkIndirectIlluminationPass, SENDS_LIGHT, Integer);

//------------------------------------------------------------------------------
struct vtkIndirectIlluminationPass::Internals
{
  // Stages of the frame, in order; the first two are members of the class.
  vtkNew<vtkGeometryBufferPass> Geometry;
  vtkNew<vtkUniformLightSampler> DefaultSampler;
  vtkNew<vtkMultiresolutionSplattingPass> DefaultEstimator;
  std::shared_ptr<vtkIndirectOccupancyVolume> Voxels{ new vtkIndirectOccupancyVolume };
  vtkNew<vtkIndirectCompositePass> Composite;

  vtkNew<vtkSequencePass> DefaultDelegate;
  vtkIndirectView View;

  // The last frame.
  vtkIndirectFrame Frame;
  vtkWeakPointer<vtkRenderer> Renderer; // guards Frame's pointers
  bool HasBuffers = false;
  bool HasIrradiance = false;
  bool EyeIsMap = false;
  // What made its irradiance: its buffers stay readable when the pass is given others.
  vtkSmartPointer<vtkIndirectEstimatorPass> Estimator;
  vtkSmartPointer<vtkVirtualLightSampler> Sampler;
  bool DepthCleared = false; // of what the frame is drawn into
  std::string Paths;         // in force
  std::string WhyDelegate = "no frame has been rendered yet";
  vtkIndirectStageTimer Timer;

  // What the irradiance was computed from; empty when there is none.
  std::vector<double> EstimateKey;
  // What the estimator could not work with, and has said so: not asked again before it changes.
  std::vector<double> FailedKey;

  std::string ReportedError;

  vtkIndirectDelegateGuard Delegate;

  // What the composite reads of the last frame.
  vtkIndirectCompositePass::Input MakeCompositeInput(vtkIndirectIlluminationPass* self) const
  {
    return { this->Frame, *this->Geometry, this->EyeIsMap ? nullptr : self->ReflectiveShadowMaps,
      this->HasIrradiance ? this->Estimator.Get() : nullptr, self->IndirectScale,
      this->DepthCleared };
  }

  // Releases everything when the window's context ends or the pass moves to another window: VTK
  // tells a pass only when it is in a renderer of that window.
  vtkNew<vtkIndirectContextGuard> Guard;
};

//------------------------------------------------------------------------------
vtkIndirectIlluminationPass::vtkIndirectIlluminationPass()
  : SurfaceCapture(vtkSurfaceCapturePass::New())
  , ReflectiveShadowMaps(vtkReflectiveShadowMapPass::New())
  , Internal(new Internals)
{
  this->Internal->Guard->Release = [this](vtkWindow* window)
  { this->ReleaseGraphicsResources(window); };
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
  this->SetDelegatePass(nullptr);
  this->SurfaceCapture->Delete();
  this->ReflectiveShadowMaps->Delete();
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  auto flag = [](bool on) { return on ? "On" : "Off"; };
  os << indent << "Estimator: " << this->Estimator << (this->Estimator ? "" : " (automatic)")
     << "\n";
  os << indent << "Sampler: " << this->Sampler << (this->Sampler ? "" : " (automatic)") << "\n";
  os << indent << "DelegatePass: " << this->DelegatePass << "\n";
  os << indent << "Shadows: " << flag(this->Shadows) << "\n";
  os << indent << "ReflectiveShadowMapResolution: " << this->GetReflectiveShadowMapResolution()
     << "\n";
  os << indent << "NumberOfBounces: " << this->NumberOfBounces << "\n";
  os << indent << "IndirectScale: " << this->IndirectScale << "\n";
  os << indent << "ErrorTolerance: " << this->ErrorTolerance << "\n";
  os << indent << "Caching: " << flag(this->Caching) << "\n";
  os << indent << "RemainingGeometry: " << flag(this->RemainingGeometry) << "\n";
  os << indent << "DebugView: \"" << this->DebugView << "\"\n";
  os << indent << "Timing: " << flag(this->GetTiming()) << "\n";
  os << indent << "NumberOfEstimates: " << this->NumberOfEstimates << "\n";
  os << indent << "SurfaceCapture:\n";
  this->SurfaceCapture->PrintSelf(os, indent.GetNextIndent());
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
  return this->Estimator ? this->Estimator : this->Internal->DefaultEstimator;
}

//------------------------------------------------------------------------------
vtkVirtualLightSampler* vtkIndirectIlluminationPass::GetActiveSampler()
{
  return this->Sampler ? this->Sampler : this->Internal->DefaultSampler;
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
void vtkIndirectIlluminationPass::SetCaching(bool caching)
{
  if (caching != this->Caching)
  {
    this->Caching = caching;
    this->ReflectiveShadowMaps->SetCaching(caching);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::SetTiming(bool timing)
{
  if (timing != this->Internal->Timer.Enabled)
  {
    this->Internal->Timer.Enabled = timing;
    this->Internal->Timer.Reset();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectIlluminationPass::GetTiming()
{
  return this->Internal->Timer.Enabled;
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
    // Selection draws identifiers, not colours; the renderer's own path knows how.
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

  in.Timer.BeginFrame(window);
  in.DepthCleared = in.View.Begin(s);

  in.Frame = vtkIndirectFrame();
  in.Renderer = renderer;
  in.HasBuffers = in.HasIrradiance = in.EyeIsMap = false;
  std::string why;
  if (this->IndirectScale == 0.0 && !this->Shadows)
  {
    why = "IndirectScale is 0 and Shadows are off";
  }
  else
  {
    in.Frame.Build(s, why);
  }
  in.Delegate.Begin();
  if (!why.empty() || !this->RenderIndirect(s, why))
  {
    this->RenderDelegate(s, why);
  }
  in.Delegate.End();
  if (this->RemainingGeometry)
  {
    this->NumberOfRenderedProps += in.View.RenderRemaining(s);
  }
  in.Timer.EndFrame();
  vtkOpenGLCheckErrorMacro("failed after indirect illumination");
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::RenderDelegate(const vtkRenderState* s, const std::string& why)
{
  Internals& in = *this->Internal;
  in.HasBuffers = in.HasIrradiance = false;
  in.EstimateKey.clear();
  in.WhyDelegate = why;
  in.Timer.Begin(vtkIndirectStageTimer::Delegate);
  vtkRenderPass* delegate = this->DelegatePass ? this->DelegatePass : in.DefaultDelegate;
  delegate->Render(s);
  this->NumberOfRenderedProps += delegate->GetNumberOfRenderedProps();
  in.Timer.End(vtkIndirectStageTimer::Delegate);
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
bool vtkIndirectIlluminationPass::RenderIndirect(const vtkRenderState* s, std::string& why)
{
  Internals& in = *this->Internal;
  vtkIndirectFrame& frame = in.Frame;
  if (in.Delegate.IsRefused(this->DelegatePass))
  {
    why = vtkIndirectDelegateGuard::Why;
    return false;
  }
  why = "OpenGL could not hold the frame's textures";
  in.Paths = vtkIndirectPaths::ToJSON();
  const vtkIndirectLight& first = frame.Lights.front();
  // The eye sees all that it lights and sends, unless a prop is not to send.
  in.EyeIsMap = frame.Lights.size() == 1 && first.Light->LightTypeIsHeadlight() &&
    !first.Positional && frame.AllSendLight;

  in.Estimator = this->GetActiveEstimator();
  vtkVirtualLightSampler* sampler = this->GetActiveSampler();
  in.Sampler = in.EyeIsMap ? in.Estimator->ChooseHeadlightSampler(sampler)
                           : in.Estimator->ChooseSampler(sampler);

  this->SurfaceCapture->SetDelegatePass(
    this->DelegatePass ? this->DelegatePass : in.DefaultDelegate.Get());
  // What somebody else's pass draws is not known.
  frame.Solid = frame.Solid && !this->DelegatePass;
  this->SurfaceCapture->SetShadows(this->Shadows && !in.EyeIsMap);
  this->SurfaceCapture->SetSpecular(this->IndirectScale > 0.0 && in.Estimator->WantsGlossy(frame));
  this->SurfaceCapture->Attach(frame);
  bool drawn = true;
  if (!in.EyeIsMap)
  {
    in.Timer.Begin(vtkIndirectStageTimer::ReflectiveShadowMap);
    drawn = this->ReflectiveShadowMaps->Update(frame, this->SurfaceCapture);
    in.Timer.End(vtkIndirectStageTimer::ReflectiveShadowMap);
  }
  in.Timer.Begin(vtkIndirectStageTimer::Geometry);
  const bool shadowed =
    this->Shadows && !in.EyeIsMap && this->ReflectiveShadowMaps->GetNumberOfMaps() > 0;
  drawn = drawn &&
    in.Geometry->Update(
      s, frame, this->SurfaceCapture, shadowed ? this->ReflectiveShadowMaps : nullptr);
  in.Timer.End(vtkIndirectStageTimer::Geometry);
  this->SurfaceCapture->Detach();
  if (this->DelegatePass && this->SurfaceCapture->IsRedirected())
  {
    this->RefuseDelegate("draws into a framebuffer of its own, where surfaces cannot be captured");
  }
  if (!drawn || in.Delegate.IsRefused(this->DelegatePass))
  {
    why = drawn ? vtkIndirectDelegateGuard::Why : why;
    return false;
  }
  this->NumberOfRenderedProps += in.Geometry->GetNumberOfRenderedProps();
  in.HasBuffers = true;

  const bool lit = in.EyeIsMap || this->ReflectiveShadowMaps->GetNumberOfMaps() > 0;
  in.HasIrradiance = this->IndirectScale > 0.0 && lit && this->UpdateIrradiance();

  in.Timer.Begin(vtkIndirectStageTimer::Composite);
  const vtkIndirectCompositePass::Input input = in.MakeCompositeInput(this);
  in.Composite->Composite(input);
  if (this->DebugView.empty())
  {
    in.ReportedError.clear();
  }
  else
  {
    if (in.Composite->RenderChannel(input, this->DebugView) ||
      (in.HasIrradiance && in.Composite->RenderChannel(input, in.Estimator, this->DebugView)))
    {
      in.ReportedError.clear();
      in.Composite->ShowImage(input);
    }
    else if (in.ReportedError != this->DebugView)
    {
      in.ReportedError = this->DebugView;
      vtkErrorMacro("DebugView '" << this->DebugView << "' is no channel of this frame; known are "
                                  << this->GetChannelNames() << ".");
    }
  }
  in.Timer.End(vtkIndirectStageTimer::Composite);
  return true;
}

//------------------------------------------------------------------------------
std::vector<double> vtkIndirectIlluminationPass::MakeEstimateKey()
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = in.Frame;
  std::vector<double> key = { static_cast<double>(frame.Size[0]),
    static_cast<double>(frame.Size[1]), static_cast<double>(in.Estimator->GetMTime()),
    static_cast<double>(this->GetActiveSampler()->GetMTime()),
    static_cast<double>(this->NumberOfBounces), static_cast<double>(in.EyeIsMap),
    this->ErrorTolerance,
    static_cast<double>(in.EyeIsMap ? 0 : this->ReflectiveShadowMaps->GetContentTime()) };
  frame.AppendTo(key);
  return key;
}

//------------------------------------------------------------------------------
bool vtkIndirectIlluminationPass::UpdateIrradiance()
{
  Internals& in = *this->Internal;
  const std::vector<double> key = this->MakeEstimateKey();
  const bool still = key == in.EstimateKey;
  if (this->Caching && still && in.Estimator->IsConverged())
  {
    return true;
  }
  in.EstimateKey.clear();
  if (key == in.FailedKey)
  {
    return false;
  }
  in.FailedKey.clear();

  in.Timer.Begin(vtkIndirectStageTimer::Lights);
  const bool sampled = !in.Sampler ||
    in.Sampler->Update(
      in.Frame, this->ReflectiveShadowMaps, in.EyeIsMap ? in.Geometry.Get() : nullptr);
  in.Timer.End(vtkIndirectStageTimer::Lights);

  const vtkIndirectEstimatorPass::Input input = { in.Frame, *in.Geometry,
    *this->ReflectiveShadowMaps, in.Sampler, in.EyeIsMap, this->NumberOfBounces, this->Caching,
    this->ErrorTolerance, in.Voxels, still };
  in.Estimator->HoldContext(in.Frame.Window);
  if (!sampled || !in.Estimator->Estimate(input, in.Timer))
  {
    in.FailedKey = key;
    return false;
  }
  ++this->NumberOfEstimates;
  in.EstimateKey = key;
  return true;
}

//------------------------------------------------------------------------------
vtkIndirectEstimatorPass* vtkIndirectIlluminationPass::GetFrameEstimator()
{
  vtkIndirectEstimatorPass* last = this->Internal->Estimator;
  return last ? last : this->GetActiveEstimator();
}

//------------------------------------------------------------------------------
std::string vtkIndirectIlluminationPass::GetChannelNames()
{
  std::string names = vtkIndirectCompositePass::GetChannelNames();
  for (const std::string& name : this->GetFrameEstimator()->GetChannelNames())
  {
    names += ", " + name;
  }
  return names;
}

//------------------------------------------------------------------------------
bool vtkIndirectIlluminationPass::CopyBuffer(const std::string& name, vtkImageData* image)
{
  Internals& in = *this->Internal;
  int map = 0;
  int channel = 0;
  const std::vector<std::string> own = this->GetFrameEstimator()->GetChannelNames();
  const bool estimators = std::find(own.begin(), own.end(), name) != own.end();
  const bool known = name == "lights" || vtkIndirectCompositePass::FindChannel(name) >= 0 ||
    vtkIndirectCompositePass::ParseMapChannel(name, map, channel) || estimators;
  if (!image)
  {
    vtkErrorMacro("CopyBuffer needs an image to copy '" << name << "' to.");
    return false;
  }
  if (!known)
  {
    vtkErrorMacro("'" << name << "' is no buffer; known are " << this->GetChannelNames() << ".");
    return false;
  }
  if (!in.HasBuffers || !in.Renderer || in.Renderer->GetRenderWindow() != in.Frame.Window)
  {
    vtkErrorMacro("There is no buffer '"
      << name << "': only the delegate drew the last frame, because " << in.WhyDelegate << ".");
    return false;
  }
  in.Frame.Window->MakeCurrent();
  if (name == "lights")
  {
    if (!in.HasIrradiance || !in.Sampler)
    {
      vtkErrorMacro("There is no buffer 'lights': the last frame used no virtual lights.");
      return false;
    }
    in.Sampler->CopyLights(in.Frame, image);
    return true;
  }
  const vtkIndirectCompositePass::Input input = in.MakeCompositeInput(this);
  const bool rendered = estimators
    ? in.HasIrradiance && in.Composite->RenderChannel(input, in.Estimator, name)
    : in.Composite->RenderChannel(input, name);
  if (!rendered)
  {
    vtkErrorMacro("There is no buffer '"
      << name << "': "
      << (estimators       ? "the last frame computed no indirect light."
             : in.EyeIsMap ? "a single headlight is read from the geometry buffer and has no map."
                           : "the frame has fewer lights."));
    return false;
  }
  in.Composite->CopyImage(image);
  return true;
}

//------------------------------------------------------------------------------
std::string vtkIndirectIlluminationPass::GetReport()
{
  Internals& in = *this->Internal;
  vtkIndirectReport report;
  auto flag = [](bool on) { return on ? "true" : "false"; };
  std::copy(in.Frame.Size, in.Frame.Size + 2, report.Size);
  const double tolerance =
    this->GetFrameEstimator()->FindErrorTolerance(this->ErrorTolerance); // in force
  report.Settings = { { "Shadows", flag(this->Shadows) },
    { "ReflectiveShadowMapResolution", std::to_string(this->GetReflectiveShadowMapResolution()) },
    { "NumberOfBounces", std::to_string(this->NumberOfBounces) },
    { "IndirectScale", vtkIndirectReport::Number(this->IndirectScale) },
    { "ErrorTolerance", vtkIndirectReport::Number(tolerance) },
    { "Caching", flag(this->Caching) } };
  in.Frame.AddToReport(report);
  if (!in.HasBuffers)
  {
    report.Modelled.emplace_back("the delegate alone", in.WhyDelegate);
    return report.ToJSON(in.Timer);
  }

  vtkIndirectEstimatorPass* estimator = in.Estimator;
  report.Paths = in.Paths;
  report.Bytes = in.Geometry->GetTarget().GetBytes();
  if (in.EyeIsMap)
  {
    report.Modelled.emplace_back(
      "a headlight, from the geometry buffer", "the eye sees what it lights; no shadow is visible");
    report.LeftOut.emplace_back("senders outside the view", "the headlight has no map of its own");
  }
  else
  {
    this->ReflectiveShadowMaps->AddToReport(report);
    for (const vtkIndirectLight& light : in.Frame.Lights)
    {
      if (light.Color == glm::dvec3(0.0))
      {
        report.LeftOut.emplace_back("light " + std::to_string(light.Index), "it emits nothing");
      }
    }
  }
  if (in.HasIrradiance)
  {
    vtkVirtualLightSampler* sampler = in.Sampler;
    report.Method = estimator->GetMethodName();
    report.VirtualLights = sampler ? sampler->GetActualNumberOfLights() : 0;
    report.Bytes += estimator->GetBytes() + (sampler ? sampler->GetBytes() : 0);
    report.MainMemoryBytes = estimator->GetMainMemoryBytes();
    estimator->AddToReport(report);
    estimator->AddSpecularToReport(report);
    if (this->ErrorTolerance > 0.0 && tolerance != this->ErrorTolerance)
    {
      report.LeftOut.emplace_back(
        "ErrorTolerance " + vtkIndirectReport::Number(this->ErrorTolerance),
        estimator->GetClassName() +
          (tolerance > 0.0 ? " aims at " + vtkIndirectReport::Number(tolerance)
                           : std::string(" has no parameters that are chosen by it")));
    }
    if (this->NumberOfBounces > estimator->GetMaximumNumberOfBounces())
    {
      report.LeftOut.emplace_back(
        "bounces beyond " + std::to_string(estimator->GetMaximumNumberOfBounces()),
        std::string(estimator->GetClassName()) + " computes no more; the result is too dark");
    }
  }
  else
  {
    const bool lit = in.EyeIsMap || this->ReflectiveShadowMaps->GetNumberOfMaps() > 0;
    report.LeftOut.emplace_back("indirect light",
      this->IndirectScale == 0.0 ? "IndirectScale is 0"
        : lit                    ? "its estimator had an error"
                                 : "no light emits anything");
  }
  if (in.Renderer && in.Frame.Window && in.Renderer->GetRenderWindow() == in.Frame.Window)
  {
    in.Frame.Window->MakeCurrent();
    report.ReadGL();
  }
  return report.ToJSON(in.Timer);
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!window)
  {
    return;
  }
  Internals& in = *this->Internal;
  this->Superclass::ReleaseGraphicsResources(window);
  this->SurfaceCapture->ReleaseGraphicsResources(window);
  this->ReflectiveShadowMaps->ReleaseGraphicsResources(window);
  in.Geometry->ReleaseGraphicsResources(window);
  in.DefaultSampler->ReleaseGraphicsResources(window);
  in.DefaultEstimator->ReleaseGraphicsResources(window);
  in.Voxels->Release(window);
  in.Composite->ReleaseGraphicsResources(window);
  in.DefaultDelegate->ReleaseGraphicsResources(window);
  auto release = [window](auto* users)
  {
    if (users)
    {
      users->ReleaseGraphicsResources(window);
    }
  };
  release(in.Estimator.Get());
  release(in.Sampler.Get());
  in.Estimator = nullptr;
  in.Sampler = nullptr;
  release(this->Estimator);
  release(this->Sampler);
  release(this->DelegatePass);
  in.View.Release(window);
  in.Timer.Release();
  in.EstimateKey.clear();
  in.FailedKey.clear();
  in.HasBuffers = in.HasIrradiance = false;
  in.WhyDelegate = "its resources have been released";
}
