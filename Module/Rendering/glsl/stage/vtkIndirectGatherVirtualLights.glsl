// Sum over a block of virtual lights.
#include "vtkIndirectLibVirtualLight.glsl"

uniform sampler2D vtkiLightPosition; // position, area
uniform sampler2D vtkiLightNormal;   // normal, lobe exponent
uniform sampler2D vtkiLightDensity;  // reflected density times area, source
uniform int vtkiRowLength;
uniform ivec2 vtkiLightRows; // first row, one past the last row
uniform int vtkiLightCount;

vec3 vtkiGather(vec3 position, vec3 normal)
{
  vec3 total = vec3(0.0f);
  for (int row = vtkiLightRows.x; row < vtkiLightRows.y; ++row)
  {
    // Sums by row keep rounding errors of long sums small.
    vec3 partial = vec3(0.0f);
    int columns = min(vtkiRowLength, vtkiLightCount - row * vtkiRowLength);
    for (int column = 0; column < columns; ++column)
    {
      ivec2 at = ivec2(column, row);
      vec4 sender = texelFetch(vtkiLightPosition, at, 0);
      partial += texelFetch(vtkiLightDensity, at, 0).rgb *
        vtkiVirtualLightWeight(
          sender.xyz - position, texelFetch(vtkiLightNormal, at, 0).xyz, normal, sender.w);
    }
    total += partial;
  }
  return total;
}
