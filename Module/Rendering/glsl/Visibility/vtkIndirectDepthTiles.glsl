// Whether a virtual light is seen from a receiver, by the depth map of that light: its tile of the atlas.
#include "vtkIndirectLibDepthTile.glsl"

uniform sampler2D vtkiDepthTiles;
uniform vec3 vtkiTileShape; // columns and rows of tiles in the atlas, texels along an edge of a tile

// What look-ups in a tile share.
struct vtkiTile
{
  vec3 right;
  vec3 up;
  vec3 axis;   // the emitter's, unit
  vec3 place;  // the emitter's
  vec2 middle; // of the tile, in the atlas
};

vtkiTile vtkiMakeTile(int number, vec3 place, vec3 axis)
{
  vtkiTile tile;
  vtkiFrameAlong(axis, tile.up, tile.right);
  tile.axis = axis;
  tile.place = place;
  float row = floor((float(number) + 0.5f) / vtkiTileShape.x);
  tile.middle = (vec2(float(number) - row * vtkiTileShape.x, row) + 0.5f) / vtkiTileShape.xy;
  return tile;
}

// Nearer to the emitter's horizon than its tile reaches, what the tile's border sees in the same azimuth
// tells how far to the side the light gets. middle: of the tile; away, normal: the way from the emitter to the
// receiver and its normal, along the tile's axes right, up and that of the emitter.
bool vtkiIsSeenAlongTile(vec2 middle, vec3 away, vec3 normal)
{
  float texels = vtkiTileShape.z;
  float border = max(abs(away.x), abs(away.y)) * (1.0f / VTKI_TILE_TANGENT);
  // Texels from the middle; within the tile, rounding included.
  float scale = (0.499995f / VTKI_TILE_TANGENT) * texels / max(max(away.z, border), VTKI_TILE_NEAR);
  vec2 at = floor(away.xy * scale) + 0.5f;
  vec2 tangents = at * (2.0f * VTKI_TILE_TANGENT / texels);
  // A look-up at a texel's centre is exact, and in software faster than a fetch.
  float inverse = vtkiTileInverseDepth(
    textureLod(vtkiDepthTiles, middle + at / (vtkiTileShape.xy * texels), 0.0f).r);
  float along = dot(normal.xy, tangents) + normal.z;
  return vtkiIsSeenInPerspectiveTile(
    inverse, away.z, border, dot(normal, away), along, VTKI_TILE_ROUGHNESS * 2.0f * VTKI_TILE_TANGENT / texels);
}

bool vtkiIsSeenInTile(vtkiTile tile, vec3 position, vec3 normal)
{
  vec3 away = position - tile.place;
  return vtkiIsSeenAlongTile(tile.middle,
    vec3(dot(tile.right, away), dot(tile.up, away), dot(tile.axis, away)),
    vec3(dot(tile.right, normal), dot(tile.up, normal), dot(tile.axis, normal)));
}
