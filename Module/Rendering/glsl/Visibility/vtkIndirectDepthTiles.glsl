// Whether a virtual light is seen from a receiver, by the depth map of that light: its tile of the atlas.
#include "vtkIndirectLibDepthTile.glsl"

uniform sampler2D vtkiDepthTiles;
uniform vec2 vtkiTileShape; // tiles along an edge of the atlas, texels along an edge of a tile

// place, axis: the emitter's, unit. Nearer to the emitter's horizon than its tile reaches, what the tile's
// border sees in the same azimuth tells how far to the side the light gets.
bool vtkiIsSeenInTile(int tile, vec3 place, vec3 axis, vec3 position, vec3 normal)
{
  vec3 up;
  vec3 right;
  vtkiFrameAlong(axis, up, right);
  vec3 d = position - place;
  vec3 p = vec3(dot(right, d), dot(up, d), dot(axis, d));
  vec3 n = vec3(dot(right, normal), dot(up, normal), dot(axis, normal));
  float texels = vtkiTileShape.y;
  float border = max(abs(p.x), abs(p.y)) / VTKI_TILE_TANGENT;
  vec2 texel =
    (0.5f + (0.5f / VTKI_TILE_TANGENT) * p.xy / max(max(p.z, border), VTKI_TILE_NEAR)) * texels;
  vec2 at = clamp(floor(texel), vec2(0.0f), vec2(texels - 1.0f));
  vec2 tangents = (2.0f * (at + 0.5f) / texels - 1.0f) * VTKI_TILE_TANGENT;
  float row = floor((float(tile) + 0.5f) / vtkiTileShape.x);
  vec2 corner = vec2(float(tile) - row * vtkiTileShape.x, row) * texels;
  // A look-up at a texel's centre is exact, and in software faster than a fetch.
  float stored = vtkiTileLinearDepth(
    textureLod(vtkiDepthTiles, (corner + at + 0.5f) / (vtkiTileShape.x * texels), 0.0f).r);
  float bias = VTKI_TILE_ROUGHNESS * 2.0f * VTKI_TILE_TANGENT / texels;
  float mine = p.z >= border
    ? vtkiTilePlaneDepth(p, n, tangents) - bias * p.z
    : (1.0f - VTKI_TILE_BORDER) * border;
  return p.z <= VTKI_TILE_NEAR || stored >= mine;
}
