// SPDX-License-Identifier: BSD-3-Clause
// The irradiance that comes directly from area lights: in closed form if nothing hid them (images:
// texels of a pyramid, as fine as the tolerance asks for), times the share of the light that is
// seen. That share is a ratio of two sums over points of the light, each with a depth map of its
// own: where nothing is hidden it is one, and there is no noise. Still frames do so at every pixel
// (vtkIndirectAreaRounds), moving ones at samples (vtkIndirectAreaSamples).
#ifndef vtkIndirectAreaGather_h
#define vtkIndirectAreaGather_h

#include "Gather/vtkIndirectAreaLamps.h"         // for a member
#include "Gather/vtkIndirectAreaLobes.h"         // for a member
#include "Gather/vtkIndirectAreaMaps.h"          // for a member
#include "Gather/vtkIndirectAreaRounds.h"        // for a member
#include "Gather/vtkIndirectAreaSamples.h"       // for a member
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectTarget.h"            // for members
#include "vtkSmartPointer.h"                     // for lights

#include <vector> // for lists

class vtkAreaLight;
class vtkIndirectGeometryBuffer;
class vtkSurfaceCapturePass;
class vtkWindow;
struct vtkIndirectFrame;
struct vtkIndirectPlan;
struct vtkIndirectReport;

class vtkIndirectAreaGather
{
public:
  vtkIndirectAreaGather();

  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectPlan& Plan;
    const vtkIndirectGeometryBuffer& Geometry;
    vtkSurfaceCapturePass* Capture;
    const std::vector<vtkSmartPointer<vtkAreaLight>>& Lights;
  };

  /**
   * Brings lights and depth maps up to date, at most so many of these. Returns false, after an
   * error, when OpenGL refuses.
   */
  bool Update(const Input& input, int most);
  /** Whether all maps are there and up to date. */
  bool IsComplete() const;
  /** Grows when lights or maps have changed. */
  size_t GetContentTime() const { return this->ContentTime + this->Maps.GetContentTime(); }
  /** Whether frames of the same view add nothing to it. */
  bool IsFinished() const;
  /** Sums. same: nothing but the time left has changed since. Returns false, after an error. */
  bool Sum(const Input& input, bool same);

  /** Irradiance in VTK's units, a value for every pixel. */
  const vtkIndirectTarget& GetIrradiance() const { return this->Irradiance; }
  /** What receivers reflect specularly; null where none does. */
  const vtkIndirectTarget* GetReflected() const
  {
    return this->Specular ? &this->Lobes.GetReflected() : nullptr;
  }

  int GetNumberOfTilesLeft() const;
  size_t GetNumberOfTilesDrawn() const
  {
    return this->Maps.GetAtlas().GetNumberOfTilesDrawn() + this->Rounds.GetNumberOfTilesDrawn();
  }
  size_t GetBytes() const;
  void AddToReport(vtkIndirectReport& report) const;
  void Release(vtkWindow* window);

private:
  using Lamp = vtkIndirectAreaLamps::Lamp;

  double GetTolerance(const Input& input) const;
  bool SumIrradiance(const Input& input, bool same);
  bool SumLobes(const Input& input);
  bool SumRounds(const Input& input, bool same);
  bool SumOpen(const Input& input, vtkIndirectTarget& target);
  void SetLamp(const Input& input, vtkShaderProgram* program, const Lamp& lamp);

  vtkIndirectAreaLamps Lamps;
  vtkIndirectAreaMaps Maps; // of the first round
  bool Visible = false;     // something can hide them
  size_t ContentTime = 0;
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
