// Charts of the lights' maps, the unit squares in which virtual lights are sampled: a texture has a
// row of numbers for each chart. A map of one face is its own chart; a map of several faces has an
// equal-area chart of its directions.
#include "vtkIndirectMapTexel.glsl"
#include "vtkIndirectLibImportance.glsl"

uniform sampler2D vtkiCharts;   // first layer; cosine of the cone of light, or 2 for a map of one face
uniform int vtkiCells;          // along an edge of a chart
uniform int vtkiColumns;        // charts in a row of the nodes' texture

// The texel for a cell of a chart, and the number of texels it represents. Returns false if the map
// has none.
bool vtkiChartTexel(int chart, ivec2 cell, out int layer, out ivec2 texel, out float texels)
{
  vec4 row = texelFetch(vtkiCharts, ivec2(chart, 0), 0);
  layer = int(row.x + 0.5f);
  vec4 map = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_SHAPE, layer), 0);
  int edge = int(map.z + 0.5f);
  if (row.y <= 1.0f)
  {
    float size = 1.0f / float(vtkiCells);
    vec3 direction = vtkiChartDirection((vec2(cell) + 0.5f) * size, row.y);
    int face = vtkiFaceOf(direction);
    vec3 p = vtkiToFace(direction, face);
    vec2 tangent = p.xy / -p.z;
    texel = clamp(ivec2((0.5f + 0.5f * tangent) * map.z), ivec2(0), ivec2(edge - 1));
    layer += face;
    float angle = 2.0f * VTKI_PI * (1.0f - row.y) * size * size;
    float texelSize = 2.0f / map.z;
    texels = angle / vtkiTexelSolidAngle((vec2(texel) + 0.5f) * texelSize - 1.0f, texelSize);
    return true;
  }
  // If a map is larger than its chart, one texel represents its neighbours.
  int step = (edge + vtkiCells - 1) / vtkiCells;
  ivec2 first = cell * step;
  ivec2 size = min(ivec2(step), ivec2(edge) - first);
  texel = first + max(size, ivec2(1)) / 2;
  texels = float(size.x) * float(size.y);
  return size.x > 0 && size.y > 0;
}

ivec2 vtkiChartPlace(int chart)
{
  return ivec2(chart % vtkiColumns, chart / vtkiColumns);
}
