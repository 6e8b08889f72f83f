// Receiver planes for percentage-closer shadow look-ups (Reeves, Salesin, Cook 1987).
#ifndef vtkIndirectLibShadow
#define vtkIndirectLibShadow
#include "vtkIndirectLibSurface.glsl"

/* Linear depth along the map's axis to what the depth buffer stores, [0,1]. */
float vtkiDepthToBuffer(float depth, float nearPlane, float farPlane, bool parallel)
{
  if (parallel)
  {
    return (depth - nearPlane) / (farPlane - nearPlane);
  }
  return depth > 0.0f ? farPlane * (depth - nearPlane) / (depth * (farPlane - nearPlane)) : 0.0f;
}

/* Derivative of that by linear depth: turns a length along the axis into a difference of depths. */
float vtkiDepthToBufferSlope(float depth, float nearPlane, float farPlane, bool parallel)
{
  if (parallel)
  {
    return 1.0f / (farPlane - nearPlane);
  }
  return depth > 0.0f ? farPlane * nearPlane / (depth * depth * (farPlane - nearPlane)) : 0.0f;
}

/* How a receiver's plane runs in the depth buffer: change per texel in x and y, and 1 in z, or 0 in z
 * for a plane that does not face the map. What a depth buffer stores is affine over the image of a
 * plane, so this is exact, and every texel can be compared with the plane's own depth there.
 * p: receiver in the map's view coordinates (-z forward); n: its unit normal there; texel: width of a
 * texel in tangents (perspective) or lengths (parallel). The plane n.x = n.p meets the ray through
 * tangents t at depth (n.p) / (n.(t,-1)). */
vec3 vtkiPlaneDepthGradient(
  vec3 p, vec3 n, float texel, float nearPlane, float farPlane, bool parallel)
{
  if (parallel)
  {
    float scale = n.z > 0.0f ? texel / (n.z * (farPlane - nearPlane)) : 0.0f;
    return vec3(n.x * scale, n.y * scale, n.z > 0.0f ? 1.0f : 0.0f);
  }
  // facing = depth * cosine between the normal and the way to the light
  float facing = -dot(n, p);
  float scale =
    facing > 0.0f ? farPlane * nearPlane * texel / (facing * (farPlane - nearPlane)) : 0.0f;
  return vec3(n.x * scale, n.y * scale, facing > 0.0f ? 1.0f : 0.0f);
}

/* A plane's slope over a map, in the bits of a float: of depth by length (parallel), or of inverse depth times depth
 * by tangents. It is the direction of a normal that faces the light; steep ones lose most, a hundredth at 100. */
float vtkiPackSlope(vec2 slope)
{
  return vtkiPackNormal(normalize(vec3(slope.x, slope.y, 1.0f)), VTKI_SURFACE_LINEAR);
}

vec2 vtkiUnpackSlope(float bits)
{
  vec2 p = vtkiUnpackCode(bits);
  return p * (1.0f / max(1.0f - abs(p.x) - abs(p.y), 1.0e-5f));
}

// Surfaces that meet at less than this angle's cosine are facets of one: what of their planes lies before a
// receiver by no more than they are apart tells nothing, since others may lie between them.
const float VTKI_SHADOW_FACET_COSINE = 0.7f;

/* A receiver as its map sees it: the depth that would be stored, its plane's change of that over a texel, one over a
 * texel's width along depth, and what stored depths may be nearer by and still be the receiver's own surface: on its
 * plane, by rounding alone; on a surface that its facets stand for, by the bias. */
struct vtkiShadowPlane
{
  float reference;
  vec2 gradient;
  float perTexel;
  float rounding;
  float bias;
  bool turned; // the facet is turned away from the light, which the normal that it is shaded by faces still
  vec2 facet;  // change of depth on the facet
};

/* What texels around a receiver say: the weights of those from which it is hidden; whether something hides it
 * whose plane comes out of the receiver's beside it or there; of what hides it, at the texel of the greatest weight, the plane: its
 * depth at the receiver, its change over a texel; and which of the texels see it. */
struct vtkiShadowVotes
{
  float hidden;
  bool contact;
  float most;
  float depth;
  vec2 gradient;
  int seen; // bits of texels
};

vtkiShadowVotes vtkiBeginShadow()
{
  vtkiShadowVotes votes;
  votes.hidden = 0.0f;
  votes.contact = false;
  votes.most = 0.0f;
  votes.depth = 1.0f;
  votes.gradient = vec2(0.0f);
  votes.seen = 0;
  return votes;
}

/* Number of the lowest bit that is set; of up to 2^24. */
int vtkiLowestBit(int bits)
{
  return int((floatBitsToUint(float(bits & -bits)) >> 23u) - 127u);
}

/* The nine texels around a receiver, by number: three rows of three. */
vec2 vtkiShadowNeighbor(int i)
{
  float row = i > 5 ? 1.0f : (i > 2 ? 0.0f : -1.0f);
  return vec2(float(i) - 3.0f * row - 4.0f, row);
}

