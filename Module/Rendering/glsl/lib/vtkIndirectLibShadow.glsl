// Depth offsets for percentage-closer shadow look-ups (Reeves, Salesin, Cook 1987).
#ifndef vtkIndirectLibShadow
#define vtkIndirectLibShadow
#include "vtkIndirectLibPortable.glsl"

/* How much nearer to the light a receiver's own plane may stand in a texel that the filter reaches.
 * p: receiver in the map's view coordinates (-z forward); n: its unit normal there;
 * reach: filter radius, in tangents (perspective) or lengths (parallel).
 * The plane n.x = n.p meets the ray through tangents t at depth (n.p) / (n.(t,-1)); the offset is the
 * difference at the far corner of the filter. Negative when the plane is so oblique that the filter
 * reaches its horizon: it cannot be decided then, and such a receiver gets next to no light. */
float vtkiPlaneDepthOffset(vec3 p, vec3 n, float reach, bool parallel)
{
  float spread = (abs(n.x) + abs(n.y)) * reach;
  if (parallel)
  {
    return abs(n.z) > 0.0f ? spread / abs(n.z) : -1.0f;
  }
  float depth = -p.z;
  float facing = depth > 0.0f ? abs(dot(n, p)) / depth : 0.0f;
  return facing > spread ? depth * spread / (facing - spread) : -1.0f;
}

/* Linear depth along the map's axis to what the depth buffer stores, [0,1]. */
float vtkiDepthToBuffer(float depth, float nearPlane, float farPlane, bool parallel)
{
  if (parallel)
  {
    return (depth - nearPlane) / (farPlane - nearPlane);
  }
  return depth > 0.0f ? farPlane * (depth - nearPlane) / (depth * (farPlane - nearPlane)) : 0.0f;
}
#endif
