// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"
#include "Scene/vtkIndirectEyeUniforms.h"

#include "Capture/vtkIndirectGeometryBuffer.h"

#include "Capture/vtkIndirectColorOnlyProp.h"
#include "Capture/vtkIndirectShadowMaps.h"
#include "Capture/vtkSurfaceCapturePass.h"
#include "OpenGL/vtkIndirectFullScreenProgram.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Plan/vtkIndirectPlan.h"
#include "Scene/vtkIndirectFrame.h"
#include "Scene/vtkIndirectPropKind.h"
#include "Scene/vtkIndirectRendererAccess.h"
#include "Scene/vtkIndirectSwitches.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"

#include <algorithm>
#include <iterator>
#include <unordered_set>

namespace
{
const vtkIndirectChannels Channels = {
  { "geometry.lit", "vtkiLit", "VTK's shading with shadows, premultiplied alpha", GL_RGBA32F,
    "view", "VTK radiance" },
  { "geometry.surface", "vtkiSurface", "linear depth, octahedral normal and kind, facet's normal",
    GL_RGBA32F, "view", "scene units, 1" },
  // Only if not everything is opaque, or a material is specular.
  { "geometry.albedo", "vtkiAlbedo", "albedo", GL_R32F, "-", "1" },
  // Only if a material of the scene is specular.
  { "geometry.specular", "vtkiSpecular", "specular reflectance, power of the lobe or -roughness",
    GL_RGBA16F, "-", "1" },
};

// Stand-ins for props that draw only colour, and one after all props.
using StandIns = std::vector<vtkSmartPointer<vtkIndirectColorOnlyProp>>;

StandIns ReplaceColorOnly(
  const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture, std::vector<vtkProp*>& props)
{
  StandIns standIns;
  auto replace = [&](vtkProp* prop)
  {
    standIns.push_back(vtkSmartPointer<vtkIndirectColorOnlyProp>::New());
    standIns.back()->Set(prop, capture, frame.ReplacedLights);
    return standIns.back().Get();
  };
  const std::unordered_set<vtkProp*> colorOnly(frame.ColorOnly.begin(), frame.ColorOnly.end());
  for (vtkProp*& prop : props)
  {
    prop = colorOnly.count(prop) ? replace(prop) : prop;
  }
  props.push_back(replace(nullptr));
  return standIns;
}
}

//------------------------------------------------------------------------------
vtkIndirectGeometryBuffer::vtkIndirectGeometryBuffer(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Target(new vtkIndirectTarget(this, Channels, true))
  , ClearKernel(new vtkIndirectFullScreenProgram(this, "vtkIndirectClearFS.glsl"))
{
  this->Target->SetNumberOfChannels(this->NumberOfChannels);
}

vtkIndirectGeometryBuffer::~vtkIndirectGeometryBuffer() = default;

//------------------------------------------------------------------------------
bool vtkIndirectGeometryBuffer::Update(const vtkRenderState* s, const vtkIndirectFrame& frame,
  const vtkIndirectPlan& plan, vtkSurfaceCapturePass* capture, const vtkIndirectShadowMaps* shadows)
{
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);

  this->NumberOfChannels = plan.SurfacesAreSpecular ? Specular + 1
    : plan.AlbedoInAlpha                            ? Albedo
                                                    : Albedo + 1;
  this->Target->SetNumberOfChannels(this->NumberOfChannels);
  this->Target->MatchDepth();
  if (!this->Target->Resize(frame.Window, frame.Size[0], frame.Size[1]))
  {
    return false;
  }
  this->Target->Begin();
  // Without blending, pixels that are drawn need not be cleared before.
  const bool clearAfter = this->HasAlbedoInLit() && this->DepthTellsBackground(frame);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  this->Target->ClearDepth();
  if (!clearAfter && !this->Clear(frame.Window, false))
  {
    this->Target->End();
    return false;
  }
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  // VTK also blends opaque props: textures and point sprites have soft edges. Only colour is
  // blended: the other channels' alphas hold bits and powers.
  state->vtkglEnable(GL_BLEND);
  DisableBlending(state, this->NumberOfChannels);

  vtkRenderState s2(s->GetRenderer());
  std::vector<vtkProp*> props(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount());
  // Flat props are drawn after the composite: labels read the depth at their places.
  props.erase(std::remove_if(props.begin(), props.end(), vtkIndirectPropKind::IsFlat), props.end());
  // A scene of opaque surfaces has no color-only props.
  const StandIns standIns =
    this->HasAlbedoInLit() ? StandIns() : ReplaceColorOnly(frame, capture, props);
  s2.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  s2.SetFrameBuffer(this->Target->GetFramebuffer());
  s2.SetRequiredKeys(s->GetRequiredKeys());
  capture->BeginEye(frame, shadows, this->Target->GetFramebuffer(), this->NumberOfChannels);
  // The background stays out of this buffer, whatever passes draw into it.
  vtkTypeBool& clearing = vtkIndirectRendererAccess::Clearing(s->GetRenderer());
  const vtkTypeBool erase = clearing;
  clearing = 0;
  capture->Render(&s2);
  clearing = erase;
  capture->EndStage();
  this->Encoded = capture->HasEncoded();
  this->NumberOfRenderedProps = capture->GetNumberOfRenderedProps();
  // Restores the blending of all draw buffers to that of VTK's state.
  state->vtkglEnable(GL_BLEND);
  for (int i = Surface; i < this->NumberOfChannels; ++i)
  {
    glEnablei(GL_BLEND, static_cast<unsigned int>(i));
  }
  const bool complete = !clearAfter || this->Clear(frame.Window, true);
  this->Target->End();
  return complete;
}

