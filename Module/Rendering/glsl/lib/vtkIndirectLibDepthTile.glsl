// Depth maps of single virtual lights, sky directions and points of lamps, tiles of one atlas: the
// place of a receiver in a tile, and the depth of its own plane there. Lengths are scene units
// (diagonal = 1).
#ifndef vtkIndirectLibDepthTile
#define vtkIndirectLibDepthTile
#include "vtkIndirectLibPortable.glsl"

// This is the tangent of the half angle of a virtual light's tile about its normal. The square
// covers 92 % of the light of a diffuse sender; the strips below the tile cover the rest.
const float VTKI_TILE_TANGENT = 3.0f;
// This is the height of all strips of a perspective tile together over the width of the tile.
const float VTKI_TILE_STRIPS = 0.25f;
// Near and far end of such a tile: the scene is one unit across.
const float VTKI_TILE_NEAR = 1.0f / 2048.0f;
const float VTKI_TILE_FAR = 1.0f;
// The tile of an area light is fitted to the casters that can occlude it: up to this tangent to the
// sides, and no nearer than this.
const float VTKI_WINDOW_TANGENT = 5.0f;
const float VTKI_WINDOW_NEAR = 1.0f / 16384.0f;
// Facets approximate curved surfaces: a concave neighbour rises over the receiver's plane by less
// than this share of a texel if the facets meet at less than 16 degrees (half a texel times the
// sine).
const float VTKI_TILE_ROUGHNESS = 0.14f;

/* Two axes perpendicular to a unit vector n: x, y, n are right-handed. Without a branch, and
 * continuous except at one direction (Duff, Burgess, Christensen, Hery, Kensler, Liani, Villemin
 * 2017, "Building an orthonormal basis, revisited"). */
void vtkiFrameAlong(vec3 n, VTKI_OUT(vec3) x, VTKI_OUT(vec3) y)
{
  float s = n.z >= 0.0f ? 1.0f : -1.0f;
  float a = -1.0f / (s + n.z);
  float b = n.x * n.y * a;
  x = vec3(1.0f + s * n.x * n.x * a, s * b, -s * n.x);
  y = vec3(b, s + n.y * n.y * a, -n.y);
}

/* This is the view of a perspective tile that contains a receiver. A tile has five views, which
 * together cover the half space that the light faces: a forward view, as wide as its limit, and
 * four strips below it in the atlas, each along an axis to a side, from the light's horizon up to
 * the edge of the forward view. */
struct vtkiTileView
{
  int strip;    // to the right, left, up or down of the tile; -1: forward
  // vector from the light to the receiver, along the view's axes right, up and forward
  vec3 away;
  vec3 normal;  // the receiver's normal, along the same axes
};

/* away, normal: along the tile's axes right, up and forward; limit: tangent of the forward view. */
vtkiTileView vtkiFindTileView(vec3 away, vec3 normal, float limit)
{
  float x = abs(away.x);
  float y = abs(away.y);
  bool beside = max(x, y) > limit * away.z;
  bool across = x >= y;
  float to = across ? away.x : away.y;
  // A strip's right axis: the tile's vertical for the strips to its right and left, its horizontal
  // for those up and down.
  float turn = (to < 0.0f) == across ? -1.0f : 1.0f;
  float aside = turn * (across ? away.y : away.x);
  float normalAside = turn * (across ? normal.y : normal.x);
  float normalTo = (to < 0.0f ? -1.0f : 1.0f) * (across ? normal.x : normal.y);
  vtkiTileView view;
  view.strip = beside ? (across ? 0 : 2) + (to < 0.0f ? 1 : 0) : -1;
  view.away = beside ? vec3(aside, away.z, max(x, y)) : away;
  view.normal = beside ? vec3(normalAside, normal.z, normalTo) : normal;
  return view;
}

/* Returns half the size of a view in texels of the atlas. texels: along an edge of the forward
 * view. */
vec2 vtkiHalfOfView(int strip, float texels)
{
  return strip < 0 ? vec2(0.5f * texels, 0.5f * texels)
                   : vec2(0.25f * texels, 0.25f * VTKI_TILE_STRIPS * texels);
}

/* Returns the offset of a view's middle from that of the forward view: the strips lie two by two.
 */
vec2 vtkiPlaceOfView(int strip, float texels)
{
  float column = strip == 1 || strip == 3 ? 0.5f : -0.5f;
  float row = strip > 1 ? 1.5f : 0.5f;
  return strip < 0
    ? vec2(0.0f, 0.0f)
    : vec2(0.5f * column * texels, (0.5f * VTKI_TILE_STRIPS * row - VTKI_TILE_STRIPS - 0.5f) * texels);
}

// This is the share of the bias by which a surface may stand before the receiver on the receiver's
// own ray where further texels tell a crease from an occluder: the whole bias lets light through
// walls beside the creases of closed bodies.
const float VTKI_TILE_LEAST_BIAS = 0.5f;

