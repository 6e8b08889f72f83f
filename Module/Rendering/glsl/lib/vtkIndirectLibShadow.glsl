// Receiver planes for percentage-closer shadow look-ups (Reeves, Salesin, Cook 1987).
#ifndef vtkIndirectLibShadow
#define vtkIndirectLibShadow
#include "vtkIndirectLibSurface.glsl"

/* Converts linear depth along the map's axis to the depth buffer's value, [0,1]. */
float vtkiDepthToBuffer(float depth, float nearPlane, float farPlane, bool parallel)
{
  if (parallel)
  {
    return (depth - nearPlane) / (farPlane - nearPlane);
  }
  return depth > 0.0f ? farPlane * (depth - nearPlane) / (depth * (farPlane - nearPlane)) : 0.0f;
}

/* Returns the derivative of vtkiDepthToBuffer by linear depth: converts a length along the axis to
 * a difference of depths. */
float vtkiDepthToBufferSlope(float depth, float nearPlane, float farPlane, bool parallel)
{
  if (parallel)
  {
    return 1.0f / (farPlane - nearPlane);
  }
  return depth > 0.0f ? farPlane * nearPlane / (depth * depth * (farPlane - nearPlane)) : 0.0f;
}

/* Returns the gradient of a receiver's plane in the depth buffer: change per texel in x and y, and
 * 1 in z, or 0 in z for a plane that does not face the map. The depth buffer's value is affine over
 * the image of a plane, so this is exact, and every texel can be compared with the plane's own
 * depth there. p: receiver in the map's view coordinates (-z forward); n: its unit normal there;
 * texel: width of a texel in tangents (perspective) or lengths (parallel). The plane n.x = n.p
 * meets the ray through tangents t at depth (n.p) / (n.(t,-1)). */
vec3 vtkiPlaneDepthGradient(
  vec3 p, vec3 n, float texel, float nearPlane, float farPlane, bool parallel)
{
  if (parallel)
  {
    float scale = n.z > 0.0f ? texel / (n.z * (farPlane - nearPlane)) : 0.0f;
    return vec3(n.x * scale, n.y * scale, n.z > 0.0f ? 1.0f : 0.0f);
  }
  // facing = depth * cosine between the normal and the direction to the light
  float facing = -dot(n, p);
  float scale =
    facing > 0.0f ? farPlane * nearPlane * texel / (facing * (farPlane - nearPlane)) : 0.0f;
  return vec3(n.x * scale, n.y * scale, facing > 0.0f ? 1.0f : 0.0f);
}

/* Packs a plane's slope over a map into the bits of a float: of depth by length (parallel), or of
 * inverse depth times depth by tangents. It is stored as the direction of a normal that faces the
 * light; steep slopes lose most, a hundredth at 100. */
float vtkiPackSlope(vec2 slope)
{
  return vtkiPackNormal(normalize(vec3(slope.x, slope.y, 1.0f)), VTKI_SURFACE_LINEAR);
}

vec2 vtkiUnpackSlope(float bits)
{
  vec2 p = vtkiUnpackCode(bits);
  return p * (1.0f / max(1.0f - abs(p.x) - abs(p.y), 1.0e-5f));
}

// Surfaces that meet at a cosine above this are facets of one curved surface: the part of a facet's
// plane before a receiver decides nothing if it is no farther before it than the facets are apart,
// since other facets may lie between them.
const float VTKI_SHADOW_FACET_COSINE = 0.7f;

/* This is a receiver as its map sees it: reference, the depth that would be stored; gradient, its
 * plane's change of depth over a texel; perTexel, one over a texel's width along depth. A nearer
 * stored depth still belongs to the receiver's own surface within rounding on its plane, and within
 * the bias on the curved surface that its facets approximate. */
struct vtkiShadowPlane
{
  float reference;
  vec2 gradient;
  float perTexel;
  float rounding;
  float bias;
  bool turned; // the facet faces away from the light and its shading normal does not
  vec2 facet;  // change of depth on the facet
};

/* Votes of the texels around a receiver: the weights of texels that hide it; whether an occluder's
 * plane comes out of the receiver's beside or at the receiver; the occluder's plane at the texel of
 * the largest weight: its depth at the receiver and its change over a texel; and the texels that
 * see the receiver. */
