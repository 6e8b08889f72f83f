// Positions of the hints. Hint i is texel vtkiTableTexel(i) of every table of hints.
#include "vtkIndirectLibTable.glsl"

uniform sampler2D vtkiHints; // position (scene units), 1 if active
uniform int vtkiHintCount;
// Number of grids, one or two.
#ifndef VTKI_GRIDS
#define VTKI_GRIDS 1
#endif
uniform vec4 vtkiGridLower0; // lower corner, first hint
uniform vec4 vtkiGridCell0;  // cell, its diagonal
uniform vec4 vtkiGridSize0;  // hints along each axis
uniform vec4 vtkiGridLower1;
uniform vec4 vtkiGridCell1;
uniform vec4 vtkiGridSize1;

struct vtkiGrid
{
  vec3 lower; // corner
  int first;  // number of its first hint
  vec3 cell;
  float diagonal; // diagonal of a cell
  ivec3 size;     // hints along each axis
};

vtkiGrid vtkiGetGrid(int grid)
{
  vec4 lower = grid == 0 ? vtkiGridLower0 : vtkiGridLower1;
  vec4 cell = grid == 0 ? vtkiGridCell0 : vtkiGridCell1;
  vec4 size = grid == 0 ? vtkiGridSize0 : vtkiGridSize1;
  return vtkiGrid(lower.xyz, int(lower.w), cell.xyz, cell.w, ivec3(size.xyz));
}

ivec2 vtkiHintTexel(int hint)
{
  return vtkiTableTexel(hint);
}

int vtkiGridOf(int hint)
{
  return VTKI_GRIDS > 1 && hint >= int(vtkiGridLower1.w) ? 1 : 0;
}

// Returns evenly distributed numbers in [0,1)^3 for item i of a sequence that each seed starts
// anew: additive recurrence on the generalized golden ratio (Roberts 2018) from a hashed start.
vec3 vtkiSpread(int i, uint seed)
{
  uint h = seed * 747796405u + 2891336453u;
  h = ((h >> ((h >> 28u) + 4u)) ^ h) * 277803737u;
  h = (h >> 22u) ^ h;
  uvec3 start = uvec3(h, h * 2654435761u + 1013904223u, (h ^ 0x9e3779b9u) * 2246822519u);
  // Fractions of the powers of 1/1.2207440846 in units of 2^-32: unsigned sums wrap by themselves.
  uvec3 sum = start + uint(i) * uvec3(3518319155u, 2882110345u, 2360945575u);
  return vec3(sum >> 8u) * (1.0f / 16777216.0f);
}
