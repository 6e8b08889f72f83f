// Tests a segment between two positions for occluding spheres, listed by the cells of a grid; see
// vtkIndirectSphereGrid.
#include "vtkIndirectLibSphereSegments.glsl"

uniform usampler3D vtkiSphereCells; // first entry of a cell's list, and its length
uniform sampler2D vtkiSphereLists;  // center and radius, in cells; 1024 a row
uniform vec4 vtkiSphereOrigin;      // scene units; cells per scene unit

uvec2 vtkiFetchList(ivec3 cell)
{
  return texelFetch(vtkiSphereCells, clamp(cell, ivec3(0), textureSize(vtkiSphereCells, 0) - 1), 0).rg;
}

// State of a walk along a segment: the cell, and the rest of its list.
struct vtkiSphereWalk
{
  vtkiCells cells;
  int next;   // next sphere of the list
  int beyond; // end of the list
  bool clear; // no sphere met so far
  bool more;
};

void vtkiOpenList(inout vtkiSphereWalk walk)
{
  uvec2 list = vtkiFetchList(walk.cells.cell);
  walk.next = int(list.x);
  walk.beyond = int(list.x + list.y);
}

// Tests the next sphere of the list; at the end of the list moves on to the next cell.
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

// With test false no sphere is looked up.
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
  // One loop serves cells and lists, so that neighbouring fragments do not wait for each other's
  // lists. llvmpipe ends all loops of a shader after 65535 rounds in total.
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
