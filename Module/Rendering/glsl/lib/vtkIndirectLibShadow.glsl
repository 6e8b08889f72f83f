// Receiver planes for percentage-closer shadow look-ups (Reeves, Salesin, Cook 1987).
#ifndef vtkIndirectLibShadow
#define vtkIndirectLibShadow
#include "vtkIndirectLibPortable.glsl"

/* Linear depth along the map's axis to what the depth buffer stores, [0,1]. */
float vtkiDepthToBuffer(float depth, float nearPlane, float farPlane, bool parallel)
{
  if (parallel)
  {
    return (depth - nearPlane) / (farPlane - nearPlane);
  }
  return depth > 0.0f ? farPlane * (depth - nearPlane) / (depth * (farPlane - nearPlane)) : 0.0f;
}

/* Derivative of that by linear depth: turns a length along the axis into a difference of depths. */
float vtkiDepthToBufferSlope(float depth, float nearPlane, float farPlane, bool parallel)
{
  if (parallel)
  {
    return 1.0f / (farPlane - nearPlane);
  }
  return depth > 0.0f ? farPlane * nearPlane / (depth * depth * (farPlane - nearPlane)) : 0.0f;
}

/* How a receiver's plane runs in the depth buffer: change per texel in x and y, and 1 in z, or 0 in z
 * for a plane that does not face the map. What a depth buffer stores is affine over the image of a
 * plane, so this is exact, and every texel can be compared with the plane's own depth there.
 * p: receiver in the map's view coordinates (-z forward); n: its unit normal there; texel: width of a
 * texel in tangents (perspective) or lengths (parallel). The plane n.x = n.p meets the ray through
 * tangents t at depth (n.p) / (n.(t,-1)). */
vec3 vtkiPlaneDepthGradient(
  vec3 p, vec3 n, float texel, float nearPlane, float farPlane, bool parallel)
{
  if (parallel)
  {
    float scale = n.z > 0.0f ? texel / (n.z * (farPlane - nearPlane)) : 0.0f;
    return vec3(n.x * scale, n.y * scale, n.z > 0.0f ? 1.0f : 0.0f);
  }
  // facing = depth * cosine between the normal and the way to the light
  float facing = -dot(n, p);
  float scale =
    facing > 0.0f ? farPlane * nearPlane * texel / (facing * (farPlane - nearPlane)) : 0.0f;
  return vec3(n.x * scale, n.y * scale, facing > 0.0f ? 1.0f : 0.0f);
}

/* Tent over three neighbouring texels, three texels wide at most; fraction: of the position between
 * them. Written so that three equal values come out exactly. */
float vtkiTent(float a, float b, float c, float fraction)
{
  return 0.5f * (b + (a + fraction * (c - a)));
}
#endif
