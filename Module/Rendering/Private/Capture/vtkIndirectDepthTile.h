// SPDX-License-Identifier: BSD-3-Clause
// The camera of an emitter: the view of a tile of the depth atlas, or of a face of a light's map.
#pragma once

#include <array>       // for strips
#include <glm/glm.hpp> // for the camera

class vtkOpenGLCamera;
struct vtkIndirectFrame;
struct vtkIndirectSeenBox;

struct vtkIndirectDepthTile
{
  bool Parallel = false;
  glm::dvec3 Place{ 0.0 }; // scene units: place of the emitter, or middle of the near plane
  glm::dvec3 Right{ 1.0, 0.0, 0.0 };
  glm::dvec3 Up{ 0.0, 1.0, 0.0 };
  glm::dvec3 Forward{ 0.0, 0.0, -1.0 };
  glm::dvec2 HalfWidth{ 1.0 }; // tangents (perspective) or scene units (parallel)
  glm::dvec2 Middle{ 0.0 };    // tangents; not zero if a window does not look straight ahead
  double Near = 0.0;           // scene units along Forward
  double Far = 1.0;

  /**
   * This is the extent of a strip, in tangents along its own axes; a strip without width is empty.
   */
  struct Strip
  {
    glm::dvec2 HalfWidth{ 0.0 };
    glm::dvec2 Middle{ 0.0 };
    bool operator==(const Strip& other) const
    {
      return this->HalfWidth == other.HalfWidth && this->Middle == other.Middle;
    }
  };
  /**
   * These are the strips of a perspective tile. They show the directions beside the view ahead down
   * to the emitter's horizon: to the right, left, up and down, from -1 to 1 across.
   */
  std::array<Strip, 4> Strips;
  double StripNear = 0.0; // scene units along a strip's axis
  double StripFar = 1.0;

  ///@{
  /**
   * A tile has five views: the view ahead and four strips, each a tile of its own. The static
   * functions return a view's size and place in the atlas, in texels from the tile's lower left
   * corner, for a view ahead of this many texels along an edge. See vtkiFindTileView.
   */
  static constexpr int NumberOfViews = 5;
  vtkIndirectDepthTile GetView(int view) const;
  static glm::ivec2 GetSizeOfView(int view, int texels);
  static glm::ivec2 GetPlaceOfView(int view, int texels, bool strips);
  ///@}

  /**
   * Makes the tile of a place that sends light along its normal, as shaders look it up, with
   * strips.
   */
  static vtkIndirectDepthTile FromPlace(const glm::dvec3& place, const glm::dvec3& normal);
  /**
   * Makes the tile of light from a direction, fitted to the casters. A caster and the receiver that
   * it hides have the same place in the tile. So the largest casters that are flat along an axis of
   * the world and hide nothing of each other, such as a ground, may reach beyond the tile. The tile
   * ends where the box ends that its receivers lie in.
   */
  static vtkIndirectDepthTile FromDirection(
    const vtkIndirectFrame& frame, const glm::dvec3& toLight, const vtkIndirectSeenBox& receivers);

  /** Returns a place, in scene units, along the axes right, up and forward. */
  glm::dvec3 ToView(const glm::dvec3& place) const
  {
    const glm::dvec3 d = place - this->Place;
    return { glm::dot(d, this->Right), glm::dot(d, this->Up), glm::dot(d, this->Forward) };
  }
  /** Returns the matrix from a frame that looks along -z, of scene units, to the scene. */
  glm::dmat4 GetToScene() const
  {
    glm::dmat4 toScene(glm::dmat3(this->Right, this->Up, -this->Forward));
    toScene[3] = glm::dvec4(this->Place, 1.0);
    return toScene;
  }

  /** Converts a parallel tile from other scene units to those of this frame. */
  vtkIndirectDepthTile FromUnits(
    double scale, const glm::dvec3& center, const vtkIndirectFrame& frame) const;

  /**
   * Returns a bit for each view that can see any of these bounds, in world coordinates. A view
   * whose texels' centres all miss the bounds does not count; the view ahead has this many texels
   * along an edge.
   */
  unsigned int FindViews(const vtkIndirectFrame& frame, const double bounds[6], int texels) const;
  /** Returns true if any view can see the bounds. */
  bool CanSee(const vtkIndirectFrame& frame, const double bounds[6], int texels) const
  {
    return this->FindViews(frame, bounds, texels) != 0;
  }

  /**
   * Returns the width of a texel of the view ahead, in world units, where these bounds are nearest
   * to the emitter.
   */
  double FindTexelAt(
    const vtkIndirectFrame& frame, const double bounds[6], const glm::dvec2& texels) const;

  /** Returns the matrix from world to clip coordinates. */
  glm::dmat4 GetWorldToClip(const vtkIndirectFrame& frame) const;
  /** Sets up a camera; it keeps the eye's ParallelProjection flag (see the source). */
  void SetUp(vtkOpenGLCamera* camera, const vtkIndirectFrame& frame) const;

  bool operator==(const vtkIndirectDepthTile& other) const;
};
