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

// A facet's normal of this length stands for a surface that goes on beyond its end, where a sample
// may lie: vtkiEndsInPerspectiveTile then finds no end.
const float VTKI_ENDLESS_FACET = 0.001f;

// Facets that are turned more from their shading normal than this belong to a mesh of few facets,
// whose samples must stand before the curved surface to be lit where their normals say so.
const float VTKI_FINE_FACET_COSINE = 0.95f;

// Moves a texel's sample along its ray to the facet in the texel's middle, if that facet is on the
// sample's surface and of a fine mesh, and returns the facet's normal: levels store mean normals,
// and their samples stand before curved surfaces, where depth maps show something else. The
// background in the texel's middle makes the facet an endless one.
vec3 vtkiPlaceSample(ivec2 texel, vec3 normalVC, inout vec3 positionVC)
{
  const float farthest = 16.0f; // move in pixel widths
  vec2 center = vtkiSubsplatCenter(vec2(texel), vtkiEdge, vec2(vtkiSize));
  vec2 pixel = floor(0.5f * (center + 1.0f) * vec2(vtkiSize)) + 0.5f;
  vec4 surface = textureLod(vtkiSurface, pixel / vec2(vtkiSize), 0.0f);
  vec3 place = vtkiReconstruct(2.0f * pixel / vec2(vtkiSize) - 1.0f, vtkiSurfaceDepth(surface),
    vtkiRayOrigin, vtkiRayDirection);
  float depth = -positionVC.z;
  float width = vtkiPixelWidth(depth);
  bool lit = vtkiSurfaceIsLit(surface);
  vec3 shading = vtkiSurfaceNormal(surface);
  bool same = lit && dot(shading, normalVC) >= VTKI_INTERPOLATION_COSINE;
  vec3 facet = same ? vtkiSurfaceFacet(surface) : (lit ? 1.0f : VTKI_ENDLESS_FACET) * normalVC;
  bool moves = same && dot(facet, shading) >= VTKI_FINE_FACET_COSINE &&
    abs(dot(normalVC, place - positionVC)) <= vtkiSamePlane * vtkiEdge * width;
  float onFacet = vtkiPlaneDepth(facet, place, vtkiRayOrigin * vec3(center, 1.0f),
    vtkiRayDirection * vec3(center, 1.0f), depth - farthest * width, depth + farthest * width);
  positionVC = vtkiReconstruct(center, moves ? onFacet : depth, vtkiRayOrigin, vtkiRayDirection);
  return facet;
}

// The sum over the lights as stored; the vector is in view coordinates, as receivers' normals are.
void vtkiEvaluateStored(
  vec3 positionVC, vec3 normalVC, vec3 facetVC, bool wanted, out vec3 irradiance, out vec3 vectorIrradiance)
{
  vec3 position = (vtkiViewToScene * vec4(positionVC, 1.0f)).xyz;
  vtkiEvaluateSubsplat(position, mat3(vtkiViewToScene) * normalVC, mat3(vtkiViewToScene) * facetVC, wanted,
    irradiance, vectorIrradiance);
  irradiance *= vtkiStorageScale;
  vectorIrradiance = (vectorIrradiance * mat3(vtkiViewToScene)) * vtkiStorageScale;
}

// True if the texel and its eight neighbours are samples of one surface.
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
