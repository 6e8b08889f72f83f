// SPDX-License-Identifier: BSD-3-Clause
// Diffuse irradiance does not depend on the eye: where a moving eye sees a place again, the place
// keeps the irradiance of the last frame. Nehab, Sander, Lawrence, Tatarchuk and Isidoro 2007,
// "Accelerating real-time shading with reverse reprojection caching". A strip of the picture is
// summed anew in each frame, so that no irradiance is older than the number of strips.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for a member
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "OpenGL/vtkIndirectTarget.h"            // for members

#include <glm/glm.hpp> // for matrices

#include <memory> // for members
#include <string> // for the report

class vtkIndirectGeometryBuffer;
struct vtkIndirectFrame;

class vtkIndirectReprojection : public vtkIndirectResource
{
public:
  /**
   * strips: one of this many strips of the picture is summed anew in each frame; a power of two.
   * withRadius: alpha of the irradiance is a radius. A pixel that has irradiance of an earlier
   * frame gets the radius of the pixel of greatest weight there, negative.
   */
  vtkIndirectReprojection(vtkIndirectResource* owner, int strips, bool withRadius = false);

  /** Returns what the report says of a frame that keeps irradiance. */
  std::string GetMeaning() const;

  /**
   * Keeps the places of a frame's pixels for the next frame. unit: of the frame's irradiance.
   * Returns false, after an error, if OpenGL refuses.
   */
  bool Keep(const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry, double unit);
  void ForgetKey() { this->Key.IsThere = false; }
  /**
   * Takes the irradiance of the last frame in exchange for an image whose content is no longer
   * needed, or for null.
   */
  void Exchange(std::unique_ptr<vtkIndirectTarget>& image) { image.swap(this->Last.Irradiance); }
  /** Drops all irradiance. */
  void Drop();
  /** Returns true if the places of a frame of the same size and unit are kept. */
  bool Has(const vtkIndirectFrame& frame, double unit) const;

  /**
   * Draws irradiance of the key picture, and of the last frame where the key picture has none; of
   * the one that is there if there is only one. The last frame becomes the key picture every
   * FramesPerKey frames: each draw from the last frame blurs a little, draws from a key picture
   * blur once in its time. Pixels that have irradiance, and pixels without a lit surface, get the
   * depth 0. Other pixels get the alpha VTKI_REPROJECTED_NONE and the depth 1. Within a
   * vtkIndirectFullScreenState.
   */
  bool Draw(const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry,
    vtkIndirectTarget& irradiance);

protected:
  // The images are parts of the caller, which releases them.
  void ReleaseOwn(vtkWindow*) override { this->Last.IsThere = this->Key.IsThere = false; }

private:
  static constexpr int FramesPerKey = 16;

  struct Picture
  {
    std::unique_ptr<vtkIndirectTarget> Surface;
    std::unique_ptr<vtkIndirectTarget> Irradiance; // of the last frame: from Exchange to Draw
    bool IsThere = false;
    double Unit = 1.0;
    glm::dmat4 ViewToScene{ 1.0 };
    glm::mat4 SceneToClip{ 1.0f };
    glm::mat3 RayOrigin{ 0.0f };
    glm::mat3 RayDirection{ 0.0f };
  };

  void RenewKey();

  int NumberOfStrips;
  std::string Definitions;
  Picture Last;
  Picture Key;
  int FramesOfKey = 0;
  vtkIndirectFullScreenProgram Reproject{ this, "vtkIndirectReprojectFS.glsl" };
  unsigned int Round = 0;
};
