//VTK::System::Dec
//VTK::Output::Dec
// Importance of the charts' cells: the lowest nodes, four cells each.
#include "vtkIndirectChart.glsl"
#include "vtkIndirectAccessibility.glsl"
#ifdef VTKI_SPECULAR
#include "vtkIndirectMapLobe.glsl"
#endif

uniform int vtkiNumberOfCharts;
uniform float vtkiOcclusion;
uniform float vtkiScale; // over the strongest light's intensity, so that no product underflows

// Returns two importances of a cell: one if it sends light, and the flux it sends.
vec2 vtkiCellImportance(int chart, ivec2 cell)
{
  int layer;
  ivec2 texel;
  float texels;
  vtkiVirtualLight light;
  if (!vtkiChartTexel(chart, cell, layer, texel, texels) ||
    !vtkiVirtualLightFromTexel(layer, texel, light))
  {
    return vec2(0.0f);
  }
  vec3 flux = light.reflected * (texelFetch(vtkiMapTable, ivec2(VTKI_MAP_LIGHT, layer), 0).rgb * vtkiScale);
#ifdef VTKI_SPECULAR
  // Flux in the specular lobe counts as well.
  vtkiTexelLobe lobe;
  if (vtkiLobeFromTexel(layer, texel, texels, lobe))
  {
    flux += lobe.densityArea * vtkiScale;
  }
#endif
  float sum = flux.r + flux.g + flux.b;
  // Cells of a chart of directions have equal size; a texel of other charts counts as often as the
  // texels it represents.
  float even = texelFetch(vtkiCharts, ivec2(chart, 0), 0).y <= 1.0f ? 1.0f : texels;
  if (!(sum > 0.0f))
  {
    return vec2(0.0f);
  }
  float factor = vtkiOcclusion > 0.0f ? vtkiNeighborFactor(vtkiOcclusion, vtkiAccessibility(layer, texel)) : 1.0f;
  return vec2(even, sum * texels * factor);
}

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  int nodes = vtkiCells / 2;
  ivec2 place = at / nodes;
  int chart = place.x + vtkiColumns * place.y;
  ivec2 cell = 2 * (at - place * nodes);
  vec2 quadrants[4];
  for (int i = 0; i < 4; ++i)
  {
    quadrants[i] = chart < vtkiNumberOfCharts
      ? vtkiCellImportance(chart, cell + ivec2(i % 2, i / 2))
      : vec2(0.0f);
  }
  gl_FragData[0] = vec4(quadrants[0].x, quadrants[1].x, quadrants[2].x, quadrants[3].x);
#ifdef VTKI_FLUX
  gl_FragData[1] = vec4(quadrants[0].y, quadrants[1].y, quadrants[2].y, quadrants[3].y);
#endif
}
