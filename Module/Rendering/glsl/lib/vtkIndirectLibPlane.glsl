// The plane of the surfaces in an occupied voxel, in 16 bits: tells on which side of a wall a
// position in the wall's own voxels lies.
#ifndef vtkIndirectLibPlane
#define vtkIndirectLibPlane
#include "vtkIndirectLibSurface.glsl"

/* normal unit; height of the plane over the voxel's centre along it, in voxels, -1 to 1. Five bits
 * for each octahedral coordinate, so that planes along the axes are exact; six for the height, with
 * an error of 0.02 of a voxel. 0 means no plane. */
int vtkiPackPlane(vec3 normal, float height)
{
  vec2 p = vtkiOctahedralEncode(normal);
  return int(floor(15.0f * p.x + 15.5f)) | (int(floor(15.0f * p.y + 15.5f)) << 5) |
    (int(floor(31.0f * height + 32.5f)) << 10);
}

/* Returns the normal, and height in voxels; all 0 if there is no plane. */
vec4 vtkiUnpackPlane(int code)
{
  if (code == 0)
  {
    return vec4(0.0f);
  }
  vec3 normal = vtkiOctahedralDecode(
    vec2(float(code & 31) - 15.0f, float((code >> 5) & 31) - 15.0f) / 15.0f);
  return vec4(normal.x, normal.y, normal.z, float((code >> 10) - 32) / 31.0f);
}

/* Moves a position in a voxel (coordinates count voxels) along the plane's normal to a voxel that
 * the plane does not touch, on the position's side. */
vec3 vtkiLeavePlane(vec3 place, vec4 plane)
{
  vec3 normal = vec3(plane.x, plane.y, plane.z);
  vec3 centre = vec3(floor(place.x), floor(place.y), floor(place.z)) + 0.5f;
  float height = dot(normal, place - centre) - plane.w;
  // Extent of a voxel along the normal, with a margin for the rounding of the packed plane.
  float clear = abs(normal.x) + abs(normal.y) + abs(normal.z) + 0.05f;
  return place + (vtkiSignNotZero(height) * clear - height) * normal;
}
#endif
