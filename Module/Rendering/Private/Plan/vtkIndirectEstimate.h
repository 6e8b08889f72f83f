// SPDX-License-Identifier: BSD-3-Clause
// The input of a sum of light in a frame, and its contribution to the picture.
#pragma once

#include "vtkSmartPointer.h" // for lights

#include <vector> // for lists

class vtkAreaLight;
class vtkEnvironmentLight;
class vtkIndirectCreases;
class vtkIndirectGeometryBuffer;
class vtkIndirectReceiverGrid;
class vtkIndirectSkyProjection;
class vtkIndirectStageTimer;
class vtkIndirectTarget;
class vtkIndirectVirtualLights;
class vtkIndirectVisibility;
class vtkIndirectLightMaps;
struct vtkIndirectFrame;
struct vtkIndirectPlan;

/** This is the data that an estimator needs from the visibility stage. */
struct vtkIndirectVisibilityNeeds
{
  bool Senders = false;  // obstacles between receivers and senders hide the senders
  bool Segments = false; // shaders test visibility segment by segment
  bool Maps = false;     // depth maps of the senders in place of voxels
  bool Volume = false;   // another stage needs the voxels, too
  bool Surfaces = false; // rays on the processor find the surfaces that they meet
  bool Exact = false;    // the surfaces themselves hide senders, on the processor
  int Resolution = 128;  // voxels along the longest edge of the scene, 16 to 128

  bool IsAny() const { return this->Senders || this->Volume || this->Exact; }
  bool HasVolume() const { return (this->Senders && !this->Maps) || this->Volume; }
  bool HasSurfaces() const { return this->Surfaces || this->Exact; }
  /** Returns true if shaders test segments against lists of spheres, which voxels do not hold. */
  bool HasSphereLists() const { return this->Segments && !this->Maps; }
};

/** A part of a frame's virtual lights: light i is in batch i modulo Count. */
struct vtkIndirectLightBatch
{
  int Number = 0;
  int Count = 1;
  bool operator==(const vtkIndirectLightBatch& other) const
  {
    return this->Number == other.Number && this->Count == other.Count;
  }
};

/** This is the input of an estimator. All of it is valid for this frame, and read only. */
struct vtkIndirectEstimateInput
{
  const vtkIndirectFrame& Frame;
  const vtkIndirectPlan& Plan;
  const vtkIndirectGeometryBuffer& Geometry;
  vtkIndirectCreases& Creases;             // found by the first stage that asks
  const vtkIndirectLightMaps& Maps;        // without maps where the plan has none
  const vtkIndirectVirtualLights* Lights;  // null if the estimator wants none
  const vtkIndirectVisibility& Visibility; // as the estimator wants it
  bool Still = false;                      // nothing has changed since the estimator's last frame
  vtkIndirectStageTimer& Timer;
  vtkEnvironmentLight* Environment = nullptr;     // null where the frame has none
  vtkIndirectSkyProjection* Projection = nullptr; // of the environment onto directions
  const std::vector<vtkSmartPointer<vtkAreaLight>>* AreaLights = nullptr;
  bool EyeMoved = false;         // nothing else has changed since the estimator's last frame
  vtkIndirectLightBatch Batch{}; // the lights to sum
};

/** This is an image of light that the composite adds to VTK's shading. */
struct vtkIndirectContribution
{
  enum KindType
  {
    SKY,       // VTK irradiance that comes directly from the environment
    AREA,      // VTK irradiance that comes directly from area lights
    BOUNCE,    // VTK irradiance that surfaces reflect
    REFLECTED, // radiance that receivers reflect specularly
    LOBE       // radiance that lobes of a specular coefficient of one reflect
  };
  KindType Kind;
  vtkIndirectTarget* Target; // a picture of more lights replaces its content
  int Channel = 0;           // of the target
  double Unit = 1.0;         // light of a stored value of one
  /**
   * This is the light at every few pixels from border to border, and Target has values for pixels
   * of mixed cells; null if each pixel has a value of its own. The composite interpolates it
   * (vtkIndirectAddedLight.glsl). The fourth component is the kind of the cell of pixels whose
   * first corner is the sample: VTKI_CELL_EMPTY, _WHOLE or _MIXED.
   */
  const vtkIndirectReceiverGrid* Coarse = nullptr;
  /**
   * The same light, in its first channel and the same unit, if nothing hid any: on surfaces that
   * catch light. Light from the sky and from area lights has it where the plan catches light.
   */
  const vtkIndirectTarget* Open = nullptr;
};

struct vtkIndirectEstimate
{
  enum StateType
  {
    FAILED,   // after an error
    REFINING, // a further frame of an unchanged scene brings the result nearer to convergence
    CONVERGED
  };
  StateType State = FAILED;
  std::vector<vtkIndirectContribution> Contributions;
};
