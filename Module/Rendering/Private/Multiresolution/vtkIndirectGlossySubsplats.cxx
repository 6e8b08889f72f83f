// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Multiresolution/vtkIndirectGlossySubsplats.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Scene/vtkIndirectEyeUniforms.h"
#include "Senders/vtkIndirectLightBlock.h"
#include "Visibility/vtkIndirectVisibility.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace
{
const vtkIndirectChannels LobeChannels = {
  { "glossy.lobe", "vtkiLevelLobe", "power of the specular lobe, state", GL_RG16F, "-", "-" },
};
const vtkIndirectChannels GlossyHalfChannels = {
  { "glossy.level", "vtkiCoarserGlossy", "indirect light in the specular lobe", GL_RGBA16F, "-",
    "VTK irradiance over the frame's unit" },
};
const vtkIndirectChannels GlossyFloatChannels = {
  { "glossy.level", "vtkiCoarserGlossy", "indirect light in the specular lobe", GL_RGBA32F, "-",
    "VTK irradiance" },
};

// OpenGL 4.3 guarantees 2^24 bytes for a storage block; drivers give 2^27 and more.
size_t GetMaximumBytes()
{
  GLint64 bytes = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
  return static_cast<size_t>(std::min<GLint64>(std::max<GLint64>(bytes, 0), GLint64(1) << 28));
}

// Returns the texels of each list: split ones, and whole ones.
std::vector<size_t> GetCapacities(const vtkIndirectSubsplatPyramid& pyramid)
{
  std::vector<size_t> capacities;
  for (size_t number = 1; number <= pyramid.GetNumberOfLevels(); ++number)
  {
    const vtkIndirectTarget& level = pyramid.GetSurface(number);
    const size_t texels = static_cast<size_t>(level.GetWidth()) * level.GetHeight();
    // The last level is always split.
    capacities.insert(
      capacities.end(), { texels, number < pyramid.GetNumberOfLevels() ? texels : 0 });
  }
  return capacities;
}

constexpr size_t SplitList(size_t number)
{
  return 2 * number - 2;
}
constexpr size_t WholeList(size_t number)
{
  return 2 * number - 1;
}
}

//------------------------------------------------------------------------------
struct vtkIndirectGlossySubsplats::Work
{
  const Input& In;
  const Settings& Set;
  const vtkIndirectSubsplatPyramid& Pyramid;
  vtkIndirectLightBlock& Lights;
  const vtkIndirectTarget& Irradiance;
};

//------------------------------------------------------------------------------
bool vtkIndirectGlossySubsplats::Fits(const vtkIndirectSubsplatPyramid& pyramid, int numberOfLights)
{
  size_t entries = 0;
  for (size_t capacity : GetCapacities(pyramid))
  {
    entries += capacity;
  }
  return vtkIndirectGlossyLists::CountBytes(entries, numberOfLights) <= GetMaximumBytes();
}

