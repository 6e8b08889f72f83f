// SPDX-License-Identifier: BSD-3-Clause
// Divides the image into subsplats: a pyramid of surfaces over the geometry buffer, whose texels
// are whole or split. Nichols and Wyman 2009, "Multiresolution splatting for indirect
// illumination", sections 3.2 and 3.3.
//
// Level n has texels of 2^n pixels. The last level has no leaves: all of it is split.
#pragma once

#include "Multiresolution/vtkIndirectSubsplatDetails.h" // for settings
#include "Multiresolution/vtkIndirectSubsplatList.h"    // for members
#include "OpenGL/vtkIndirectFullScreenProgram.h"        // for members
#include "OpenGL/vtkIndirectResource.h"                 // for the base class
#include "OpenGL/vtkIndirectTarget.h"                   // for members
#include "Plan/vtkIndirectEstimate.h"                   // for the input

#include <memory> // for levels
#include <vector> // for levels

class vtkIndirectLightBlock;

/** These are the settings of a frame, with thresholds for the frame's tolerance. */
struct vtkIndirectSubsplatSettings : vtkIndirectSubsplatDetails
{
  bool TakesNearest = false;    // below the finest level texels without a sample on their surface
                                // take the nearest one
  int FinestLevel = 0;          // no texel of this level or a finer one is split; level 0 is pixels
  bool PointFormFactor = false; // of lights at diffuse receivers, see vtkiPointLightStrength
  double PlaneThreshold = 0.0;
  double DepthThreshold = 0.0;
  double NormalThreshold = 0.0;
  double SurfaceDetail = 0.0;
  double StorageScale = 1.0;
  bool HasCompute = false; // compute shaders sum lights by lists of split texels
  /** The image to fill, with irradiance of the last frame, see vtkIndirectReprojection; or null. */
  const vtkIndirectTarget* Reprojected = nullptr;
};

class vtkIndirectSubsplatPyramid : public vtkIndirectResource
{
public:
  using vtkIndirectResource::vtkIndirectResource;

  /** Creates or resizes the levels for an image. Returns false, after an error, if it cannot. */
  bool Resize(
    vtkOpenGLRenderWindow* window, const int size[2], const vtkIndirectSubsplatSettings& settings);

  /** Measures the variation of the lighting, then builds all levels. */
  bool Build(const vtkIndirectEstimateInput& input, const vtkIndirectSubsplatSettings& settings,
    vtkIndirectLightBlock& lights);

  size_t GetNumberOfLevels() const { return this->Levels.size(); }
  /** Returns the octahedral normal, depth and state of level `number`, from 1 on. */
  const vtkIndirectTarget& GetSurface(size_t number) const { return *this->Levels[number - 1]; }
  /** Activates the distances from the planes of level `number`, and whether texels are needed. */
  void ActivateDeviation(size_t number, const vtkIndirectProgram& program) const
  {
    this->Levels[number - 1]->Activate(1, program);
  }
  /** Returns the list i: the split texels of level i + 1. */
  vtkIndirectSubsplatList& GetLists() { return this->Lists; }

  /** Returns the pixels along the edge of a texel of a level. */
  static float EdgeOf(size_t number) { return static_cast<float>(1u << number); }

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  using Input = vtkIndirectEstimateInput;
  using Settings = vtkIndirectSubsplatSettings;
  bool ProbeLighting(const Input& input, const Settings& settings, vtkIndirectLightBlock& lights);
  bool BuildLevel(const Input& input, const Settings& settings, size_t number);

  std::vector<std::unique_ptr<vtkIndirectTarget>> Levels; // [i] is level i + 1
  bool DepthRange = false;
  vtkIndirectSubsplatList Lists{ this };
  std::unique_ptr<vtkIndirectTarget> Probe;
  std::unique_ptr<vtkIndirectTarget> Variation;
  vtkIndirectFullScreenProgram ProbeLights{ this, "vtkIndirectSubsplatProbeFS.glsl" };
  vtkIndirectFullScreenProgram MeasureVariation{ this, "vtkIndirectSubsplatVariationFS.glsl" };
  vtkIndirectFullScreenProgram BuildFinest{ this, "vtkIndirectSubsplatFirstFS.glsl" };
  vtkIndirectFullScreenProgram BuildCoarser{ this, "vtkIndirectSubsplatNextFS.glsl" };
};
