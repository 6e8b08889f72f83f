// SPDX-License-Identifier: BSD-3-Clause
// Depth maps of points of area lights, which tell what hides them. Each shows no more than what can
// hide its point, and is drawn again when that, or its light, has moved.
#ifndef vtkIndirectAreaMaps_h
#define vtkIndirectAreaMaps_h

#include "Gather/vtkIndirectAreaLamps.h"        // for points
#include "Visibility/vtkIndirectCasterWindow.h" // for members
#include "Visibility/vtkIndirectDepthAtlas.h"   // for a member

#include <vector> // for lists

class vtkSurfaceCapturePass;
struct vtkIndirectFrame;

class vtkIndirectAreaMaps
{
public:
  /** Texels that are wanted along an edge of a map. */
  static int GetTexels(const vtkIndirectAreaLamps& lamps);

  /**
   * Brings maps of one round of the lamps' points up to date, at most so many. Returns false, after
   * an error, when OpenGL refuses.
   */
  bool Update(const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture,
    const vtkIndirectAreaLamps& lamps, int round, bool caching, int most);

  /** Grows when a map or what a point stands for has changed. */
  size_t GetContentTime() const { return this->ContentTime; }
  /** Whether all maps are there and up to date. */
  bool IsComplete() const { return this->Atlas.GetNumberOfStaleTiles() == 0; }

  const std::vector<vtkIndirectAreaLamps::Point>& GetPoints(size_t lamp) const
  {
    return this->Lamps[lamp].Points;
  }
  /** The round that the points are of. */
  int GetRound() const { return this->Round; }
  /** Where in the atlas a point's map of a side is, its middle from 0 to 1; negative: nowhere. */
  glm::vec2 GetMiddle(const vtkIndirectAreaLamps::Point& point, size_t side) const;
  /** From tangents to places in that map from -1 to 1: factors, and what is added. */
  glm::vec4 GetWindow(const vtkIndirectAreaLamps::Point& point, size_t side) const;

  /** The same of a strip, for all points of a lamp. */
  glm::vec4 GetStripWindow(size_t lamp, size_t side, size_t strip) const;
  /** One over the depths at which maps of a side of a lamp begin and end, and strips of them. */
  glm::dvec4 GetRange(size_t lamp, size_t side) const;

  const vtkIndirectDepthAtlas& GetAtlas() const { return this->Atlas; }
  void Release(vtkWindow* window);

private:
  // What was made of a lamp, and from what.
  struct Made
  {
    const void* Light = nullptr; // to be compared only
    vtkMTimeType Time = 0;
    glm::dvec3 Corner{ 0.0 };
    std::vector<vtkIndirectAreaLamps::Point> Points;
    vtkIndirectCasterWindow Window;
    vtkIndirectDepthTile Views[2]; // of each side, for strips and depths
  };

  void MakeEmitters(const vtkIndirectAreaLamps& lamps);

  std::vector<Made> Lamps;
  int Round = -1;
  std::vector<vtkIndirectDepthAtlas::Emitter> Emitters;
  vtkIndirectDepthAtlas Atlas{ true };
  size_t ContentTime = 0;
};

#endif
