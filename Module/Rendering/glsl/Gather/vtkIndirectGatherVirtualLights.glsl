// Sum over a block of virtual lights.
// VTKI_VISIBILITY: those that the receiver sees.
#include "vtkIndirectLightRow.glsl"
#ifdef VTKI_VISIBILITY
#include "vtkIndirectVisibility.glsl"
#endif

uniform sampler2D vtkiLightPosition; // position, area
uniform sampler2D vtkiLightNormal;   // normal, lobe exponent
uniform sampler2D vtkiLightDensity;  // reflected density times area, source
uniform ivec2 vtkiLightRows; // first row, one past the last row
uniform int vtkiLightCount;

vec3 vtkiGather(vec3 position, vec3 normal)
{
  vec3 total = vec3(0.0f);
#ifdef VTKI_VISIBILITY
  vec3 open = vtkiOpenPlace(position, normal);
#endif
  for (int row = vtkiLightRows.x; row < vtkiLightRows.y; ++row)
  {
    // Sums by row keep rounding errors of long sums small.
    vec3 partial = vec3(0.0f);
    int columns = min(VTKI_ROW_LENGTH, vtkiLightCount - row * VTKI_ROW_LENGTH);
    for (int column = 0; column < columns; ++column)
    {
      ivec2 at = ivec2(column, row);
      vec4 sender = texelFetch(vtkiLightPosition, at, 0);
#ifdef VTKI_VISIBILITY
      vec3 density = texelFetch(vtkiLightDensity, at, 0).rgb;
      vec3 senderNormal = texelFetch(vtkiLightNormal, at, 0).xyz;
      float weight =
        vtkiSenderWeight(vtkiToSender(sender, position), senderNormal, normal, sender.w);
      bool lit = weight > 0.0f && max(max(density.r, density.g), density.b) > 0.0f;
      bool seen = vtkiIsSenderVisible(
        row * VTKI_ROW_LENGTH + column, open, position, normal, sender, senderNormal, lit);
      partial += seen ? density * weight : vec3(0.0f);
#else
      partial += texelFetch(vtkiLightDensity, at, 0).rgb *
        vtkiSenderWeight(vtkiToSender(sender, position), texelFetch(vtkiLightNormal, at, 0).xyz,
          normal, sender.w);
#endif
    }
    total += partial;
  }
  return total;
}
