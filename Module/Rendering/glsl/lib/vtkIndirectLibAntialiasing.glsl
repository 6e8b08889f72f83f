// Morphological antialiasing (Reshetov 2009; Jimenez, Echevarria, Sousa, Gutierrez 2012): an
// outline made of a row of equal steps between pixels is redrawn as a line, and each pixel gets the
// share of its neighbour's colour that the line cuts off.
//
// Outlines are ends of surfaces: vtkiIsOutline. Colours only tell how clearly an outline is
// visible; steps of colour within a surface are data.
//
// Edges are bits, 32 positions of a row in a word, so that the ends of a run are found by
// arithmetic instead of a search. "Line" is a row of pixels, "position" the place along it; the
// same applies to columns. An edge of line l and position s lies between pixels (s, l - 1) and (s,
// l); a crossing edge of line l at position s between (s - 1, l) and (s, l).
#ifndef vtkIndirectLibAntialiasing
#define vtkIndirectLibAntialiasing
#include "vtkIndirectLibPortable.glsl"
#include "vtkIndirectLibSurface.glsl"

/* This is the contrast of the weakest edge, and of edges whose pixels are blended in full: steps of
 * 5 % are visible, and a ramp keeps an edge that passes the first contrast from flickering. */
const float VTKI_EDGE_CONTRAST = 0.05f;
const float VTKI_EDGE_FULL_CONTRAST = 0.1f;
/* An edge is dropped if an adjoining edge has this many times its contrast: it is a crease that
 * ends at an outline. */
const float VTKI_EDGE_DOMINANCE = 4.0f;
/* Range of the search for the ends of a run on either side, positions. */
const int VTKI_EDGE_REACH = 31;
/* Range of the search for the ends of a diagonal on either side, positions; and the least length at
 * which a diagonal tells more of the outline than runs, which have up to two positions there. */
const int VTKI_DIAGONAL_REACH = 15;
const int VTKI_DIAGONAL_LENGTH = 3;

/* A step of depth or of the normal between pixels is an outline if it is this many times the steps
 * beside it. On round surfaces steps grow towards the outline, near which depth and angle go with
 * the root of the distance: by at most 1 / (sqrt(2) - 1) = 2.42. */
const float VTKI_OUTLINE_RATIO = 2.5f;

/* Returns true if depth leaps between the middle two of four pixels in a row: values of the depth
 * buffer; 1 for the background and beyond the picture. They are affine on a plane, so that a
 * plane's steps are equal. On a surface curved to one side a step lies between its neighbours; on a
 * wavy surface it may be the largest, within the ratio for waves of six pixels. Thin things step
 * there and back again: a step of the other sign counts only if both sides have one. */
bool vtkiIsDepthLeap(vec4 depth)
{
  float step = abs(depth.z - depth.y);
  float turn = depth.z < depth.y ? -1.0f : 1.0f;
  bool hasBefore = depth.x < 1.0f;
  bool hasBehind = depth.w < 1.0f;
  float before = turn * (depth.y - depth.x);
  float behind = turn * (depth.w - depth.z);
  before = hasBefore ? before : behind;
  behind = hasBehind ? behind : before;
  float most = max(min(abs(before), abs(behind)), max(before, behind));
  // Two roundings of the step, and as many of a neighbour's, times the ratio.
  return (hasBefore || hasBehind) &&
    step > VTKI_OUTLINE_RATIO * most + (2.0f + 2.0f * VTKI_OUTLINE_RATIO) * VTKI_DEPTH_ROUNDING;
}

/* Returns true if normals turn abruptly between the middle two of four pixels, which are lit: by
 * more than on either side, and enough for a visible change of light. */
bool vtkiIsCrease(vec2 code0, vec2 code1, vec2 code2, vec2 code3, bool hasBefore, bool hasBehind)
{
  vec3 n1 = vtkiOctahedralDecode(code1);
  vec3 n2 = vtkiOctahedralDecode(code2);
  vec3 turn = n2 - n1;
  vec3 before = n1 - vtkiOctahedralDecode(code0);
  vec3 behind = vtkiOctahedralDecode(code3) - n2;
  // Squared lengths. A cosine changes by at most the chord between the normals.
  float most = max(hasBefore ? dot(before, before) : 0.0f, hasBehind ? dot(behind, behind) : 0.0f);
  return (hasBefore || hasBehind) &&
    dot(turn, turn) >
      max(VTKI_OUTLINE_RATIO * VTKI_OUTLINE_RATIO * most, VTKI_EDGE_CONTRAST * VTKI_EDGE_CONTRAST);
}

