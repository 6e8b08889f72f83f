// SPDX-License-Identifier: BSD-3-Clause
// Geometry of a light's map: its projection, its faces and the cameras that draw them.
#pragma once

#include "Capture/vtkIndirectShadowMaps.h" // for views and shadow maps
#include "Frame/vtkIndirectFrame.h"        // for the light
#include "vtkSmartPointer.h"               // for cameras

#include <array> // for cameras

class vtkIndirectKey;
class vtkOpenGLCamera;

class vtkIndirectLightMap
{
public:
  vtkIndirectLightMap();
  ~vtkIndirectLightMap();

  /**
   * Surfaces nearer to a light than this fraction of its farthest surface are not in its map. The
   * depth buffer's steps grow with far/near: 2.4e-7 * 1024 * far is below a tenth of a texel of
   * 512.
   */
  static constexpr double NearestFraction = 1.0 / 1024.0;

  /** Fits the map to the scene. */
  void Fit(const vtkIndirectFrame& frame, const vtkIndirectLight& light);

  /** Sets up the camera of a face; it keeps the eye's ParallelProjection flag (see the source). */
  vtkOpenGLCamera* GetCamera(int face, bool eyeIsParallel);

  /**
   * Returns the matrix from view to clip coordinates, of a map or a tile. halfWidth: tangents, or
   * for a parallel projection lengths in the unit of near and far. middle: tangents, of a
   * perspective projection that does not look straight ahead.
   */
  static glm::dmat4 MakeProjection(bool parallel, const glm::dvec2& halfWidth, double nearPlane,
    double farPlane, const glm::dvec2& middle = glm::dvec2(0.0));
  /** Gives a camera that projection, whatever its ParallelProjection flag is. */
  static void SetProjection(vtkOpenGLCamera* camera, const glm::dmat4& projection);

  /**
   * Returns true if a face of this many texels along an edge can hold anything within these bounds:
   * they are in sight, and not so small that they lie between the texels' centres.
   */
  bool CanHold(int face, const double bounds[6], int texels) const;

  ///@{
  /**
   * Return the data by which the capture draws into a map of this many texels, and looks up shadows
   * in it.
   */
  vtkIndirectMapView GetView(int texels) const;
  vtkIndirectShadowMap GetShadowMap() const;
  ///@}

  /**
   * Returns a texel's width across the light, in world units, at a place, for this many texels
   * along an edge.
   */
  double FindTexelAt(const glm::dvec3& place, int texels) const;

  /** Appends the inputs of the map's image, except the casters and the resolution. */
  void AppendTo(vtkIndirectKey& key) const;

  vtkIndirectLight Light;
  int Projection = 0; // VTKI_MAP_...
  int NumberOfFaces = 1;
  int FirstLayer = 0;
  double HalfWidth = 1.0; // tangents (perspective) or scene units (parallel)
  double Near = 0.0;      // scene units along a face's axis
  double Far = 1.0;
  double SceneScale = 1.0;
  glm::dmat4 WorldToLight{ 1.0 }; // light frame: light at the origin, -z forward; world units
  glm::dmat4 LightToWorld{ 1.0 };
  std::array<glm::dmat4, 6> FaceToScene; // from scaled face view coordinates
  std::array<glm::dvec3, 6> FaceAxis;    // direction of the light in a face's view coordinates

private:
  glm::dmat3 GetFaceRotation(int face) const; // light frame to face
  std::array<vtkSmartPointer<vtkOpenGLCamera>, 6> Cameras;
};
