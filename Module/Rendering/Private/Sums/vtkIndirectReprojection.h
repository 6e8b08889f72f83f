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

  static constexpr int FramesPerKey = 16;
  /** Returns what the report says of a frame that keeps irradiance. */
  std::string GetMeaning() const;

  /**
   * Keeps the places of a frame's pixels for the next frame. unit: of the frame's irradiance.
   * Returns false, after an error, if OpenGL refuses.
   */
  bool Keep(const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry, double unit);
  void Forget() { this->Last.IsThere = this->Key.IsThere = false; }
  void ForgetKey() { this->Key.IsThere = false; }
  /** Returns true if the places of a frame of the same size and unit are kept. */
  bool Has(const vtkIndirectFrame& frame, double unit) const;

  /**
   * Each draw from the last frame blurs a little. Draws from a key picture, which stays for
   * FramesPerKey frames, blur once in its time. Returns true if this frame makes the last frame the
   * key picture; the caller then keeps its irradiance likewise. To be called once before Draw by
   * callers that have key pictures.
   */
  bool WantsKey();

  /**
   * Draws irradiance of the key picture, and of the frame whose places are kept where the key
   * picture has none; null: there is no such picture. Pixels that have some, and pixels without a
   * lit surface, get the depth 0. Other pixels get the alpha VTKI_REPROJECTED_NONE and the depth 1.
   * Within a vtkIndirectFullScreenState.
   */
  bool Draw(const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry,
    const vtkIndirectTarget* before, const vtkIndirectTarget* key, vtkIndirectTarget& irradiance);

protected:
  void ReleaseOwn(vtkWindow*) override { this->Forget(); }

private:
  struct Picture
  {
    std::unique_ptr<vtkIndirectTarget> Surface;
    bool IsThere = false;
    double Unit = 1.0;
    glm::dmat4 ViewToScene{ 1.0 };
    glm::mat4 SceneToClip{ 1.0f };
    glm::mat3 RayOrigin{ 0.0f };
    glm::mat3 RayDirection{ 0.0f };
  };

  int NumberOfStrips;
  std::string Definitions;
  Picture Last;
  Picture Key;
  int FramesOfKey = 0;
  vtkIndirectFullScreenProgram Reproject{ this, "vtkIndirectReprojectFS.glsl" };
  unsigned int Round = 0;
};
