// Tests that samples lie on the same surface.
#include "vtkIndirectSubsplat.glsl"

uniform float vtkiSamePlane;  // fraction of the texels' edge
uniform float vtkiSameNormal; // difference of octahedral coordinates

// A tangent plane for the test of samples: their distance is affine in place and depth.
struct vtkiTangentPlane
{
  vec3 alongOrigin;
  vec3 alongDirection;
  float offset;
  vec2 octahedral;
  float tolerance;
};

// octahedral: the normal's coordinates; depth: of the position; edge: of the samples' texels.
vtkiTangentPlane vtkiMakeTangentPlane(
  vec3 position, vec3 normal, vec2 octahedral, float depth, float edge)
{
  return vtkiTangentPlane(normal * vtkiRayOrigin, normal * vtkiRayDirection, dot(normal, position),
    octahedral, vtkiSamePlane * edge * vtkiPixelWidth(depth));
}

float vtkiPlaneDistance(vtkiTangentPlane plane, vec2 center, vec4 surface)
{
  vec3 ray = vec3(center, 1.0f);
  return dot(plane.alongOrigin, ray) + surface.z * dot(plane.alongDirection, ray) - plane.offset;
}

bool vtkiIsOnPlane(vtkiTangentPlane plane, vec2 center, vec4 surface)
{
  float distance = vtkiPlaneDistance(plane, center, surface);
  vec2 turn = surface.xy - plane.octahedral;
  return abs(distance) <= plane.tolerance && dot(turn, turn) <= vtkiSameNormal * vtkiSameNormal;
}

// Returns a weight that falls with the distance and the turn from the plane, both in units of their
// tolerances; one at a texel without a surface, which has no place and no tolerance.
float vtkiNearness(vtkiTangentPlane plane, vec2 center, vec4 surface)
{
  float distance = vtkiPlaneDistance(plane, center, surface);
  vec2 turn = surface.xy - plane.octahedral;
  float apart = distance * distance / (plane.tolerance * plane.tolerance) +
    dot(turn, turn) / (vtkiSameNormal * vtkiSameNormal);
  return plane.tolerance > 0.0f ? 1.0f / ((1.0f + apart) * (1.0f + apart)) : 1.0f;
}
