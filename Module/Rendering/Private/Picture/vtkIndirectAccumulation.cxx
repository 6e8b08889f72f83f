// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Picture/vtkIndirectAccumulation.h"

#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

namespace
{
const vtkIndirectChannels SumChannels = {
  { "accumulated", "vtkiAccumulated", "light of batches of virtual lights", GL_RGBA32F, "-",
    "VTK irradiance" },
};
}

//------------------------------------------------------------------------------
vtkIndirectAccumulation::vtkIndirectAccumulation(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
{
}

//------------------------------------------------------------------------------
bool vtkIndirectAccumulation::Resize(const vtkIndirectFrame& frame, size_t count, Images& images)
{
  images.resize(count);
  bool resized = true;
  for (std::unique_ptr<vtkIndirectTarget>& image : images)
  {
    if (!image)
    {
      image = std::make_unique<vtkIndirectTarget>(this, SumChannels, false);
    }
    resized = resized && image->Resize(frame.Window, frame.Size[0], frame.Size[1]);
  }
  return resized;
}

//------------------------------------------------------------------------------
// Draws light times a scale, in place of what is there, or in addition to it.
bool vtkIndirectAccumulation::Draw(const vtkIndirectFrame& frame, const vtkIndirectTarget& from,
  int channel, double scale, bool adds, vtkIndirectTarget& to)
{
  vtkIndirectFullScreenState kernelState(frame.Window);
  vtkOpenGLState* state = frame.Window->GetState();
  const bool drawn = this->Copy.Run(frame.Window, to,
    [&](const vtkIndirectProgram& program)
    {
      from.Activate(channel, program, "vtkiLight");
      program->SetUniformf("vtkiScale", static_cast<float>(scale));
      // Alpha has meanings of its own in some images.
      state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
      if (adds)
      {
        state->vtkglEnable(GL_BLEND);
        state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE);
      }
    });
  state->vtkglDisable(GL_BLEND);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  return drawn;
}

//------------------------------------------------------------------------------
bool vtkIndirectAccumulation::Keep(const vtkIndirectFrame& frame, const Contributions& picture)
{
  bool kept = this->Resize(frame, picture.size(), this->Kept);
  for (size_t i = 0; kept && i < picture.size(); ++i)
  {
    const vtkIndirectContribution& light = picture[i];
    kept = this->Draw(frame, *light.Target, light.Channel, light.Unit, false, *this->Kept[i]);
  }
  return kept;
}

//------------------------------------------------------------------------------
bool vtkIndirectAccumulation::Add(
  const vtkIndirectFrame& frame, size_t number, const vtkIndirectContribution& light, bool first)
{
  return number < this->Kept.size() && this->Resize(frame, this->Kept.size(), this->Sums) &&
    this->Draw(frame, *light.Target, light.Channel, light.Unit, !first, *this->Sums[number]);
}

//------------------------------------------------------------------------------
void vtkIndirectAccumulation::Finish()
{
  this->Before.swap(this->Kept);
  this->Kept.swap(this->Sums);
}

//------------------------------------------------------------------------------
bool vtkIndirectAccumulation::Repeat(const vtkIndirectFrame& frame)
{
  bool repeated = this->Resize(frame, this->Kept.size(), this->Sums);
  for (size_t i = 0; repeated && i < this->Kept.size(); ++i)
  {
    repeated = this->Draw(frame, *this->Kept[i], 0, 1.0, false, *this->Sums[i]);
  }
  return repeated;
}

//------------------------------------------------------------------------------
bool vtkIndirectAccumulation::Correct(
  const vtkIndirectFrame& frame, const std::vector<float>& light)
{
  if (this->Kept.empty() || !this->Resize(frame, 1, this->Added))
  {
    return false;
  }
  this->Added.front()->Write(0, light);
  return this->Draw(frame, *this->Added.front(), 0, 1.0, true, *this->Kept.front());
}

//------------------------------------------------------------------------------
bool vtkIndirectAccumulation::Show(
  const vtkIndirectFrame& frame, const Contributions& picture, double share)
{
  const bool mixes = share < 1.0;
  bool shown = picture.size() == this->Kept.size();
  for (size_t i = 0; shown && i < picture.size(); ++i)
  {
    const vtkIndirectContribution& light = picture[i];
    shown =
      (!mixes ||
        this->Draw(frame, *this->Before[i], 0, (1.0 - share) / light.Unit, false, *light.Target)) &&
      this->Draw(frame, *this->Kept[i], 0, share / light.Unit, mixes, *light.Target);
  }
  return shown;
}
