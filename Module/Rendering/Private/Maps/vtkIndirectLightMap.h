// SPDX-License-Identifier: BSD-3-Clause
// Geometry of a light's map: its projection, and the views of its faces.
#pragma once

#include "Capture/vtkIndirectDepthTile.h"  // for faces
#include "Capture/vtkIndirectShadowMaps.h" // for the base class

#include <array> // for faces

class vtkIndirectKey;

class vtkIndirectLightMap : public vtkIndirectShadowMap
{
public:
  /** Fits the map to the scene. */
  void Fit(const vtkIndirectFrame& frame, const vtkIndirectLight& light);

  /**
   * Chooses the window of a map whose texels are wider than the picture's pixels where the eye sees
   * them: the part of the map that gains most, or none. texels: along an edge of the map and of the
   * window. The window has half of the map's width or less; share: of each width in the next larger
   * one.
   */
  void FitWindow(const vtkIndirectFrame& frame, int texels, double share = 0.5);
  /** Returns true if the texels of the window are senders; a parallel map's are. */
  bool HasSenderWindow() const { return this->Window.Layer >= 0 && !this->Light.Positional; }

  ///@{
  /** Return the view and the layer of a face, or of the window, which comes after the faces. */
  vtkIndirectDepthTile GetView(int face) const;
  int GetLayer(int face) const
  {
    return face < this->NumberOfFaces ? this->FirstLayer + face : this->Window.Layer;
  }
  ///@}

  /**
   * Fits the depth range of a positional light's map to casters within bounds along the axes of the
   * light's frame. radius: of the light, from all whose points the casters are seen.
   */
  static void FitDepths(vtkIndirectShadowMap& map, const glm::dvec3& lower, const glm::dvec3& upper,
    double radius = 0.0);
  /** Returns the view of a map's face; axes and place are those of the light's frame. */
  static vtkIndirectDepthTile MakeFace(
    const vtkIndirectShadowMap& map, const glm::dmat3& axes, const glm::dvec3& place, int face);

  /**
   * Returns a texel's width across the light, in world units, at a place, for this many texels
   * along an edge; of the window where the window holds the place.
   */
  double FindTexelAt(const glm::dvec3& place, int texels) const;

  /** Appends the inputs of the map's image, except the casters and the resolution. */
  void AppendTo(vtkIndirectKey& key) const;

  double SceneScale = 1.0;
  std::array<vtkIndirectDepthTile, 6> Faces; // the axes of the first one are those of the light
};
