//VTK::System::Dec
//VTK::Output::Dec
// One where a surface ends between a pixel and its left neighbour (r) or the one below it (g), else
// zero; blending multiplies contrasts by it. A change of data within a surface is no outline.
#include "vtkIndirectLibAntialiasing.glsl"

uniform sampler2D vtkiDepth;
uniform sampler2D vtkiSurface;
flat in vec2 vtkiTexel;

float vtkiFetchDepth(vec2 place)
{
  bool inside = place.x > 0.0f && place.y > 0.0f && place.x < 1.0f && place.y < 1.0f;
  return inside ? textureLod(vtkiDepth, place, 0.0f).r : 1.0f;
}

// Returns the outline between the pixel and the one a step before it.
float vtkiFindOutline(vec2 place, vec2 step)
{
  vec4 depth = vec4(vtkiFetchDepth(place - 2.0f * step), vtkiFetchDepth(place - step), vtkiFetchDepth(place),
    vtkiFetchDepth(place + step));
  return vtkiIsOutline(depth, textureLod(vtkiSurface, place - 2.0f * step, 0.0f),
           textureLod(vtkiSurface, place - step, 0.0f), textureLod(vtkiSurface, place, 0.0f),
           textureLod(vtkiSurface, place + step, 0.0f))
    ? 1.0f
    : 0.0f;
}

void main()
{
  vec2 place = gl_FragCoord.xy * vtkiTexel;
  gl_FragData[0] = vec4(vtkiFindOutline(place, vec2(vtkiTexel.x, 0.0f)),
    vtkiFindOutline(place, vec2(0.0f, vtkiTexel.y)), 0.0f, 0.0f);
}
