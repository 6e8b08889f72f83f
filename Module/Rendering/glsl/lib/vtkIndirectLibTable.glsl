// Layout of tables of numbers in textures, shared by the C++ code that writes them and the shaders
// that read them.
#ifndef vtkIndirectLibTable
#define vtkIndirectLibTable
#include "vtkIndirectLibPortable.glsl"

// Entries in a row of a table of virtual lights, of hints, or of surfaces around hints. A power of
// two, so that an index takes two bit operations.
const int VTKI_ROW_LENGTH = 256;

// These are the entries of the table of zonal logarithms of spheres' visibility, over 1 - cos.
const int VTKI_PROXY_TABLE = 1024;

// Pixels that no coarse receiver of the spheres' sums represents share receivers in tiles of this
// many pixels along an edge; each tile has a block of this many texels.
const int VTKI_PROXY_TILE = 8;
const int VTKI_PROXY_BLOCK = 4;

// Branches of a virtual light, in a table of their own: its first child, the children of that
// child, its second child, and so on.
const int VTKI_BRANCHES_PER_NODE = 8;
const int VTKI_BRANCHES = 72;

/* Returns the texel of an entry. */
ivec2 vtkiTableTexel(int entry)
{
  return ivec2(entry % VTKI_ROW_LENGTH, entry / VTKI_ROW_LENGTH);
}

/* Returns the entry of a texel. */
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
