// Tests the visibility of a point of an area light from a receiver with the point's depth map,
// which covers only possible casters.
#define VTKI_ONE_TEXEL
#include "vtkIndirectDepthTiles.glsl"

// middle: of the tile's forward view in the atlas; view: the view of the tile that has the
// receiver; window: scale (xy) and offset (zw) from tangents to places in the view, from -1 to 1;
// range: one over the depths at which the view begins and ends.
bool vtkiIsSeenInWindow(vec2 middle, vtkiTileView view, vec4 window, vec2 range)
{
  vec4 tangents = vec4(1.0f / window.xy, -window.zw / window.xy);
  return vtkiIsSeenInView(middle, view, window, tangents, range, VTKI_WINDOW_NEAR);
}
