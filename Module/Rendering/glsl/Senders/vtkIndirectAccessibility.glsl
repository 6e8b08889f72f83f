// Share of the hemisphere above a texel of a light's map that other surfaces in the map leave open.
// Needs vtkIndirectMapTexel.glsl and vtkIndirectLibImportance.glsl.

// This is the sampled neighbours: this many directions at each of the distances.
const int VTKI_NEIGHBOR_DIRECTIONS = 8;
const int VTKI_NEIGHBOR_RINGS = 3;

float vtkiAccessibility(int layer, ivec2 texel)
{
  vec4 map = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_SHAPE, layer), 0);
  vec4 surface = texelFetch(vtkiMapSurface, ivec3(texel, layer), 0);
  if (!vtkiSurfaceIsLit(surface))
  {
    return 1.0f;
  }
  vec3 p = vtkiMapPosition(map, texel, vtkiSurfaceDepth(surface));
  vec3 normal = vtkiMapFacet(map, surface, texelFetch(vtkiMapSlope, ivec3(texel, layer), 0).rg, p);
  bool parallel = int(map.x + 0.5f) == VTKI_MAP_PARALLEL;
  float texelLength = 2.0f * map.y / map.z * (parallel ? 1.0f : vtkiSurfaceDepth(surface));
  int edge = int(map.z + 0.5f);
  float hidden = 0.0f;
  for (int i = 0; i < VTKI_NEIGHBOR_DIRECTIONS * VTKI_NEIGHBOR_RINGS; ++i)
  {
    float angle = 2.0f * VTKI_PI * (float(i) + 0.5f) / float(VTKI_NEIGHBOR_DIRECTIONS);
    float distance =
      VTKI_NEIGHBOR_RADIUS * float(i / VTKI_NEIGHBOR_DIRECTIONS + 1) / float(VTKI_NEIGHBOR_RINGS);
    vec2 offset = vec2(cos(angle), sin(angle)) * min(distance / max(texelLength, 1.0e-6f), map.z);
    ivec2 at = clamp(texel + ivec2(floor(offset + 0.5f)), ivec2(0), ivec2(edge - 1));
    vec4 other = texelFetch(vtkiMapSurface, ivec3(at, layer), 0);
    if (vtkiSurfaceIsLit(other))
    {
      hidden += vtkiHiddenBy(vtkiMapPosition(map, at, vtkiSurfaceDepth(other)) - p, normal);
    }
  }
  return 1.0f - min(2.0f * hidden / float(VTKI_NEIGHBOR_DIRECTIONS * VTKI_NEIGHBOR_RINGS), 1.0f);
}
