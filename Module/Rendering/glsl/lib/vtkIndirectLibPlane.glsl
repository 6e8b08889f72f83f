// The plane of the surfaces in an occupied voxel, in 16 bits: on which side of a wall a place in the
// wall's own voxels lies.
#ifndef vtkIndirectLibPlane
#define vtkIndirectLibPlane
#include "vtkIndirectLibSurface.glsl"

/* normal unit; height of the plane over the voxel's centre along it, in voxels, -1 to 1. Five bits for
 * each octahedral coordinate, so that planes along the axes are exact, six for the height: 0.02 of a
 * voxel off. 0 is no plane. */
int vtkiPackPlane(vec3 normal, float height)
{
  vec2 p = vtkiOctahedralEncode(normal);
  return int(floor(15.0f * p.x + 15.5f)) | (int(floor(15.0f * p.y + 15.5f)) << 5) |
    (int(floor(31.0f * height + 32.5f)) << 10);
}

/* Normal, and height in voxels; all 0 when there is no plane. */
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

/* From a place in a voxel (coordinates count voxels) along the plane's normal to a voxel that the plane
 * does not touch, on the side that the place is on. */
vec3 vtkiLeavePlane(vec3 place, vec4 plane)
{
  vec3 normal = vec3(plane.x, plane.y, plane.z);
  vec3 centre = vec3(floor(place.x), floor(place.y), floor(place.z)) + 0.5f;
  float height = dot(normal, place - centre) - plane.w;
  // As far as a voxel reaches along the normal, and a little for what the bits leave out.
  float clear = abs(normal.x) + abs(normal.y) + abs(normal.z) + 0.05f;
  return place + (vtkiSignNotZero(height) * clear - height) * normal;
}
#endif
