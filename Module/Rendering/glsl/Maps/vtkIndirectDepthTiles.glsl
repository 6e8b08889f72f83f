// Tests the visibility of a virtual light from a receiver with the light's depth map, a tile of the
// atlas.
#include "vtkIndirectLibDepthTile.glsl"

uniform sampler2D vtkiDepthTiles;
uniform vec3 vtkiTileShape; // columns and rows of tiles in the atlas, texels along an edge of a tile
// 1 if all receivers cast shadows. Tiles show no surface of other receivers, which ends nowhere.
uniform int vtkiReceiversCast;

// This is the data that all look-ups in a tile share.
struct vtkiTile
{
  vec3 right;
  vec3 up;
  vec3 axis;   // the virtual light's axis, unit
  vec3 place;  // the virtual light's position
  vec2 middle; // middle of the tile's forward view in the atlas
};

vtkiTile vtkiMakeTile(int number, vec3 place, vec3 axis)
{
  vtkiTile tile;
  vtkiFrameAlong(axis, tile.up, tile.right);
  tile.axis = axis;
  tile.place = place;
  float row = floor((float(number) + 0.5f) / vtkiTileShape.x);
  const vec2 inTile = vec2(0.5f, (0.5f + VTKI_TILE_STRIPS) / (1.0f + VTKI_TILE_STRIPS));
  tile.middle = (vec2(float(number) - row * vtkiTileShape.x, row) + inTile) / vtkiTileShape.xy;
  return tile;
}

// Looks a receiver up in a view of a tile. Area lights (VTKI_ONE_TEXEL) read one texel. Moving
// frames (VTKI_SHARES_LOOKS) read a second texel beyond the first, which tells where two surfaces
// meet, and do not ask where the receiver's surface ends: a third texel and that question take 12 %
// of a frame. All other look-ups read three texels. middle: of the forward view in the atlas;
// window: scale (xy) and offset (zw) from tangents to places in the view, from -1 to 1; tangents:
// the inverse of window; range: one over the depths at which the view begins and ends; nearest:
// least depth of a look-up.
bool vtkiIsSeenInView(
  vec2 middle, vtkiTileView view, vec4 window, vec4 tangents, vec2 range, float nearest)
{
  // Keeps divisions by constants of the tile few: OpenGL on the processor moves none out of loops.
  float texels = vtkiTileShape.z;
  float perTexel = 1.0f / texels;
  vec2 perSize = 1.0f / (vtkiTileShape.xy * vec2(texels, (1.0f + VTKI_TILE_STRIPS) * texels));
  vec2 halfSize = vtkiHalfOfView(view.strip, texels);
  vec2 perHalf = perTexel * (view.strip < 0 ? vec2(2.0f, 2.0f) : vec2(4.0f, 4.0f / VTKI_TILE_STRIPS));
  vec2 place = view.away.xy * (1.0f / max(view.away.z, nearest)) * window.xy + window.zw;
  // A place on the border of the view counts as inside in spite of rounding. The lowest row of a
  // strip lies on the light's horizon and shows the facets around the light, beyond which the
  // branches of a curved cluster see: it counts as outside.
  float lowestPlace = view.strip < 0 ? -1.0001f : perHalf.y - 1.0f;
  bool outside = max(abs(place.x), place.y) > 1.0001f || place.y < lowestPlace;
  // Offset in texels from the middle, kept within the view in spite of rounding.
  vec2 at = floor(clamp(place, -0.99999f, 0.99999f) * halfSize) + 0.5f;
  vec2 ray = at * perHalf * tangents.xy + tangents.zw;
  // A look-up at a texel's centre is exact, and in software faster than a fetch.
  vec2 corner = middle + vtkiPlaceOfView(view.strip, texels) * perSize;
  float stored = textureLod(vtkiDepthTiles, corner + at * perSize, 0.0f).r;
  float inverse = range.x - stored * (range.x - range.y);
  float along = dot(view.normal.xy, ray) + view.normal.z;
  float bias = VTKI_TILE_ROUGHNESS * max(tangents.x * perHalf.x, tangents.y * perHalf.y);
  float facing = dot(view.normal, view.away);
#ifdef VTKI_ONE_TEXEL
  float least = bias;
#else
  float least = VTKI_TILE_LEAST_BIAS * bias;
#endif
  bool onSurface = stored >= 1.0f ||
    vtkiIsSeenInPerspectiveTile(inverse, view.away.z, facing, along, bias, least);
#ifndef VTKI_ONE_TEXEL
  vec2 offset = at - place * halfSize;
  vec2 lowest = 0.5f - halfSize;
#endif
#ifdef VTKI_SHARES_LOOKS
  vec2 beyond = vtkiStepBeyond(offset);
  vec2 next = clamp(at + beyond, lowest, -lowest);
  float second = textureLod(vtkiDepthTiles, corner + next * perSize, 0.0f).r;
  float rise = (stored - second) * (range.x - range.y);
  // A diagonal step is the square root of two long.
  float steps = dot(offset, beyond) * (beyond.x * beyond.y == 0.0f ? 1.0f : 0.5f);
  return outside || onSurface ||
    vtkiMeetsInPerspectiveTile(inverse, view.away.z, steps * rise);
#else
  bool ends = vtkiReceiversCast != 0 &&
    vtkiEndsInPerspectiveTile(inverse, view.away.z, facing, along, bias);
  bool byNeighbors = false;
#ifndef VTKI_ONE_TEXEL
  // Beside the texel lie one texel at the receiver's side, which tells where the receiver's surface
  // ends before the texel's centre, and two texels at the other side, which tell otherwise.
  vec2 side = vec2(
    (offset.x < 0.0f) == ends ? 1.0f : -1.0f, (offset.y < 0.0f) == ends ? 1.0f : -1.0f);
  vec2 next = clamp(at + side, lowest, -lowest);
  vec2 stepped = vec2(next.x, ends ? next.y : at.y);
  float first = textureLod(vtkiDepthTiles, corner + stepped * perSize, 0.0f).r;
  float second = textureLod(vtkiDepthTiles, corner + vec2(at.x, next.y) * perSize, 0.0f).r;
  float inverseFirst = range.x - first * (range.x - range.y);
  float alongFirst = along + dot(view.normal.xy, (next - at) * perHalf * tangents.xy);
  vec2 rise = (stored - vec2(first, second)) * (range.x - range.y);
  byNeighbors = ends
    ? vtkiShowsPlaneInPerspectiveTile(inverseFirst, view.away.z, facing, alongFirst, bias)
    : vtkiMeetsInPerspectiveTile(inverse, view.away.z, dot(abs(offset), rise));
#endif
  return outside || byNeighbors || (!ends && onSurface);
#endif
}

