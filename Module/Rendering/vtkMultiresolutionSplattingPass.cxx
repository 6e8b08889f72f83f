// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGL.h"

#include "vtkMultiresolutionSplattingPass.h"

#include "vtkGeometryBufferPass.h"
#include "vtkIndirectComputeProgram.h"
#include "vtkIndirectKernelProgram.h"
#include "vtkIndirectLightBlock.h"
#include "vtkIndirectStageTimer.h"
#include "vtkIndirectSubsplatList.h"
#include "vtkIndirectTarget.h"
#include "vtkIndirectUniforms.h"
#include "vtkObjectFactory.h"
#include "vtkTextureObject.h"
#include "vtkVirtualLightSampler.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkMultiresolutionSplattingPass);

namespace
{
const vtkIndirectChannel SurfaceChannels[] = {
  { "subsplat.surface", "vtkiLevelSurface", "octahedral normal, depth, state", GL_RGBA32F, "view",
    "scene units" },
  { "subsplat.deviation", "vtkiFinerDeviation",
    "distance from the mean plane over the width, spread of the normals", GL_RG16F, "-", "-" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
const vtkIndirectChannel HalfIllumination[] = {
  { "subsplat.irradiance", "vtkiCoarserIrradiance", "irradiance, how it was come by", GL_RGBA16F,
    "-", "VTK irradiance over the frame's unit" },
  { "subsplat.vector", "vtkiCoarserVector", "luminance of the vector irradiance", GL_RGBA16F,
    "view", "VTK irradiance over the frame's unit" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
const vtkIndirectChannel FloatIllumination[] = {
  { "subsplat.irradiance", "vtkiCoarserIrradiance", "irradiance, how it was come by", GL_RGBA32F,
    "-", "VTK irradiance" },
  { "subsplat.vector", "vtkiCoarserVector", "luminance of the vector irradiance", GL_RGBA32F,
    "view", "VTK irradiance" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};

const vtkIndirectChannel ProbeChannels[] = {
  { "subsplat.probe", "vtkiProbe", "luminance of the irradiance at a pixel of each texel",
    GL_RGBA32F, "-", "VTK irradiance over the frame's unit" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
const vtkIndirectChannel VariationChannels[] = {
  { "subsplat.variation", "vtkiVariation", "relative error of interpolation between probes",
    GL_RGBA32F, "-", "-" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};

// A level of the pyramid, without pixels themselves.
struct Level
{
  vtkIndirectTarget Surface{ SurfaceChannels, false };
  std::unique_ptr<vtkIndirectTarget> Illumination;
};

// Pixels along the edge of a texel of a level.
float EdgeOf(size_t number)
{
  return static_cast<float>(1u << number);
}
}

//------------------------------------------------------------------------------
struct vtkMultiresolutionSplattingPass::Internals
{
  // Levels[i] is level i + 1. The last has no leaves: all of it is split.
  std::vector<std::unique_ptr<Level>> Levels;
  bool IsHalf = true;
  bool InBlocks = false; // whether leaves are evaluated four at a time
  vtkIndirectLightBlock Lights;
  vtkIndirectTarget Probe{ ProbeChannels, false };
  vtkIndirectTarget Variation{ VariationChannels, false };
  vtkIndirectKernelProgram ProbeLights{ "vtkIndirectSubsplatProbeFS.glsl" };
  vtkIndirectKernelProgram Vary{ "vtkIndirectSubsplatVariationFS.glsl" };
  vtkIndirectKernelProgram First{ "vtkIndirectSubsplatFirstFS.glsl" };
  vtkIndirectKernelProgram Next{ "vtkIndirectSubsplatNextFS.glsl" };
  vtkIndirectKernelProgram Amid{ "vtkIndirectSubsplatSmoothFS.glsl" };
  vtkIndirectKernelProgram Between{ "vtkIndirectSubsplatLevelFS.glsl" };
  vtkIndirectSubsplatList Lists; // list i: what is split on level i + 1
  vtkIndirectComputeProgram TexelBlock{ "vtkIndirectSubsplatBlockCS.glsl" };
  vtkIndirectComputeProgram PixelBlock{ "vtkIndirectSubsplatBlockCS.glsl" };
  vtkIndirectKernelProgram Smooth{ "vtkIndirectSubsplatSmoothFS.glsl" };
  vtkIndirectKernelProgram Pixel{ "vtkIndirectSubsplatPixelFS.glsl" };

  bool Resize(
    vtkOpenGLRenderWindow* window, const vtkIndirectTarget& pixels, int coarsest, bool half);
  void DefineKernels(vtkOpenGLRenderWindow* window, const vtkMultiresolutionSplattingPass* self);
  bool ProbeLighting(const Input& input, const vtkMultiresolutionSplattingPass* self, double scale);
  bool BuildPyramid(const Input& input, const vtkMultiresolutionSplattingPass* self);
  bool DrawInTwo(const Input& input, const vtkMultiresolutionSplattingPass* self, size_t number,
    double scale, vtkIndirectKernelProgram& amid, vtkIndirectKernelProgram& edge);
  bool Illuminate(const Input& input, const vtkMultiresolutionSplattingPass* self,
    vtkIndirectTarget& target, size_t number, double scale);
  bool EvaluateBlocks(const Input& input, const vtkMultiresolutionSplattingPass* self,
    vtkIndirectTarget& target, size_t number, double scale);
  void ActivateCoarser(
    vtkShaderProgram* program, size_t number, const vtkMultiresolutionSplattingPass* self) const;
  void DeactivateCoarser(size_t number) const;
  void ReleaseLevels(vtkWindow* window, size_t keep);
};

namespace
{
// Irradiance that a half float's one stands for: what the strongest light gives a surface that
// faces it in the middle of the scene, so that 1e-7 to 65504 times that can be stored.
double MakeUnit(const vtkIndirectFrame& frame)
{
  double unit = 0.0;
  for (const vtkIndirectLight& light : frame.Lights)
  {
    const double color = std::max({ light.Color.x, light.Color.y, light.Color.z });
    double attenuation = 1.0;
    if (light.Positional)
    {
      const double d =
        std::max(glm::length(light.PositionWC - frame.SceneCenter), 0.1 / frame.SceneScale);
      const double denominator =
        light.Attenuation.x + d * (light.Attenuation.y + d * light.Attenuation.z);
      attenuation = denominator > 0.0 ? 1.0 / denominator : 1.0;
    }
    unit = std::max(unit, color * attenuation);
  }
  // A power of two: storing loses nothing but the bits that half floats lack.
  return unit > 0.0 && std::isfinite(unit) ? std::exp2(std::ceil(std::log2(unit))) : 1.0;
}
}

//------------------------------------------------------------------------------
vtkMultiresolutionSplattingPass::vtkMultiresolutionSplattingPass()
  : Internal(new Internals)
{
}

vtkMultiresolutionSplattingPass::~vtkMultiresolutionSplattingPass() = default;

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CoarsestResolution: " << this->CoarsestResolution << "\n";
  os << indent << "FinestLevel: "
     << (this->FinestLevel == FULL_RESOLUTION ? "FullResolution" : "HalfResolution") << "\n";
  os << indent << "PlaneThreshold: " << this->PlaneThreshold << "\n";
  os << indent << "NormalThreshold: " << this->NormalThreshold << "\n";
  os << indent << "LightingThreshold: " << this->LightingThreshold << "\n";
  os << indent << "Balance: " << (this->Balance ? "On" : "Off") << "\n";
  os << indent << "NormalCorrection: " << (this->NormalCorrection ? "On" : "Off") << "\n";
  os << indent << "SurfaceDetail: " << this->SurfaceDetail << "\n";
  os << indent << "Storage: " << (this->Storage == HALF_FLOAT ? "HalfFloat" : "Float") << "\n";
}

//------------------------------------------------------------------------------
size_t vtkMultiresolutionSplattingPass::GetBytes() const
{
  size_t bytes = this->Superclass::GetBytes() + this->Internal->Lights.GetBytes() +
    this->Internal->Lists.GetBytes();
  for (const auto& level : this->Internal->Levels)
  {
    bytes += level->Surface.GetBytes() + level->Illumination->GetBytes();
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::Internals::ReleaseLevels(vtkWindow* window, size_t keep)
{
  while (this->Levels.size() > keep)
  {
    this->Levels.back()->Surface.Release(window);
    this->Levels.back()->Illumination->Release(window);
    this->Levels.pop_back();
  }
}

//------------------------------------------------------------------------------
bool vtkMultiresolutionSplattingPass::Internals::Resize(
  vtkOpenGLRenderWindow* window, const vtkIndirectTarget& pixels, int coarsest, bool half)
{
  if (half != this->IsHalf)
  {
    this->ReleaseLevels(window, 0);
    this->IsHalf = half;
  }
  int width = pixels.GetWidth();
  int height = pixels.GetHeight();
  size_t count = 0;
  do
  {
    width = (width + 1) / 2;
    height = (height + 1) / 2;
    if (count == this->Levels.size())
    {
      this->Levels.emplace_back(new Level);
      this->Levels.back()->Illumination.reset(
        new vtkIndirectTarget(half ? HalfIllumination : FloatIllumination, false));
      this->Levels.back()->Illumination->ShareDepth(pixels);
    }
    Level& level = *this->Levels[count++];
    if (!level.Surface.Resize(window, width, height) ||
      !level.Illumination->Resize(window, width, height))
    {
      return false;
    }
  } while (2 * std::max(width, height) > coarsest || count < 2);
  this->ReleaseLevels(window, count);
  for (const auto& level : this->Levels)
  {
    for (int channel = 0; channel < 2; ++channel)
    {
      vtkTextureObject* texture = level->Illumination->GetTexture(channel);
      texture->SetMinificationFilter(vtkTextureObject::Linear);
      texture->SetMagnificationFilter(vtkTextureObject::Linear);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMultiresolutionSplattingPass::Internals::ProbeLighting(
  const Input& input, const vtkMultiresolutionSplattingPass* self, double scale)
{
  const vtkIndirectFrame& frame = input.Frame;
  if (self->LightingThreshold <= 0.0)
  {
    this->Probe.Release(frame.Window);
    this->Variation.Release(frame.Window);
    return true;
  }
  const vtkIndirectTarget& coarsest = this->Levels.back()->Surface;
  const int size[2] = { coarsest.GetWidth(), coarsest.GetHeight() };
  for (const bool probe : { true, false })
  {
    vtkIndirectKernelProgram& kernel = probe ? this->ProbeLights : this->Vary;
    vtkIndirectTarget& target = probe ? this->Probe : this->Variation;
    vtkShaderProgram* program =
      target.Resize(frame.Window, size[0], size[1]) ? kernel.Use(frame.Window) : nullptr;
    if (!program)
    {
      return false;
    }
    target.Begin();
    vtkIndirectSetEyeUniforms(program, frame);
    program->SetUniform2i("vtkiSize", frame.Size);
    program->SetUniform2i("vtkiLevelSize", size);
    program->SetUniformf("vtkiEdge", EdgeOf(this->Levels.size()));
    program->SetUniformf("vtkiStorageScale", static_cast<float>(scale));
    program->SetUniformf("vtkiSamePlane", static_cast<float>(self->PlaneThreshold));
    program->SetUniformf("vtkiSameNormal", static_cast<float>(self->NormalThreshold));
    input.Geometry.GetTarget().Activate(vtkGeometryBufferPass::Surface, program);
    if (probe)
    {
      this->Lights.Activate(program, *input.Sampler);
    }
    else
    {
      this->Probe.Activate(0, program);
    }
    kernel.Draw();
    this->Probe.Deactivate();
    input.Sampler->GetTarget().Deactivate();
    input.Geometry.GetTarget().Deactivate();
    target.End();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMultiresolutionSplattingPass::Internals::BuildPyramid(
  const Input& input, const vtkMultiresolutionSplattingPass* self)
{
  const vtkIndirectFrame& frame = input.Frame;
  if (this->InBlocks)
  {
    std::vector<size_t> texels;
    for (const auto& level : this->Levels)
    {
      texels.push_back(static_cast<size_t>(level->Surface.GetWidth()) * level->Surface.GetHeight());
    }
    this->Lists.Begin(texels);
  }
  for (size_t i = 0; i < this->Levels.size(); ++i)
  {
    vtkIndirectKernelProgram& kernel = i == 0 ? this->First : this->Next;
    vtkShaderProgram* program = kernel.Use(frame.Window);
    if (!program)
    {
      return false;
    }
    Level& level = *this->Levels[i];
    level.Surface.Begin();
    vtkIndirectSetEyeUniforms(program, frame);
    program->SetUniform2i("vtkiSize", frame.Size);
    program->SetUniformf("vtkiEdge", EdgeOf(i + 1));
    program->SetUniformi("vtkiSplits", i > 0 || self->FinestLevel == FULL_RESOLUTION);
    if (this->InBlocks)
    {
      this->Lists.Activate(program, i);
    }
    program->SetUniformf("vtkiPlaneThreshold",
      i + 1 < this->Levels.size() ? static_cast<float>(self->PlaneThreshold) : 0.0f);
    program->SetUniformf("vtkiNormalThreshold", static_cast<float>(self->NormalThreshold));
    const bool varies = self->LightingThreshold > 0.0;
    const double widths = std::exp2(static_cast<double>(this->Levels.size() - (i + 1)));
    program->SetUniformf("vtkiVariationThreshold",
      varies ? static_cast<float>(self->LightingThreshold * widths * widths) : -1.0f);
    if (varies)
    {
      this->Variation.Activate(0, program);
    }
    else
    {
      vtkTextureObject* unread = input.Geometry.GetTarget().GetTexture(0);
      unread->Activate(); // a sampler needs a unit, read or not
      program->SetUniformi("vtkiVariation", unread->GetTextureUnit());
    }
    if (i == 0)
    {
      input.Geometry.GetTarget().Activate(vtkGeometryBufferPass::Surface, program);
      kernel.Draw();
      input.Geometry.GetTarget().Deactivate();
    }
    else
    {
      vtkIndirectTarget& finer = this->Levels[i - 1]->Surface;
      const int finerSize[2] = { finer.GetWidth(), finer.GetHeight() };
      finer.Activate(0, program, "vtkiFinerSurface");
      finer.Activate(1, program, "vtkiFinerDeviation");
      program->SetUniform2i("vtkiFinerSize", finerSize);
      kernel.Draw();
      finer.Deactivate();
    }
    this->Variation.Deactivate();
    input.Geometry.GetTarget().Deactivate();
    level.Surface.End();
  }
  if (this->InBlocks)
  {
    this->Lists.Deactivate();
#ifdef GL_SHADER_STORAGE_BARRIER_BIT
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
#endif
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::Internals::DefineKernels(
  vtkOpenGLRenderWindow* window, const vtkMultiresolutionSplattingPass* self)
{
  const std::string lights = this->Lights.GetDefinitions(window);
  const std::string detail = self->SurfaceDetail > 0.0 ? "#define VTKI_SURFACE_DETAIL\n" : "";
  this->InBlocks = vtkIndirectComputeProgram::IsSupported();
  const std::string evaluate = lights + "#define VTKI_EVALUATE\n";
  const std::string list = this->InBlocks
    ? "#extension GL_ARB_shader_storage_buffer_object : require\n#define VTKI_LIST_SPLIT\n"
    : "";
  this->First.SetDefinitions(list);
  this->Next.SetDefinitions(list + (self->Balance ? "#define VTKI_BALANCE\n" : ""));
  this->ProbeLights.SetDefinitions(lights);
  this->Between.SetDefinitions(this->InBlocks ? lights : evaluate);
  this->Amid.SetDefinitions("#define VTKI_TEXELS\n");
  this->Smooth.SetDefinitions(detail);
  // At half resolution pixels without a sample of their own are evaluated one by one.
  this->Pixel.SetDefinitions(
    (this->InBlocks && self->FinestLevel == FULL_RESOLUTION ? lights : evaluate) + detail);
  const std::string images =
    std::string("#define VTKI_FORMAT ") + (this->IsHalf ? "rgba16f\n" : "rgba32f\n") + lights;
  this->TexelBlock.SetDefinitions(images);
  this->PixelBlock.SetDefinitions(images + "#define VTKI_PIXELS\n" + detail);
}

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::Internals::ActivateCoarser(
  vtkShaderProgram* program, size_t number, const vtkMultiresolutionSplattingPass* self) const
{
  const Level& coarser = *this->Levels[number - 1];
  const int size[2] = { coarser.Surface.GetWidth(), coarser.Surface.GetHeight() };
  coarser.Surface.Activate(0, program, "vtkiCoarserSurface");
  coarser.Illumination->Activate(0, program);
  coarser.Illumination->Activate(1, program);
  program->SetUniform2i("vtkiCoarserSize", size);
  program->SetUniformf("vtkiCoarserEdge", EdgeOf(number));
}

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::Internals::DeactivateCoarser(size_t number) const
{
  this->Levels[number - 1]->Surface.Deactivate();
  this->Levels[number - 1]->Illumination->Deactivate();
}

//------------------------------------------------------------------------------
// Where a level's neighbourhood is smooth a filter fetch does; the first draw writes depth one half
// there and leaves one elsewhere, so that the second runs on the rest only.
// Early depth tests branch where shaders cannot.
bool vtkMultiresolutionSplattingPass::Internals::DrawInTwo(const Input& input,
  const vtkMultiresolutionSplattingPass* self, size_t number, double scale,
  vtkIndirectKernelProgram& amid, vtkIndirectKernelProgram& edge)
{
  const vtkIndirectFrame& frame = input.Frame;
  vtkOpenGLState* state = frame.Window->GetState();
  const vtkIndirectTarget& geometry = input.Geometry.GetTarget();
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglClearDepth(1.0);
  state->vtkglClear(GL_DEPTH_BUFFER_BIT);
  for (vtkIndirectKernelProgram* kernel : { &amid, &edge })
  {
    vtkShaderProgram* program = kernel->Use(frame.Window);
    if (!program)
    {
      return false;
    }
    const bool first = kernel == &amid;
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(first ? GL_ALWAYS : GL_LESS);
    state->vtkglDepthMask(first ? GL_TRUE : GL_FALSE);
    vtkIndirectSetEyeUniforms(program, frame);
    program->SetUniform2i("vtkiSize", frame.Size);
    program->SetUniformf("vtkiStorageScale", static_cast<float>(scale));
    program->SetUniformf("vtkiSamePlane", static_cast<float>(self->PlaneThreshold));
    program->SetUniformf("vtkiSameNormal", static_cast<float>(self->NormalThreshold));
    if (number == 0)
    {
      program->SetUniformi("vtkiSplits", self->FinestLevel == FULL_RESOLUTION);
      program->SetUniformi("vtkiCorrectNormals", self->NormalCorrection);
      program->SetUniformf("vtkiSurfaceDetail", static_cast<float>(self->SurfaceDetail));
      geometry.Activate(vtkGeometryBufferPass::Surface, program);
    }
    else
    {
      const vtkIndirectTarget& surface = this->Levels[number - 1]->Surface;
      const int size[2] = { surface.GetWidth(), surface.GetHeight() };
      program->SetUniform2i("vtkiLevelSize", size);
      program->SetUniformf("vtkiEdge", EdgeOf(number));
      surface.Activate(0, program);
    }
    if (!first)
    {
      this->Lights.Activate(program, *input.Sampler);
    }
    this->ActivateCoarser(program, number + 1, self);
    kernel->Draw();
    this->DeactivateCoarser(number + 1);
    geometry.Deactivate();
    if (number > 0)
    {
      this->Levels[number - 1]->Surface.Deactivate();
    }
    input.Sampler->GetTarget().Deactivate();
  }
  state->vtkglDisable(GL_DEPTH_TEST);
  return true;
}

//------------------------------------------------------------------------------
// Illumination of a level, 0 for pixels.
bool vtkMultiresolutionSplattingPass::Internals::Illuminate(const Input& input,
  const vtkMultiresolutionSplattingPass* self, vtkIndirectTarget& target, size_t number,
  double scale)
{
  target.Begin();
  const bool done = this->DrawInTwo(input, self, number, scale,
    number == 0 ? this->Smooth : this->Amid, number == 0 ? this->Pixel : this->Between);
  target.End();
  const bool inBlocks = this->InBlocks && (number > 0 || self->FinestLevel == FULL_RESOLUTION);
  return done && (!inBlocks || this->EvaluateBlocks(input, self, target, number, scale));
}

//------------------------------------------------------------------------------
// Evaluates what is split one level above `number`, 0 for pixels, into target's images.
bool vtkMultiresolutionSplattingPass::Internals::EvaluateBlocks(const Input& input,
  const vtkMultiresolutionSplattingPass* self, vtkIndirectTarget& target, size_t number,
  double scale)
{
#ifdef GL_COMPUTE_SHADER
  const vtkIndirectFrame& frame = input.Frame;
  const bool pixels = number == 0;
  vtkShaderProgram* program = (pixels ? this->PixelBlock : this->TexelBlock).Use(frame.Window);
  if (!program)
  {
    return false;
  }
  const int size[2] = { target.GetWidth(), target.GetHeight() };
  vtkIndirectSetEyeUniforms(program, frame);
  program->SetUniform2i("vtkiSize", frame.Size);
  program->SetUniform2i("vtkiLevelSize", size);
  program->SetUniformf("vtkiEdge", EdgeOf(number));
  program->SetUniformf("vtkiStorageScale", static_cast<float>(scale));
  program->SetUniformf("vtkiSurfaceDetail", static_cast<float>(self->SurfaceDetail));
  this->Lights.Activate(program, *input.Sampler);
  const vtkIndirectTarget& surface =
    pixels ? input.Geometry.GetTarget() : this->Levels[number - 1]->Surface;
  surface.Activate(pixels ? vtkGeometryBufferPass::Surface : 0, program);
  static const char* const images[] = { "vtkiIrradianceImage", "vtkiVectorImage" };
  const GLenum format = this->IsHalf ? GL_RGBA16F : GL_RGBA32F;
  for (int i = 0; i < (pixels ? 1 : 2); ++i)
  {
    glBindImageTexture(i, target.GetTexture(i)->GetHandle(), 0, GL_FALSE, 0, GL_READ_WRITE, format);
    program->SetUniformi(images[i], i);
  }
  this->Lists.Activate(program, number);
  this->Lists.Dispatch(number);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
  this->Lists.Deactivate();
  for (int i = 0; i < (pixels ? 1 : 2); ++i)
  {
    glBindImageTexture(i, 0, 0, GL_FALSE, 0, GL_READ_WRITE, format);
  }
  surface.Deactivate();
  input.Sampler->GetTarget().Deactivate();
  return true;
#else
  (void)input, (void)self, (void)target, (void)number, (void)scale;
  return false;
#endif
}

//------------------------------------------------------------------------------
bool vtkMultiresolutionSplattingPass::Estimate(const Input& input, vtkIndirectStageTimer& timer)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  vtkOpenGLRenderWindow* window = frame.Window;
  const bool half = this->Storage == HALF_FLOAT;
  const double unit = half ? MakeUnit(frame) : 1.0;
  this->SetIrradianceStorage(window, half, unit, true);
  if (!this->Irradiance->Resize(window, frame.Size[0], frame.Size[1]) ||
    !in.Resize(window, *this->Irradiance, this->CoarsestResolution, half))
  {
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglDepthFunc depthFunc(state);
  vtkIndirectKernelState kernelState(window);

  timer.Begin(vtkIndirectStageTimer::Estimate);
  in.Lights.Update(window, *input.Sampler);
  in.DefineKernels(window, this);
  bool done = in.ProbeLighting(input, this, 1.0 / unit) && in.BuildPyramid(input, this);
  Level& last = *in.Levels.back();
  last.Illumination->Begin();
  last.Illumination->Clear();
  last.Illumination->End();
  for (size_t number = in.Levels.size() - 1; done && number > 0; --number)
  {
    done = in.Illuminate(input, this, *in.Levels[number - 1]->Illumination, number, 1.0 / unit);
  }
  timer.End(vtkIndirectStageTimer::Estimate);
  timer.Begin(vtkIndirectStageTimer::Upsample);
  done = done && in.Illuminate(input, this, *this->Irradiance, 0, 1.0 / unit);
  timer.End(vtkIndirectStageTimer::Upsample);
  return done;
}

//------------------------------------------------------------------------------
void vtkMultiresolutionSplattingPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  Internals& in = *this->Internal;
  in.ReleaseLevels(window, 0);
  in.Lights.Release();
  in.First.Release();
  in.Next.Release();
  in.Probe.Release(window);
  in.Variation.Release(window);
  in.ProbeLights.Release();
  in.Vary.Release();
  in.Amid.Release();
  in.Between.Release();
  in.TexelBlock.Release(window);
  in.PixelBlock.Release(window);
  in.Lists.Release();
  in.Smooth.Release();
  in.Pixel.Release();
}