//------------------------------------------------------------------------------
bool vtkIndirectGeometryBuffer::DrawDepthOfSamples(
  const vtkRenderState* s, const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture)
{
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  // Only if needed, because it draws opaque props once more.
  if (samples < 2 || !vtkIndirectSwitches::LooksDepthUp(s))
  {
    return false;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglDepthFunc depthFunc(state);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  std::vector<vtkProp*> props;
  std::copy_if(frame.Captured.begin(), frame.Captured.end(), std::back_inserter(props),
    [](vtkProp* prop) { return !vtkIndirectPropKind::CatchesLight(prop); });
  props.insert(props.end(), frame.ColorOnly.begin(), frame.ColorOnly.end());
  vtkRenderState s2(s->GetRenderer());
  s2.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  capture->BeginDepth();
  capture->Render(&s2);
  capture->EndStage();
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectGeometryBuffer::DrawMore(
  const vtkIndirectFrame& frame, const std::function<bool()>& draw)
{
  vtkOpenGLState* state = frame.Window->GetState();
  vtkIndirectFullScreenState kernelState(frame.Window);
  this->Target->Begin();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_TRUE);
  const bool drawn = draw();
  this->Target->End();
  return drawn;
}

//------------------------------------------------------------------------------
bool vtkIndirectGeometryBuffer::DepthTellsBackground(const vtkIndirectFrame& frame) const
{
  // Least share of the far plane's distance whose depths equal the background's: half a step of the
  // depth buffer, over the slope of depth there.
  constexpr double mostLost = 1e-3;
  const double slope = frame.Parallel ? 1.0 : frame.Near / frame.Far;
  return 0.5 * this->Target->GetDepthStep() < mostLost * slope;
}

//------------------------------------------------------------------------------
bool vtkIndirectGeometryBuffer::Clear(vtkOpenGLRenderWindow* window, bool background)
{
  vtkOpenGLState* state = window->GetState();
  vtkIndirectFullScreenState kernelState(window);
  if (!this->ClearKernel->Use(window))
  {
    return false;
  }
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (background)
  {
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglDepthMask(GL_FALSE);
    // VTK's state does not track the depth range and assumes the default.
    glDepthRange(1.0, 1.0);
  }
  this->ClearKernel->Draw();
  if (background)
  {
    glDepthRange(0.0, 1.0);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectGeometryBuffer::ActivateAlbedo(const vtkIndirectProgram& program) const
{
  this->Target->Activate(Lit, program);
  if (!this->HasAlbedoInLit())
  {
    this->Target->Activate(Albedo, program);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectGeometryBuffer::ActivateReceivers(
  const vtkIndirectProgram& program, const vtkIndirectFrame& frame) const
{
  vtkIndirectSetEyeUniforms(program, frame);
  this->Target->Activate(Surface, program);
}
