// Tests a segment against many spheres, listed by the cells of a grid (Amanatides and Woo 1987, "A
// fast voxel traversal algorithm for ray tracing"). Coordinates count cells: cell i extends from i
// to i + 1.
#ifndef vtkIndirectLibSphereSegments
#define vtkIndirectLibSphereSegments
#include "vtkIndirectLibPortable.glsl"

/* State of a walk. */
struct vtkiCells
{
  vec3 next;  // parameter of the next border along each axis
  vec3 delta; // parameter from border to border
  ivec3 cell; // current
  ivec3 side; // -1 or 1
  ivec3 last; // the farthest cell of the grid along side
  float leave; // parameter at which the segment ends or leaves the grid
  bool inside; // the segment meets the grid
};

vtkiCells vtkiBeginCells(vec3 start, vec3 along, ivec3 size)
{
  const float huge = 1.0e30f;
  vtkiCells w;
  float enter = 0.0f;
  w.leave = 1.0f;
  for (int axis = 0; axis < 3; ++axis)
  {
    bool moves = abs(along[axis]) > 1.0e-9f;
    float inverse = moves ? 1.0f / along[axis] : huge;
    float lower = -start[axis] * inverse;
    float upper = (float(size[axis]) - start[axis]) * inverse;
    bool within = start[axis] >= 0.0f && start[axis] <= float(size[axis]);
    enter = moves ? max(enter, min(lower, upper)) : (within ? enter : huge);
    w.leave = moves ? min(w.leave, max(lower, upper)) : w.leave;
  }
  w.inside = enter <= w.leave;
  for (int axis = 0; axis < 3; ++axis)
  {
    bool moves = abs(along[axis]) > 1.0e-9f;
    bool up = along[axis] >= 0.0f;
    int at = w.inside ? int(floor(start[axis] + enter * along[axis])) : 0;
    at = at < 0 ? 0 : (at < size[axis] ? at : size[axis] - 1);
    w.cell[axis] = at;
    w.side[axis] = up ? 1 : -1;
    w.last[axis] = up ? size[axis] - 1 : 0;
    w.delta[axis] = moves ? abs(1.0f / along[axis]) : huge;
    w.next[axis] = moves ? (float(up ? at + 1 : at) - start[axis]) / along[axis] : huge;
  }
  return w;
}

/* Moves to the next cell; returns false if the segment ends before. */
bool vtkiNextCell(VTKI_INOUT(vtkiCells) w)
{
  int axis = w.next.x <= w.next.y ? (w.next.x <= w.next.z ? 0 : 2) : (w.next.y <= w.next.z ? 1 : 2);
  bool on = w.next[axis] < w.leave && w.cell[axis] != w.last[axis];
  w.cell[axis] += w.side[axis];
  w.next[axis] += w.delta[axis];
  return on;
}

/* Returns one over the square of a segment's length, for vtkiSphereBlocks. */
float vtkiInverseSquare(vec3 along)
{
  return 1.0f / max(dot(along, along), 1.0e-30f);
}

/* Returns true if a sphere (center, radius) stands between the ends of a segment. A sphere that
 * contains an end does not count: it is the surface that the end lies on, or, where spheres
 * represent a mesh, extends beyond that. Nor does a sphere with an end on its surface, if the
 * segment leaves it, without any tolerance. Computed from the point nearest to the center: a
 * difference of squares would lose spheres that are small against their distance (Haines, Gunther,
 * Akenine-Moeller 2019, "Precision improvements for ray/sphere intersection"). */
bool vtkiSphereBlocks(vec3 start, vec3 along, float inverseSquare, vec4 sphere)
{
  vec3 away = start - vec3(sphere.x, sphere.y, sphere.z);
  float t = -dot(away, along) * inverseSquare;
  vec3 nearest = away + t * along;
  vec3 end = away + along;
  float square = sphere.w * sphere.w;
  return t > 0.0f && t < 1.0f && dot(nearest, nearest) < square && dot(away, away) > square &&
    dot(end, end) > square;
}
#endif
