// Sum over a block of virtual lights.
// VTKI_VISIBILITY: those that the receiver sees.
#include "vtkIndirectLightRow.glsl"
#ifdef VTKI_DIVIDED
#include "vtkIndirectBranches.glsl"
#endif
#ifdef VTKI_VISIBILITY
#include "vtkIndirectVisibility.glsl"
#endif

uniform sampler2D vtkiLightPosition; // position, area
uniform sampler2D vtkiLightNormal;   // normal, reach
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
      vec4 senderNormal = texelFetch(vtkiLightNormal, at, 0);
      vec3 density = texelFetch(vtkiLightDensity, at, 0).rgb;
      float weight =
        vtkiSenderWeight(vtkiToSender(sender, position), senderNormal.xyz, normal, sender.w);
      float share = 1.0f;
      float division = 0.0f;
#ifdef VTKI_DIVIDED
      division = vtkiDivision(sender.xyz - position, senderNormal.w);
#endif
#ifdef VTKI_VISIBILITY
      bool lit = (weight > 0.0f || division > 0.0f) && max(max(density.r, density.g), density.b) > 0.0f;
      bool seen = vtkiIsSenderVisible(
        row * VTKI_ROW_LENGTH + column, open, position, normal, sender, senderNormal.xyz, lit);
      share = seen ? 1.0f : 0.0f;
#endif
      partial += density * (weight * share * (1.0f - division));
#ifdef VTKI_DIVIDED
      vec3 unused = vec3(0.0f);
      vtkiAddBranches(row * VTKI_ROW_LENGTH + column, position, normal, share * division, partial, unused);
#endif
    }
    total += partial;
  }
  return total;
}
