// A segment through voxels whose distances to the nearest occupied one are known: it leaps over the
// empty cube around each voxel that it stops in (sphere tracing, Hart 1996, in the chessboard metric,
// where the empty region is a cube of voxels and nothing is skipped that it might meet).
#ifndef vtkIndirectLibDistanceField
#define vtkIndirectLibDistanceField
#include "vtkIndirectLibPortable.glsl"

/* Where a segment is. Coordinates count voxels: voxel i reaches from i to i + 1. */
struct vtkiLeap
{
  vec3 start;
  vec3 along;   // end minus start
  vec3 inverse; // of along, 0 where that is 0
  vec3 never;   // 2 on axes that have no border to cross, else 0
  vec3 side;    // -1 or 1
  ivec3 voxel;  // now
  ivec3 last;   // of the end
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

/* To the first voxel beyond the cube that reaches freeVoxels - 1 voxels to each side, freeVoxels at
 * least 1; returns false when the segment ends before. The new voxel shares a face with one of the
 * cube however numbers round, so that no chain of voxels gets through a wall. */
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

/* Where a point on a surface, in voxels, is out of reach of that surface's own voxels: those that a
 * plane touches reach no farther from it than the sum of the normal's components. */
float vtkiClearHeight(vec3 normal)
{
  return abs(normal.x) + abs(normal.y) + abs(normal.z) + 1.0e-3f;
}

/* Where to look for an empty voxel when the place above a surface is in another surface's: beside it,
 * in eight directions, half a voxel farther each time around. */
const int VTKI_ASIDE = 24;
vec3 vtkiAside(int i, vec3 normal)
{
  vec3 helper = abs(normal.x) < 0.5f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
  vec3 tangent = cross(helper, normal);
  tangent = tangent * (1.0f / sqrt(max(dot(tangent, tangent), 1.0e-12f)));
  vec3 bitangent = cross(normal, tangent);
  int way = i - (i / 8) * 8;
  float reach = 0.5f * float(i / 8 + 1);
  // Four along the two, then four between them.
  float along = way < 4 ? (way == 0 ? 1.0f : (way == 1 ? -1.0f : 0.0f)) : (way < 6 ? 1.0f : -1.0f);
  float across = way < 4 ? (way == 2 ? 1.0f : (way == 3 ? -1.0f : 0.0f))
                         : (way == 4 || way == 6 ? 1.0f : -1.0f);
  return (reach * along) * tangent + (reach * across) * bitangent;
}

/* Moves an end of a segment until it is clear of the other end's plane too, within its own: near the
 * edge where walls meet, the way between them is parallel to one of them and beside it. place,
 * otherNormal, height: the other surface, and how far above it is clear. */
vec3 vtkiClearOf(vec3 end, vec3 normal, vec3 place, vec3 otherNormal, float height)
{
  float c = dot(normal, otherNormal);
  float lacking = max(height - dot(otherNormal, end - place), 0.0f);
  // Planes that nearly face each other leave no such place nearby.
  return end + (lacking / max(1.0f - c * c, 0.25f)) * (otherNormal - c * normal);
}
#endif
