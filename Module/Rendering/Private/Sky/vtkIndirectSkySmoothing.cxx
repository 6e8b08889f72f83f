// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Sky/vtkIndirectSkySmoothing.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Scene/vtkIndirectFrame.h"

namespace
{
const vtkIndirectChannels ShareChannels = {
  { "sky.shares", "vtkiSkyShares", "visible shares of the sky; how far these are smoothed",
    GL_RGBA32F, "-", "1; scene units" },
};

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
  , Shares{ { this, ShareChannels, false }, { this, ShareChannels, false } }
{
  this->Rows.SetDefinitions("#define VTKI_SKY_ROWS\n");
  this->Last.SetDefinitions("#define VTKI_SKY_LAST\n");
}

//------------------------------------------------------------------------------
bool vtkIndirectSkySmoothing::Resize(
  const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry)
{
  bool done = true;
  for (vtkIndirectTarget& shares : this->Shares)
  {
    done = done && shares.Resize(frame.Window, frame.Size[0], frame.Size[1], &geometry.GetTarget());
  }
  return done;
}

//------------------------------------------------------------------------------
bool vtkIndirectSkySmoothing::Run(const Input& input, vtkIndirectTarget& irradiance,
  const std::function<void(const vtkIndirectProgram&)>& setLast)
{
  const int neighbors = input.Moving ? MovingNeighbors : StillNeighbors;
  const float angle = static_cast<float>(input.PartAngle);
  const vtkIndirectTarget* from = &this->Shares[0];
  for (int k = input.Visibility ? 0 : Steps - 1; k < Steps; ++k)
  {
    const bool last = k == Steps - 1;
    const bool between = k > 1;
    vtkIndirectTarget& to = last ? irradiance : this->Shares[1 - k % 2];
    vtkIndirectFullScreenProgram& kernel = last ? this->Last
      : k % 2 == 0                              ? this->Rows
                                                : this->Columns;
    const bool done = kernel.RunOnSurfaces(input.Frame.Window, to,
      [&](const vtkIndirectProgram& program)
      {
        input.Geometry.ActivateReceivers(program, input.Frame);
        from->Activate(0, program);
        program->SetUniformi("vtkiSkyNeighbors",
          !input.Visibility ? 0
            : between       ? NeighborsBetween
                            : neighbors);
        program->SetUniformf(
          "vtkiSkyScale", between ? 1.0f / static_cast<float>(neighbors + 1) : 1.0f);
        program->SetUniformf("vtkiSkyTurn", 1.0f / (angle * angle));
        program->SetUniformf("vtkiSkyMost", MostSmoothed * static_cast<float>(input.Frame.Size[1]));
        if (last)
        {
          setLast(program);
        }
      });
    if (!done)
    {
      return false;
    }
    from = &to;
  }
  return true;
}
