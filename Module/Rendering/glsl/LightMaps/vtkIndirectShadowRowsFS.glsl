//VTK::System::Dec
//VTK::Output::Dec
// Depth of a texel and of its neighbours in the row of a light's map, and the slope of the texel's
// surface; see vtkIndirectCaptureDecFS.glsl.
#include "vtkIndirectLibShadow.glsl"

uniform sampler2DArray vtkiShadowMaps;
uniform sampler2DArray vtkiMapSlope;
uniform int vtkiLayer;

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  int last = textureSize(vtkiShadowMaps, 0).x - 1;
  gl_FragData[0] = vec4(texelFetch(vtkiShadowMaps, ivec3(max(at.x - 1, 0), at.y, vtkiLayer), 0).r,
    texelFetch(vtkiShadowMaps, ivec3(at, vtkiLayer), 0).r,
    texelFetch(vtkiShadowMaps, ivec3(min(at.x + 1, last), at.y, vtkiLayer), 0).r,
    vtkiPackSlope(texelFetch(vtkiMapSlope, ivec3(at, vtkiLayer), 0).rg));
}
