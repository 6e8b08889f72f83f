// Whether spheres stand between two places: lists by the cells of a grid, see vtkIndirectSphereGrid.
#include "vtkIndirectLibSphereSegments.glsl"

uniform usampler3D vtkiSphereCells; // the first of a cell's list, and how many
uniform sampler2D vtkiSphereLists;  // center and radius, in cells; 1024 a row
uniform vec4 vtkiSphereOrigin;      // scene units; cells per scene unit

uvec2 vtkiFetchList(ivec3 cell)
{
  return texelFetch(vtkiSphereCells, clamp(cell, ivec3(0), textureSize(vtkiSphereCells, 0) - 1), 0).rg;
}

// Where a segment is, and in which list.
struct vtkiSphereWalk
{
  vtkiCells cells;
  int next;   // of the list
  int beyond; // its end
  bool clear; // so far
  bool more;
};

void vtkiOpenList(inout vtkiSphereWalk walk)
{
  uvec2 list = vtkiFetchList(walk.cells.cell);
  walk.next = int(list.x);
  walk.beyond = int(list.x + list.y);
}

// A sphere, if the list has another; at its end the next cell.
void vtkiStepThroughSpheres(vec3 start, vec3 along, float inverseSquare, inout vtkiSphereWalk walk)
{
  if (walk.next < walk.beyond)
  {
    vec4 sphere = texelFetch(vtkiSphereLists, ivec2(walk.next & 1023, walk.next >> 10), 0);
    walk.clear = !vtkiSphereBlocks(start, along, inverseSquare, sphere);
    walk.more = walk.clear;
    walk.next += 1;
  }
  if (walk.next >= walk.beyond)
  {
    walk.more = vtkiNextCell(walk.cells) && walk.more;
    vtkiOpenList(walk);
  }
}

// With test false nothing is looked up.
bool vtkiIsFreeOfSpheres(vec3 from, vec3 to, bool test)
{
  vec3 start = (from - vtkiSphereOrigin.xyz) * vtkiSphereOrigin.w;
  vec3 along = (to - from) * vtkiSphereOrigin.w;
  float inverseSquare = vtkiInverseSquare(along);
  vtkiSphereWalk walk;
  walk.cells = vtkiBeginCells(start, along, textureSize(vtkiSphereCells, 0));
  walk.clear = true;
  walk.more = test && walk.cells.inside;
  vtkiOpenList(walk);
  // One loop for cells and lists: neighbours need not wait for each other's lists. llvmpipe ends all loops of a
  // shader after 65535 rounds together.
  while (walk.more)
  {
    vtkiStepThroughSpheres(start, along, inverseSquare, walk);
#ifdef VTKI_LONG_STEPS
    for (int i = 0; i < 3; ++i)
    {
      if (walk.more)
      {
        vtkiStepThroughSpheres(start, along, inverseSquare, walk);
      }
    }
#endif
  }
  return walk.clear;
}
