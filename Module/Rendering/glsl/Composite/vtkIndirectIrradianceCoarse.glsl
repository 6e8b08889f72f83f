// Irradiance interpolated from the hints' values at every vtkiStep-th pixel. If the cell of pixels
// between four samples is one surface, this is their bilinear mean; vtkIndirectHintCell.glsl has
// tested that once a cell. Pixels of mixed cells have their own value.
#include "vtkIndirectReceiverGrid.glsl"

uniform sampler2D vtkiCoarse;
uniform sampler2D vtkiIrradiance;

// position: centre of a pixel, in pixels of the view.
vec3 vtkiFetchIrradiance(vec2 position)
{
  float edge = float(vtkiStep);
  vec2 cell = floor(position / edge);
  vec2 blend = (position - 0.5f) / edge - cell;
  vec2 texel = 1.0f / vec2(vtkiCoarseSize);
  vec2 first = (cell + 0.5f) * texel;
  vec2 second = first + texel;
  vec4 corner = textureLod(vtkiCoarse, first, 0.0f);
  vec3 below = mix(corner.rgb, textureLod(vtkiCoarse, vec2(second.x, first.y), 0.0f).rgb, blend.x);
  vec3 above = mix(textureLod(vtkiCoarse, vec2(first.x, second.y), 0.0f).rgb,
    textureLod(vtkiCoarse, second, 0.0f).rgb, blend.x);
  // Whole cells do not read the image: one of its texels costs more than the four above, which
  // neighbours share.
  vec2 at = corner.a == VTKI_CELL_WHOLE ? vec2(0.0f) : position / vec2(vtkiSize);
  vec3 own = textureLod(vtkiIrradiance, at, 0.0f).rgb;
  return corner.a == VTKI_CELL_WHOLE ? mix(below, above, blend.y)
                                     : (corner.a == VTKI_CELL_EMPTY ? vec3(0.0f) : own);
}
