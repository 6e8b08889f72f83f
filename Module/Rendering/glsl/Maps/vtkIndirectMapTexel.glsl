// Makes a virtual light of a map's texel. The table has one row a layer; see
// vtkIndirectLibTable.glsl.
#include "vtkIndirectLibSurface.glsl"
#include "vtkIndirectLibLightMap.glsl"
#include "vtkIndirectLibTable.glsl"

uniform sampler2D vtkiMapTable;
uniform sampler2DArray vtkiMapAlbedo;
uniform sampler2DArray vtkiMapSurface;
uniform sampler2DArray vtkiMapSlope;

// Far below the least cosine that a map's texel can have; keeps divisions defined.
const float VTKI_COSINE_MIN = 1.0e-6f;

// Returns the position of a texel's surface in its face's view coordinates.
vec3 vtkiMapPosition(vec4 map, ivec2 texel, float depth)
{
  vec2 centre = (vec2(texel) + 0.5f) * (2.0f * map.y / map.z) - map.y;
  return int(map.x + 0.5f) == VTKI_MAP_PARALLEL ? vec3(centre, -depth)
                                                : vec3(centre * depth, -depth);
}

// att(d) d^2 cone at a position in a face's view coordinates, the factor between the map's
// reflectance and reflected density; 1 for directional lights.
float vtkiMapFalloff(int layer, vec4 map, vec3 p)
{
  if (int(map.x + 0.5f) == VTKI_MAP_PARALLEL)
  {
    return 1.0f;
  }
  vec4 falloff = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_FALLOFF, layer), 0);
  vec3 axis = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_AXIS, layer), 0).xyz;
  float d = length(p);
  float along = dot(p, axis);
  vec3 across = cross(p, axis);
  // Compares tangents: the cosine of a narrow cone rounds to one.
  if (!(d > 0.0f) || (falloff.w >= 0.0f &&
    (along <= 0.0f || dot(across, across) > falloff.w * along * along)))
  {
    return 0.0f;
  }
  return vtkiAttenuationTimesDistance2(falloff.xyz, d) *
    vtkiConeFactor(along / d, falloff.w < 0.0f ? -2.0f : -1.0f, map.w);
}

// Cosine at the facet's own normal, from the slope of its depth (see vtkiDepthSlope). The plane
// n.(d t, -d) = c has inverse depth n.(t, -1) / c, with gradient n.xy / c over tangents t.
// One texel may not cover more depth than the scene has.
float vtkiMapFacetCosine(vec4 map, vec2 slope, vec3 p)
{
  float texelSize = 2.0f * map.y / map.z;
  if (int(map.x + 0.5f) == VTKI_MAP_PARALLEL)
  {
    return max(inversesqrt(1.0f + dot(slope, slope)), texelSize);
  }
  vec2 tangent = p.z < 0.0f ? p.xy / -p.z : vec2(0.0f);
  float across = 1.0f - dot(slope, tangent);
  float cosine =
    inversesqrt(max((dot(slope, slope) + across * across) * (1.0f + dot(tangent, tangent)), 1.0f));
  return max(cosine, max(length(p) * texelSize, VTKI_COSINE_MIN));
}

// This is the least squared sine of the angle between a facet and its shading normal; the error of
// slopes of eleven bits is smaller.
const float VTKI_MAP_FACET_SINE2 = 1.0e-5f;
// Slopes are differences of depths, which have a few roundings of a float, over texels: those of
// narrow cones are unreliable. Twice that error.
const float VTKI_MAP_SLOPE_ERROR = 1.0e-6f;

