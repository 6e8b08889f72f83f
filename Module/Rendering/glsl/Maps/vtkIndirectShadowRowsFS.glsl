//VTK::System::Dec
//VTK::Output::Dec
// Depths of a texel and of the next in the row of a light's map, and the slopes of their surfaces;
// see vtkIndirectCaptureDecFS.glsl.
#include "vtkIndirectLibShadow.glsl"

uniform sampler2DArray vtkiShadowMaps;
uniform sampler2DArray vtkiMapSlope;
uniform int vtkiLayer;

void main()
{
  ivec3 at = ivec3(ivec2(gl_FragCoord.xy), vtkiLayer);
  ivec3 next = ivec3(min(at.x + 1, textureSize(vtkiShadowMaps, 0).x - 1), at.yz);
  gl_FragData[0] =
    vec4(texelFetch(vtkiShadowMaps, at, 0).r, texelFetch(vtkiShadowMaps, next, 0).r,
      vtkiPackSlope(texelFetch(vtkiMapSlope, at, 0).rg),
      vtkiPackSlope(texelFetch(vtkiMapSlope, next, 0).rg));
}
