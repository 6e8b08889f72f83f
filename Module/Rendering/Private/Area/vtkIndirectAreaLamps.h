// SPDX-License-Identifier: BSD-3-Clause
// The area lights of a scene that are on, as data for shaders: their places in scene units, their
// radiances, the points whose depth maps tell what hides them, and their images in one texture.
//
// Points stay in place on the rectangle while its image changes, and so do their maps.
#pragma once

#include "Emitters/vtkIndirectAreaPyramid.h" // for members
#include "Emitters/vtkIndirectRectangle.h"   // for places
#include "OpenGL/vtkIndirectKey.h"           // for members
#include "OpenGL/vtkIndirectResource.h"      // for the base class
#include "OpenGL/vtkIndirectTarget.h"        // for a member
#include "vtkSmartPointer.h"                 // for lights

#include <glm/glm.hpp> // for places
#include <memory>      // for lamps
#include <vector>      // for lists

struct vtkIndirectFrame;

class vtkIndirectAreaLamps : public vtkIndirectResource
{
public:
  explicit vtkIndirectAreaLamps(vtkIndirectResource* owner);

  /** Points of a lamp in a round. With many lamps each has fewer points, but at least LeastPoints.
   */
  static constexpr int MostPoints = 64;
  static constexpr int LeastPoints = 16;
  /** Number of rounds, by which a still frame looks up further points. */
  static constexpr int NumberOfRounds = 16;

  // A point of a light: its place, its weight, and its tiles in the atlas of depth maps.
  struct Point
  {
    glm::dvec2 Place;          // in [0,1) along the edges
    glm::dvec3 Weight{ 1.0 };  // radiance over the mean
    int Tiles[2] = { -1, -1 }; // tiles of the front and of the back
  };
  struct Lamp : vtkIndirectRectangle // in scene units
  {
    vtkIndirectKey Light;       // the light that the other members were made for
    glm::dvec3 Radiance{ 0.0 }; // mean radiance
    vtkIndirectAreaPyramid Pyramid;
    int Row = -1; // first row of the image in the texture; -1 for a lamp of one radiance
    bool TextureIsStale = true;
  };
  using List = std::vector<std::unique_ptr<Lamp>>;

  /** Brings the lamps up to date. Returns true if anything has changed. */
  bool Update(
    const vtkIndirectFrame& frame, const std::vector<vtkSmartPointer<vtkAreaLight>>& lights);
  const List& Get() const { return this->Lamps; }

  /** Returns the number of points of each lamp in a round. */
  int GetNumberOfPoints() const;
  /**
   * Makes the points of a round. In the first round, which may be the only one, each point
   * represents the part of an image that is nearer to it than to other points. In further rounds,
   * which fill the gaps, a point represents the image at its place.
   */
  std::vector<Point> MakePoints(const Lamp& lamp, int round) const;

  /** Brings the images' texture up to date. Returns false, after an error. */
  bool UpdateTexture(const vtkIndirectFrame& frame);
  /** Returns that texture, vtkiAreaPyramid. Valid only if some lamp has an image. */
  const vtkIndirectTarget& GetTexture() const { return this->Texture; }

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  void UpdateLamp(Lamp& lamp, vtkAreaLight* light, int texels);
  void PlaceImages();

  List Lamps;
  double SceneScale = 0.0; // scale in which the lamps were placed
  glm::dvec3 SceneCenter{ 0.0 };
  vtkIndirectTarget Texture;
  int Width = 0; // width of the texture
  int Height = 0;
};
