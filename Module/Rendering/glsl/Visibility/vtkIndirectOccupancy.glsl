// Tests a segment between two points for occlusion with the bits of the scene's voxels.
#include "vtkIndirectLibOccupancy.glsl"

uniform usampler2D vtkiOccupancy;  // one texel a column of voxels
uniform vec4 vtkiOccupancyOrigin;  // scene units; voxels per scene unit
uniform vec3 vtkiOccupancySize;    // voxels

vec3 vtkiToVoxels(vec3 position)
{
  return (position - vtkiOccupancyOrigin.xyz) * vtkiOccupancyOrigin.w;
}

// A look-up at a texel's centre is exact, and in software faster than a fetch.
uvec4 vtkiFetchColumn(ivec2 at)
{
  return textureLod(vtkiOccupancy, (vec2(at) + 0.5f) / vtkiOccupancySize.xy, 0.0f);
}

bool vtkiIsOccupied(ivec3 voxel)
{
  ivec2 at = clamp(voxel.xy, ivec2(0), ivec2(vtkiOccupancySize.xy) - 1);
  return vtkiHasBit(vtkiFetchColumn(at), voxel.z) && voxel.xy == at;
}

// Returns true if the segment between two points (voxel coordinates) meets no occupied voxel
// besides those of its ends. With test false no voxel is looked up, which a branch around the call
// would not save.
bool vtkiIsFree(vec3 start, vec3 end, bool test)
{
  vtkiWalk walk = vtkiBeginWalk(start, end);
  bool free = true;
  int count = test ? walk.remaining : -1;
  for (int i = 0; i <= count; ++i)
  {
    ivec2 at = clamp(walk.column, ivec2(0), ivec2(vtkiOccupancySize.xy) - 1);
    if (walk.column == at && vtkiAnyBit(vtkiFetchColumn(at), vtkiWalkBits(walk)))
    {
      free = false;
      break;
    }
    vtkiAdvance(walk);
  }
  return free;
}
