//VTK::System::Dec
//VTK::Output::Dec
// Mean intensity of the lights that send; a lobe counts its flux as that of diffuse light, over pi.
// First by columns of their table, then over the columns.
#include "vtkIndirectSplatLobe.glsl"

#ifdef VTKI_SPLAT_COLUMNS
uniform sampler2D vtkiSplatColumns; // sum, number

void main()
{
  vec2 sum = vec2(0.0f);
  for (int column = 0; column < VTKI_ROW_LENGTH; ++column)
  {
    sum += texelFetch(vtkiSplatColumns, ivec2(column, 0), 0).xy;
  }
  gl_FragData[0] = vec4(sum.x / max(sum.y, 1.0f), sum.y, 0.0f, 1.0f);
}
#else
void main()
{
  vec2 sum = vec2(0.0f);
  int column = int(gl_FragCoord.x);
  for (int light = column; light < vtkiLightCount; light += VTKI_ROW_LENGTH)
  {
    vec4 sender;
    vec4 senderNormal;
    vec3 density;
    vtkiFetchLight(light, sender, senderNormal, density);
    // A light from a direction is radiance times solid angle: its distance is unbounded.
    float intensity = sender.w < 0.0f ? 0.0f : vtkiGreatestIntensity(senderNormal.xyz, density);
#ifdef VTKI_SPLAT_LOBES
    vec3 flux = texelFetch(vtkiLobeDensity, vtkiTableTexel(light), 0).rgb;
    intensity += max(max(flux.r, flux.g), flux.b) / VTKI_PI;
#endif
    sum += intensity > 0.0f ? vec2(intensity, 1.0f) : vec2(0.0f);
  }
  gl_FragData[0] = vec4(sum, 0.0f, 1.0f);
}
#endif
