// Whether a point of an area light is seen from a receiver, by its depth map, which holds no more than what can
// hide the point.
#include "vtkIndirectDepthTiles.glsl"

// middle: of the tile's view ahead, in the atlas; view: in which the receiver is; window: tangents times xy and zw more
// are places in it, from -1 to 1; range: one over the depths at which it begins and ends.
bool vtkiIsSeenInWindow(vec2 middle, vtkiTileView view, vec4 window, vec2 range)
{
  vec4 tangents = vec4(1.0f / window.xy, -window.zw / window.xy);
  return vtkiIsSeenInView(middle, view, window, tangents, range, VTKI_WINDOW_NEAR);
}
