// SPDX-License-Identifier: BSD-3-Clause
// The area lights of a scene that are on, as shaders have them: where they are in scene units, what
// they send, the points of them whose depth maps tell what hides them, and images in one texture.
//
// Points stay where they are on the rectangle while its image changes, and with them their maps.
#ifndef vtkIndirectAreaLamps_h
#define vtkIndirectAreaLamps_h

#include "Gather/vtkIndirectAreaPyramid.h" // for members
#include "OpenGL/vtkIndirectTarget.h"      // for a member
#include "vtkSmartPointer.h"               // for lights
#include "vtkType.h"                       // for times

#include <glm/glm.hpp> // for places
#include <memory>      // for lamps
#include <vector>      // for lists

class vtkAreaLight;
class vtkWindow;
struct vtkIndirectFrame;

class vtkIndirectAreaLamps
{
public:
  vtkIndirectAreaLamps();

  /** Points of a lamp in a round; where lamps are many, fewer of each, but so many at least. */
  static constexpr int MostPoints = 64;
  static constexpr int LeastPoints = 16;
  /** Rounds, in which a frame that stands still asks further points. */
  static constexpr int NumberOfRounds = 16;

  // A point of a light: where, what it stands for, and its places in the atlas of depth maps.
  struct Point
  {
    glm::dvec2 Place;          // in [0,1) along the edges
    glm::dvec3 Weight{ 1.0 };  // radiance over the mean
    int Tiles[2] = { -1, -1 }; // of the front, and of the back
  };
  struct Lamp
  {
    vtkAreaLight* Light = nullptr; // to be compared only
    vtkMTimeType Time = 0;         // of the light that the rest was made from
    glm::dvec3 Corner{ 0.0 };      // scene units
    glm::dvec3 Edge1{ 0.0 };
    glm::dvec3 Edge2{ 0.0 };
    glm::dvec3 Normal{ 0.0 };
    glm::dvec3 Radiance{ 0.0 }; // mean
    bool TwoSided = false;
    vtkIndirectAreaPyramid Pyramid;
    int Row = -1; // first of the image's in the texture; -1 where the radiance is one
    bool TextureIsStale = true;

    double GetArea() const { return glm::length(glm::cross(this->Edge1, this->Edge2)); }
    glm::dvec3 GetPlace(const Point& point) const
    {
      return this->Corner + point.Place.x * this->Edge1 + point.Place.y * this->Edge2;
    }
  };
  using List = std::vector<std::unique_ptr<Lamp>>;

  /** Returns whether anything has changed. */
  bool Update(
    const vtkIndirectFrame& frame, const std::vector<vtkSmartPointer<vtkAreaLight>>& lights);
  const List& Get() const { return this->Lamps; }

  /** Of each lamp, in a round. */
  int GetNumberOfPoints() const;
  /**
   * Those of a round. In the first one, which may be all there is, each stands for what of an image
   * is nearer to it than to others; in further ones, which fill the gaps, for what is where it is.
   */
  std::vector<Point> MakePoints(const Lamp& lamp, int round) const;

  /** Brings the images' texture up to date. Returns false, after an error. */
  bool UpdateTexture(const vtkIndirectFrame& frame);
  /** That texture: vtkiAreaPyramid. Only where some lamp has an image. */
  const vtkIndirectTarget& GetTexture() const { return this->Texture; }

  size_t GetBytes() const { return this->Texture.GetBytes(); }
  void Release(vtkWindow* window);

private:
  void UpdateLamp(Lamp& lamp, vtkAreaLight* light, int texels);
  void PlaceImages();

  List Lamps;
  double SceneScale = 0.0; // that they were placed in
  glm::dvec3 SceneCenter{ 0.0 };
  vtkIndirectTarget Texture;
  int Width = 0; // of the texture
  int Height = 0;
};

#endif
