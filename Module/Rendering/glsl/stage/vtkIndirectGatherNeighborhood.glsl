// Sum over the texels around a receiver's own place in each light's map.
#include "vtkIndirectMapTexel.glsl"
#include "vtkIndirectLibVirtualLight.glsl"
#include "vtkIndirectLibSampling.glsl"
#ifdef VTKI_OCCUPANCY
#include "vtkIndirectSight.glsl"
#endif

uniform int vtkiSampleCount;
uniform float vtkiRadius; // of the disk, as a fraction of the map's width
uniform int vtkiLayerCount;

vec3 vtkiGather(vec3 position, vec3 normal)
{
  vec3 total = vec3(0.0f);
#ifdef VTKI_OCCUPANCY
  vec3 open = vtkiOpenPlace(position, normal);
#endif
  for (int layer = 0; layer < vtkiLayerCount; ++layer)
  {
    vec4 map = texelFetch(vtkiMapTable, ivec2(3, layer), 0);
    vec3 p = vtkiTransformRows(layer, 5, vec4(position, 1.0f));
    bool parallel = int(map.x + 0.5f) == VTKI_MAP_PARALLEL;
    if (int(map.x + 0.5f) == VTKI_MAP_FACES && vtkiFaceOf(p) != 0)
    {
      continue;
    }
    float w = parallel ? map.y : -p.z * map.y;
    if (!(w > 0.0f))
    {
      continue;
    }
    vec2 uv = 0.5f * p.xy / w + 0.5f;
    // Texels in a square as wide as the disk's radius: the pattern's weights are for a unit disk.
    float texels = map.z * map.z * vtkiRadius * vtkiRadius;
    for (int i = 0; i < vtkiSampleCount; ++i)
    {
      vec3 pattern = vtkiDiskSample(i, vtkiSampleCount);
      vec2 at = uv + vtkiRadius * pattern.xy;
      if (min(at.x, at.y) < 0.0f || max(at.x, at.y) >= 1.0f)
      {
        continue;
      }
      vtkiVirtualLight light;
      if (vtkiVirtualLightFromTexel(layer, ivec2(at * map.z), light))
      {
        float weight =
          vtkiVirtualLightWeight(light.position - position, light.normal, normal, light.area);
#ifdef VTKI_OCCUPANCY
        bool seen =
          vtkiSees(open, position, normal, light.position, light.normal, weight > 0.0f);
        weight = seen ? weight : 0.0f;
#endif
        total += light.densityArea * (pattern.z * texels * weight);
      }
    }
  }
  return total;
}
