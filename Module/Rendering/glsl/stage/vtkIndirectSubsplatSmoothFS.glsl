//VTK::System::Dec
//VTK::Output::Dec
// Illumination amid one surface: the texture unit's own bilinear filter over the level above. Other
// places keep their depth of one and are left to the stage that looks at each sample. With VTKI_TEXELS for the
// texels of a level, else for pixels, with the correction for their normals.
#include "vtkIndirectSubsplat.glsl"

#ifndef VTKI_TEXELS
uniform sampler2D vtkiSurface;
uniform bool vtkiCorrectNormals;
#endif
uniform sampler2D vtkiCoarserIrradiance;
uniform sampler2D vtkiCoarserVector;
uniform ivec2 vtkiCoarserSize;

void main()
{
  vec2 place = 0.5f * gl_FragCoord.xy / vec2(vtkiCoarserSize);
  vec4 irradiance = textureLod(vtkiCoarserIrradiance, place, 0.0f);
  vec4 vectorIrradiance = textureLod(vtkiCoarserVector, place, 0.0f);
  // Half floats round the filter's weights; with one neighbour amiss it is 31/32 at most. The
  // texel's own weight is 9/16: what lies under a split one is evaluated, with VTKI_BLOCKS_FOLLOW
  // after this.
  bool amid = irradiance.a > 0.98f * VTKI_ILLUMINATION_SMOOTH && vectorIrradiance.a < 0.5f;
#ifdef VTKI_TEXELS
  // What lies around is within the neighbourhood that is known to be smooth.
  gl_FragData[0] = vec4(irradiance.rgb, VTKI_ILLUMINATION_SMOOTH);
  gl_FragData[1] = vec4(vectorIrradiance.xyz, 0.0f);
  if (!amid)
  {
    discard;
  }
#else
  vec4 surface = textureLod(vtkiSurface, gl_FragCoord.xy / vec2(vtkiSize), 0.0f);
  bool lit = vtkiSurfaceIsLit(surface);
  vec3 normal = vtkiSurfaceNormal(surface);
  float correction = vtkiCorrectNormals
    ? vtkiNormalCorrection(vtkiLuminance(irradiance.rgb), dot(normal, vectorIrradiance.xyz))
    : 1.0f;
  correction *= vtkiDetail(2.0f * gl_FragCoord.xy / vec2(vtkiSize) - 1.0f, normal);
  gl_FragData[0] = lit ? vec4(irradiance.rgb * correction, 1.0f) : vec4(0.0f);
#ifdef VTKI_BLOCKS_FOLLOW
  bool evaluated = lit && vectorIrradiance.a > 0.5f;
  gl_FragData[0] = evaluated ? vec4(0.0f, 0.0f, 0.0f, 1.0f) : gl_FragData[0];
  amid = amid || evaluated;
#endif
  if (lit && !amid)
  {
    discard;
  }
#endif
}
