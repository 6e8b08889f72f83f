// Sum over the texels around a receiver's own place in each light's map.
#include "vtkIndirectMapTexel.glsl"
#include "vtkIndirectLibVirtualLight.glsl"
#include "vtkIndirectLibSampling.glsl"
#ifdef VTKI_VISIBILITY
#include "vtkIndirectVisibility.glsl"
#endif

uniform int vtkiSampleCount;
uniform float vtkiRadius; // the disk's radius as a fraction of the map's width
uniform int vtkiLayerCount;

// A sample of the disk in a map.
struct vtkiMapSample
{
  int layer;
  vec2 at;      // map coordinates
  float texels; // texels that the sample represents
};

// Sample of a map of one face: the disk lies in the map's plane.
vtkiMapSample vtkiSampleOnPlane(int layer, vec4 map, vec2 uv, vec3 pattern)
{
  // Texels in a square as wide as the disk's radius: the pattern's weights are for a unit disk.
  float texels = map.z * map.z * vtkiRadius * vtkiRadius;
  return vtkiMapSample(layer, uv + vtkiRadius * pattern.xy, pattern.z * texels);
}

// Sample of a cube map, without a seam between faces: the disk touches the sphere of directions at
// the receiver and is as wide as on the face. direction: to the receiver, unit, in the coordinates
// of this layer's face.
vtkiMapSample vtkiSampleOnCube(int layer, vec4 map, vec3 direction, vec3 pattern)
{
  vec3 helper = abs(direction.x) < 0.5f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
  vec3 tangent = normalize(cross(helper, direction));
  vec3 bitangent = cross(direction, tangent);
  vec2 offset = 2.0f * map.y * vtkiRadius * pattern.xy;
  vec3 ray = direction + offset.x * tangent + offset.y * bitangent;
  int own = int(texelFetch(vtkiMapTable, ivec2(VTKI_MAP_AXIS, layer), 0).w + 0.5f);
  // Transforms back to the light's coordinates: opposite side faces are each other's inverse,
  // forward and backward are their own.
  int inverse = own == 0 || own == 5 ? own : (own == 1 || own == 3 ? own + 1 : own - 1);
  vec3 inLight = vtkiToFace(ray, inverse);
  int face = vtkiFaceOf(inLight);
  vec3 inFace = vtkiToFace(inLight, face);
  int there = layer - own + face;
  // Maps of wide spot lights have no backward face.
  bool has = there < vtkiLayerCount &&
    int(texelFetch(vtkiMapTable, ivec2(VTKI_MAP_AXIS, clamp(there, 0, vtkiLayerCount - 1)), 0).w + 0.5f) == face;
  vec2 tangents = inFace.xy / -inFace.z;
  // Solid angle of the pattern's share of the disk over its solid angle on the face's plane.
  float stretch = (1.0f + dot(tangents, tangents)) / (1.0f + dot(offset, offset));
  float texels = map.z * map.z * vtkiRadius * vtkiRadius * stretch * sqrt(stretch);
  return vtkiMapSample(
    has ? there : layer, has ? 0.5f * tangents / map.y + 0.5f : vec2(-1.0f), pattern.z * texels);
}

vec3 vtkiGather(vec3 position, vec3 normal, vec3 facet, ivec2 pixel)
{
  vec3 total = vec3(0.0f);
#ifdef VTKI_VISIBILITY
  vec3 open = vtkiOpenPlace(position, normal, facet, pixel);
#endif
  for (int layer = 0; layer < vtkiLayerCount; ++layer)
  {
    vec4 map = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_SHAPE, layer), 0);
    vec3 p = vtkiTransformRows(layer, VTKI_MAP_FROM_SCENE, vec4(position, 1.0f));
    bool parallel = int(map.x + 0.5f) == VTKI_MAP_PARALLEL;
    bool cube = int(map.x + 0.5f) == VTKI_MAP_FACES;
    if (cube && vtkiFaceOf(p) != 0)
    {
      continue;
    }
    float w = parallel ? map.y : -p.z * map.y;
    if (!(w > 0.0f))
    {
      continue;
    }
    vec2 uv = 0.5f * p.xy / w + 0.5f;
    for (int i = 0; i < vtkiSampleCount; ++i)
    {
      vec3 pattern = vtkiDiskSample(i, vtkiSampleCount);
      vtkiMapSample place = vtkiSampleOnPlane(layer, map, uv, pattern);
      if (cube)
      {
        place = vtkiSampleOnCube(layer, map, normalize(p), pattern);
      }
      if (min(place.at.x, place.at.y) < 0.0f || max(place.at.x, place.at.y) >= 1.0f)
      {
        continue;
      }
      vtkiVirtualLight light;
      if (vtkiVirtualLightFromTexel(place.layer, ivec2(place.at * map.z), light))
      {
        float weight =
          vtkiVirtualLightWeight(light.position - position, light.normal, normal, light.area);
#ifdef VTKI_VISIBILITY
        bool seen =
          vtkiIsVisible(open, position, normal, light.position, light.normal, weight > 0.0f);
        weight = seen ? weight : 0.0f;
#endif
        total += light.densityArea * (place.texels * weight);
      }
    }
  }
  return total;
}
