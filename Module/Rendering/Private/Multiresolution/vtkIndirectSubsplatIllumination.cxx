// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Multiresolution/vtkIndirectSubsplatIllumination.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectBackEndChoices.h"
#include "Plan/vtkIndirectPlan.h"
#include "Scene/vtkIndirectEyeUniforms.h"
#include "Senders/vtkIndirectLightBlock.h"
#include "Visibility/vtkIndirectVisibility.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace
{
const vtkIndirectChannels HalfChannels = {
  { "subsplat.irradiance", "vtkiCoarserIrradiance", "irradiance, whether there is any", GL_RGBA16F,
    "-", "VTK irradiance over the frame's unit" },
  { "subsplat.vector", "vtkiCoarserVector", "luminance of the vector irradiance", GL_RGBA16F,
    "view", "VTK irradiance over the frame's unit" },
};
const vtkIndirectChannels FloatChannels = {
  { "subsplat.irradiance", "vtkiCoarserIrradiance", "irradiance, whether there is any", GL_RGBA32F,
    "-", "VTK irradiance" },
  { "subsplat.vector", "vtkiCoarserVector", "luminance of the vector irradiance", GL_RGBA32F,
    "view", "VTK irradiance" },
};

// Split texels for one invocation, which fetches a light once for all texels below them, and
// invocations in a group of 64.
std::string GetGrouping()
{
  return vtkIndirectBackEndChoices::Get(vtkIndirectBackEndChoices::Grouping) ==
      vtkIndirectBackEndChoices::GroupingOfFour
    ? "#define VTKI_BLOCKS 4\n#define VTKI_INVOCATIONS 16\n"
    : "#define VTKI_BLOCKS 2\n#define VTKI_INVOCATIONS 32\n";
}
}

