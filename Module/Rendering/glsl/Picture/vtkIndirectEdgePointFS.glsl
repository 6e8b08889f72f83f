//VTK::System::Dec
//VTK::Output::Dec
// Blends pixels on either side of the picture's edges and leaves others as they were drawn.
// vtkIndirectEdgesFS.glsl describes the words of edge bits. Pixels of the background and of earlier
// layers stay unchanged: one of the two pixels belongs to this frame.
#include "vtkIndirectShown.glsl"

uniform sampler2D vtkiDepth;
uniform usampler2D vtkiEdges;
flat in vec2 vtkiTexel;
flat in vec2 vtkiEdgeTexel;
flat in ivec3 vtkiPlaces; // the viewport's origin, and the first line of columns

// Returns the word of edge bits of a line that holds a position, which may be one before the
// picture's first or after its last. Sampled, because software samples the nearest texel faster
// than it fetches one.
uvec4 vtkiFetchEdges(int position, int line)
{
  return textureLod(vtkiEdges, (vec2(float((position + 32) >> 5), float(line)) + 0.5f) * vtkiEdgeTexel, 0.0f);
}

// Returns four bits of each channel, beginning at a position.
uvec3 vtkiFetchFour(int position, int line)
{
  uvec3 lower = vtkiFetchEdges(position, line).rgb;
  uvec3 upper = vtkiFetchEdges(position + 3, line).rgb;
  int first = position & 31;
  return uvec3(vtkiBitWindow(lower.r, upper.r, first), vtkiBitWindow(lower.g, upper.g, first),
           vtkiBitWindow(lower.b, upper.b, first)) & 15u;
}

// Kind of end of a run at a position. The run's lines begin at `lines`, the crossing lines at
// `others`.
float vtkiFetchRunEnd(int position, int line, int others, bool first)
{
  // At the run's end, edges along the run are the crossing edges of the other direction.
  uvec3 four = vtkiFetchFour(line - 2, others + position);
  return vtkiRunEnd(four.r, four.g, four.b, first);
}

// Returns the bits of a line's words at a position: is there an edge, and does an outline with this
// turn reach the position from the one before.
bool vtkiHasEdge(uvec4 words, int position)
{
  return ((words.r >> uint(position & 31)) & 1u) != 0u;
}

bool vtkiHasStep(uvec4 words, int position, int turn)
{
  return (((turn > 0 ? words.g : words.b) >> uint(position & 31)) & 1u) != 0u;
}

// Returns the words of lines up to two away from an edge, clamped: lines beyond the picture have no
// edges.
uvec4 vtkiFetchNear(int position, int line)
{
  return vtkiFetchEdges(position, clamp(line, 0, textureSize(vtkiEdges, 0).y - 1));
}

// vtkiDiagonalAreas at an edge of a diagonal with this turn. count: positions of the diagonal.
vec2 vtkiFetchDiagonal(int position, int line, int lines, int turn, out int count)
{
  int at = position;
  int row = lines + line;
  int backward = 0;
  uvec4 here = vtkiFetchEdges(at, row);
  bool on = true;
  while (on && backward < VTKI_DIAGONAL_REACH)
  {
    uvec4 next = vtkiFetchEdges(at - 1, row - turn);
    on = vtkiHasStep(here, at, turn) && vtkiHasEdge(next, at - 1);
    here = on ? next : here;
    at -= on ? 1 : 0;
    row -= on ? turn : 0;
    backward += on ? 1 : 0;
  }
  float firstEnd = 0.0f;
  if (backward < VTKI_DIAGONAL_REACH)
  {
    // The outline continues after this end: such a corner does not tell where the line lies.
    uvec4 aside = vtkiFetchEdges(at - 1, row);
    uvec4 behind = vtkiFetchEdges(at - 2, row - turn);
    bool isFlat = vtkiHasEdge(aside, at - 1) && vtkiHasStep(aside, at - 1, turn) &&
      vtkiHasEdge(behind, at - 2);
    bool isSteep = vtkiHasStep(here, at, turn) &&
      vtkiHasStep(vtkiFetchEdges(at, row - turn), at, turn) &&
      vtkiHasEdge(vtkiFetchNear(at - 1, row - 2 * turn), at - 1);
    firstEnd = vtkiDiagonalEnd(isFlat, isSteep, turn, true);
  }
  at = position;
  row = lines + line;
  int forward = 0;
  on = true;
  while (on && forward < VTKI_DIAGONAL_REACH)
  {
    uvec4 next = vtkiFetchEdges(at + 1, row + turn);
    on = vtkiHasStep(next, at + 1, turn) && vtkiHasEdge(next, at + 1);
    at += on ? 1 : 0;
    row += on ? turn : 0;
    forward += on ? 1 : 0;
  }
  float lastEnd = 0.0f;
  if (forward < VTKI_DIAGONAL_REACH)
  {
    uvec4 behind = vtkiFetchEdges(at + 2, row + turn);
    bool isFlat = vtkiHasEdge(vtkiFetchEdges(at + 1, row), at + 1) &&
      vtkiHasStep(behind, at + 2, turn) && vtkiHasEdge(behind, at + 2);
    uvec4 above = vtkiFetchNear(at + 1, row + 2 * turn);
    bool isSteep = vtkiHasStep(vtkiFetchEdges(at + 1, row + turn), at + 1, turn) &&
      vtkiHasStep(above, at + 1, turn) && vtkiHasEdge(above, at + 1);
    lastEnd = vtkiDiagonalEnd(isFlat, isSteep, turn, false);
  }
  count = backward + forward + 1;
  return vtkiDiagonalAreas(backward, forward, firstEnd, lastEnd, turn);
}