// Returns the normal of the facet at a texel, in the face's view coordinates: the facet sends,
// whichever normal lights it. See vtkiMapFacetCosine.
vec3 vtkiMapFacet(vec4 map, vec4 surface, vec2 slope, vec3 p)
{
  vec2 tangent = p.z < 0.0f ? p.xy / -p.z : vec2(0.0f);
  vec3 facet = int(map.x + 0.5f) == VTKI_MAP_PARALLEL ? vec3(slope, 1.0f)
                                                      : vec3(-slope, 1.0f - dot(slope, tangent));
  facet *= inversesqrt(max(dot(facet, facet), 1.0e-30f));
  vec3 normal = vtkiSurfaceNormal(surface);
  vec3 across = cross(facet, normal);
  float error = VTKI_MAP_SLOPE_ERROR * map.z / (2.0f * map.y);
  return dot(across, across) > max(VTKI_MAP_FACET_SINE2, error * error) ? facet : normal;
}

// Returns the albedo times the ratio of the cosines at the shading and the facet's normal.
vec3 vtkiMapReflectance(int layer, ivec2 texel, vec4 map, vec4 surface, vec3 p, float facetCosine)
{
  bool parallel = int(map.x + 0.5f) == VTKI_MAP_PARALLEL;
  vec3 toLight = parallel ? vec3(0.0f, 0.0f, 1.0f) : -p / max(length(p), VTKI_COSINE_MIN * facetCosine);
  return texelFetch(vtkiMapAlbedo, ivec3(texel, layer), 0).rgb *
    vtkiCosineRatio(dot(vtkiSurfaceNormal(surface), toLight), facetCosine, facetCosine);
}

struct vtkiVirtualLight
{
  vec3 position; // scene units
  vec3 normal;
  float area;       // area of one texel, scene units squared
  vec3 reflected;   // densityArea without the light's colour and intensity
  vec3 densityArea; // reflected density times area of one texel
  float source;     // light index
};

vec3 vtkiTransformRows(int layer, int row, vec4 v)
{
  return vec3(dot(texelFetch(vtkiMapTable, ivec2(row, layer), 0), v),
    dot(texelFetch(vtkiMapTable, ivec2(row + 1, layer), 0), v),
    dot(texelFetch(vtkiMapTable, ivec2(row + 2, layer), 0), v));
}

// Returns false if the map holds no surface.
bool vtkiVirtualLightFromTexel(int layer, ivec2 texel, out vtkiVirtualLight light)
{
  vec4 map = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_SHAPE, layer), 0);
  vec4 power = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_LIGHT, layer), 0);
  vec4 surface = texelFetch(vtkiMapSurface, ivec3(texel, layer), 0);
  light.position = vec3(0.0f);
  light.normal = vec3(0.0f, 0.0f, 1.0f);
  light.area = 1.0f;
  light.reflected = vec3(0.0f);
  light.densityArea = vec3(0.0f);
  light.source = power.w;
  if (!vtkiSurfaceIsLit(surface))
  {
    return false;
  }
  float texelSize = 2.0f * map.y / map.z;
  bool parallel = int(map.x + 0.5f) == VTKI_MAP_PARALLEL;
  vec3 p = vtkiMapPosition(map, texel, vtkiSurfaceDepth(surface));
  float footprint = parallel
    ? texelSize * texelSize
    : vtkiTexelSolidAngle((vec2(texel) + 0.5f) * texelSize - map.y, texelSize);
  vec2 slope = texelFetch(vtkiMapSlope, ivec3(texel, layer), 0).rg;
  float cosine = vtkiMapFacetCosine(map, slope, p);
  vec3 reflectance = vtkiMapReflectance(layer, texel, map, surface, p, cosine);
  light.position = vtkiTransformRows(layer, VTKI_MAP_TO_SCENE, vec4(p, 1.0f));
  light.normal = vtkiTransformRows(layer, VTKI_MAP_TO_SCENE, vec4(vtkiMapFacet(map, surface, slope, p), 0.0f));
  light.area = footprint * (parallel ? 1.0f : dot(p, p)) / cosine;
  light.reflected = reflectance * (vtkiMapFalloff(layer, map, p) * footprint);
  light.densityArea = light.reflected * power.rgb;
  return true;
}
