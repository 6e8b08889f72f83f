//VTK::System::Dec
//VTK::Output::Dec
// Warps an even pattern in the charts by importance to texels of the lights' maps: one fragment a
// sample, in the form of the pattern that vtkIndirectVirtualLightFS.glsl reads.
#include "vtkIndirectChart.glsl"

// place in [0,1)^2; chart, or below zero for all charts; share of the light
uniform sampler2D vtkiPattern;
uniform sampler2D vtkiLitEven;  // nodes of level 0, 2, ...: each cell that sends light counts one
uniform sampler2D vtkiLitOdd;   // nodes of level 1, 3, ...
#ifdef VTKI_FLUX
uniform sampler2D vtkiFluxEven; // the same nodes by the flux of the cells
uniform sampler2D vtkiFluxOdd;
uniform int vtkiNumberOfCharts;
// share of samples that are spread evenly over cells that send light
uniform float vtkiEvenness;
uniform int vtkiMethod;
uniform int vtkiWarpedLevels;   // from the top; below them, nonempty quarters are equally likely
#endif
uniform int vtkiLevels;

vec4 vtkiFetchNode(sampler2D even, sampler2D odd, int level, ivec2 chart, ivec2 node)
{
  ivec2 at = ivec2(vtkiNodesBegin(vtkiColumns * (vtkiCells / 2), level), 0) +
    chart * ((vtkiCells / 2) >> level) + node;
  return (level & 1) == 0 ? texelFetch(even, at, 0) : texelFetch(odd, at, 0);
}

float vtkiLitOf(int chart)
{
  return dot(vtkiFetchNode(vtkiLitEven, vtkiLitOdd, vtkiLevels - 1, vtkiChartPlace(chart), ivec2(0)), vec4(1.0f));
}

#ifdef VTKI_FLUX
float vtkiFluxOf(int chart)
{
  return dot(vtkiFetchNode(vtkiFluxEven, vtkiFluxOdd, vtkiLevels - 1, vtkiChartPlace(chart), ivec2(0)), vec4(1.0f));
}

// The charts lie side by side, each as wide as its flux. Warps the place into the chart where it
// falls.
int vtkiChooseChart(inout vec2 place, inout float probability)
{
  float total = 0.0f;
  for (int i = 0; i < vtkiNumberOfCharts; ++i)
  {
    total += vtkiFluxOf(i);
  }
  float at = place.x * total;
  float begin = 0.0f;
  int chosen = 0;
  float from = 0.0f;
  float width = 0.0f;
  for (int i = 0; i < vtkiNumberOfCharts; ++i)
  {
    float own = vtkiFluxOf(i);
    if (own > 0.0f && (width == 0.0f || at >= begin))
    {
      chosen = i;
      from = begin;
      width = own;
    }
    begin += own;
  }
  place.x = clamp((at - from) / max(width, 1.0e-37f), 0.0f, VTKI_BELOW_ONE);
  probability *= width / max(total, 1.0e-37f);
  return chosen;
}
#endif

void main()
{
  vec4 pattern = texelFetch(vtkiPattern, ivec2(gl_FragCoord.xy), 0);
  gl_FragData[0] = vec4(0.0f);
  vec2 place = pattern.xy;
  float probability = 1.0f;
  int chart = int(pattern.z + (pattern.z < 0.0f ? -0.5f : 0.5f));
#ifdef VTKI_FLUX
  if (chart < 0)
  {
    chart = vtkiChooseChart(place, probability);
  }
  float flux = vtkiFluxOf(chart);
  float evenly = vtkiEvenness / max(vtkiLitOf(chart), 1.0f);
  float byFlux = (1.0f - vtkiEvenness) / max(flux, 1.0e-37f);
#endif
  // The pattern is empty after its last sample.
  if (!(pattern.w > 0.0f) || !(vtkiLitOf(chart) > 0.0f))
  {
    return;
  }
  ivec2 cell = ivec2(0);
  for (int level = vtkiLevels - 1; level >= 0; --level)
  {
    vec4 quadrants = vtkiFetchNode(vtkiLitEven, vtkiLitOdd, level, vtkiChartPlace(chart), cell);
    int method = VTKI_WARP_APART;
#ifdef VTKI_FLUX
    quadrants = evenly * quadrants +
      byFlux * vtkiFetchNode(vtkiFluxEven, vtkiFluxOdd, level, vtkiChartPlace(chart), cell);
    method = vtkiLevels - level > vtkiWarpedLevels ? VTKI_WARP_EVENLY : vtkiMethod;
#endif
    cell = 2 * cell + vtkiWarpQuadrant(quadrants, method, place, probability);
  }
  int layer;
  ivec2 texel;
  float texels;
  if (vtkiChartTexel(chart, cell, layer, texel, texels))
  {
    float edge = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_SHAPE, layer), 0).z;
    gl_FragData[0] = vec4((vec2(texel) + 0.5f) / edge, float(layer), pattern.w * texels / probability);
  }
}
