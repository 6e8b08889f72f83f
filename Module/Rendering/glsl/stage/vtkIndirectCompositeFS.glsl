//VTK::System::Dec
//VTK::Output::Dec
// Direct light plus albedo times irradiance. Background is left as it was drawn.
#include "vtkIndirectLibSurface.glsl"
#include "vtkIndirectLibColor.glsl"

uniform sampler2D vtkiLit;
uniform sampler2D vtkiSurface;
uniform sampler2D vtkiAlbedo;
uniform sampler2D vtkiIrradiance;
uniform sampler2D vtkiDepth;
uniform ivec2 vtkiOrigin;
uniform float vtkiIndirectScale;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - vtkiOrigin;
  float depth = texelFetch(vtkiDepth, pixel, 0).r;
  vec4 lit = texelFetch(vtkiLit, pixel, 0);
  if (depth >= 1.0f && lit.a <= 0.0f)
  {
    discard;
  }
  float kind = vtkiSurfaceKind(texelFetch(vtkiSurface, pixel, 0));
  if (vtkiIndirectScale > 0.0f && kind > 0.5f && kind < 2.5f)
  {
    vec3 indirect = texelFetch(vtkiAlbedo, pixel, 0).rgb *
      texelFetch(vtkiIrradiance, pixel, 0).rgb * vtkiIndirectScale * lit.a;
    lit.rgb = kind == VTKI_SURFACE_ENCODED ? vtkiEncodeGamma(vtkiDecodeGamma(lit.rgb) + indirect)
                                           : lit.rgb + indirect;
  }
  gl_FragData[0] = lit;
  gl_FragDepth = depth;
}
