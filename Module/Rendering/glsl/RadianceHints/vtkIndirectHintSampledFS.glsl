//VTK::System::Dec
//VTK::Output::Dec
// First bounce at a hint as in the paper: some texels of every map, others for every hint, seen
// from positions spread over the hint's cell.
#include "vtkIndirectMapTexel.glsl"
#include "vtkIndirectHintInject.glsl"

uniform int vtkiSampleCount; // samples of each layer
uniform int vtkiLayerCount;
uniform float vtkiCoverage; // share of a map's area that its samples are spread over

void main()
{
  vtkiHintPlace place = vtkiFetchHintPlace();
  vtkiHintSums sums = vtkiBeginHint();
  int layers = place.used ? vtkiLayerCount : 0;
  for (int layer = 0; layer < layers; ++layer)
  {
    vec4 map = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_SHAPE, layer), 0);
    // A square of that share about the hint's own place in the map, moved to lie inside the map.
    float edge = sqrt(vtkiCoverage);
    vec3 p = vtkiTransformRows(layer, VTKI_MAP_FROM_SCENE, vec4(place.position, 1.0f));
    float w = int(map.x + 0.5f) == VTKI_MAP_PARALLEL ? map.y : max(-p.z, 1.0e-6f) * map.y;
    vec2 corner = clamp(0.5f * p.xy / w + 0.5f - 0.5f * edge, 0.0f, 1.0f - edge);
    float texels = map.z * map.z * vtkiCoverage / float(vtkiSampleCount);
    for (int i = 0; i < vtkiSampleCount; ++i)
    {
      vec3 random = vtkiSpread(i, uint(place.hint * 16 + layer));
      vec3 jitter = vtkiSpread(i, uint(place.hint * 16 + layer) + 77777777u);
      vtkiVirtualLight light;
      ivec2 texel = ivec2(min((corner + edge * random.xy) * map.z, vec2(map.z - 1.0f)));
      if (vtkiVirtualLightFromTexel(layer, texel, light))
      {
        float area = light.area * texels;
        vtkiAddSender(sums, place.hint, place.position + (jitter - 0.5f) * place.cell, light.position,
          light.normal, area, light.densityArea * texels,
          (vtkiSoftening > 0.0f ? max(area, vtkiSoftening * place.face) : light.area) / 6.2831853f);
      }
    }
  }
  vtkiEndHint(sums);
}
