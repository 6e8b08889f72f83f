// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Gather/vtkIndirectLobeGather.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Plan/vtkIndirectPlan.h"
#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectSampler.h"
#include "Senders/vtkIndirectVirtualLights.h"
#include "Visibility/vtkIndirectVisibility.h"

namespace
{
const vtkIndirectChannels CoarseChannels = {
  { "lobes.coarse", "vtkiCoarse", "irradiance of lobes at every few pixels, variation", GL_RGBA32F,
    "-", "VTK irradiance" },
};

// Rows of 256 lights in one draw: long draws stall a desktop, and some drivers abort them.
constexpr int LobeRowsPerDraw = 16;

// Light below this share of the frame's brightest irradiance is interpolated in any case.
constexpr double Least = 1e-3;
}

//------------------------------------------------------------------------------
vtkIndirectLobeGather::vtkIndirectLobeGather(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Coarse(this, CoarseChannels)
{
}

//------------------------------------------------------------------------------
bool vtkIndirectLobeGather::Add(
  const vtkIndirectEstimateInput& input, const Output& output, int step, double tolerance)
{
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  if (!input.Lights || !input.Lights->HasLobes())
  {
    this->Coarse.Release(window);
    return true;
  }
  vtkOpenGLState* state = window->GetState();
  const vtkIndirectVisibility& visibility = input.Visibility;
  const int rows = input.Lights->GetNumberOfRows();
  const int rowsPerDraw = FindRowsPerDraw(input);
  // The pixels that cannot be interpolated are summed in one draw.
  const bool interpolate =
    step > 1 && rows * vtkIndirectSampler::RowLength <= visibility.GetMaximumNumberOfSenders();
  if (!interpolate)
  {
    this->Coarse.Release(window);
    if (!this->Draw(
          input, this->AtPixels, "", output.Irradiance, output.Unit, 1, tolerance, rowsPerDraw))
    {
      return false;
    }
  }
  else
  {
    if (!this->Coarse.Resize(input.Frame, step))
    {
      return false;
    }
    this->Coarse.Begin();
    this->Coarse.Clear();
    this->Coarse.End();
    if (!this->Draw(input, this->AtSamples, "#define VTKI_COARSE\n", this->Coarse, 1.0, step,
          tolerance, rowsPerDraw))
    {
      return false;
    }
    if (output.HasOwn)
    {
      state->vtkglEnable(GL_DEPTH_TEST);
      state->vtkglDepthFunc(GL_LEQUAL);
      state->vtkglDepthMask(GL_FALSE);
    }
    const bool drawn = this->Draw(input, this->AtPixels, "#define VTKI_INTERPOLATED\n",
      output.Irradiance, output.Unit, step, tolerance, rows);
    state->vtkglDisable(GL_DEPTH_TEST);
    if (!drawn)
    {
      return false;
    }
  }
  return !output.Glossy ||
    this->Draw(input, this->InGlossy, "#define VTKI_GLOSSY\n", *output.Glossy, output.Unit, 1,
      tolerance, rowsPerDraw);
}

//------------------------------------------------------------------------------
int vtkIndirectLobeGather::FindRowsPerDraw(const vtkIndirectEstimateInput& input)
{
  return input.Visibility.WalksSegments()
    ? input.Visibility.GetMaximumNumberOfSegments() / vtkIndirectSampler::RowLength
    : LobeRowsPerDraw;
}

//------------------------------------------------------------------------------
bool vtkIndirectLobeGather::AddToGlossy(
  const vtkIndirectEstimateInput& input, vtkIndirectTarget& glossy)
{
  this->Coarse.Release(input.Frame.Window);
  return !input.Lights || !input.Lights->HasLobes() ||
    this->Draw(
      input, this->InGlossy, "#define VTKI_GLOSSY\n", glossy, 1.0, 1, 0.0, FindRowsPerDraw(input));
}

//------------------------------------------------------------------------------
bool vtkIndirectLobeGather::Draw(const vtkIndirectEstimateInput& input,
  vtkIndirectFullScreenProgram& kernel, const std::string& definitions, vtkIndirectTarget& target,
  double unit, int step, double tolerance, int rowsPerDraw)
{
  const vtkIndirectFrame& frame = input.Frame;
  const vtkIndirectVirtualLights& lights = *input.Lights;
  vtkIndirectProgram program = kernel.Use(
    frame.Window, definitions + input.Visibility.GetDefinitions() + lights.GetDefinitions());
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  const bool interpolates = &target != &this->Coarse && step > 1;
  input.Geometry.ActivateReceivers(program, frame);
  program->SetUniformf("vtkiStorageScale", static_cast<float>(1.0 / unit));
  this->Coarse.SetUniforms(program);
  if (&kernel == &this->InGlossy)
  {
    input.Geometry.GetTarget().Activate(vtkIndirectGeometryBuffer::Specular, program);
  }
  input.Visibility.Activate(frame.Window, program, input.Creases);
  lights.Activate(program);
  lights.ActivateLobes(program);
  if (interpolates)
  {
    this->Coarse.ActivateAll(program);
    program->SetUniformf("vtkiTolerance", static_cast<float>(tolerance));
    program->SetUniformf("vtkiLeast", static_cast<float>(Least * input.Plan.IrradianceUnit));
  }
  target.Begin();
  state->vtkglEnable(GL_BLEND);
  // The alpha of an image is one; that of samples is a sum.
  const GLenum alpha = &target == &this->Coarse ? GL_ONE : GL_ZERO;
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, alpha, GL_ONE);
  kernel.DrawRows(program, lights.GetNumberOfRows(), rowsPerDraw);
  state->vtkglDisable(GL_BLEND);
  target.End();
  return true;
}
