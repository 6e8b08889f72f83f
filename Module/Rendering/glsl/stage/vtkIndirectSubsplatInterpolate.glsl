// Illumination at a texel or pixel from the level above.
#include "vtkIndirectSubsplatPlane.glsl"

uniform sampler2D vtkiCoarserSurface;
uniform sampler2D vtkiCoarserIrradiance; // irradiance; whether there is any
uniform sampler2D vtkiCoarserVector;     // luminance of the vector irradiance
uniform ivec2 vtkiCoarserSize;
uniform float vtkiCoarserEdge; // pixels along the edge of a coarser texel

// Weighs the coarser texels around with bilinear weights, those on the plane only. trusted: the own
// one counts in any case. Returns the sum of the weights.
float vtkiInterpolateSubsplat(ivec2 texel, vtkiTangentPlane plane, bool trusted,
  out vec3 irradiance, out vec3 vectorIrradiance)
{
  ivec2 own = texel >> 1;
  ivec2 step = 2 * (texel & 1) - 1;
  irradiance = vec3(0.0f);
  vectorIrradiance = vec3(0.0f);
  float weights = 0.0f;
  for (int i = 0; i < 4; ++i)
  {
    ivec2 shift = ivec2(i & 1, i >> 1);
    ivec2 at = clamp(own + shift * step, ivec2(0), vtkiCoarserSize - 1);
    vec4 sampled = texelFetch(vtkiCoarserIrradiance, at, 0);
    vec2 center = vtkiSubsplatCenter(vec2(at), vtkiCoarserEdge, vec2(vtkiSize));
    bool same = vtkiIsOnPlane(plane, center, texelFetch(vtkiCoarserSurface, at, 0));
    bool counts = sampled.a > 0.0f && (same || (trusted && i == 0));
    float weight = (shift.x == 0 ? 0.75f : 0.25f) * (shift.y == 0 ? 0.75f : 0.25f);
    weight = counts ? weight : 0.0f;
    irradiance += weight * sampled.rgb;
    vectorIrradiance += weight * texelFetch(vtkiCoarserVector, at, 0).xyz;
    weights += weight;
  }
  float scale = weights > 0.0f ? 1.0f / weights : 0.0f;
  irradiance *= scale;
  vectorIrradiance *= scale;
  return weights;
}