// middle: of the tile's forward view in the atlas; away, normal: the vector from the virtual light
// to the receiver and the receiver's normal, along the tile's axes right, up and forward.
bool vtkiIsSeenAlongTile(vec2 middle, vec3 away, vec3 normal)
{
  const float limit = VTKI_TILE_TANGENT;
  vtkiTileView view = vtkiFindTileView(away, normal, limit);
  bool ahead = view.strip < 0;
  vec4 window = ahead ? vec4(1.0f / limit, 1.0f / limit, 0.0f, 0.0f) : vec4(1.0f, 2.0f * limit, 0.0f, -1.0f);
  vec4 tangents = ahead ? vec4(limit, limit, 0.0f, 0.0f) : vec4(1.0f, 0.5f / limit, 0.0f, 0.5f / limit);
  const vec2 range = vec2(1.0f / VTKI_TILE_NEAR, 1.0f / VTKI_TILE_FAR);
  return vtkiIsSeenInView(middle, view, window, tangents, range, VTKI_TILE_NEAR);
}

// normal: of the receiver's facet. A light behind the facet's plane is not hidden: its map does not
// show what is before the plane. Its branches there count by vtkiShareOfBranches, and the light as a
// whole counts only where a shading normal leans towards the light.
bool vtkiIsSeenInTile(vtkiTile tile, vec3 position, vec3 normal)
{
  vec3 away = position - tile.place;
  return dot(normal, away) > 0.0f || vtkiIsSeenAlongTile(tile.middle,
    vec3(dot(tile.right, away), dot(tile.up, away), dot(tile.axis, away)),
    vec3(dot(tile.right, normal), dot(tile.up, normal), dot(tile.axis, normal)));
}
