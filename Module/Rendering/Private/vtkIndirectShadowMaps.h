// SPDX-License-Identifier: BSD-3-Clause
// What shading needs to look shadows up: handed from the maps to the capture by the stage between.
#ifndef vtkIndirectShadowMaps_h
#define vtkIndirectShadowMaps_h

#include <vector> // for the maps

class vtkIndirectLightMap;

struct vtkIndirectShadowMaps
{
  std::vector<const vtkIndirectLightMap*> Maps;
  int Texels = 0; // along an edge of a map
  int Unit = -1;  // texture unit that the rows of depths are bound to; -1 where there are none
};

#endif
