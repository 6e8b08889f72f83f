//VTK::System::Dec
// Edges of the picture as bits: 32 positions of a line in a texel. The lines are the picture's rows, and below
// them (in the image above, from row vtkiRows on) its columns. A word on either side is left empty, so that
// whoever reads runs needs no borders; pixels beyond the picture equal those of its border.
// r: edges of this line. g, b: crossing edges of the line before and of this one. See
// vtkIndirectLibAntialiasing.glsl.
#include "vtkIndirectShown.glsl"

uniform ivec2 vtkiSize;
uniform int vtkiRows;

out uvec4 vtkiEdges;

void main()
{
  bool columns = gl_FragCoord.y > float(vtkiRows);
  float line = gl_FragCoord.y - (columns ? float(vtkiRows) : 0.0f); // its middle
  float first = 32.0f * (floor(gl_FragCoord.x) - 1.0f);
  vec2 texel = 1.0f / vec2(vtkiSize);
  vec2 along = columns ? vec2(0.0f, texel.y) : vec2(texel.x, 0.0f);
  vec2 across = columns ? vec2(texel.x, 0.0f) : vec2(0.0f, texel.y);
  vec2 begin = (first + 0.5f) * along + line * across;

  vec4 before = vtkiShown(begin - along);
  vec4 beforeBelow = vtkiShown(begin - along - across);
  float edge = 0.0f;      // of the position before
  float strongest = 0.0f; // crossing edge at its beginning
  uint edges = 0u;
  uint crossing = 0u;
  uint crossingBelow = 0u;
  uint bit = 1u;
  for (int i = 0; i <= 32; ++i)
  {
    vec2 place = begin + float(i) * along;
    vec4 here = vtkiShown(place);
    vec4 below = vtkiShown(place - across);
    float side = vtkiContrast(here, before);
    float sideBelow = vtkiContrast(below, beforeBelow);
    float next = max(side, sideBelow);
    bool isEdge = i > 0 && edge >= VTKI_EDGE_CONTRAST &&
      edge * VTKI_EDGE_DOMINANCE >= max(strongest, next);
    // The bit of the position before; there is none when i is zero.
    edges |= isEdge ? (bit >> 1u) : 0u;
    crossing |= side >= VTKI_EDGE_CONTRAST ? bit : 0u;
    crossingBelow |= sideBelow >= VTKI_EDGE_CONTRAST ? bit : 0u;
    bit = i == 31 ? 0u : bit << 1u;
    edges |= isEdge && i == 32 ? 0x80000000u : 0u;
    edge = vtkiContrast(here, below);
    strongest = next;
    before = here;
    beforeBelow = below;
  }
  vtkiEdges = uvec4(edges, crossingBelow, crossing, 0u);
}
