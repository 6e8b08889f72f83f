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

/* Linear depth of what the depth buffer stores, perspective. */
float vtkiDepthOfBuffer(float stored, float nearPlane, float farPlane)
{
  return nearPlane * farPlane / (farPlane - stored * (farPlane - nearPlane));
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
  return p / max(1.0f - abs(p.x) - abs(p.y), 1.0e-5f);
}

/* A receiver as its map sees it: the depth that would be stored, its plane's change of that over a texel, and what
 * stored depths may be nearer by and still be the receiver's own surface: on its plane, by rounding alone; on a surface
 * that its facets stand for, by the bias. */
struct vtkiShadowPlane
{
  float reference;
  vec2 gradient;
  float rounding;
  float bias;
};

/* What texels around a receiver say: the weights of those that see it and of those from which it is hidden; and of
 * what hides it, at the texel of the greatest weight, the plane: its depth at the receiver, its change over a texel. */
struct vtkiShadowVotes
{
  float hidden;
  float most;
  float depth;
  vec2 gradient;
  int seen; // bits of texels
};

vtkiShadowVotes vtkiBeginShadow()
{
  vtkiShadowVotes votes;
  votes.hidden = 0.0f;
  votes.most = 0.0f;
  votes.depth = 1.0f;
  votes.gradient = vec2(0.0f);
  votes.seen = 0;
  return votes;
}

/* The nine texels around a receiver, by number. */
vec2 vtkiShadowNeighbor(int i)
{
  return vec2(float(i % 3) - 1.0f, float(i / 3) - 1.0f);
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
 * that line tells nothing of the receiver. */
void vtkiVoteOnShadow(vtkiShadowPlane receiver, vec2 offset, float stored, vec2 gradient, float weight, int number,
  VTKI_INOUT(vtkiShadowVotes) votes)
{
  float depthThere = stored - gradient.x * offset.x - gradient.y * offset.y;
  float plane = receiver.reference + receiver.gradient.x * offset.x + receiver.gradient.y * offset.y;
  // The map ends with what casts shadows: a receiver behind that is compared with its end, where nothing is.
  bool before = stored < min(plane - receiver.bias, 1.0f);
  // Slopes are rounded to a hundredth at most.
  float rounding = receiver.rounding + 0.01f * (abs(gradient.x) + abs(gradient.y));
  bool hides = before && depthThere < receiver.reference - rounding;
  votes.seen |= before ? 0 : (1 << number);
  votes.hidden += hides ? weight : 0.0f;
  bool first = hides && weight > votes.most;
  votes.most = first ? weight : votes.most;
  votes.depth = first ? depthThere : votes.depth;
  votes.gradient = first ? gradient : votes.gradient;
}

/* Share of the light. Texels beyond the line where what hides the receiver meets the receiver's plane, as
 * those on the other side of a thin wall, do not count. toCenter: to the middle texel's centre. */
float vtkiCountShadow(vtkiShadowPlane receiver, vec2 toCenter, vtkiShadowVotes votes)
{
  float seen = 0.0f;
  for (int i = 0; i < 9; ++i)
  {
    vec2 neighbor = vtkiShadowNeighbor(i);
    vec2 offset = neighbor + toCenter;
    float height = receiver.reference - votes.depth +
      (receiver.gradient.x - votes.gradient.x) * offset.x + (receiver.gradient.y - votes.gradient.y) * offset.y;
    bool counts = ((votes.seen >> i) & 1) == 1 && (votes.most == 0.0f || height > receiver.bias);
    seen += counts ? vtkiShadowWeight(neighbor.x, toCenter.x) * vtkiShadowWeight(neighbor.y, toCenter.y) : 0.0f;
  }
  float counted = seen + votes.hidden;
  return counted > 0.0f ? seen / counted : 1.0f;
}
#endif
