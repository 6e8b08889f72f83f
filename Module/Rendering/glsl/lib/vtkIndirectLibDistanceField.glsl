// Walks a segment through voxels with known distances to the nearest occupied voxel: each step
// leaps over the empty cube around the current voxel (sphere tracing, Hart 1996, in the chessboard
// metric, where the empty region is a cube of voxels, so that the leap skips no voxel the segment
// might meet).
#ifndef vtkIndirectLibDistanceField
#define vtkIndirectLibDistanceField
#include "vtkIndirectLibPortable.glsl"

/* State of a walk. Coordinates count voxels: voxel i extends from i to i + 1. */
struct vtkiLeap
{
  vec3 start;
  vec3 along;   // end minus start
  vec3 inverse; // one over along, 0 where along is 0
  vec3 never;   // 2 on axes without a border to cross, else 0
  vec3 side;    // -1 or 1
  ivec3 voxel;  // current voxel
  ivec3 last;   // voxel of the end
};

float vtkiInverse(float along)
{
  return abs(along) > 1.0e-9f ? 1.0f / along : 0.0f;
}

vtkiLeap vtkiBeginLeap(vec3 start, vec3 end)
{
  vtkiLeap leap;
  leap.start = start;
  leap.along = end - start;
  leap.inverse = vec3(vtkiInverse(leap.along.x), vtkiInverse(leap.along.y), vtkiInverse(leap.along.z));
  leap.never = vec3(leap.inverse.x == 0.0f ? 2.0f : 0.0f, leap.inverse.y == 0.0f ? 2.0f : 0.0f,
    leap.inverse.z == 0.0f ? 2.0f : 0.0f);
  leap.side = vec3(leap.along.x < 0.0f ? -1.0f : 1.0f, leap.along.y < 0.0f ? -1.0f : 1.0f,
    leap.along.z < 0.0f ? -1.0f : 1.0f);
  leap.voxel = ivec3(int(floor(start.x)), int(floor(start.y)), int(floor(start.z)));
  leap.last = ivec3(int(floor(end.x)), int(floor(end.y)), int(floor(end.z)));
  return leap;
}

int vtkiWithin(int value, int middle, int reach)
{
  int upper = value < middle + reach ? value : middle + reach;
  return upper > middle - reach ? upper : middle - reach;
}

/* Moves to the first voxel beyond the cube that extends freeVoxels - 1 voxels to each side,
 * freeVoxels at least 1; returns false if the segment ends before. The new voxel shares a face with
 * one of the cube in spite of rounding, so that no walk passes through a wall of connected
 * voxels. */
bool vtkiLeapOn(VTKI_INOUT(vtkiLeap) leap, int freeVoxels)
{
  float reach = float(freeVoxels) - 0.5f;
  vec3 here = vec3(float(leap.voxel.x), float(leap.voxel.y), float(leap.voxel.z)) + 0.5f;
  vec3 t = (here - leap.start + reach * leap.side) * leap.inverse + leap.never;
  float next = min(min(t.x, t.y), t.z);
  vec3 at = leap.start + next * leap.along;
  bool exitX = t.x <= next;
  bool exitY = !exitX && t.y <= next;
  bool exitZ = !exitX && !exitY;
  int x = vtkiWithin(int(floor(at.x)), leap.voxel.x, freeVoxels - 1);
  int y = vtkiWithin(int(floor(at.y)), leap.voxel.y, freeVoxels - 1);
  int z = vtkiWithin(int(floor(at.z)), leap.voxel.z, freeVoxels - 1);
  leap.voxel = ivec3(exitX ? leap.voxel.x + int(leap.side.x) * freeVoxels : x,
    exitY ? leap.voxel.y + int(leap.side.y) * freeVoxels : y,
    exitZ ? leap.voxel.z + int(leap.side.z) * freeVoxels : z);
  return next < 1.0f;
}

/* Returns the height over a surface, in voxels, that clears the surface's own voxels: voxels
 * touched by a plane extend from it by at most the sum of the normal's components. */
float vtkiClearHeight(vec3 normal)
{
  return abs(normal.x) + abs(normal.y) + abs(normal.z) + 1.0e-3f;
}

/* Offsets for the search of an empty voxel if the voxel above a surface belongs to another surface:
 * eight directions along the surface, half a voxel farther with each turn. */
const int VTKI_ASIDE = 24;
vec3 vtkiAside(int i, vec3 normal)
{
  vec3 helper = abs(normal.x) < 0.5f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
  vec3 tangent = cross(helper, normal);
  tangent = tangent * (1.0f / sqrt(max(dot(tangent, tangent), 1.0e-12f)));
  vec3 bitangent = cross(normal, tangent);
  int way = i - (i / 8) * 8;
  float reach = 0.5f * float(i / 8 + 1);
  // The first four ways go along the two axes, the other four are diagonal.
  float along = way < 4 ? (way == 0 ? 1.0f : (way == 1 ? -1.0f : 0.0f)) : (way < 6 ? 1.0f : -1.0f);
  float across = way < 4 ? (way == 2 ? 1.0f : (way == 3 ? -1.0f : 0.0f))
                         : (way == 4 || way == 6 ? 1.0f : -1.0f);
  return (reach * along) * tangent + (reach * across) * bitangent;
}

/* Moves an end of a segment along its own plane until it clears the plane of the other end, too:
 * near the edge where walls meet, the segment between them is nearly parallel to one of them.
 * place, otherNormal, height: the other surface, and its clear height. */
vec3 vtkiClearOf(vec3 end, vec3 normal, vec3 place, vec3 otherNormal, float height)
{
  float c = dot(normal, otherNormal);
  float lacking = max(height - dot(otherNormal, end - place), 0.0f);
  // Planes that nearly face each other have no such position nearby.
  return end + (lacking / max(1.0f - c * c, 0.25f)) * (otherNormal - c * normal);
}
#endif
