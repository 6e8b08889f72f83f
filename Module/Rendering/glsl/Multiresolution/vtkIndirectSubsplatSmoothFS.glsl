//VTK::System::Dec
//VTK::Output::Dec
// Illumination inside one surface: the texture unit's own bilinear filter over the level above. Other
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
  // The texel's own weight in the filter is 9/16: what lies under a split one is evaluated, with
  // VTKI_BLOCKS_FOLLOW after this. All four that the filter takes must be smooth for what is
  // written to be known as smooth itself (with one amiss it is 0.94 at most); for a pixel the own one
  // must: that says that the others lie on its surface.
#ifdef VTKI_TEXELS
  bool inside = irradiance.a > 0.97f && vectorIrradiance.a < 0.5f;
  // What lies around is within the neighbourhood that is known to be smooth.
  gl_FragData[0] = vec4(irradiance.rgb, VTKI_ILLUMINATION_SMOOTH);
  gl_FragData[1] = vec4(vectorIrradiance.xyz, 0.0f);
  if (!inside)
  {
    discard;
  }
#else
  bool inside = irradiance.a > 0.5f && vectorIrradiance.a < 0.5f;
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
  inside = inside || evaluated;
#endif
  if (lit && !inside)
  {
    discard;
  }
#endif
}
