// SPDX-License-Identifier: BSD-3-Clause
// The irradiance that comes directly from area lights: in closed form if nothing hid them (images:
// texels of a pyramid, as fine as the tolerance asks for), times the share of the light that is
// seen. That share is a ratio of two sums over points of the light, each with a depth map of its
// own: where nothing is hidden it is one, and there is no noise. Still frames do so at every pixel
// (vtkIndirectAreaRounds), moving ones at samples (vtkIndirectAreaSamples).
#ifndef vtkIndirectAreaGather_h
#define vtkIndirectAreaGather_h

#include "Frame/vtkIndirectFrameLight.h"         // for the base class
#include "Gather/vtkIndirectAreaLamps.h"         // for a member
#include "Gather/vtkIndirectAreaLobes.h"         // for a member
#include "Gather/vtkIndirectAreaMaps.h"          // for a member
#include "Gather/vtkIndirectAreaRounds.h"        // for a member
#include "Gather/vtkIndirectAreaSamples.h"       // for a member
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectTarget.h"            // for members

class vtkShaderProgram;

class vtkIndirectAreaGather : public vtkIndirectFrameLight
{
public:
  vtkIndirectAreaGather();

  const char* GetName() const override { return "light of area lights"; }
  void AppendTo(vtkIndirectKey& key, const Input& input) const override;
  int CountMapsNeeded(const Input& input) const override;
  bool Update(const Input& input, int mostMaps) override;
  size_t GetNumberOfTilesDrawn() const override
  {
    return this->Maps.GetAtlas().GetNumberOfTilesDrawn() + this->Rounds.GetNumberOfTilesDrawn();
  }
  bool IsComplete() const override { return !this->Visible || this->Maps.IsComplete(); }
  int GetNumberOfTilesLeft() const override;
  /** A still result is refined by further rounds of points of each light. */
  vtkIndirectEstimate Sum(const Input& input) override;
  void AddToReport(vtkIndirectReport& report, const vtkIndirectPlan& plan) const override;
  void Release(vtkWindow* window) override;

  size_t GetBytes() const;

private:
  using Lamp = vtkIndirectAreaLamps::Lamp;

  bool IsFinished() const;
  bool SumAll(const Input& input);
  double GetTolerance(const Input& input) const;
  bool SumIrradiance(const Input& input);
  bool SumLobes(const Input& input);
  bool SumRounds(const Input& input);
  bool SumOpen(const Input& input, vtkIndirectTarget& target);
  void SetLamp(const Input& input, vtkShaderProgram* program, const Lamp& lamp);

  vtkIndirectAreaLamps Lamps;
  vtkIndirectAreaMaps Maps; // of the first round
  bool Visible = false;     // something can hide them
  bool Moving = false;
  int TilesLeft = 0;                                               // to draw in this frame
  vtkIndirectFullScreenProgram Kernel{ "vtkIndirectAreaFS.glsl" }; // of one radiance
  vtkIndirectAreaSamples Samples;                                  // of moving frames
  vtkIndirectAreaSamples StillSamples;                             // of images, in others
  vtkIndirectAreaRounds Rounds;
  vtkIndirectAreaLobes Lobes;
  bool Specular = false; // some receiver is
  vtkIndirectTarget Irradiance;
};

#endif
