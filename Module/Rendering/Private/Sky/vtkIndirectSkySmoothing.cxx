// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Sky/vtkIndirectSkySmoothing.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Scene/vtkIndirectFrame.h"
#include "Sky/vtkIndirectSkyReprojection.h"
#include "vtkShaderProgram.h"

namespace
{
// Largest radius of the smoothing over the picture's height.
constexpr float MostSmoothed = 1.0f / 8.0f;
// Neighbours to either side, along rows and along columns, and those that fill the gaps between.
constexpr int StillNeighbors = 4;
constexpr int MovingNeighbors = 2;
constexpr int NeighborsBetween = 2;
constexpr int Steps = 4;
}

//------------------------------------------------------------------------------
vtkIndirectSkySmoothing::vtkIndirectSkySmoothing(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Shares{ { this, vtkIndirectSkyReprojection::ShareChannels, false },
    { this, vtkIndirectSkyReprojection::ShareChannels, false } }
{
  this->OwnKernels.Rows.SetDefinitions("#define VTKI_SKY_ROWS\n");
  this->KeptKernels.Rows.SetDefinitions("#define VTKI_SKY_ROWS\n#define VTKI_SKY_KEPT\n");
  this->KeptKernels.Columns.SetDefinitions("#define VTKI_SKY_KEPT\n");
  this->Last.SetDefinitions("#define VTKI_SKY_LAST\n");
}

//------------------------------------------------------------------------------
bool vtkIndirectSkySmoothing::Resize(const vtkIndirectFrame& frame, const vtkIndirectTarget& depth)
{
  bool done = true;
  for (vtkIndirectTarget& shares : this->Shares)
  {
    done = done && shares.Resize(frame.Window, frame.Size[0], frame.Size[1], &depth);
  }
  return done;
}

//------------------------------------------------------------------------------
bool vtkIndirectSkySmoothing::Draw(const Input& input, const Pass& pass,
  vtkIndirectFullScreenProgram& kernel, const vtkIndirectTarget& from, vtkIndirectTarget& to)
{
  const auto set = [&](const vtkIndirectProgram& program)
  {
    const float angle = static_cast<float>(input.PartAngle);
    input.Geometry.ActivateReceivers(program, input.Frame);
    from.Activate(0, program);
    if (input.Kept)
    {
      input.Kept->GetShares().Activate(0, program, "vtkiSkyKept");
    }
    program->SetUniformi("vtkiSkyNeighbors", pass.Neighbors);
    program->SetUniformf("vtkiSkyScale", pass.Scale);
    program->SetUniformf("vtkiSkyTurn", 1.0f / (angle * angle));
    program->SetUniformf("vtkiSkyMost", MostSmoothed * static_cast<float>(input.Frame.Size[1]));
    if (pass.SetLast)
    {
      pass.SetLast(program);
    }
  };
  return input.Kept && !pass.SetLast ? input.Kept->DrawFresh(input.Frame.Window, kernel, to, set)
                                     : kernel.RunOnSurfaces(input.Frame.Window, to, set);
}

//------------------------------------------------------------------------------
bool vtkIndirectSkySmoothing::Run(
  const Input& input, vtkIndirectTarget& irradiance, const SetUniforms& setLast)
{
  const int neighbors = input.Moving ? MovingNeighbors : StillNeighbors;
  const Pass passes[2] = { { neighbors, 1.0f },
    { NeighborsBetween, 1.0f / static_cast<float>(neighbors + 1) } };
  Kernels& kernels = input.Kept ? this->KeptKernels : this->OwnKernels;
  vtkIndirectTarget* from = input.Kept ? &input.Kept->GetShares() : &this->Shares[0];
  bool done = true;
  for (int k = 0; done && input.Visibility && k < Steps; ++k)
  {
    Pass pass = passes[k / 2];
    if (k == Steps - 1 && !input.Kept && !input.LeavesMeans)
    {
      pass.SetLast = setLast;
      return this->Draw(input, pass, this->Last, *from, irradiance);
    }
    vtkIndirectTarget& to = this->Shares[1 - k % 2];
    done = this->Draw(input, pass, k % 2 == 0 ? kernels.Rows : kernels.Columns, *from, to);
    from = &to;
  }
  if (input.Kept)
  {
    vtkIndirectTarget& kept = input.Kept->GetShares();
    done = done && this->Draw(input, { 0, 1.0f }, this->OwnKernels.Columns, *from, kept);
    from = &kept;
  }
  return done && this->Draw(input, { 0, 1.0f, setLast }, this->Last, *from, irradiance);
}