/* Returns true if a surface ends between the middle two of four pixels in a row: at the background,
 * at another kind of surface, at another unlit prop, at a leap of depth, or at a crease. surface0
 * to surface3: texels of the geometry buffer. */
bool vtkiIsOutline(vec4 depth, vec4 surface0, vec4 surface1, vec4 surface2, vec4 surface3)
{
  bool drawn = depth.y < 1.0f;
  bool both = drawn && depth.z < 1.0f;
  float kind = vtkiSurfaceKind(surface1);
  bool alike = kind == vtkiSurfaceKind(surface2);
  vec2 code1 = vtkiSurfaceCode(surface1);
  vec2 code2 = vtkiSurfaceCode(surface2);
  bool lit = vtkiSurfaceIsLit(surface1);
  bool crease = lit
    ? vtkiIsCrease(vtkiSurfaceCode(surface0), code1, code2, vtkiSurfaceCode(surface3),
        depth.x < 1.0f && vtkiSurfaceIsLit(surface0), depth.w < 1.0f && vtkiSurfaceIsLit(surface3))
    : code1 != code2;
  return both ? !alike || crease || vtkiIsDepthLeap(depth) : drawn || depth.z < 1.0f;
}

/* Returns the largest difference of a channel between colours as shown. */
float vtkiContrast(vec4 a, vec4 b)
{
  vec4 d = abs(a - b);
  return max(max(d.x, d.y), max(d.z, d.w));
}

/* Returns the strength of blending for an edge of that contrast. */
float vtkiEdgeStrength(float contrast)
{
  return min(max((contrast - VTKI_EDGE_CONTRAST) *
                 (1.0f / (VTKI_EDGE_FULL_CONTRAST - VTKI_EDGE_CONTRAST)),
               0.0f),
    1.0f);
}

/* Returns the numbers of the lowest and of the highest bit of a nonzero word: the exponent of a
 * float that has no other bit, or none next to it that could round it up. */
int vtkiLowestBit(uint word)
{
  return int(floatBitsToUint(float(word & (~word + 1u))) >> 23u) - 127;
}

int vtkiHighestBit(uint word)
{
  return int(floatBitsToUint(float(word & ~(word >> 1u))) >> 23u) - 127;
}

/* 32 bits of two words in a row, from bit `first` (0 to 31) of the lower one on. */
uint vtkiBitWindow(uint lower, uint upper, int first)
{
  return first == 0 ? lower : (lower >> uint(first)) | (upper << uint(32 - first));
}

/* Returns the number of positions after that of bit 0 in its run: up to VTKI_EDGE_REACH, which
 * means that the end is farther away. edges, breaks: windows from that position on; a break
 * separates a position from the one before. */
int vtkiRunForward(uint edges, uint breaks)
{
  return vtkiLowestBit(~((edges & ~breaks) >> 1u));
}

/* Returns the number of positions before that of bit 31 in its run, for windows that end with it.
 */
int vtkiRunBackward(uint edges, uint breaks)
{
  return 31 - vtkiHighestBit(~((edges & ~(breaks >> 1u)) << 1u));
}

/* Course of the outline at the end of a run: half a pixel to the side of the greater lines, half a
 * pixel to the other side (negative), or straight on (0). across: edges that cross the end, of the
 * lines l - 2 to l + 1 in bits 0 to 3, for a run between the lines l - 1 and l. before, behind: the
 * edges of the positions before and behind the end, between lines l - 3 and l - 2 in bit 0, to l
 * and l + 1 in bit 3. first: true if the run begins at this end. */
float vtkiRunEnd(uint across, uint before, uint behind, bool first)
{
  bool up = (across & 4u) != 0u;
  bool down = (across & 2u) != 0u;
  if (up && down)
  {
    // At a crossing of outlines, one pair of pixels that face each other across the corner belongs
    // together: the pair of a thing one pixel thin.
    bool crossing = (before & behind & 4u) != 0u;
    bool rising = (before & 2u) != 0u || (behind & 8u) != 0u;
    bool falling = (before & 8u) != 0u || (behind & 2u) != 0u;
    float side = crossing && rising != falling ? (rising ? 0.5f : -0.5f) : 0.0f;
    return first ? -side : side;
  }
  // A step is one pixel high, and the outline continues outwards behind it. Otherwise the end is a
  // corner or the end of a line, which stays sharp.
  uint outside = first ? before : behind;
  return up && (outside & 8u) != 0u ? 0.5f : (down && (outside & 2u) != 0u ? -0.5f : 0.0f);
}

