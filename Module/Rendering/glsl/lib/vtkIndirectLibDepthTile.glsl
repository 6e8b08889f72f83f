// Depth maps of single emitters, tiles of one atlas: where a receiver falls in a tile, and at what depth
// its own plane would be there. Lengths are scene units (diagonal = 1).
#ifndef vtkIndirectLibDepthTile
#define vtkIndirectLibDepthTile
#include "vtkIndirectLibPortable.glsl"

// Tangent of the half angle that the tile of a virtual light sees about its normal. The square holds 92 %
// of what a diffuse sender sends.
const float VTKI_TILE_TANGENT = 3.0f;
// Near and far end of such a tile: a scene is one across, and nothing reaches farther.
const float VTKI_TILE_NEAR = 1.0f / 2048.0f;
const float VTKI_TILE_FAR = 1.0f;
// The tile of an area light is fitted to what can hide the light: at most so far to the sides, and no nearer.
const float VTKI_WINDOW_TANGENT = 5.0f;
const float VTKI_WINDOW_NEAR = 1.0f / 16384.0f;
// Facets stand for curved surfaces: a concave one rises over its neighbour's plane by less than this
// share of a texel as long as they meet at less than 16 degrees (half a texel times the sine).
const float VTKI_TILE_ROUGHNESS = 0.14f;

// Beyond the border what is to the side is compared, less this share of it: four texels there.
const float VTKI_TILE_BORDER = 0.06f;

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

/* One over the depth along a perspective tile's axis that a stored value stands for. */
float vtkiTileInverseDepth(float stored)
{
  return 1.0f / VTKI_TILE_NEAR - stored * (1.0f / VTKI_TILE_NEAR - 1.0f / VTKI_TILE_FAR);
}

/* Whether a perspective tile lets a receiver see its emitter: what is stored at a texel's centre is
 * compared with the depth of the receiver's own plane there. inverse: one over the stored depth; depth: the
 * receiver's along the tile's axis; border: the least that the tile holds in its direction, below which the
 * border's texels tell how far to the side the light gets; facing: product of the receiver's normal and the way
 * from the emitter to it; along: and the way to where depth is one on the texel's ray; bias: share of the
 * depth, by which the plane lies nearer. At grazing angles that is along its normal, since a surface bends away from it
 * by as much in a texel that it fills, but along the ray by no more than twice as much. The plane counts where it comes
 * nearer: one that runs away from the emitter does not reach behind what ends the surface. So does a wall that leans
 * over the emitter where the border sees it, above its foot. Without a division. */
bool vtkiIsSeenInPerspectiveTile(
  float inverse, float depth, float border, float facing, float along, float bias)
{
  float held = max(depth, border);
  float least = (1.0f - (depth >= border ? bias : VTKI_TILE_BORDER)) * held;
  float nearer = bias * max(-held * along, min(held, -2.0f * facing));
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
