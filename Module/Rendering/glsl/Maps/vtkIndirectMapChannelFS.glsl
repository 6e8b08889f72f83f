//VTK::System::Dec
//VTK::Output::Dec
// Copies one channel of a light's map as floats, its faces in a row; world units and coordinates.
#include "vtkIndirectMapTexel.glsl"
#include "vtkIndirectLibChannel.glsl"

uniform int vtkiFirstLayer;
uniform int vtkiChannel; // VTKI_MAP_CHANNEL_...
uniform float vtkiSceneScale;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 map = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_SHAPE, vtkiFirstLayer), 0);
  int texels = int(map.z + 0.5f);
  int layer = vtkiFirstLayer + pixel.x / texels;
  ivec3 at = ivec3(pixel.x % texels, pixel.y, layer);
  vec4 surface = texelFetch(vtkiMapSurface, at, 0);
  vec3 value = vec3(0.0f);
  if (vtkiChannel == VTKI_MAP_CHANNEL_DEPTH)
  {
    value = vec3(vtkiSurfaceDepth(surface) / vtkiSceneScale);
  }
  else if (vtkiChannel == VTKI_MAP_CHANNEL_NORMAL && vtkiSurfaceIsLit(surface))
  {
    value = vtkiTransformRows(layer, VTKI_MAP_TO_SCENE, vec4(vtkiSurfaceNormal(surface), 0.0f));
  }
  else if (vtkiChannel == VTKI_MAP_CHANNEL_DENSITY && vtkiSurfaceIsLit(surface))
  {
    vec4 own = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_SHAPE, layer), 0);
    bool parallel = int(own.x + 0.5f) == VTKI_MAP_PARALLEL;
    vec3 p = vtkiMapPosition(own, at.xy, vtkiSurfaceDepth(surface));
    float cosine = vtkiMapFacetCosine(own, texelFetch(vtkiMapSlope, at, 0).rg, p);
    value = vtkiMapReflectance(layer, at.xy, own, surface, p, cosine) * vtkiMapFalloff(layer, own, p) /
      (parallel ? 1.0f : vtkiSceneScale * vtkiSceneScale);
  }
  gl_FragData[0] = vec4(value, 1.0f);
}