/* Returns the area between a and b of a run below a triangle of this `height` at 0 and zero at
 * `length`. */
float vtkiCutArea(float height, float length, float a, float b)
{
  float end = min(b, length);
  return end > a ? height * (end - a) * (1.0f - 0.5f * (a + end) / length) : 0.0f;
}

/* Returns the areas that the outline of a run cuts off the pixels at one of its positions, with
 * `backward` positions of the run before it and `forward` after it: the share that the pixel of the
 * greater line loses to its neighbour, and vice versa. firstEnd, lastEnd: see vtkiRunEnd. From each
 * end the outline meets the pixels' border in the middle of the run; if both ends turn to different
 * sides it is one straight line. */
vec2 vtkiRunAreas(int backward, int forward, float firstEnd, float lastEnd)
{
  float s = float(backward);
  float t = float(forward);
  float middle = 0.5f * (s + t + 1.0f);
  float a = vtkiCutArea(firstEnd, middle, s, s + 1.0f);
  float b = vtkiCutArea(lastEnd, middle, t, t + 1.0f);
  return vec2(max(a, 0.0f) + max(b, 0.0f), max(-a, 0.0f) + max(-b, 0.0f));
}

/* Course of the outline at a diagonal's end, as vtkiRunEnd. Near 45 degrees an outline consists of
 * diagonals: one step a position, but here and there two positions or two lines for one step.
 * Sheared by one line a position, a diagonal is a run and these are its steps; shearing maps pixel
 * centres to pixel centres, so that the line passes through the middles of the steps as it does
 * along a run. turn: 1 if the diagonal rises to greater lines with the position, -1 if it falls.
 * isFlat: two positions for one step at the end; isSteep: two lines. */
float vtkiDiagonalEnd(bool isFlat, bool isSteep, int turn, bool first)
{
  float side = isFlat == isSteep ? 0.0f : (isFlat ? -0.5f : 0.5f);
  return float(turn) * (first ? -side : side);
}

/* Returns the integral of min(max(x, 0), 1) up to v. */
float vtkiRampArea(float v)
{
  return v > 0.0f ? (v < 1.0f ? 0.5f * v * v : v - 0.5f) : 0.0f;
}

/* Returns the area of a pixel below a line that passes the middle of the pixel's position at that
 * height over its lower border. slope: greater than 0; a falling line has the same area. */
float vtkiAreaBelow(float height, float slope)
{
  return (vtkiRampArea(height + 0.5f * slope) - vtkiRampArea(height - 0.5f * slope)) / slope;
}

/* vtkiRunAreas for a diagonal. If neither end locates the line, it may lie anywhere between the
 * centres of the pixels: the mean over all positions is a sixth, which has the least error. */
vec2 vtkiDiagonalAreas(int backward, int forward, float firstEnd, float lastEnd, int turn)
{
  if (firstEnd == 0.0f && lastEnd == 0.0f)
  {
    return vec2(1.0f / 6.0f);
  }
  float place = float(backward) + 0.5f;
  float middle = 0.5f * float(backward + forward + 1);
  float end = place < middle ? firstEnd : lastEnd;
  float height = end * abs(1.0f - place / middle);
  float slope = (place < middle ? -firstEnd : lastEnd) / middle;
  // In the middle itself both ends count.
  slope = place == middle ? 0.5f * (lastEnd - firstEnd) / middle : slope;
  slope = 1.0f + float(turn) * slope;
  return vec2(vtkiAreaBelow(height, slope), vtkiAreaBelow(-height, slope));
}

/* Returns the shares of two neighbours on opposite sides in a pixel's colour, from the areas that
 * either has of it: their mean weighted with the areas, so that a thing of one pixel does not
 * vanish. */
vec2 vtkiNeighborShares(float area1, float area2)
{
  float sum = area1 + area2;
  return sum > 0.0f ? vec2(area1 * area1 / sum, area2 * area2 / sum) : vec2(0.0f);
}
#endif
