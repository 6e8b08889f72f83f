// Morphological antialiasing (Reshetov 2009; Jimenez, Echevarria, Sousa, Gutierrez 2012): the outline that a
// row of equal steps between pixels is made of is drawn anew as a line, and each pixel gets the share of its
// neighbour's colour that the line cuts off.
//
// An outline is where surfaces end: vtkiIsOutline. Colours only say how clearly it is seen. Steps of colour
// within a surface are data.
//
// Edges are bits, 32 positions of a row in a word, so that the ends of a run are found by arithmetic and not
// step by step. "Line" is a row of pixels, "position" the place along it; the same holds of columns. An edge of
// line l and position s lies between pixels (s, l - 1) and (s, l); a crossing edge of line l at position s
// between (s - 1, l) and (s, l).
#ifndef vtkIndirectLibAntialiasing
#define vtkIndirectLibAntialiasing
#include "vtkIndirectLibPortable.glsl"
#include "vtkIndirectLibSurface.glsl"

/* Contrast from which there is an edge, and from which its pixels are blended in full: the eye sees steps of
 * 5 %, and a ramp keeps an edge whose contrast passes the first from flashing up. */
const float VTKI_EDGE_CONTRAST = 0.05f;
const float VTKI_EDGE_FULL_CONTRAST = 0.1f;
/* An edge is dropped where one that it meets has so many times its contrast: creases that end at an outline. */
const float VTKI_EDGE_DOMINANCE = 4.0f;
/* How far the ends of a run are searched for on either side, positions. */
const int VTKI_EDGE_REACH = 31;
/* How far the ends of a diagonal are searched for on either side, positions; and how long it must be, so that it
 * tells more of the outline than runs do, which have up to two positions there. */
const int VTKI_DIAGONAL_REACH = 15;
const int VTKI_DIAGONAL_LENGTH = 3;

/* A step of depth or of the normal from pixel to pixel is an outline where it is so many times those beside it.
 * On what is round, steps grow towards its outline, next to which depth and angle go with the root of the distance:
 * by 1 / (sqrt(2) - 1) = 2.42 at most. */
const float VTKI_OUTLINE_RATIO = 2.5f;

/* Whether depth leaps between the middle two of four pixels in a row: depths of the depth buffer; 1 where nothing is
 * drawn, and beyond the picture. They are affine on a plane, so that a plane's step is that of the pixels on either
 * side. On what is bent to one side the step lies between its neighbours'; where it winds it may be the largest,
 * within the ratio for waves of six pixels. What is thin steps there and back again: what a step of the other sign
 * says is only taken where both sides have one. */
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
  // Two roundings of the step, and as many of a neighbour's for each time.
  return (hasBefore || hasBehind) &&
    step > VTKI_OUTLINE_RATIO * most + (2.0f + 2.0f * VTKI_OUTLINE_RATIO) * VTKI_DEPTH_ROUNDING;
}

/* Whether normals turn at once between the middle two of four pixels, which are lit: by more than on either side,
 * and so far that light may show it. */
bool vtkiIsCrease(vec2 code0, vec2 code1, vec2 code2, vec2 code3, bool hasBefore, bool hasBehind)
{
  vec3 n1 = vtkiOctahedralDecode(code1);
  vec3 n2 = vtkiOctahedralDecode(code2);
  vec3 turn = n2 - n1;
  vec3 before = n1 - vtkiOctahedralDecode(code0);
  vec3 behind = vtkiOctahedralDecode(code3) - n2;
  // Squares of all. A cosine changes by no more than the chord between the normals.
  float most = max(hasBefore ? dot(before, before) : 0.0f, hasBehind ? dot(behind, behind) : 0.0f);
  return (hasBefore || hasBehind) &&
    dot(turn, turn) >
      max(VTKI_OUTLINE_RATIO * VTKI_OUTLINE_RATIO * most, VTKI_EDGE_CONTRAST * VTKI_EDGE_CONTRAST);
}

/* Whether a surface ends between the middle two of four pixels in a row: at the background, at another kind of
 * surface, at another prop that is not lit, where depth leaps, or at a crease. surface0 to surface3: texels of the
 * geometry buffer. */
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

/* The greatest difference of a channel, of colours as they are shown. */
float vtkiContrast(vec4 a, vec4 b)
{
  vec4 d = abs(a - b);
  return max(max(d.x, d.y), max(d.z, d.w));
}

/* How much of an edge of that contrast is blended. */
float vtkiEdgeStrength(float contrast)
{
  return min(max((contrast - VTKI_EDGE_CONTRAST) *
                 (1.0f / (VTKI_EDGE_FULL_CONTRAST - VTKI_EDGE_CONTRAST)),
               0.0f),
    1.0f);
}

/* Number of the lowest bit and of the highest of a word that is not zero: the exponent of a float that has no
 * other bit, or none next to it that it could be rounded up by. */
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

/* How many positions behind the one of bit 0 belong to its run: up to VTKI_EDGE_REACH, which says that its
 * end is farther away. edges, breaks: windows from that position on; a break at a position parts it from the
 * one before. */
