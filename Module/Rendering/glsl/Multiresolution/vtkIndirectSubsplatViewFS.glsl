//VTK::System::Dec
//VTK::Output::Dec
// Visualizes multiresolution splatting: drawn level by level, coarse to fine.
#include "vtkIndirectSubsplat.glsl"

uniform sampler2D vtkiSurface;
uniform sampler2D vtkiIrradiance;
uniform sampler2D vtkiLevelSurface;
uniform sampler2D vtkiLevelIrradiance;
uniform sampler2D vtkiCoarserSurface;
uniform int vtkiLevel;
uniform int vtkiView; // see vtkIndirectSubsplatView
uniform float vtkiIrradianceUnit;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int edge = 1 << vtkiLevel;
  ivec2 texel = pixel / edge;
  vec4 surface = texelFetch(vtkiSurface, pixel, 0);
  bool parentSplit = vtkiSubsplatIsSplit(texelFetch(vtkiCoarserSurface, texel >> 1, 0).w);
  float state = texelFetch(vtkiLevelSurface, texel, 0).w;
  bool whole = vtkiLevel == 0 || !vtkiSubsplatIsSplit(state);
  bool leaf = parentSplit && whole && vtkiSurfaceIsLit(surface);
  vec4 level = vtkiLevel == 0 ? texelFetch(vtkiIrradiance, pixel, 0)
                              : texelFetch(vtkiLevelIrradiance, texel, 0);
  level.rgb *= vtkiIrradianceUnit;
  if (vtkiView == 0 && leaf)
  {
    gl_FragData[0] = vec4(vec3(float(vtkiLevel)), 1.0f);
  }
  else if (vtkiView == 1 && leaf)
  {
    // Draws the borders of subsplats over the irradiance.
    bool border = vtkiLevel > 0 && (pixel.x % edge == 0 || pixel.y % edge == 0);
    vec3 irradiance = texelFetch(vtkiIrradiance, pixel, 0).rgb * vtkiIrradianceUnit;
    gl_FragData[0] = vec4(border ? vec3(1.0f, 0.4f, 0.0f) : irradiance, 1.0f);
  }
  else if (vtkiView == 2 && leaf)
  {
    gl_FragData[0] = vec4(level.rgb, 1.0f);
  }
  else if (vtkiView == 3 && level.a > 0.0f)
  {
    gl_FragData[0] = vec4(level.rgb, 1.0f);
  }
  else
  {
    discard;
  }
}
