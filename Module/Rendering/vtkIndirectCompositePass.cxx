// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGL.h"

#include "vtkIndirectCompositePass.h"

#include "vtkGeometryBufferPass.h"
#include "vtkImageData.h"
#include "vtkIndirectEstimatorPass.h"
#include "vtkIndirectKernelProgram.h"
#include "vtkIndirectLightMap.h"
#include "vtkIndirectPaths.h"
#include "vtkIndirectTarget.h"
#include "vtkIndirectUniforms.h"
#include "vtkObjectFactory.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkTextureObject.h"

vtkStandardNewMacro(vtkIndirectCompositePass);

namespace
{
const vtkIndirectChannel ImageChannels[] = {
  { "image", "vtkiImage", "one channel of the frame", GL_RGBA32F, "world", "world units" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};

// How a channel is shown: value * scale + bias.
struct FrameChannel
{
  const char* Name;
  int Components;
  float Scale;
  float Bias;
};

// In the order of vtkIndirectChannelFS.glsl. Depth is shown over the far plane; see ShowImage.
const FrameChannel FrameChannels[] = {
  { "final", 3, 1.0f, 0.0f },
  { "direct", 3, 1.0f, 0.0f },
  { "indirect", 3, 1.0f, 0.0f },
  { "irradiance", 3, 1.0f, 0.0f },
  { "glossy", 3, 1.0f, 0.0f },
  { "albedo", 3, 1.0f, 0.0f },
  { "normal", 3, 0.5f, 0.5f },
  { "depth", 1, 1.0f, 0.0f },
  { "specular", 4, 1.0f, 0.0f },
};
const FrameChannel MapChannels[] = {
  { "depth", 1, 1.0f, 0.0f },
  { "normal", 3, 0.5f, 0.5f },
  { "density", 3, 1.0f, 0.0f },
};
}

//------------------------------------------------------------------------------
struct vtkIndirectCompositePass::Internals
{
  vtkIndirectTarget Image{ ImageChannels, false };
  // Linear colours only, or encoded ones too.
  vtkIndirectKernelProgram Composite[2] = { { "vtkIndirectCompositeFS.glsl" },
    { "vtkIndirectCompositeFS.glsl" } };
  vtkIndirectKernelProgram Channel{ "vtkIndirectChannelFS.glsl" };
  vtkIndirectKernelProgram MapChannel{ "vtkIndirectMapChannelFS.glsl" };
  vtkIndirectKernelProgram Display{ "vtkIndirectDisplayFS.glsl" };
  const FrameChannel* Shown = nullptr;
  double Farthest = 1.0; // world units

  static bool HasGlossy(const Input& input)
  {
    return input.Estimator && input.Estimator->GetGlossy() && input.Geometry.HasSpecular();
  }

  // Programs are built for where the estimator has its irradiance.
  static vtkShaderProgram* Use(
    vtkIndirectKernelProgram& kernel, const Input& input, const std::string& definitions)
  {
    kernel.SetGather(input.Estimator ? input.Estimator->GetIrradianceShader()
                                     : "vtkIndirectIrradianceTexture.glsl");
    kernel.SetDefinitions(input.Geometry.GetAlbedoDefinitions() +
      std::string(HasGlossy(input) ? "#define VTKI_GLOSSY\n" : "") + definitions);
    return kernel.Use(input.Frame.Window);
  }

  // Without an estimate the sampler reads the surface and the result is multiplied by zero.
  static void ActivateFrame(vtkShaderProgram* program, const Input& input)
  {
    const vtkIndirectTarget& geometry = input.Geometry.GetTarget();
    input.Geometry.ActivateAlbedo(program);
    geometry.Activate(vtkGeometryBufferPass::Surface, program);
    if (input.Estimator)
    {
      input.Estimator->ActivateIrradiance(program);
    }
    else
    {
      program->SetUniformi(
        "vtkiIrradiance", geometry.GetTexture(vtkGeometryBufferPass::Surface)->GetTextureUnit());
    }
    if (HasGlossy(input))
    {
      geometry.Activate(vtkGeometryBufferPass::Specular, program);
      input.Estimator->GetGlossy()->Activate(0, program);
    }
    vtkIndirectSetEyeUniforms(program, input.Frame);
    program->SetUniform2i("vtkiSize", input.Frame.Size);
    program->SetUniformf(
      "vtkiIndirectScale", input.Estimator ? static_cast<float>(input.IndirectScale) : 0.0f);
    program->SetUniformf("vtkiIrradianceUnit",
      input.Estimator ? static_cast<float>(input.Estimator->GetIrradianceUnit()) : 0.0f);
  }