int vtkiRunForward(uint edges, uint breaks)
{
  return vtkiLowestBit(~((edges & ~breaks) >> 1u));
}

/* The same before the position of bit 31, of windows that end with it. */
int vtkiRunBackward(uint edges, uint breaks)
{
  return 31 - vtkiHighestBit(~((edges & ~(breaks >> 1u)) << 1u));
}

/* Where the outline goes at the end of a run: half a pixel to the side of the greater lines, half a pixel to
 * the other side (negative), or on (0).
 * across: edges that cross the end, of the lines l - 2 to l + 1 in bits 0 to 3, for a run between the lines
 * l - 1 and l. before, behind: the edges of the positions before and behind the end, between lines l - 3 and
 * l - 2 in bit 0, to l and l + 1 in bit 3. first: whether the run begins at this end. */
float vtkiRunEnd(uint across, uint before, uint behind, bool first)
{
  bool up = (across & 4u) != 0u;
  bool down = (across & 2u) != 0u;
  if (up && down)
  {
    // Where outlines cross, one pair of pixels that face each other across the corner belongs together: the
    // pair of what is one pixel thin.
    bool crossing = (before & behind & 4u) != 0u;
    bool rising = (before & 2u) != 0u || (behind & 8u) != 0u;
    bool falling = (before & 8u) != 0u || (behind & 2u) != 0u;
    float side = crossing && rising != falling ? (rising ? 0.5f : -0.5f) : 0.0f;
    return first ? -side : side;
  }
  // A step is one pixel high, and the outline goes on outwards behind it. Where it does not there is a corner or
  // the end of a line, which stays sharp.
  uint outside = first ? before : behind;
  return up && (outside & 8u) != 0u ? 0.5f : (down && (outside & 2u) != 0u ? -0.5f : 0.0f);
}

/* Area that a triangle cuts off the part from a to b of a run: its height is `height` at 0 and 0 at `length`. */
float vtkiCutArea(float height, float length, float a, float b)
{
  float end = min(b, length);
  return end > a ? height * (end - a) * (1.0f - 0.5f * (a + end) / length) : 0.0f;
}

/* What the outline of a run leaves of the pixels at one of its positions, with `backward` positions of the run
 * before it and `forward` behind: the share that the pixel of the greater line loses to its neighbour, and the
 * other way round. firstEnd, lastEnd: of vtkiRunEnd. From each end the outline reaches the pixels' border in
 * the middle of the run; where both ends turn to different sides it is one straight line. */
vec2 vtkiRunAreas(int backward, int forward, float firstEnd, float lastEnd)
{
  float s = float(backward);
  float t = float(forward);
  float middle = 0.5f * (s + t + 1.0f);
  float a = vtkiCutArea(firstEnd, middle, s, s + 1.0f);
  float b = vtkiCutArea(lastEnd, middle, t, t + 1.0f);
  return vec2(max(a, 0.0f) + max(b, 0.0f), max(-a, 0.0f) + max(-b, 0.0f));
}

/* Near 45 degrees an outline is made of diagonals: one step a position, but here and there two positions or two
 * lines for one step. Sheared by one line a position, a diagonal is a run and these are its steps; shearing
 * leaves pixels' centres where centres are, so that the line goes through the middles of the steps as it does
 * along a run.
 * Where the line goes at a diagonal's end, as of vtkiRunEnd. turn: 1 where the diagonal rises to greater lines
 * with the position, -1 where it falls. isFlat: two positions for one step at the end; isSteep: two lines. */
float vtkiDiagonalEnd(bool isFlat, bool isSteep, int turn, bool first)
{
  float side = isFlat == isSteep ? 0.0f : (isFlat ? -0.5f : 0.5f);
  return float(turn) * (first ? -side : side);
}

/* Integral of min(max(x, 0), 1) up to v. */
float vtkiRampArea(float v)
{
  return v > 0.0f ? (v < 1.0f ? 0.5f * v * v : v - 0.5f) : 0.0f;
}

/* Area of a pixel below a line that passes the middle of the pixel's position at that height over its lower
 * border. slope: greater than 0; that of a line which falls is the same. */
float vtkiAreaBelow(float height, float slope)
{
  return (vtkiRampArea(height + 0.5f * slope) - vtkiRampArea(height - 0.5f * slope)) / slope;
}

/* As vtkiRunAreas, of a diagonal. Where neither end says where the line is it may be anywhere between the
 * centres of the pixels: the mean over all of these is a sixth, and no other share has a smaller error there. */
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
  // In the middle itself both ends have a say.
  slope = place == middle ? 0.5f * (lastEnd - firstEnd) / middle : slope;
  slope = 1.0f + float(turn) * slope;
  return vec2(vtkiAreaBelow(height, slope), vtkiAreaBelow(-height, slope));
}

/* The share of two neighbours on opposite sides that a pixel takes on, from the areas that either has of it:
 * their mean with the areas for weights, so that what is one pixel large does not vanish. */
vec2 vtkiNeighborShares(float area1, float area2)
{
  float sum = area1 + area2;
  return sum > 0.0f ? vec2(area1 * area1 / sum, area2 * area2 / sum) : vec2(0.0f);
}
#endif