//------------------------------------------------------------------------------
bool vtkIndirectGlossySubsplats::Resize(
  vtkOpenGLRenderWindow* window, const vtkIndirectSubsplatPyramid& pyramid, bool halfFloats)
{
  const size_t count = halfFloats == this->HalfFloats ? pyramid.GetNumberOfLevels() : 0;
  this->Levels.resize(std::min(count, this->Levels.size()));
  this->Lobes.resize(this->Levels.size());
  this->HalfFloats = halfFloats;
  while (this->Levels.size() < pyramid.GetNumberOfLevels())
  {
    this->Levels.push_back(std::make_unique<vtkIndirectTarget>(
      this, halfFloats ? GlossyHalfChannels : GlossyFloatChannels, false));
    this->Lobes.push_back(std::make_unique<vtkIndirectTarget>(this, LobeChannels, false));
  }
  for (size_t i = 0; i < this->Levels.size(); ++i)
  {
    const vtkIndirectTarget& surface = pyramid.GetSurface(i + 1);
    if (!this->Levels[i]->Resize(window, surface.GetWidth(), surface.GetHeight()) ||
      !this->Lobes[i]->Resize(window, surface.GetWidth(), surface.GetHeight()))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectGlossySubsplats::FillLobes(const Work& work)
{
  const vtkIndirectFrame& frame = work.In.Frame;
  const vtkIndirectTarget& geometry = work.In.Geometry.GetTarget();
  this->LobeOfPixels.SetDefinitions("#define VTKI_PIXELS\n");
  for (size_t number = 1; number <= this->Lobes.size(); ++number)
  {
    const bool pixels = number == 1;
    vtkIndirectFullScreenProgram& kernel = pixels ? this->LobeOfPixels : this->Lobe;
    vtkIndirectTarget& target = *this->Lobes[number - 1];
    const vtkIndirectTarget& finer = pixels ? geometry : *this->Lobes[number - 2];
    const int size[2] = { finer.GetWidth(), finer.GetHeight() };
    const bool drawn = kernel.Run(frame.Window, target,
      [&](const vtkIndirectProgram& program)
      {
        program->SetUniform2i("vtkiFinerSize", size);
        work.Pyramid.GetSurface(number).Activate(0, program);
        if (pixels)
        {
          geometry.Activate(vtkIndirectGeometryBuffer::Surface, program);
          geometry.Activate(vtkIndirectGeometryBuffer::Specular, program);
        }
        else
        {
          finer.Activate(0, program, "vtkiFinerLobe");
        }
      });
    if (!drawn)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectGlossySubsplats::ListFirst(const Work& work)
{
  vtkIndirectProgram program = this->First.Use(work.In.Frame.Window);
  if (!program)
  {
    return false;
  }
  const size_t last = this->Lobes.size();
  const int lights = work.Lights.GetNumberOfLights();
  this->Lists.Begin(work.In.Frame.Window, GetCapacities(work.Pyramid), lights);
  const vtkIndirectTarget& lobe = *this->Lobes.back();
  lobe.Activate(0, program);
  this->Lists.Activate(program);
  program->SetUniformi("vtkiLightCount", lights);
  program->SetUniformi("vtkiSplitList", static_cast<int>(SplitList(last)));
  program->SetUniformi("vtkiSplitFirst", this->Lists.GetFirst(SplitList(last)));
  this->First.Run(lobe.GetWidth(), lobe.GetHeight(), 8);
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectGlossySubsplats::SetLevelUniforms(
  const vtkIndirectProgram& program, const Work& work, size_t number) const
{
  const Settings& settings = work.Set;
  const vtkIndirectTarget& coarser = *this->Levels[number];
  const int coarserSize[2] = { coarser.GetWidth(), coarser.GetHeight() };
  int size[2] = { work.In.Frame.Size[0], work.In.Frame.Size[1] };
  if (number > 0)
  {
    size[0] = this->Levels[number - 1]->GetWidth();
    size[1] = this->Levels[number - 1]->GetHeight();
  }
  vtkIndirectSetEyeUniforms(program, work.In.Frame);
  program->SetUniform2i("vtkiLevelSize", size);
  program->SetUniform2i("vtkiCoarserSize", coarserSize);
  program->SetUniformf("vtkiEdge", vtkIndirectSubsplatPyramid::EdgeOf(number));
  program->SetUniformf("vtkiCoarserEdge", vtkIndirectSubsplatPyramid::EdgeOf(number + 1));
  program->SetUniformf("vtkiStorageScale", static_cast<float>(settings.StorageScale));
  // Also with the paper's test of depths, because lobes show surfaces beside the plane.
  program->SetUniformf(
    "vtkiSamePlane", static_cast<float>(std::max(settings.PlaneThreshold, 0.01)));
  program->SetUniformf(
    "vtkiSameNormal", static_cast<float>(std::max(settings.NormalThreshold, 0.01)));
}

//------------------------------------------------------------------------------
void vtkIndirectGlossySubsplats::ActivateLevel(
  const vtkIndirectProgram& program, const Work& work, size_t number) const
{
  const vtkIndirectTarget& geometry = work.In.Geometry.GetTarget();
  work.Pyramid.GetSurface(number + 1).Activate(0, program, "vtkiCoarserSurface");
  this->Lobes[number]->Activate(0, program, "vtkiCoarserLobe");
  if (number == 0)
  {
    geometry.Activate(vtkIndirectGeometryBuffer::Surface, program);
    geometry.Activate(vtkIndirectGeometryBuffer::Specular, program);
  }
  else
  {
    work.Pyramid.GetSurface(number).Activate(0, program);
    this->Lobes[number - 1]->Activate(0, program);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectGlossySubsplats::Interpolate(
  const Work& work, size_t number, vtkIndirectTarget& target)
{
  this->UpsamplePixels.SetDefinitions("#define VTKI_PIXELS\n");
  vtkIndirectFullScreenProgram& kernel = number == 0 ? this->UpsamplePixels : this->Upsample;
  return kernel.Run(work.In.Frame.Window, target,
    [&](const vtkIndirectProgram& program)
    {
      this->SetLevelUniforms(program, work, number);
      this->ActivateLevel(program, work, number);
      this->Levels[number]->Activate(0, program);
    });
}

//------------------------------------------------------------------------------
bool vtkIndirectGlossySubsplats::Evaluate(
  const Work& work, size_t number, vtkIndirectTarget& target, bool whole)
{
  vtkOpenGLRenderWindow* window = work.In.Frame.Window;
  const bool pixels = number == 0;
  const int count = work.Lights.GetNumberOfLights();
  std::string definitions = std::string("#define VTKI_FORMAT ") +
    (this->HalfFloats ? "rgba16f\n" : "rgba32f\n") + work.Lights.GetDefinitions() +
    work.In.Visibility.GetDefinitions();
  definitions += pixels ? "#define VTKI_PIXELS\n" : "";
  definitions += whole ? "" : "#define VTKI_UNDER_SPLIT\n";
  definitions += work.Set.DepthRange ? "#define VTKI_DEPTH_RANGE\n" : "";
  vtkIndirectComputeProgram& kernel = this->Sums[2 * pixels + whole];
  kernel.SetDefinitions(definitions);
  vtkIndirectProgram program = kernel.Use(window);
  if (!program)
  {
    return false;
  }
  const size_t list = whole ? WholeList(number + 1) : SplitList(number + 1);
  this->SetLevelUniforms(program, work, number);
  this->ActivateLevel(program, work, number);
  work.Lights.Activate(program);
  work.In.Visibility.Activate(window, program, work.In.Creases);
  this->Lists.Activate(program);
  program->SetUniformi("vtkiList", static_cast<int>(list));
  program->SetUniformi("vtkiListFirst", this->Lists.GetFirst(list));
  if (!pixels)
  {
    program->SetUniformi("vtkiSplitList", static_cast<int>(SplitList(number)));
    program->SetUniformi("vtkiSplitFirst", this->Lists.GetFirst(SplitList(number)));
    program->SetUniformi("vtkiWholeList", static_cast<int>(WholeList(number)));
    program->SetUniformi("vtkiWholeFirst", this->Lists.GetFirst(WholeList(number)));
    program->SetUniformf(
      "vtkiGlossyThreshold", static_cast<float>(work.Set.GlossyThreshold / std::max(count, 1)));
    program->SetUniformf("vtkiPlaneThreshold", static_cast<float>(work.Set.PlaneThreshold));
    program->SetUniformf("vtkiNormalThreshold", static_cast<float>(work.Set.NormalThreshold));
    for (int channel = 1; channel < (work.Set.DepthRange ? 3 : 2); ++channel)
    {
      work.Pyramid.GetSurface(number).Activate(channel, program);
    }
    work.Irradiance.Activate(0, program, "vtkiIrradiance");
  }
  kernel.AddImages(target);
  program->SetUniformi("vtkiGlossyImage", 0);
  kernel.Run(this->Lists.GetBuffer(), list);
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectGlossySubsplats::Fill(const Input& input, const Settings& settings,
  const vtkIndirectSubsplatPyramid& pyramid, vtkIndirectLightBlock& lights,
  const vtkIndirectTarget& irradiance, vtkIndirectTarget& glossy)
{
  const Work work = { input, settings, pyramid, lights, irradiance };
  this->FinestLevel = static_cast<size_t>(settings.FinestLevel);
  bool done = this->FillLobes(work) && this->ListFirst(work);
  this->Levels.back()->Begin();
  this->Levels.back()->Clear();
  this->Levels.back()->End();
  for (size_t number = this->Levels.size(); done && number-- > 0;)
  {
    vtkIndirectTarget& target = number == 0 ? glossy : *this->Levels[number - 1];
    done = this->Interpolate(work, number, target) && this->Evaluate(work, number, target, false);
    // The last level has no whole texel. Texels of the finest level and of finer ones keep what
    // they have interpolated.
    const bool stays = number + 1 == this->Levels.size() || number < this->FinestLevel;
    done = done && (stays || this->Evaluate(work, number, target, true));
  }
  return done;
}

//------------------------------------------------------------------------------
double vtkIndirectGlossySubsplats::CountEvaluations() const
{
  double evaluations = 0.0;
  for (size_t number = 1; number <= this->Levels.size(); ++number)
  {
    // A pair counts for four children, and under whole texels also for the nine samples around.
    evaluations += 4.0 * static_cast<double>(this->Lists.Count(SplitList(number)).Pairs);
    evaluations += number > this->FinestLevel
      ? 13.0 * static_cast<double>(this->Lists.Count(WholeList(number)).Pairs)
      : 0.0;
  }
  return evaluations;
}

//------------------------------------------------------------------------------
void vtkIndirectGlossySubsplats::ReleaseOwn(vtkWindow*)
{
  this->Levels.clear();
  this->Lobes.clear();
}
