// A map's texel as a virtual light. The table has one row a layer:
//   0-2 face view coordinates to scene, 3 (projection, half width, texels, first layer of the light),
//   4 (colour times intensity, light index), 5-7 scene to face view coordinates.
#include "vtkIndirectLibSurface.glsl"
#include "vtkIndirectLibLightMap.glsl"

uniform sampler2D vtkiMapTable;
uniform sampler2DArray vtkiMapDensity;
uniform sampler2DArray vtkiMapSurface;
uniform sampler2DArray vtkiMapCosine;

struct vtkiVirtualLight
{
  vec3 position; // scene units
  vec3 normal;
  float area;       // of one texel, scene units squared
  vec3 densityArea; // reflected density times area of one texel
  float source;     // light index
};

vec3 vtkiTransformRows(int layer, int row, vec4 v)
{
  return vec3(dot(texelFetch(vtkiMapTable, ivec2(row, layer), 0), v),
    dot(texelFetch(vtkiMapTable, ivec2(row + 1, layer), 0), v),
    dot(texelFetch(vtkiMapTable, ivec2(row + 2, layer), 0), v));
}

// Returns false where the map holds no surface.
bool vtkiVirtualLightFromTexel(int layer, ivec2 texel, out vtkiVirtualLight light)
{
  vec4 map = texelFetch(vtkiMapTable, ivec2(3, layer), 0);
  vec4 power = texelFetch(vtkiMapTable, ivec2(4, layer), 0);
  vec4 surface = texelFetch(vtkiMapSurface, ivec3(texel, layer), 0);
  vec3 density = texelFetch(vtkiMapDensity, ivec3(texel, layer), 0).rgb;
  float cosine = texelFetch(vtkiMapCosine, ivec3(texel, layer), 0).r;
  light.position = vec3(0.0f);
  light.normal = vec3(0.0f, 0.0f, 1.0f);
  light.area = 1.0f;
  light.densityArea = vec3(0.0f);
  light.source = power.w;
  if (!vtkiSurfaceIsLit(surface))
  {
    return false;
  }
  float texelSize = 2.0f * map.y / map.z;
  vec2 centre = (vec2(texel) + 0.5f) * texelSize - map.y;
  float depth = surface.z;
  bool parallel = int(map.x + 0.5f) == VTKI_MAP_PARALLEL;
  vec3 p = parallel ? vec3(centre, -depth) : vec3(centre * depth, -depth);
  float footprint = parallel ? texelSize * texelSize : vtkiTexelSolidAngle(centre, texelSize);
  light.position = vtkiTransformRows(layer, 0, vec4(p, 1.0f));
  light.normal = vtkiTransformRows(layer, 0, vec4(vtkiSurfaceNormal(surface), 0.0f));
  light.area = footprint * (parallel ? 1.0f : dot(p, p)) / cosine;
  light.densityArea = density * footprint * power.rgb;
  return true;
}
