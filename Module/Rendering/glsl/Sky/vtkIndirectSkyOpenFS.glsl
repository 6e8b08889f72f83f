//VTK::System::Dec
//VTK::Output::Dec
// Irradiance from the sky if nothing hid it, at surfaces that catch light: what
// vtkIndirectSkyFilterFS.glsl and the sum over strong directions give where all directions are
// seen.
#ifndef VTKI_SKY_BLOCK
#define VTKI_SKY_BLOCK 16
#endif
#include "vtkIndirectSkyDirections.glsl"
#include "vtkIndirectLibSky.glsl"

uniform sampler2D vtkiOpenSky;
uniform sampler2D vtkiOpenColors;
uniform vec3 vtkiOpenFlux;
uniform mat3 vtkiColorFlux;
uniform float vtkiSkyUnit;
uniform int vtkiSkyCount; // strong directions

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  bool catches = vtkiFetchReceiver(pixel, receiver) &&
    vtkiSurfaceCatches(textureLod(vtkiSurface, (vec2(pixel) + 0.5f) / vec2(vtkiSize), 0.0f));
  vec2 place = vtkiOpenSkyPlace(receiver.normal);
  float open = textureLod(vtkiOpenSky, place, 0.0f).r + dot(vtkiOpenFlux, receiver.normal);
  vec3 colors = max(textureLod(vtkiOpenColors, place, 0.0f).rgb + receiver.normal * vtkiColorFlux,
    vec3(0.0f));
  vec4 sum = vec4(vtkiSkyUnit *
    vtkiSkyIrradiance(colors, colors.r + colors.g + colors.b, max(open, 0.0f)), 0.0f);
  vtkiCrease none = vtkiCrease(vec3(0.0f), 0.0f, 0.0f);
  float nearness = 0.0f;
  int count = catches ? vtkiSkyCount : 0;
  for (int i = 0; i < count; ++i)
  {
    sum += vtkiFromSky(
      vtkiFetchSkyDirection(i), receiver.position, receiver.normal, receiver.facet, none, nearness);
  }
  gl_FragData[0] = vec4(catches ? sum.rgb : vec3(0.0f), 1.0f);
}
