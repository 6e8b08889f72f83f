// Interpolates a texel or pixel from whole texels of the level above on the same surface. The
// picture uses the same weights that each light's residual is tested with.
#include "vtkIndirectSubsplatPlane.glsl"
#include "vtkIndirectGlossyState.glsl"

uniform sampler2D vtkiCoarserSurface;
uniform sampler2D vtkiCoarserLobe;
uniform ivec2 vtkiCoarserSize;
uniform float vtkiCoarserEdge; // pixels along the edge of a coarser texel

// Returns the four surrounding texels above: its own, the next along x, along y, and across.
ivec2 vtkiCoarserTexel(ivec2 texel, int i)
{
  ivec2 shift = ivec2(i & 1, i >> 1) * (2 * (texel & 1) - 1);
  return clamp((texel >> 1) + shift, ivec2(0), vtkiCoarserSize - 1);
}

// Weights of these texels, of sum one. The pixel's own texel always counts: it is whole.
vec4 vtkiCoarserWeights(ivec2 texel, vec3 position, vec3 normal, float depth, float power)
{
  vtkiTangentPlane plane = vtkiMakeTangentPlane(
    position, normal, vtkiOctahedralEncode(normal), depth, vtkiCoarserEdge);
  vec4 weights = vec4(0.5625f, 0.1875f, 0.1875f, 0.0625f);
  for (int i = 1; i < 4; ++i)
  {
    ivec2 at = vtkiCoarserTexel(texel, i);
    vec2 lobe = texelFetch(vtkiCoarserLobe, at, 0).xy;
    vec2 center = vtkiSubsplatCenter(vec2(at), vtkiCoarserEdge, vec2(vtkiSize));
    bool same = lobe == vec2(power, VTKI_GLOSSY_WHOLE) &&
      vtkiIsOnPlane(plane, center, texelFetch(vtkiCoarserSurface, at, 0));
    weights[i] = same ? weights[i] : 0.0f;
  }
  return weights / (weights.x + weights.y + weights.z + weights.w);
}
