// A leaf under a split texel: with VTKI_PIXELS a pixel, otherwise a texel of a level.
#include "vtkIndirectSubsplatTexel.glsl"

// Finds the position, normal and facet normal in scene units and coordinates. Returns false if
// there is no surface to evaluate.
bool vtkiFetchLeaf(ivec2 texel, out vec3 position, out vec3 normal, out vec3 facet)
{
  ivec2 inside = min(texel, vtkiLevelSize - 1);
#ifdef VTKI_PIXELS
  vec4 surface = texelFetch(vtkiSurface, inside, 0);
  vec2 ndc = 2.0f * (vec2(texel) + 0.5f) / vec2(vtkiSize) - 1.0f;
  vec3 positionVC = vtkiReconstruct(ndc, vtkiSurfaceDepth(surface), vtkiRayOrigin, vtkiRayDirection);
  vec3 normalVC = vtkiSurfaceNormal(surface);
  vec3 facetVC = vtkiSurfaceFacet(surface);
  bool leaf = vtkiSurfaceIsLit(surface);
#else
  vec4 surface = texelFetch(vtkiLevelSurface, inside, 0);
  vec3 normalVC = vtkiOctahedralDecode(surface.xy);
  vec3 positionVC;
  vec3 facetVC;
  vtkiFindSample(inside, surface, normalVC, positionVC, facetVC);
  bool leaf = vtkiSubsplatIsSample(surface.w);
#endif
  position = (vtkiViewToScene * vec4(positionVC, 1.0f)).xyz;
  normal = mat3(vtkiViewToScene) * normalVC;
  facet = mat3(vtkiViewToScene) * facetVC;
  return leaf && texel == inside;
}
