// SPDX-License-Identifier: BSD-3-Clause
// Description of lights' maps for the capture, which looks shadows up in them, without access to
// the maps' owner.
#pragma once

#include "Scene/vtkIndirectFrame.h" // for the light

#include <glm/glm.hpp> // for the transformation
#include <vector>      // for the maps

/** A map that shadows are looked up in. */
struct vtkIndirectShadowMap
{
  vtkIndirectLight Light;
  // The light is at the origin of its frame, and looks along -z; world units.
  glm::dmat4 WorldToLight{ 1.0 };
  int FirstLayer = 0;
  int NumberOfFaces = 1;
  int Projection = 0;     // VTKI_MAP_...
  double HalfWidth = 1.0; // tangents (perspective) or scene units (parallel)
  double Near = 0.0;      // scene units
  double Far = 1.0;
  /** A second image of a part of the map, with finer texels; see vtkIndirectLightMap::FitWindow. */
  struct WindowType
  {
    int Layer = -1;           // negative: there is none
    glm::dvec2 Middle{ 0.0 }; // tangents (perspective) or scene units (parallel)
    double HalfWidth = 0.0;
  };
  WindowType Window;
};

/** The maps of a light with a size, one from each of its points: tiles of one texture. */
struct vtkIndirectPenumbraMap
{
  vtkIndirectShadowMap Map; // common values of all maps; the first layer is a tile
  double Size = 0.0; // radius in scene units of a positional light, else sine of its angular radius
  bool HoldsAll = true; // no caster is outside the maps
};

struct vtkIndirectShadowMaps
{
  std::vector<vtkIndirectShadowMap> Maps;
  int Texels = 0; // along an edge of a map
  int Unit = -1;  // texture unit of the rows of depths; -1 for none

  ///@{
  /** In place of Maps, for lights with a size. */
  std::vector<vtkIndirectPenumbraMap> Penumbrae;
  int TileTexels = 0; // along an edge of a tile
  int TileColumns = 1;
  int TileRows = 1;
  int TileUnit = -1; // texture unit of their depths
  ///@}
};
