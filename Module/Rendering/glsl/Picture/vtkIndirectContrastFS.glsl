//VTK::System::Dec
//VTK::Output::Dec
// Contrasts of a pixel with its left neighbour (r) and with the one below it (g), where an outline
// is possible; else, and at the picture's border, zero.
#include "vtkIndirectShown.glsl"

uniform ivec2 vtkiSize;

void main()
{
  vec2 texel = 1.0f / vec2(vtkiSize);
  vec2 place = gl_FragCoord.xy * texel;
  vec4 here = vtkiShown(place);
  vec2 contrast = vec2(vtkiContrast(here, vtkiShown(place - vec2(texel.x, 0.0f))),
    vtkiContrast(here, vtkiShown(place - vec2(0.0f, texel.y))));
  gl_FragData[0] =
    vec4(contrast * vec2(greaterThanEqual(contrast, vec2(VTKI_EDGE_CONTRAST))), 0.0f, 0.0f);
}
