// How tables of numbers lie in textures: what C++ writes and shaders read, declared once for both.
#ifndef vtkIndirectLibTable
#define vtkIndirectLibTable
#include "vtkIndirectLibPortable.glsl"

// Entries in a row of a table of virtual lights, of hints, or of surfaces that hints see. A power of
// two: a place in it is two bit operations.
const int VTKI_ROW_LENGTH = 256;

// Zonal logarithms of what spheres leave, over 1 - cos.
const int VTKI_PROXY_TABLE = 1024;

// Pixels that no coarse receiver of sums over spheres stands for share receivers in tiles of so many along an edge, of
// which each has a block of so many texels.
const int VTKI_PROXY_TILE = 8;
const int VTKI_PROXY_BLOCK = 4;

// Branches of a virtual light, in a table of their own: the first node below it, the nodes below that one, the
// second node below it, and so on.
const int VTKI_BRANCHES_PER_NODE = 8;
const int VTKI_BRANCHES = 72;

/* Texel of an entry. */
ivec2 vtkiTableTexel(int entry)
{
  return ivec2(entry % VTKI_ROW_LENGTH, entry / VTKI_ROW_LENGTH);
}

/* Entry of a texel. */
int vtkiTableEntry(ivec2 texel)
{
  return texel.x + VTKI_ROW_LENGTH * texel.y;
}

// The table of lights' maps has a row for each layer; these are its texels.
const int VTKI_MAP_TO_SCENE = 0;   // three rows of a matrix, from face view coordinates to scene
const int VTKI_MAP_SHAPE = 3;      // projection, half width, texels along an edge, cone exponent
const int VTKI_MAP_LIGHT = 4;      // colour times intensity, light index
const int VTKI_MAP_FROM_SCENE = 5; // three rows of a matrix, from scene to face view coordinates
const int VTKI_MAP_FALLOFF = 8;    // attenuation for scene units, squared tangent of the cone or -1
const int VTKI_MAP_AXIS = 9;       // direction of the light, face of the cube
const int VTKI_MAP_TABLE_WIDTH = 10;
#endif
