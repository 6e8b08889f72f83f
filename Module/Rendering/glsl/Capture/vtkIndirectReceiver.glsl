// The surface at a pixel of the geometry buffer, in scene units.
#include "vtkIndirectLibSurface.glsl"

uniform sampler2D vtkiSurface;
uniform ivec2 vtkiSize;
uniform mat3 vtkiRayOrigin;
uniform mat3 vtkiRayDirection;
uniform mat4 vtkiViewToScene;

struct vtkiReceiver
{
  vec3 positionVC;
  vec3 normalVC;
  vec3 position; // scene units
  vec3 normal;   // scene coordinates
  vec3 facetVC; // normal of the drawn plane, see vtkIndirectLibSurface.glsl
  vec3 facet;   // facetVC in scene coordinates
  float depth;
};

// Returns false where no lit surface was drawn.
bool vtkiFetchReceiver(ivec2 pixel, out vtkiReceiver receiver)
{
  vec2 place = (vec2(pixel) + 0.5f) / vec2(vtkiSize);
  vec4 surface = textureLod(vtkiSurface, place, 0.0f);
  receiver.depth = vtkiSurfaceDepth(surface);
  vec2 ndc = 2.0f * place - 1.0f;
  receiver.positionVC = vtkiReconstruct(ndc, vtkiSurfaceDepth(surface), vtkiRayOrigin, vtkiRayDirection);
  receiver.normalVC = vtkiSurfaceNormal(surface);
  receiver.position = (vtkiViewToScene * vec4(receiver.positionVC, 1.0f)).xyz;
  receiver.normal = mat3(vtkiViewToScene) * receiver.normalVC;
  receiver.facetVC = vtkiSurfaceFacet(surface);
  receiver.facet = mat3(vtkiViewToScene) * receiver.facetVC;
  return vtkiSurfaceIsLit(surface);
}