  static void DeactivateFrame(const Input& input)
  {
    input.Geometry.GetTarget().Deactivate();
    if (input.Estimator)
    {
      input.Estimator->DeactivateIrradiance();
    }
    if (HasGlossy(input))
    {
      input.Estimator->GetGlossy()->Deactivate();
    }
  }
};

vtkIndirectCompositePass::vtkIndirectCompositePass()
  : Internal(new Internals)
{
}

vtkIndirectCompositePass::~vtkIndirectCompositePass() = default;

//------------------------------------------------------------------------------
void vtkIndirectCompositePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Channels: " << GetChannelNames() << "\n";
}

//------------------------------------------------------------------------------
void vtkIndirectCompositePass::Render(const vtkRenderState*)
{
  vtkErrorMacro("A composite has nothing to add by itself; use vtkIndirectIlluminationPass.");
}

//------------------------------------------------------------------------------
int vtkIndirectCompositePass::FindChannel(const std::string& name)
{
  int i = 0;
  for (const FrameChannel& channel : FrameChannels)
  {
    if (name == channel.Name)
    {
      return i;
    }
    ++i;
  }
  return -1;
}

//------------------------------------------------------------------------------
bool vtkIndirectCompositePass::ParseMapChannel(const std::string& name, int& map, int& channel)
{
  const size_t dot = name.find('.');
  if (name.compare(0, 3, "rsm") != 0 || dot == std::string::npos || dot < 4 || dot > 8)
  {
    return false;
  }
  map = 0;
  for (size_t i = 3; i < dot; ++i)
  {
    if (name[i] < '0' || name[i] > '9')
    {
      return false;
    }
    map = 10 * map + (name[i] - '0');
  }
  for (channel = 0; channel < 3; ++channel)
  {
    if (name.compare(dot + 1, std::string::npos, MapChannels[channel].Name) == 0)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::string vtkIndirectCompositePass::GetChannelNames()
{
  std::string names;
  for (const FrameChannel& channel : FrameChannels)
  {
    names += std::string(channel.Name) + ", ";
  }
  return names + "rsm<i>.depth, rsm<i>.normal, rsm<i>.density, lights";
}

//------------------------------------------------------------------------------
bool vtkIndirectCompositePass::Composite(const Input& input)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunc(state);
  const bool encoded = input.Geometry.HasEncoded();
  vtkIndirectKernelProgram& kernel = in.Composite[encoded];
  // Where nothing has been drawn before, copying depth is cheaper than testing and writing each
  // pixel's.
  const bool copied = input.DepthCleared &&
    vtkIndirectPaths::Get(vtkIndirectPaths::Depth) == vtkIndirectPaths::DepthByCopy &&
    input.Geometry.GetTarget().CopyDepth(frame.Origin);
  vtkShaderProgram* program = Internals::Use(kernel, input,
    std::string(encoded ? "#define VTKI_ENCODED\n" : "") +
      (copied ? "#define VTKI_DEPTH_COPIED\n" : ""));
  if (!program)
  {
    return false;
  }
  if (copied)
  {
    state->vtkglDisable(GL_DEPTH_TEST);
  }
  else
  {
    // The depth test keeps what an earlier layer has drawn in front.
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglDepthMask(GL_TRUE);
  }
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglViewport(frame.Origin[0], frame.Origin[1], frame.Size[0], frame.Size[1]);
  Internals::ActivateFrame(program, input);
  if (!copied)
  {
    input.Geometry.GetTarget().ActivateDepth(program, "vtkiDepth");
  }
  program->SetUniform2i("vtkiOrigin", frame.Origin);
  kernel.Draw();
  Internals::DeactivateFrame(input);
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectCompositePass::RenderChannel(const Input& input, const std::string& name)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  int map = 0;
  int mapChannel = 0;
  const int channel = FindChannel(name);
  const bool ofMap = channel < 0 && ParseMapChannel(name, map, mapChannel) && input.Maps &&
    map < input.Maps->GetNumberOfMaps();
  if (channel < 0 && !ofMap)
  {
    return false;
  }
  int size[2] = { frame.Size[0], frame.Size[1] };
  if (ofMap)
  {
    size[1] = input.Maps->GetResolution();
    size[0] = input.Maps->GetMap(map).NumberOfFaces * size[1];
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkIndirectKernelState kernelState(frame.Window);
  vtkIndirectKernelProgram& kernel = ofMap ? in.MapChannel : in.Channel;
  if (!in.Image.Resize(frame.Window, size[0], size[1]))
  {
    return false;
  }
  vtkShaderProgram* program = ofMap ? kernel.Use(frame.Window) : Internals::Use(kernel, input, "");
  if (!program)
  {
    return false;
  }
  in.Image.Begin();
  program->SetUniformf("vtkiSceneScale", static_cast<float>(frame.SceneScale));
  if (ofMap)
  {
    const vtkIndirectLightMap& lightMap = input.Maps->GetMap(map);
    input.Maps->Activate(program);
    program->SetUniformi("vtkiFirstLayer", lightMap.FirstLayer);
    program->SetUniformi("vtkiChannel", mapChannel);
    kernel.Draw();
    input.Maps->Deactivate();
    in.Shown = &MapChannels[mapChannel];
    in.Farthest = lightMap.Far / frame.SceneScale;
  }
  else
  {
    const int origin[2] = { 0, 0 };
    Internals::ActivateFrame(program, input);
    program->SetUniform2i("vtkiOrigin", origin);
    program->SetUniformi("vtkiChannel", channel);
    vtkIndirectSetUniform(
      program, "vtkiViewToWorldDirection", glm::mat3(glm::inverse(glm::dmat3(frame.WorldToView))));
    kernel.Draw();
    Internals::DeactivateFrame(input);
    in.Shown = &FrameChannels[channel];
    in.Farthest = frame.Far / frame.SceneScale;
  }
  in.Image.End();
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectCompositePass::RenderChannel(
  const Input& input, vtkIndirectEstimatorPass* estimator, const std::string& name)
{
  static const FrameChannel shown[] = { { "", 1, 1.0f, 0.0f }, { "", 3, 1.0f, 0.0f } };
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkIndirectKernelState kernelState(frame.Window);
  if (!in.Image.Resize(frame.Window, frame.Size[0], frame.Size[1]))
  {
    return false;
  }
  in.Image.Begin();
  in.Image.Clear();
  const int components = estimator->DrawChannel(name, frame, input.Geometry);
  in.Image.End();
  in.Shown = &shown[components == 3];
  in.Farthest = 8.0; // what a length of one component, such as a level, is shown over
  return components > 0;
}

//------------------------------------------------------------------------------
void vtkIndirectCompositePass::CopyImage(vtkImageData* image)
{
  vtkIndirectTarget& source = this->Internal->Image;
  const int components = this->Internal->Shown->Components;
  const std::vector<float> values = source.ReadBack(0);
  image->SetDimensions(source.GetWidth(), source.GetHeight(), 1);
  image->AllocateScalars(VTK_FLOAT, components);
  auto* out = static_cast<float*>(image->GetScalarPointer());
  for (size_t i = 0; i < values.size(); i += 4)
  {
    out = std::copy(&values[i], &values[i] + components, out);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectCompositePass::ShowImage(const Input& input)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  vtkIndirectKernelState kernelState(frame.Window);
  vtkShaderProgram* program = in.Display.Use(frame.Window);
  if (!program)
  {
    return false;
  }
  frame.Window->GetState()->vtkglViewport(
    frame.Origin[0], frame.Origin[1], frame.Size[0], frame.Size[1]);
  in.Image.Activate(0, program);
  program->SetUniform2i("vtkiOrigin", frame.Origin);
  vtkIndirectSetUniform(program, "vtkiViewSize", glm::vec2(frame.Size[0], frame.Size[1]));
  const bool isLength = in.Shown->Components == 1;
  vtkIndirectSetUniform(program, "vtkiScaleBias",
    glm::vec2(isLength ? 1.0 / in.Farthest : in.Shown->Scale, in.Shown->Bias));
  in.Display.Draw();
  in.Image.Deactivate();
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectCompositePass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!window)
  {
    return;
  }
  Internals& in = *this->Internal;
  in.Image.Release(window);
  for (vtkIndirectKernelProgram& composite : in.Composite)
  {
    composite.Release();
  }
  in.Channel.Release();
  in.MapChannel.Release();
  in.Display.Release();
}
