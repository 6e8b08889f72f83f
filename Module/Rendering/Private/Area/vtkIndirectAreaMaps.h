// SPDX-License-Identifier: BSD-3-Clause
// Depth maps of points of area lights, which tell what hides these points. A map shows only the
// casters that can hide its point. It is drawn again when these casters, or the light, have moved.
#pragma once

#include "Area/vtkIndirectAreaLamps.h"    // for points
#include "Maps/vtkIndirectCasterWindow.h" // for members
#include "Maps/vtkIndirectDepthMaps.h"    // for depth maps
#include "OpenGL/vtkIndirectResource.h"   // for the base class

#include <vector> // for lists

struct vtkIndirectFrame;

class vtkIndirectAreaMaps : public vtkIndirectResource
{
public:
  vtkIndirectAreaMaps(
    vtkIndirectResource* owner, vtkIndirectDepthMaps& maps, vtkIndirectDepthMaps::ClientType client)
    : vtkIndirectResource(owner)
    , DepthMaps(maps)
    , Client(client)
    , Atlas(maps.Get(client))
  {
  }

  /** Asks for the maps of one round of the lamps' points. */
  void Update(const vtkIndirectFrame& frame, const vtkIndirectAreaLamps& lamps, int round);

  /** Returns true if all maps are present and up to date. */
  bool IsComplete() const { return this->Atlas.GetNumberOfTilesLeft() == 0; }

  const std::vector<vtkIndirectAreaLamps::Point>& GetPoints(size_t lamp) const
  {
    return this->Lamps[lamp].Points;
  }
  /** Returns the round that the points belong to. */
  int GetRound() const { return this->Round; }
  /**
   * Returns the middle of a point's map of a side in the atlas, from 0 to 1; negative: there is
   * none.
   */
  glm::vec2 GetMiddle(const vtkIndirectAreaLamps::Point& point, size_t side) const;
  /**
   * Returns the transform from tangents to places in that map from -1 to 1: factors, and summands.
   */
  glm::vec4 GetWindow(const vtkIndirectAreaLamps::Point& point, size_t side) const;

  /** Returns the same for a strip, for all points of a lamp. */
  glm::vec4 GetStripWindow(size_t lamp, size_t side, size_t strip) const;
  /** Returns one over the near and far depths of maps of a side of a lamp, and of their strips. */
  glm::dvec4 GetRange(size_t lamp, size_t side) const;

  const vtkIndirectDepthAtlas& GetAtlas() const { return this->Atlas; }

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  // This is the data made from a lamp, and their inputs.
  struct Made
  {
    vtkIndirectKey Light;
    glm::dvec3 Corner{ 0.0 };
    std::vector<vtkIndirectAreaLamps::Point> Points;
    vtkIndirectCasterWindow Window;
    vtkIndirectDepthTile Views[2]; // view of each side, for strips and depths
  };

  void MakeMaps(const vtkIndirectAreaLamps& lamps);

  vtkIndirectDepthMaps& DepthMaps;
  const vtkIndirectDepthMaps::ClientType Client;
  const vtkIndirectDepthAtlas& Atlas;
  std::vector<Made> Lamps;
  int Round = -1;
  std::vector<vtkIndirectDepthMaps::Map> Maps;
};