struct vtkiShadowVotes
{
  float hidden;
  bool contact;
  float most;
  float depth;
  vec2 gradient;
  int seen; // one bit a texel
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

/* Returns the four texels around a receiver, by number: two rows of two. */
vec2 vtkiShadowNeighbor(int i)
{
  float row = i > 1 ? 1.0f : 0.0f;
  return vec2(float(i) - 2.0f * row, row);
}

/* Returns the weight of such a texel: a tent two texels wide, so that light and shadow pass an edge
 * by a texel at most. fraction: from the first texel's centre to the receiver, in texels, 0 to 1.
 */
float vtkiShadowWeight(vec2 neighbor, vec2 fraction)
{
  return (neighbor.x > 0.0f ? fraction.x : 1.0f - fraction.x) *
    (neighbor.y > 0.0f ? fraction.y : 1.0f - fraction.y);
}

/* A texel's vote. offset: from the receiver to the texel's centre, in texels; stored: its depth;
 * gradient: change of depth over a texel on the plane of the texel's surface.
 *   A surface hides the receiver if it lies before the receiver's plane at the texel, and its own
 * plane lies before the receiver at the receiver's place. One smooth surface never meets both
 * conditions: where it bends away from the light it lies behind the receiver's plane, and where it
 * bends towards the light its plane passes behind the receiver. If only the first holds, the two
 * planes meet between the texel and the receiver, as at the foot of a wall: the map beyond that
 * line tells nothing about the receiver. If they meet as near on the receiver's other side, as
 * behind a thin wall, the texel hides the receiver only if no texel sees it; so it does if they
 * meet at the receiver, within rounding, as in a corner of a closed body with the receiver
 * inside. */
void vtkiVoteOnShadow(vtkiShadowPlane receiver, vec2 offset, float stored, vec2 gradient, float weight, int number,
  VTKI_INOUT(vtkiShadowVotes) votes)
{
  float depthThere = stored - gradient.x * offset.x - gradient.y * offset.y;
  float plane = receiver.reference + receiver.gradient.x * offset.x + receiver.gradient.y * offset.y;
  // Slopes are rounded to a hundredth at most.
  float rounding = receiver.rounding + 0.01f * (abs(gradient.x) + abs(gradient.y));
  vec2 own = receiver.gradient * receiver.perTexel;
  vec2 other = gradient * receiver.perTexel;
  float product = 1.0f + own.x * other.x + own.y * other.y;
  float lengths2 = (1.0f + own.x * own.x + own.y * own.y) * (1.0f + other.x * other.x + other.y * other.y);
  bool alike = product > 0.0f &&
    product * product > VTKI_SHADOW_FACET_COSINE * VTKI_SHADOW_FACET_COSINE * lengths2;
  // The bias is for facets of the receiver's own surface. The map ends at the last caster: a
  // receiver beyond it is compared with the map's end, which holds no caster.
  bool before = stored < min(plane - (alike ? receiver.bias : rounding), 1.0f);
  bool over = depthThere < receiver.reference - rounding;
  // Light that falls on the back of the receiver's own facet does not pass through it.
  vec2 apart = abs(gradient - receiver.facet);
  bool behind = receiver.turned && abs(depthThere - receiver.reference) <= rounding &&
    (apart.x + apart.y) * receiver.perTexel <=
      0.1f * (1.0f + (abs(gradient.x) + abs(gradient.y)) * receiver.perTexel);
  bool hides = before && over;
  bool contact = 2.0f * (receiver.reference - depthThere) < plane - stored;
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

/* Returns the depth by which the receiver's own surface may lie behind its plane at a texel around
 * it: it may bend away by half a texel's width and half of its rise over one. */
float vtkiMostBehind(vtkiShadowPlane receiver)
{
  return receiver.bias + 0.5f * (abs(receiver.gradient.x) + abs(receiver.gradient.y));
}

/* Returns true if a texel that sees the receiver counts, by its number. It does not count beyond
 * the line where the occluder meets the receiver's plane, as on the other side of a thin wall, nor
 * if it shows the occluder, nor if its surface lies so far behind the receiver's plane that the
 * receiver's surface has ended, as beyond the rim of a closed body with the receiver inside. */
bool vtkiCountsForShadow(
  vtkiShadowPlane receiver, vec2 offset, float stored, int number, vtkiShadowVotes votes)
{
  float plane = receiver.reference + receiver.gradient.x * offset.x + receiver.gradient.y * offset.y;
  float before = votes.depth + votes.gradient.x * offset.x + votes.gradient.y * offset.y;
  bool beside = plane - before > receiver.rounding && stored > 0.5f * (plane + before);
  bool ended = stored > plane + vtkiMostBehind(receiver);
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