// vtkiRunAreas or vtkiDiagonalAreas at an edge.
vec2 vtkiFetchAreas(int position, int line, int lines, int others)
{
  int bit = position & 31;
  uvec4 before = vtkiFetchEdges(position - 32, lines + line);
  uvec4 here = vtkiFetchEdges(position, lines + line);
  uvec4 behind = vtkiFetchEdges(position + 32, lines + line);
  int forward = vtkiRunForward(vtkiBitWindow(here.r, behind.r, bit),
    vtkiBitWindow(here.g & here.b, behind.g & behind.b, bit));
  int next = (bit + 1) & 31;
  bool last = bit == 31;
  uint ending = last ? here.r : vtkiBitWindow(before.r, here.r, next);
  uint endingBreaks =
    last ? here.g & here.b : vtkiBitWindow(before.g & before.b, here.g & here.b, next);
  int backward = vtkiRunBackward(ending, endingBreaks);
  if (backward + forward + 1 < VTKI_DIAGONAL_LENGTH)
  {
    // An outline rises or falls from the first or the last end of an edge; where outlines cross, it
    // does both.
    uvec4 after = vtkiFetchEdges(position + forward + 1, lines + line);
    uvec4 start = vtkiFetchEdges(position - backward, lines + line);
    int longest = VTKI_DIAGONAL_LENGTH - 1;
    vec2 areas = vec2(0.0f);
    bool rises = vtkiHasStep(start, position - backward, 1) &&
      vtkiHasStep(after, position + forward + 1, -1);
    bool falls = vtkiHasStep(start, position - backward, -1) &&
      vtkiHasStep(after, position + forward + 1, 1);
    // A loop, because software skips one of no rounds, but takes both sides of a branch.
    while (rises || falls)
    {
      int turn = rises ? 1 : -1;
      int count;
      vec2 found = vtkiFetchDiagonal(position, line, lines, turn, count);
      areas = count > longest ? found : areas;
      longest = max(longest, count);
      falls = falls && rises;
      rises = false;
    }
    if (longest >= VTKI_DIAGONAL_LENGTH)
    {
      return areas;
    }
  }
  float firstEnd = backward < VTKI_EDGE_REACH
    ? vtkiFetchRunEnd(position - backward, line, others, true) : 0.0f;
  float lastEnd = forward < VTKI_EDGE_REACH
    ? vtkiFetchRunEnd(position + forward + 1, line, others, false) : 0.0f;
  return vtkiRunAreas(backward, forward, firstEnd, lastEnd);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - vtkiPlaces.xy;
  int rows = vtkiPlaces.z;
  uint row = uint(pixel.x & 31);
  uint column = uint(pixel.y & 31);
  // Bits: below, above, left, right.
  uint sides = ((vtkiFetchEdges(pixel.x, pixel.y).r >> row) & 1u) |
    (((vtkiFetchEdges(pixel.x, pixel.y + 1).r >> row) & 1u) << 1u) |
    (((vtkiFetchEdges(pixel.y, rows + pixel.x).r >> column) & 1u) << 2u) |
    (((vtkiFetchEdges(pixel.y, rows + pixel.x + 1).r >> column) & 1u) << 3u);
  if (sides == 0u)
  {
    discard;
  }
  vec2 texel = vtkiTexel;
  vec2 place = (vec2(pixel) + 0.5f) * texel;
  vec4 color = textureLod(vtkiPicture, place, 0.0f);
  vec4 shown = vtkiToShown(color);
  bool drawn = textureLod(vtkiDepth, place, 0.0f).r < 1.0f;
  vec4 areas = vec4(0.0f);
  while (sides != 0u)
  {
    uint side = sides & (~sides + 1u);
    bool columns = side > 2u;
    bool far = (side & 10u) != 0u; // the neighbour comes after this pixel, not before it
    int line = (columns ? pixel.x : pixel.y) + (far ? 1 : 0);
    vec2 cut = vtkiFetchAreas(columns ? pixel.y : pixel.x, line, columns ? rows : 0,
      columns ? 0 : rows);
    vec2 step = (columns ? vec2(texel.x, 0.0f) : vec2(0.0f, texel.y)) * (far ? 1.0f : -1.0f);
    bool counts = drawn || textureLod(vtkiDepth, place + step, 0.0f).r < 1.0f;
    float area = counts
      ? (far ? cut.y : cut.x) * vtkiEdgeStrength(vtkiContrast(shown, vtkiShown(place + step))) : 0.0f;
    areas += vec4(side == 1u ? area : 0.0f, side == 2u ? area : 0.0f, side == 4u ? area : 0.0f,
      side == 8u ? area : 0.0f);
    sides ^= side;
  }
  // If both directions would blend, they have found the same outline: keep the direction that sees
  // more of it, along which it runs.
  bool alongRows = max(areas.x, areas.y) >= max(areas.z, areas.w);
  vec2 shares = alongRows ? vtkiNeighborShares(areas.x, areas.y) : vtkiNeighborShares(areas.z, areas.w);
  if (shares.x + shares.y == 0.0f)
  {
    discard;
  }
  vec2 step = alongRows ? vec2(0.0f, texel.y) : vec2(texel.x, 0.0f);
  gl_FragData[0] = color +
    shares.x * (textureLod(vtkiPicture, place - step, 0.0f) - color) +
    shares.y * (textureLod(vtkiPicture, place + step, 0.0f) - color);
}