//------------------------------------------------------------------------------
bool vtkIndirectSubsplatIllumination::Resize(
  vtkOpenGLRenderWindow* window, const vtkIndirectSubsplatPyramid& pyramid, bool halfFloats)
{
  const size_t count = halfFloats == this->HalfFloats ? pyramid.GetNumberOfLevels() : 0;
  this->Levels.resize(std::min(count, this->Levels.size()));
  this->HalfFloats = halfFloats;
  while (this->Levels.size() < pyramid.GetNumberOfLevels())
  {
    this->Levels.push_back(std::make_unique<vtkIndirectTarget>(
      this, halfFloats ? HalfChannels : FloatChannels, this->Levels.empty(), 16));
  }
  for (size_t i = 0; i < this->Levels.size(); ++i)
  {
    vtkIndirectTarget& level = *this->Levels[i];
    const vtkIndirectTarget& surface = pyramid.GetSurface(i + 1);
    const vtkIndirectTarget* const shared = i > 0 ? this->Levels[0].get() : nullptr;
    if (!level.Resize(window, surface.GetWidth(), surface.GetHeight(), shared))
    {
      return false;
    }
    for (int channel = 0; channel < 2; ++channel)
    {
      level.GetTexture(channel)->SetMinificationFilter(vtkTextureObject::Linear);
      level.GetTexture(channel)->SetMagnificationFilter(vtkTextureObject::Linear);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectSubsplatIllumination::SharesLooks(const Work& work)
{
  return work.In.Plan.Interactive && work.In.Visibility.LooksUpMaps();
}

//------------------------------------------------------------------------------
bool vtkIndirectSubsplatIllumination::IsBelowFinest(const Work& work)
{
  return static_cast<int>(work.Number) < work.Set.FinestLevel;
}

//------------------------------------------------------------------------------
vtkIndirectSubsplatIllumination::OtherType vtkIndirectSubsplatIllumination::FindOther(
  const Work& work)
{
  return !IsBelowFinest(work) ? SPLITS : work.Set.TakesNearest ? NEAREST : EVALUATES;
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatIllumination::Define(const Work& work)
{
  const Settings& settings = work.Set;
  const std::string lights = work.Lights.GetDefinitions() + work.In.Visibility.GetDefinitions() +
    (settings.PointFormFactor ? "#define VTKI_POINT_FORM_FACTOR\n" : "");
  const std::string detail = settings.SurfaceDetail > 0.0 ? "#define VTKI_SURFACE_DETAIL\n" : "";
  const OtherType other = FindOther(work);
  const std::string others = other == NEAREST    ? "#define VTKI_NEAREST\n"
    : other == EVALUATES || !settings.HasCompute ? lights + "#define VTKI_EVALUATE\n"
                                                 : lights;
  const std::string images = std::string("#define VTKI_FORMAT ") +
    (this->HalfFloats ? "rgba16f\n" : "rgba32f\n") + lights + GetGrouping() +
    (SharesLooks(work) ? "#define VTKI_SHARES_LOOKS\n" : "");
  const std::string reprojected = settings.Reprojected ? "#define VTKI_REPROJECTED\n" : "";
  if (work.Number > 0)
  {
    this->SmoothTexels.SetDefinitions(reprojected + "#define VTKI_TEXELS\n");
    this->OtherTexels[other].SetDefinitions(others);
    this->TexelBlocks[SharesLooks(work)].SetDefinitions(images);
    return;
  }
  this->SmoothPixels.SetDefinitions(
    detail + reprojected + (settings.HasCompute ? "#define VTKI_BLOCKS_FOLLOW\n" : ""));
  this->OtherPixels[other].SetDefinitions(others + detail);
  this->PixelBlocks[SharesLooks(work)].SetDefinitions(images + "#define VTKI_PIXELS\n" + detail);
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatIllumination::SetUniforms(
  const vtkIndirectProgram& program, const Work& work) const
{
  const Settings& settings = work.Set;
  const int size[2] = { work.Target.GetWidth(), work.Target.GetHeight() };
  vtkIndirectSetEyeUniforms(program, work.In.Frame);
  program->SetUniform2i("vtkiLevelSize", size);
  program->SetUniformf("vtkiEdge", vtkIndirectSubsplatPyramid::EdgeOf(work.Number));
  program->SetUniformf("vtkiStorageScale", static_cast<float>(settings.StorageScale));
  program->SetUniformi("vtkiSplits", !IsBelowFinest(work));
  program->SetUniformi("vtkiCorrectNormals", settings.NormalCorrection);
  program->SetUniformf("vtkiSurfaceDetail", static_cast<float>(settings.SurfaceDetail));
  // The paper interpolates from all illuminated neighbours.
  const double any = 1.0e6;
  program->SetUniformf(
    "vtkiSamePlane", static_cast<float>(settings.DepthRange ? any : settings.PlaneThreshold));
  program->SetUniformf(
    "vtkiSameNormal", static_cast<float>(settings.DepthRange ? any : settings.NormalThreshold));
  program->SetUniformi("vtkiContinuesSlopes", settings.DepthRange ? 0 : 1);
}

//------------------------------------------------------------------------------
void vtkIndirectSubsplatIllumination::ActivateSurface(
  const vtkIndirectProgram& program, const Work& work) const
{
  const vtkIndirectTarget& pixels = work.In.Geometry.GetTarget();
  if (work.Number == 0)
  {
    pixels.Activate(vtkIndirectGeometryBuffer::Surface, program);
    return;
  }
  if (program->IsUniformUsed("vtkiSurface"))
  {
    pixels.Activate(vtkIndirectGeometryBuffer::Surface, program); // facets
  }
  work.Pyramid.GetSurface(work.Number).Activate(0, program);
}

//------------------------------------------------------------------------------
// A filtered fetch interpolates smooth neighbourhoods: the first draw writes depth one half there
// and leaves one elsewhere, so that the second draw runs only on the rest. Early depth tests branch
// where shaders cannot.
bool vtkIndirectSubsplatIllumination::Interpolate(const Work& work)
{
  vtkIndirectFullScreenProgram& smooth = work.Number == 0 ? this->SmoothPixels : this->SmoothTexels;
  vtkIndirectFullScreenProgram& others =
    (work.Number == 0 ? this->OtherPixels : this->OtherTexels)[FindOther(work)];
  vtkOpenGLRenderWindow* window = work.In.Frame.Window;
  vtkOpenGLState* state = window->GetState();
  const vtkIndirectTarget& coarserSurface = work.Pyramid.GetSurface(work.Number + 1);
  const vtkIndirectTarget& coarser = this->GetLevel(work.Number + 1);
  const int coarserSize[2] = { coarser.GetWidth(), coarser.GetHeight() };
  bool done = true;
  work.Target.Begin();
  state->vtkglEnable(GL_DEPTH_TEST);
  // Pixels that have irradiance of the last frame have the depth 0.
  const bool kept = work.Number == 0 && work.Set.Reprojected;
  if (!kept)
  {
    work.Target.ClearDepth();
  }
  for (vtkIndirectFullScreenProgram* kernel : { &smooth, &others })
  {
    vtkIndirectProgram program = kernel->Use(window);
    if (!program)
    {
      done = false;
      break;
    }
    const bool first = kernel == &smooth;
    state->vtkglDepthFunc(first && !kept ? GL_ALWAYS : GL_LESS);
    state->vtkglDepthMask(first ? GL_TRUE : GL_FALSE);
    this->SetUniforms(program, work);
    this->ActivateSurface(program, work);
    if (work.Number > 0 && program->IsUniformUsed("vtkiFinerDeviation"))
    {
      work.Pyramid.ActivateDeviation(work.Number, program);
    }
    coarserSurface.Activate(0, program, "vtkiCoarserSurface");
    coarser.Activate(0, program);
    coarser.Activate(1, program);
    program->SetUniform2i("vtkiCoarserSize", coarserSize);
    program->SetUniformf("vtkiCoarserEdge", vtkIndirectSubsplatPyramid::EdgeOf(work.Number + 1));
    if (!first && FindOther(work) != NEAREST)
    {
      work.Lights.Activate(program);
      work.In.Visibility.Activate(work.In.Frame.Window, program, work.In.Creases);
    }
    kernel->Draw();
  }
  state->vtkglDisable(GL_DEPTH_TEST);
  work.Target.End();
  return done;
}

//------------------------------------------------------------------------------
bool vtkIndirectSubsplatIllumination::EvaluateBlocks(const Work& work)
{
  vtkIndirectComputeProgram& kernel =
    (work.Number == 0 ? this->PixelBlocks : this->TexelBlocks)[SharesLooks(work)];
  vtkIndirectProgram program = kernel.Use(work.In.Frame.Window);
  if (!program)
  {
    return false;
  }
  this->SetUniforms(program, work);
  work.Lights.Activate(program);
  work.In.Visibility.Activate(work.In.Frame.Window, program, work.In.Creases);
  this->ActivateSurface(program, work);
  kernel.AddImages(work.Target);
  program->SetUniformi("vtkiIrradianceImage", 0);
  if (work.Number > 0)
  {
    program->SetUniformi("vtkiVectorImage", 1);
  }
  const vtkIndirectSubsplatList& lists = work.Pyramid.GetLists();
  lists.Activate(program, work.Number);
  kernel.Run(lists.GetBuffer(), work.Number);
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectSubsplatIllumination::Fill(const Work& work)
{
  this->Define(work);
  if (!this->Interpolate(work))
  {
    return false;
  }
  return !work.Set.HasCompute || IsBelowFinest(work) || this->EvaluateBlocks(work);
}

//------------------------------------------------------------------------------
bool vtkIndirectSubsplatIllumination::FillLevels(const Input& input, const Settings& settings,
  vtkIndirectSubsplatPyramid& pyramid, vtkIndirectLightBlock& lights)
{
  // The last level has no leaves.
  this->Levels.back()->Begin();
  this->Levels.back()->Clear();
  this->Levels.back()->End();
  bool done = true;
  for (size_t number = this->Levels.size() - 1; done && number > 0; --number)
  {
    done = this->Fill({ input, settings, pyramid, lights, *this->Levels[number - 1], number });
  }
  return done;
}

//------------------------------------------------------------------------------
bool vtkIndirectSubsplatIllumination::FillPixels(const Input& input, const Settings& settings,
  vtkIndirectSubsplatPyramid& pyramid, vtkIndirectLightBlock& lights, vtkIndirectTarget& pixels)
{
  return this->Fill({ input, settings, pyramid, lights, pixels, 0 });
}
