// SPDX-License-Identifier: BSD-3-Clause
// Diffuse irradiance does not depend on the eye: where a moving eye sees a place again, the place
// keeps the irradiance of the last frame. Nehab, Sander, Lawrence, Tatarchuk and Isidoro 2007,
// "Accelerating real-time shading with reverse reprojection caching". A strip of the picture is
// summed anew in each frame, so that no irradiance is older than NumberOfStrips frames.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for a member
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "OpenGL/vtkIndirectTarget.h"            // for members

#include <glm/glm.hpp> // for matrices

#include <string> // for the report

class vtkIndirectGeometryBuffer;
struct vtkIndirectFrame;

class vtkIndirectReprojection : public vtkIndirectResource
{
public:
  /**
   * withRadius: alpha of the irradiance is a radius. A pixel that has irradiance of the last frame
   * gets the radius of the pixel of greatest weight there, negative.
   */
  explicit vtkIndirectReprojection(vtkIndirectResource* owner, bool withRadius = false);

  static constexpr int NumberOfStrips = 16;
  /** Returns what the report says of a frame that keeps irradiance. */
  static std::string Meaning();

  /**
   * Keeps the places of a frame's pixels for the next frame. unit: of the frame's irradiance.
   * Returns false, after an error, if OpenGL refuses.
   */
  bool Keep(const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry, double unit);
  void Forget() { this->IsThere = false; }
  /** Returns true if the places of a frame of the same size and unit are kept. */
  bool Has(const vtkIndirectFrame& frame, double unit) const;

  /**
   * Draws irradiance of the frame whose places are kept. Pixels that have some, and pixels without
   * a lit surface, get the depth 0. Other pixels get the alpha VTKI_REPROJECTED_NONE and the depth
   * 1. Within a vtkIndirectFullScreenState.
   */
  bool Draw(const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry,
    const vtkIndirectTarget& before, vtkIndirectTarget& irradiance);

protected:
  void ReleaseOwn(vtkWindow*) override { this->Forget(); }

private:
  vtkIndirectTarget Surface; // of the last frame
  vtkIndirectFullScreenProgram Reproject{ this, "vtkIndirectReprojectFS.glsl" };
  bool IsThere = false;
  double Unit = 1.0;
  glm::dmat4 ViewToScene{ 1.0 };
  glm::mat4 SceneToClip{ 1.0f };
  glm::mat3 RayOrigin{ 0.0f };
  glm::mat3 RayDirection{ 0.0f };
  unsigned int Round = 0;
};
