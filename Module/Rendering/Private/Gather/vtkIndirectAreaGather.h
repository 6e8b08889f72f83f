// SPDX-License-Identifier: BSD-3-Clause
// The irradiance that comes directly from area lights: in closed form if nothing hid them (images:
// texels of a pyramid, as fine as the tolerance asks for), times the share of the light that is
// seen. That share is a ratio of two sums over a few points of the light, each with a depth map of
// its own: where nothing is hidden it is one, and there is no noise. Still frames do so at every
// pixel, moving ones at samples (vtkIndirectAreaSamples).
#ifndef vtkIndirectAreaGather_h
#define vtkIndirectAreaGather_h

#include "Gather/vtkIndirectAreaLamps.h"         // for a member
#include "Gather/vtkIndirectAreaSamples.h"       // for a member
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectTarget.h"            // for members
#include "OpenGL/vtkIndirectUniformBlock.h"      // for members
#include "Visibility/vtkIndirectDepthAtlas.h"    // for members
#include "vtkSmartPointer.h"                     // for lights

#include <string> // for definitions
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
  size_t GetContentTime() const { return this->ContentTime; }
  /** Sums. Returns false, after an error. */
  bool Sum(const Input& input);

  /** Irradiance in VTK's units, a value for every pixel. */
  const vtkIndirectTarget& GetIrradiance() const { return this->Irradiance; }

  size_t GetNumberOfTilesDrawn() const { return this->Atlas.GetNumberOfTilesDrawn(); }
  size_t GetBytes() const;
  void AddToReport(vtkIndirectReport& report) const;
  void Release(vtkWindow* window);

private:
  using Lamp = vtkIndirectAreaLamps::Lamp;

  bool UpdateMaps(const Input& input, int most);
  double GetTolerance(const Input& input) const;
  bool SumPixels(const Input& input);
  void SetLamp(const Input& input, vtkShaderProgram* program, const Lamp& lamp);
  void SetPoints(const Input& input, vtkShaderProgram* program, const Lamp& lamp);

  vtkIndirectAreaLamps Lamps;
  vtkIndirectDepthAtlas Atlas;
  bool Visible = false; // something can hide them
  size_t ContentTime = 0;
  bool Moving = false;
  vtkIndirectUniformBlock Block{ "vtkiAreaBlock" };
  vtkIndirectFullScreenProgram Kernels[2]; // of one radiance, of images
  vtkIndirectAreaSamples Samples;
  vtkIndirectTarget Irradiance;
};

#endif