/* Returns true if a perspective tile shows the receiver from its light: compares the depth stored
 * at a texel's centre with the depth of the receiver's own plane there. inverse: one over the
 * stored depth; depth: the receiver's along the view's axis; facing: product of the receiver's
 * normal and the vector from the light to it; along: product of the normal and the vector to depth
 * one on the texel's ray; bias: share of the depth by which the plane is moved nearer. At grazing
 * angles the bias is along the normal, since a surface that fills a texel bends away from the plane
 * by as much, but along the ray at most twice as much. least: share of the depth by which the
 * receiver itself is moved nearer, up to the bias. The plane counts only where it comes nearer: a
 * plane that recedes from the light does not extend behind the end of the surface. Needs no
 * division. */
bool vtkiIsSeenInPerspectiveTile(
  float inverse, float depth, float facing, float along, float bias, float least)
{
  float nearer = bias * max(-depth * along, min(depth, -2.0f * facing));
  bool onPlane = facing < 0.0f && along <= (facing + nearer) * inverse;
  return depth <= VTKI_TILE_NEAR || (1.0f - least) * depth * inverse <= 1.0f || onPlane;
}

/* Returns true if the receiver's surface ends before the texel's centre, as beyond the rim of a
 * closed body with the receiver inside: the receiver's plane comes nearer to the light there, and
 * the tile shows something farther behind the plane than two texels: a surface may bend away within
 * a texel, and a sample of several pixels stands before the surface. Such a texel does not tell
 * what hides the receiver. Values are those of vtkiIsSeenInPerspectiveTile. Needs no division. */
bool vtkiEndsInPerspectiveTile(float inverse, float depth, float facing, float along, float bias)
{
  float bend = (2.0f / VTKI_TILE_ROUGHNESS) * bias * depth;
  return along * depth < facing && along < (facing - bend) * inverse;
}

/* This is the greatest depth of a receiver over the depth of a surface that the receiver's surface
 * meets in a crease: 1.25 at half a texel from a wall that the light sees at 7 degrees. A surface
 * farther before the receiver hides the receiver. */
const float VTKI_TILE_CREASE = 1.25f;

/* Returns the step in texels from a receiver's texel to the one of the eight texels around it that
 * lies nearest to the line from the receiver through the texel's centre. offset: from the receiver
 * to the centre. */
vec2 vtkiStepBeyond(vec2 offset)
{
  const float least = 0.41421356f; // tangent of 22.5 degrees
  vec2 size = abs(offset);
  return vec2(size.x > least * size.y ? (offset.x < 0.0f ? -1.0f : 1.0f) : 0.0f,
    size.y > least * size.x ? (offset.y < 0.0f ? -1.0f : 1.0f) : 0.0f);
}

/* Returns true if the surface that a texel shows lies behind the receiver on the receiver's ray, as
 * beyond a crease between the receiver and the texel's centre, where a floor meets a wall. One over
 * the depth is linear over the view on a plane, so that texels farther from the receiver extend the
 * surface to the receiver. inverse: one over the stored depth; depth: the receiver's; rise: of one
 * over the surface's depth from the receiver to the texel's centre. Needs no division. */
bool vtkiMeetsInPerspectiveTile(float inverse, float depth, float rise)
{
  return (inverse - rise) * depth <= 1.0f && inverse * depth <= VTKI_TILE_CREASE;
}

/* Returns true if a texel shows the receiver's own surface. Values are those of
 * vtkiIsSeenInPerspectiveTile. A texel at the receiver's side of an edge tells whether the light
 * sees a receiver whose own texel shows what lies beyond the edge. Needs no division. */
bool vtkiShowsPlaneInPerspectiveTile(
  float inverse, float depth, float facing, float along, float bias)
{
  float behind = along - facing * inverse;
  float share = bias * depth * inverse;
  return behind <= share && behind >= -(2.0f / VTKI_TILE_ROUGHNESS) * share;
}

/* Answer of a texel of a parallel tile: 1 if the tile shows the receiver from its light, and 1 if
 * the texel tells whether it does. Compares the value stored at the texel's centre, [0,1], with the
 * depth of the receiver's own plane there. outside: the texel lies beyond the tile's border, where
 * no casters are; depth: the receiver's, less the bias; facing: its cosine towards the light over
 * the range of depth; slope: change of the plane's depth over a texel, times facing; offset: from
 * the receiver to the centre in texels; bend: half a texel along the normal, in the same units.
 *   The plane counts only where it comes nearer: a plane that recedes from the light does not
 * extend behind the end of the surface. A stored 1 means no caster. The texel does not tell where
 * the surface ends before the texel's centre, see vtkiEndsInPerspectiveTile. Needs no division,
 * because a sky has hundreds of these tests at a pixel. */
vec2 vtkiLookUpParallelTile(
  bool outside, float stored, float depth, float facing, vec2 slope, vec2 offset, float bend)
{
  float rise = slope.x * offset.x + slope.y * offset.y;
  float behind = (stored - depth) * facing;
  bool seen = outside || stored >= 1.0f || behind >= min(rise, 0.0f);
  bool ended = !outside && rise < 0.0f && behind - rise > bend;
  return vec2(seen && !ended ? 1.0f : 0.0f, ended ? 0.0f : 1.0f);
}
#endif
