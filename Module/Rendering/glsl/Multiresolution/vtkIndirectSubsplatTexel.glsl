// A texel of a level and the values written for it.
#include "vtkIndirectSubsplatPlane.glsl"
#include "vtkIndirectSubsplatLights.glsl"
#include "vtkIndirectLibReceiverGrid.glsl"

uniform sampler2D vtkiSurface; // surface of the pixels
uniform sampler2D vtkiLevelSurface;
uniform ivec2 vtkiLevelSize;
uniform float vtkiEdge; // pixels along a texel's edge
uniform mat4 vtkiViewToScene;
uniform float vtkiStorageScale;

vec3 vtkiTexelPosition(ivec2 texel, float depth)
{
  vec2 center = vtkiSubsplatCenter(vec2(texel), vtkiEdge, vec2(vtkiSize));
  return vtkiReconstruct(center, depth, vtkiRayOrigin, vtkiRayDirection);
}

// Returns the pixel in a texel's middle.
ivec2 vtkiTexelPixel(ivec2 texel)
{
  return min(ivec2(vtkiEdge * (vec2(texel) + 0.5f)), vtkiSize - 1);
}

// Returns the facet's normal in the middle of a texel, if that is on the texel's surface; levels
// store only mean normals.
vec3 vtkiTexelFacet(ivec2 texel, vec3 normalVC)
{
  vec2 center = vtkiSubsplatCenter(vec2(texel), vtkiEdge, vec2(vtkiSize));
  vec4 surface = textureLod(vtkiSurface, 0.5f * center + 0.5f, 0.0f);
  bool same = vtkiSurfaceIsLit(surface) &&
    dot(vtkiSurfaceNormal(surface), normalVC) >= VTKI_INTERPOLATION_COSINE;
  return same ? vtkiSurfaceFacet(surface) : normalVC;
}

// The sum over the lights as stored; the vector is in view coordinates, as receivers' normals are.
void vtkiEvaluateStored(
  vec3 positionVC, vec3 normalVC, vec3 facetVC, ivec2 pixel, bool wanted, out vec3 irradiance, out vec3 vectorIrradiance)
{
  vec3 position = (vtkiViewToScene * vec4(positionVC, 1.0f)).xyz;
  vtkiEvaluateSubsplat(position, mat3(vtkiViewToScene) * normalVC, mat3(vtkiViewToScene) * facetVC, pixel, wanted,
    irradiance, vectorIrradiance);
  irradiance *= vtkiStorageScale;
  vectorIrradiance = (vectorIrradiance * mat3(vtkiViewToScene)) * vtkiStorageScale;
}

// Returns true if the texel and its eight neighbours are samples of one surface.
bool vtkiIsInsideSurface(ivec2 texel, vec4 surface, vec3 position, vec3 normal)
{
  bool inside = surface.w == VTKI_SUBSPLAT_WHOLE || surface.w == VTKI_SUBSPLAT_PARTED;
  vtkiTangentPlane plane =
    vtkiMakeTangentPlane(position, normal, surface.xy, surface.z, vtkiEdge);
  for (int i = 0; i < 9; ++i)
  {
    vec2 at = clamp(vec2(texel) + vec2(i % 3 - 1, i / 3 - 1), vec2(0.0f), vec2(vtkiLevelSize - 1));
    vec4 other = textureLod(vtkiLevelSurface, (at + 0.5f) / vec2(vtkiLevelSize), 0.0f);
    inside = inside && vtkiIsOnPlane(plane, vtkiSubsplatCenter(at, vtkiEdge, vec2(vtkiSize)), other) &&
      vtkiSubsplatIsSample(other.w);
  }
  return inside;
}
