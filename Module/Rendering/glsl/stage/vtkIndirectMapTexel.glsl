// A map's texel as a virtual light. The table has one row a layer:
//   0-2 face view coordinates to scene, 3 (projection, half width, texels, cone exponent),
//   4 (colour times intensity, light index), 5-7 scene to face view coordinates,
//   8 (attenuation for scene units, cosine of the cone or -2), 9 (direction of the light, 0).
#include "vtkIndirectLibSurface.glsl"
#include "vtkIndirectLibLightMap.glsl"

uniform sampler2D vtkiMapTable;
uniform sampler2DArray vtkiMapReflectance;
uniform sampler2DArray vtkiMapSurface;
uniform sampler2DArray vtkiMapCosine;

// Position of a texel's surface in its face's view coordinates.
vec3 vtkiMapPosition(vec4 map, ivec2 texel, float depth)
{
  vec2 centre = (vec2(texel) + 0.5f) * (2.0f * map.y / map.z) - map.y;
  return int(map.x + 0.5f) == VTKI_MAP_PARALLEL ? vec3(centre, -depth)
                                                : vec3(centre * depth, -depth);
}

// att(d) d^2 cone at a place in a face's view coordinates, what makes reflected density of the map's
// reflectance; 1 for directional lights.
float vtkiMapFalloff(int layer, vec4 map, vec3 p)
{
  if (int(map.x + 0.5f) == VTKI_MAP_PARALLEL)
  {
    return 1.0f;
  }
  vec4 falloff = texelFetch(vtkiMapTable, ivec2(8, layer), 0);
  vec3 axis = texelFetch(vtkiMapTable, ivec2(9, layer), 0).xyz;
  float d = length(p);
  return d > 0.0f ? vtkiAttenuationTimesDistance2(falloff.xyz, d) *
      vtkiConeFactor(dot(p, axis) / d, falloff.w, map.w)
                  : 0.0f;
}

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
  vec3 reflectance = texelFetch(vtkiMapReflectance, ivec3(texel, layer), 0).rgb;
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
  bool parallel = int(map.x + 0.5f) == VTKI_MAP_PARALLEL;
  vec3 p = vtkiMapPosition(map, texel, surface.z);
  float footprint = parallel
    ? texelSize * texelSize
    : vtkiTexelSolidAngle((vec2(texel) + 0.5f) * texelSize - map.y, texelSize);
  light.position = vtkiTransformRows(layer, 0, vec4(p, 1.0f));
  light.normal = vtkiTransformRows(layer, 0, vec4(vtkiSurfaceNormal(surface), 0.0f));
  light.area = footprint * (parallel ? 1.0f : dot(p, p)) / cosine;
  light.densityArea =
    reflectance * (vtkiMapFalloff(layer, map, p) * footprint) * power.rgb;
  return true;
}
