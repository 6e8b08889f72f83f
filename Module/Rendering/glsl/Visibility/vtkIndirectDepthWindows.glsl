// Whether a point of an area light is seen from a receiver, by its depth map, which holds no more than what can
// hide the point.
#include "vtkIndirectDepthTiles.glsl"

// middle: of the tile, in the atlas; window: tangents times xy and zw more are places in it, from -1 to 1; away,
// normal: the way from the emitter to the receiver and its normal, along the tile's axes right, up and that of the
// emitter; range: one over the depths at which the map begins and ends. Farther to the side than windows may reach, what one there
// sees in the same azimuth tells how far to the side the light gets.
bool vtkiIsSeenInWindow(vec2 middle, vec4 window, vec2 range, vec3 away, vec3 normal)
{
  float texels = vtkiTileShape.z;
  // At the limit itself a place is within a window that reaches to it, rounding included.
  float border = max(abs(away.x), abs(away.y)) * (1.00001f / VTKI_WINDOW_TANGENT);
  vec2 place = away.xy / max(max(away.z, border), VTKI_WINDOW_NEAR) * window.xy + window.zw;
  bool outside = max(abs(place.x), abs(place.y)) >= 1.0f;
  // Texels from the middle; within the tile, rounding included.
  vec2 at = floor(clamp(place, -0.99999f, 0.99999f) * (0.5f * texels)) + 0.5f;
  vec2 tangents = (at * (2.0f / texels) - window.zw) / window.xy;
  // A look-up at a texel's centre is exact, and in software faster than a fetch.
  float stored = textureLod(vtkiDepthTiles, middle + at / (vtkiTileShape.xy * texels), 0.0f).r;
  float inverse = range.x - stored * (range.x - range.y);
  float along = dot(normal.xy, tangents) + normal.z;
  float bias = VTKI_TILE_ROUGHNESS * 2.0f / (texels * min(window.x, window.y));
  return outside || stored >= 1.0f ||
    vtkiIsSeenInPerspectiveTile(inverse, away.z, border, dot(normal, away), along, bias);
}
