// Depth maps of single emitters, tiles of one atlas: where a receiver falls in a tile, and at what depth
// its own plane would be there. Lengths are scene units (diagonal = 1).
#ifndef vtkIndirectLibDepthTile
#define vtkIndirectLibDepthTile
#include "vtkIndirectLibPortable.glsl"

// Tangent of the half angle that the tile of a virtual light sees about its normal. The square holds 92 %
// of what a diffuse sender sends; the strips below it hold the rest.
const float VTKI_TILE_TANGENT = 3.0f;
// Height of the strips of a perspective tile, all together, over the width of the tile.
const float VTKI_TILE_STRIPS = 0.25f;
// Near and far end of such a tile: a scene is one across, and nothing reaches farther.
const float VTKI_TILE_NEAR = 1.0f / 2048.0f;
const float VTKI_TILE_FAR = 1.0f;
// The tile of an area light is fitted to what can hide the light: at most so far to the sides, and no nearer.
const float VTKI_WINDOW_TANGENT = 5.0f;
const float VTKI_WINDOW_NEAR = 1.0f / 16384.0f;
// Facets stand for curved surfaces: a concave one rises over its neighbour's plane by less than this
// share of a texel as long as they meet at less than 16 degrees (half a texel times the sine).
const float VTKI_TILE_ROUGHNESS = 0.14f;

/* Two axes across a unit vector n: x, y, n are right-handed. Without a branch, and continuous but for one
 * direction (Duff, Burgess, Christensen, Hery, Kensler, Liani, Villemin 2017, "Building an orthonormal
 * basis, revisited"). */
void vtkiFrameAlong(vec3 n, VTKI_OUT(vec3) x, VTKI_OUT(vec3) y)
{
  float s = n.z >= 0.0f ? 1.0f : -1.0f;
  float a = -1.0f / (s + n.z);
  float b = n.x * n.y * a;
  x = vec3(1.0f + s * n.x * n.x * a, s * b, -s * n.x);
  y = vec3(b, s + n.y * n.y * a, -n.y);
}

/* The view of a perspective tile that a receiver falls in. A tile has five views, which together hold the half space
 * that the emitter faces: one ahead, as wide as its limit, and four strips below it in the atlas, each along an axis to
 * a side, from the emitter's horizon up to where the view ahead begins. */
struct vtkiTileView
{
  int strip;    // towards right, left, up or down of the tile; -1: ahead
  vec3 away;    // the way from the emitter to the receiver, along the view's axes right, up and forward
  vec3 normal;  // the receiver's, along the same
};

/* away, normal: along the tile's axes right, up and that of the emitter; limit: tangent of the view ahead. */
vtkiTileView vtkiFindTileView(vec3 away, vec3 normal, float limit)
{
  float x = abs(away.x);
  float y = abs(away.y);
  bool beside = max(x, y) > limit * away.z;
  bool across = x >= y;
  float to = across ? away.x : away.y;
  // A strip's axis to the right: up and down of the tile seen to its right and left, left and right seen up and down.
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

/* Half the size of a view, in texels of the atlas. texels: along an edge of the view ahead. */
vec2 vtkiHalfOfView(int strip, float texels)
{
  return strip < 0 ? vec2(0.5f * texels, 0.5f * texels)
                   : vec2(0.25f * texels, 0.25f * VTKI_TILE_STRIPS * texels);
}

/* Where its middle lies from the middle of the view ahead: strips lie two by two. */
vec2 vtkiPlaceOfView(int strip, float texels)
{
  float column = strip == 1 || strip == 3 ? 0.5f : -0.5f;
  float row = strip > 1 ? 1.5f : 0.5f;
  return strip < 0
    ? vec2(0.0f, 0.0f)
    : vec2(0.5f * column * texels, (0.5f * VTKI_TILE_STRIPS * row - VTKI_TILE_STRIPS - 0.5f) * texels);
}

/* Whether a perspective tile lets a receiver see its emitter: what is stored at a texel's centre is
 * compared with the depth of the receiver's own plane there. inverse: one over the stored depth; depth: the
 * receiver's along the view's axis; facing: product of the receiver's normal and the way
 * from the emitter to it; along: and the way to where depth is one on the texel's ray; bias: share of the
 * depth, by which the plane lies nearer. At grazing angles that is along its normal, since a surface bends away from it
 * by as much in a texel that it fills, but along the ray by no more than twice as much. The plane counts where it comes
 * nearer: one that runs away from the emitter does not reach behind what ends the surface. Without a division. */
bool vtkiIsSeenInPerspectiveTile(
  float inverse, float depth, float facing, float along, float bias)
{
  float least = (1.0f - bias) * depth;
  float nearer = bias * max(-depth * along, min(depth, -2.0f * facing));
  bool onPlane = facing < 0.0f && along <= (facing + nearer) * inverse;
  return depth <= VTKI_TILE_NEAR || least * inverse <= 1.0f || onPlane;
}

/* Whether a parallel tile lets a receiver see its emitter: what is stored at a texel's centre, [0,1], is
 * compared with the depth of the receiver's own plane there. depth: the receiver's, less the bias; facing: its
 * cosine towards the emitter over the range of depth; rise: how much nearer to the emitter, over that range,
 * the plane runs from the receiver to the texel's centre, times facing. The plane counts where it comes
 * nearer: one that runs away from the emitter does not reach behind what ends the surface. At the end of the map
 * nothing is. Without a division, because a sky has hundreds of these at a pixel. */
bool vtkiIsSeenInParallelTile(float stored, float depth, float facing, float rise)
{
  return stored >= 1.0f || (stored - depth) * facing >= min(rise, 0.0f);
}
#endif
