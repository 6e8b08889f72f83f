// One bit a voxel: a column of up to 128 voxels along z in one texel of four words. A segment is
// walked from column to column; all its voxels within a column are tested at once.
#ifndef vtkIndirectLibOccupancy
#define vtkIndirectLibOccupancy
#include "vtkIndirectLibPortable.glsl"

/* Returns the lowest n bits; n may be negative or exceed 32. */
uint vtkiBitsBelow(int n)
{
  if (n <= 0)
  {
    return 0u;
  }
  return n >= 32 ? 0xffffffffu : (1u << uint(n)) - 1u;
}

/* Returns the bits first to last of a column, both included. */
uvec4 vtkiBitRange(int first, int last)
{
  return uvec4(vtkiBitsBelow(last + 1) & ~vtkiBitsBelow(first),
    vtkiBitsBelow(last - 31) & ~vtkiBitsBelow(first - 32),
    vtkiBitsBelow(last - 63) & ~vtkiBitsBelow(first - 64),
    vtkiBitsBelow(last - 95) & ~vtkiBitsBelow(first - 96));
}

bool vtkiAnyBit(uvec4 column, uvec4 range)
{
  return ((column.x & range.x) | (column.y & range.y) | (column.z & range.z) |
           (column.w & range.w)) != 0u;
}

/* Returns bit z of a column; none outside it. */
bool vtkiHasBit(uvec4 column, int z)
{
  uint lower = z < 32 ? column.x : column.y;
  uint upper = z < 96 ? column.z : column.w;
  uint word = z < 64 ? lower : upper;
  return z >= 0 && z < 128 && ((word >> uint(z & 31)) & 1u) != 0u;
}

/* State of a walk. Coordinates count voxels: voxel i extends from i to i + 1. */
struct vtkiWalk
{
  vec3 start;
  vec3 along;      // end minus start
  vec2 next;       // parameter of the next border in x and y
  vec2 delta;      // parameter from border to border
  ivec2 column;    // current
  ivec2 direction; // -1 or 1
  int remaining;   // columns after this one
  float t;         // parameter at which the column is entered
  ivec3 first;     // voxels of the two ends
  ivec3 last;
};

vtkiWalk vtkiBeginWalk(vec3 start, vec3 end)
{
  vtkiWalk w;
  w.start = start;
  w.along = end - start;
  w.first = ivec3(int(floor(start.x)), int(floor(start.y)), int(floor(start.z)));
  w.last = ivec3(int(floor(end.x)), int(floor(end.y)), int(floor(end.z)));
  w.column = ivec2(w.first.x, w.first.y);
  w.direction = ivec2(w.last.x >= w.first.x ? 1 : -1, w.last.y >= w.first.y ? 1 : -1);
  w.remaining = (w.last.x - w.first.x) * w.direction.x + (w.last.y - w.first.y) * w.direction.y;
  w.t = 0.0f;
  // An axis without a border to cross never comes next.
  float dx = abs(w.along.x);
  float dy = abs(w.along.y);
  bool crossX = w.last.x != w.first.x && dx > 0.0f;
  bool crossY = w.last.y != w.first.y && dy > 0.0f;
  float toX = w.direction.x > 0 ? float(w.first.x + 1) - start.x : start.x - float(w.first.x);
  float toY = w.direction.y > 0 ? float(w.first.y + 1) - start.y : start.y - float(w.first.y);
  w.delta = vec2(crossX ? 1.0f / dx : 2.0f, crossY ? 1.0f / dy : 2.0f);
  w.next = vec2(crossX ? toX / dx : 2.0f, crossY ? toY / dy : 2.0f);
  return w;
}

/* Returns the bits of the current column that the segment passes through, without the voxels of its
 * ends. */
uvec4 vtkiWalkBits(vtkiWalk w)
{
  float leave = w.remaining > 0 ? min(min(w.next.x, w.next.y), 1.0f) : 1.0f;
  float z0 = w.start.z + w.t * w.along.z;
  float z1 = w.start.z + leave * w.along.z;
  // Rounding may put a border's height on either side of a voxel's face: both voxels count.
  const float slack = 1.0e-4f;
  int low = int(floor(min(z0, z1) - slack));
  int high = int(floor(max(z0, z1) + slack));
  int least = w.first.z < w.last.z ? w.first.z : w.last.z;
  int most = w.first.z < w.last.z ? w.last.z : w.first.z;
  uvec4 range = vtkiBitRange(low > least ? low : least, high < most ? high : most);
  if (w.column.x == w.first.x && w.column.y == w.first.y)
  {
    range = range & ~vtkiBitRange(w.first.z, w.first.z);
  }
  if (w.column.x == w.last.x && w.column.y == w.last.y)
  {
    range = range & ~vtkiBitRange(w.last.z, w.last.z);
  }
  return range;
}

/* Moves to the next column; valid while remaining > 0. */
void vtkiAdvance(VTKI_INOUT(vtkiWalk) w)
{
  bool alongX = w.next.x <= w.next.y;
  w.t = min(alongX ? w.next.x : w.next.y, 1.0f);
  if (alongX)
  {
    w.column.x += w.direction.x;
    w.next.x = w.column.x == w.last.x ? 2.0f : w.next.x + w.delta.x;
  }
  else
  {
    w.column.y += w.direction.y;
    w.next.y = w.column.y == w.last.y ? 2.0f : w.next.y + w.delta.y;
  }
  w.remaining -= 1;
}
#endif
