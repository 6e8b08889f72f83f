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
  return ivec2(vtkiPixelInTexel(texel, vtkiEdge, 0));
}

// Finds the position and the facet's normal at which a texel is evaluated: on its plane in the middle,
// or at a pixel, see vtkIndirectSubsplatJoin.glsl. Levels store only mean normals: normalVC.
void vtkiFindSample(ivec2 texel, vec4 levelSurface, vec3 normalVC, out vec3 positionVC, out vec3 facetVC)
{
  int number = vtkiSubsplatPixel(levelSurface.w);
  vec2 place = vtkiPixelInTexel(texel, vtkiEdge, number) / vec2(vtkiSize);
  vec4 surface = textureLod(vtkiSurface, place, 0.0f);
  vec2 center = vtkiSubsplatCenter(vec2(texel), vtkiEdge, vec2(vtkiSize));
  vec2 ndc = number > 0 ? 2.0f * place - 1.0f : center;
  float depth = number > 0 ? vtkiSurfaceDepth(surface) : levelSurface.z;
  positionVC = vtkiReconstruct(ndc, depth, vtkiRayOrigin, vtkiRayDirection);
  bool same = vtkiSurfaceIsLit(surface) &&
    dot(vtkiSurfaceNormal(surface), normalVC) >= VTKI_INTERPOLATION_COSINE;
  facetVC = same ? vtkiSurfaceFacet(surface) : normalVC;
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
  float state = vtkiSubsplatState(surface.w);
  bool inside = state == VTKI_SUBSPLAT_WHOLE || state == VTKI_SUBSPLAT_PARTED;
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
