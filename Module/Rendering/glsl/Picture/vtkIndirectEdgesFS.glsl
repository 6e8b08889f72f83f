//VTK::System::Dec
// Outlines of the picture as bits, 32 positions of a line in a texel. The lines are the picture's
// rows and, from row vtkiRows on, its columns. An empty word on either side spares readers of runs
// a test for borders; pixels beyond the picture equal those of its border. r: edges of this line;
// g, b: crossing edges of the line before and of this line. See vtkIndirectLibAntialiasing.glsl.
#include "vtkIndirectLibAntialiasing.glsl"

uniform sampler2D vtkiContrasts; // at outlines: with the left pixel, and with the pixel below
uniform ivec2 vtkiSize;
uniform int vtkiRows;

out uvec4 vtkiEdges;

// Contrasts of a pixel with the position before and with the line before.
vec2 vtkiFetchContrasts(vec2 place, bool columns)
{
  vec2 contrasts = textureLod(vtkiContrasts, place, 0.0f).rg;
  // Beyond the picture this reads the border's contrast, of which only outlines across the border
  // continue.
  contrasts *= vec2(lessThan(place, vec2(1.0f)));
  return columns ? contrasts.gr : contrasts;
}

void main()
{
  bool columns = gl_FragCoord.y > float(vtkiRows);
  float line = gl_FragCoord.y - (columns ? float(vtkiRows) : 0.0f); // middle of the line
  float first = 32.0f * (floor(gl_FragCoord.x) - 1.0f);
  vec2 texel = 1.0f / vec2(vtkiSize);
  vec2 along = columns ? vec2(0.0f, texel.y) : vec2(texel.x, 0.0f);
  vec2 across = columns ? vec2(texel.x, 0.0f) : vec2(0.0f, texel.y);
  vec2 begin = (first + 0.5f) * along + line * across;

  float edge = 0.0f;      // contrast at the position before
  float strongest = 0.0f; // crossing edge at its beginning
  uint edges = 0u;
  uint crossing = 0u;
  uint crossingBelow = 0u;
  uint bit = 1u;
  for (int i = 0; i <= 32; ++i)
  {
    vec2 place = begin + float(i) * along;
    vec2 here = vtkiFetchContrasts(place, columns);
    float side = here.x;
    float sideBelow = vtkiFetchContrasts(place - across, columns).x;
    float next = max(side, sideBelow);
    bool isEdge = i > 0 && edge >= VTKI_EDGE_CONTRAST &&
      edge * VTKI_EDGE_DOMINANCE >= max(strongest, next);
    // The bit of the position before; when i is zero, none.
    edges |= isEdge ? (bit >> 1u) : 0u;
    crossing |= side >= VTKI_EDGE_CONTRAST ? bit : 0u;
    crossingBelow |= sideBelow >= VTKI_EDGE_CONTRAST ? bit : 0u;
    bit = i == 31 ? 0u : bit << 1u;
    edges |= isEdge && i == 32 ? 0x80000000u : 0u;
    edge = here.y;
    strongest = next;
  }
  vtkiEdges = uvec4(edges, crossingBelow, crossing, 0u);
}
