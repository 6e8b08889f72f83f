// SPDX-License-Identifier: BSD-3-Clause
// What one tile of the depth atlas sees: the camera of an emitter.
#ifndef vtkIndirectDepthTile_h
#define vtkIndirectDepthTile_h

#include <array>       // for strips
#include <glm/glm.hpp> // for the camera

class vtkOpenGLCamera;
struct vtkIndirectFrame;

struct vtkIndirectDepthTile
{
  bool Parallel = false;
  glm::dvec3 Place{ 0.0 }; // scene units: the emitter's, or the middle of the near plane
  glm::dvec3 Right{ 1.0, 0.0, 0.0 };
  glm::dvec3 Up{ 0.0, 1.0, 0.0 };
  glm::dvec3 Forward{ 0.0, 0.0, -1.0 };
  glm::dvec2 HalfWidth{ 1.0 }; // tangents (perspective) or scene units (parallel)
  glm::dvec2 Middle{ 0.0 };    // tangents, of a window that does not look straight ahead
  double Near = 0.0;           // scene units along Forward
  double Far = 1.0;

  /** What a strip shows, in tangents along its own axes; nothing where it has no width. */
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
   * Of a perspective tile, what lies beside the view ahead down to the emitter's horizon: to the
   * right, left, up and down, from -1 to 1 across.
   */
  std::array<Strip, 4> Strips;
  double StripNear = 0.0; // scene units along a strip's axis
  double StripFar = 1.0;

  ///@{
  /**
   * The views of a tile: ahead, and four strips, each a tile of its own. Where they lie in the
   * atlas, in texels from the tile's lower left corner, if the view ahead has so many along an
   * edge. See vtkiFindTileView.
   */
  static constexpr int NumberOfViews = 5;
  vtkIndirectDepthTile GetView(int view) const;
  static glm::ivec2 GetSizeOfView(int view, int texels);
  static glm::ivec2 GetPlaceOfView(int view, int texels, bool strips);
  ///@}

  /** The tile of a place that sends light along its normal, as shaders look it up, with strips. */
  static vtkIndirectDepthTile FromPlace(const glm::dvec3& place, const glm::dvec3& normal);
  /**
   * The tile of light that comes from a direction, fitted to what casts shadows. Where a caster
   * hides a receiver, both have the same place in the tile: so the largest of those that are flat
   * along an axis of the world and hide nothing of each other, such as a ground, may reach out.
   */
  static vtkIndirectDepthTile FromDirection(
    const vtkIndirectFrame& frame, const glm::dvec3& toLight);

  /** The same tile of the world in this frame's scene units, of one in others; if parallel. */
  vtkIndirectDepthTile FromUnits(
    double scale, const glm::dvec3& center, const vtkIndirectFrame& frame) const;

  /**
   * Which of the views can see any of these bounds, in world coordinates, and with so many texels
   * along an edge of the view ahead hold anything of them, which does not lie between the texels'
   * centres: a bit for each.
   */
  unsigned int FindViews(const vtkIndirectFrame& frame, const double bounds[6], int texels) const;
  /** Whether any of them does. */
  bool CanSee(const vtkIndirectFrame& frame, const double bounds[6], int texels) const
  {
    return this->FindViews(frame, bounds, texels) != 0;
  }

  /** A texel's width, in world units, where these bounds are nearest to the emitter: of the view
   * ahead, of so many texels. */
  double FindTexelAt(
    const vtkIndirectFrame& frame, const double bounds[6], const glm::dvec2& texels) const;

  /** From world to clip coordinates. */
  glm::dmat4 GetWorldToClip(const vtkIndirectFrame& frame) const;
  /** Sets up a camera that keeps the eye's ParallelProjection flag; see vtkIndirectLightMap. */
  void SetUp(vtkOpenGLCamera* camera, const vtkIndirectFrame& frame) const;

  bool operator==(const vtkIndirectDepthTile& other) const;
};

#endif
