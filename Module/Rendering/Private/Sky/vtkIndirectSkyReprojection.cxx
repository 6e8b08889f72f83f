// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Sky/vtkIndirectSkyReprojection.h"

#include "Scene/vtkIndirectFrame.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

const vtkIndirectChannels vtkIndirectSkyReprojection::ShareChannels = {
  { "sky.shares", "vtkiSkyShares", "visible shares of the sky; how far these are smoothed",
    GL_RGBA32F, "-", "1; scene units" },
};

namespace
{
const vtkIndirectChannels FreshChannels = {
  { "sky.fresh", "vtkiSkyFresh", "1 at blocks of pixels that sum directions", GL_R8, "-", "-" },
};
}

//------------------------------------------------------------------------------
vtkIndirectSkyReprojection::vtkIndirectSkyReprojection(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Reprojection(this, 32, true)
  , Fresh(this, FreshChannels, false)
  , Spread(this, FreshChannels, false)
{
  this->SpreadFresh.SetDefinitions("#define VTKI_SKY_SPREAD\n");
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyReprojection::Resize(const vtkIndirectFrame& frame)
{
  if (!this->Now)
  {
    this->Now = std::make_unique<vtkIndirectTarget>(this, ShareChannels, true);
  }
  return this->Now->Resize(frame.Window, frame.Size[0], frame.Size[1]);
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyReprojection::Begin(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  this->Reprojected = this->Now && this->Reprojection.Has(frame, 1.0);
  this->Reprojection.Exchange(this->Now);
  if (!this->Resize(frame))
  {
    return false;
  }
  if (this->Reprojected)
  {
    return this->Reprojection.Draw(frame, input.Geometry, *this->Now) &&
      this->FindFreshBlocks(input);
  }
  this->Reprojection.ForgetKey();
  this->Now->Begin();
  this->Now->Clear();
  this->Now->End();
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyReprojection::FindFreshBlocks(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  const int blocks[2] = { (frame.Size[0] + input.Step - 1) / input.Step,
    (frame.Size[1] + input.Step - 1) / input.Step };
  if (!this->Fresh.Resize(frame.Window, blocks[0], blocks[1]) ||
    !this->Spread.Resize(frame.Window, blocks[0], blocks[1]))
  {
    return false;
  }
  const bool found = this->FindFresh.Run(frame.Window, this->Fresh,
    [&](const vtkIndirectProgram& program)
    {
      this->Now->Activate(0, program);
      program->SetUniformi("vtkiEdge", input.Step);
      program->SetUniform2i("vtkiSize", frame.Size);
    });
  return found &&
    this->SpreadFresh.Run(frame.Window, this->Spread,
      [&](const vtkIndirectProgram& program)
      {
        this->Fresh.Activate(0, program);
        program->SetUniform2i("vtkiSize", blocks);
      });
}

//------------------------------------------------------------------------------
std::string vtkIndirectSkyReprojection::GetDefinition() const
{
  return this->Reprojected ? "#define VTKI_SKY_FRESH\n" : "";
}

//------------------------------------------------------------------------------
void vtkIndirectSkyReprojection::Activate(const vtkIndirectProgram& program) const
{
  if (this->Reprojected)
  {
    this->Spread.Activate(0, program);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyReprojection::DrawFresh(vtkOpenGLRenderWindow* window,
  vtkIndirectFullScreenProgram& kernel, vtkIndirectTarget& target,
  const std::function<void(const vtkIndirectProgram&)>& set)
{
  const vtkIndirectProgram program = kernel.Use(window);
  if (program)
  {
    // Pixels with a share of the last frame have the depth 0.
    vtkOpenGLState* state = window->GetState();
    target.Begin();
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglDepthFunc(GL_LESS);
    set(program);
    kernel.Draw();
    state->vtkglDisable(GL_DEPTH_TEST);
    target.End();
  }
  return program != nullptr;
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyReprojection::Keep(const Input& input)
{
  return this->Reprojection.Keep(input.Frame, input.Geometry, 1.0);
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyReprojection::KeepStill(const Input& input, const vtkIndirectTarget& shares)
{
  this->Reprojected = false;
  this->Reprojection.Drop();
  return this->Resize(input.Frame) && this->Now->CopyFrom(shares, 0) && this->Keep(input);
}

//------------------------------------------------------------------------------
void vtkIndirectSkyReprojection::ReleaseOwn(vtkWindow*)
{
  this->Now.reset();
  this->Reprojected = false;
}