/* Weight of one of three texels, -1 to 1, of a tent that is three texels wide at most; toCenter: to the middle one's
 * centre, half a texel at most. */
float vtkiShadowWeight(float offset, float toCenter)
{
  return 0.5f * (offset == 0.0f ? 1.0f : (0.5f - offset * toCenter));
}

/* A texel's vote. offset: from the receiver to the texel's centre, in texels; stored: its depth; gradient: how that
 * changes over a texel on the plane of what it holds.
 *   A surface hides the receiver where it lies before the receiver's plane at the texel, and its own plane before the
 * receiver at the receiver's place. Of one smooth surface never both hold: what bends away from the light lies behind the
 * receiver's plane, and the plane of what bends towards the light passes behind the receiver. Where only the first
 * holds the two planes meet between the texel and the receiver, as at the foot of a wall: what a map sees beyond
 * that line tells nothing of the receiver. Where they meet as near on the receiver's other side, as behind a thin wall, the
 * texel tells that the receiver is hidden only if none sees it; so it does where they meet at the receiver, within
 * rounding, as in a corner of a closed body whose inside the receiver is on. */
void vtkiVoteOnShadow(vtkiShadowPlane receiver, vec2 offset, float stored, vec2 gradient, float weight, int number,
  VTKI_INOUT(vtkiShadowVotes) votes)
{
  float depthThere = stored - gradient.x * offset.x - gradient.y * offset.y;
  float plane = receiver.reference + receiver.gradient.x * offset.x + receiver.gradient.y * offset.y;
  // The map ends with what casts shadows: a receiver behind that is compared with its end, where nothing is.
  bool before = stored < min(plane - receiver.bias, 1.0f);
  // Slopes are rounded to a hundredth at most.
  float rounding = receiver.rounding + 0.01f * (abs(gradient.x) + abs(gradient.y));
  bool over = depthThere < receiver.reference - rounding;
  // Light that comes to the back of the receiver's own facet does not go through it.
  vec2 apart = abs(gradient - receiver.facet);
  bool behind = receiver.turned && abs(depthThere - receiver.reference) <= rounding &&
    (apart.x + apart.y) * receiver.perTexel <=
      0.1f * (1.0f + (abs(gradient.x) + abs(gradient.y)) * receiver.perTexel);
  bool hides = before && over;
  bool contact = 2.0f * (receiver.reference - depthThere) < plane - stored;
  vec2 own = receiver.gradient * receiver.perTexel;
  vec2 other = gradient * receiver.perTexel;
  float product = 1.0f + own.x * other.x + own.y * other.y;
  float lengths2 = (1.0f + own.x * own.x + own.y * own.y) * (1.0f + other.x * other.x + other.y * other.y);
  bool alike = product > 0.0f &&
    product * product > VTKI_SHADOW_FACET_COSINE * VTKI_SHADOW_FACET_COSINE * lengths2;
  hides = (hides && !(contact && alike)) || behind;
  bool through = !alike && depthThere < receiver.reference + rounding;
  bool edge = through && stored < plane + receiver.bias;
  votes.seen |= before || edge || behind ? 0 : (1 << number);
  votes.hidden += hides && !contact ? weight : 0.0f;
  votes.contact = votes.contact || (before && contact && through) || behind;
  bool first = hides && weight > votes.most;
  votes.most = first ? weight : votes.most;
  votes.depth = first ? depthThere : votes.depth;
  votes.gradient = first ? gradient : votes.gradient;
}

/* Whether a texel that sees the receiver counts, by its number. Not beyond the line where what hides the receiver meets
 * the receiver's plane, as on the other side of a thin wall, nor where it holds that itself. Nor where what it holds lies
 * so far behind the receiver's plane that the receiver's surface has ended, as beyond the rim of a closed body whose
 * inside the receiver is on: it may bend away by half a texel's width and half of its rise over one. */
bool vtkiCountsForShadow(
  vtkiShadowPlane receiver, vec2 offset, float stored, int number, vtkiShadowVotes votes)
{
  float plane = receiver.reference + receiver.gradient.x * offset.x + receiver.gradient.y * offset.y;
  float before = votes.depth + votes.gradient.x * offset.x + votes.gradient.y * offset.y;
  bool beside = plane - before > receiver.rounding && stored > 0.5f * (plane + before);
  bool ended = stored > plane + receiver.bias + 0.5f * (abs(receiver.gradient.x) + abs(receiver.gradient.y));
  bool counts = votes.most > 0.0f ? beside && !ended : !(votes.contact && ended);
  return ((votes.seen >> number) & 1) == 1 && counts;
}

/* Share of the light; seen: the weights of texels that count. */
float vtkiShareOfShadow(float seen, vtkiShadowVotes votes)
{
  float counted = seen + votes.hidden;
  return counted > 0.0f ? seen / counted : (votes.contact ? 0.0f : 1.0f);
}
#endif
