//VTK::System::Dec
//VTK::Output::Dec
// Illumination inside one surface, by the texture unit's bilinear filter over the level above.
// Other texels keep their depth of one and are left to the stage that tests each sample. With
// VTKI_TEXELS for the texels of a level, otherwise for pixels, with the correction for their
// normals.
#include "vtkIndirectSubsplat.glsl"

#if defined(VTKI_REPROJECTED) && defined(VTKI_TEXELS)
uniform sampler2D vtkiFinerDeviation; // of this level
#endif
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
  // The texel's own weight in the filter is 9/16; children of a split texel are evaluated, with
  // VTKI_BLOCKS_FOLLOW after this stage. The result is marked smooth only if all four samples of
  // the filter are smooth (with one exception alpha is at most 0.94); for a pixel its own sample
  // must be smooth, which implies that the others lie on its surface.
#ifdef VTKI_TEXELS
  bool inside = irradiance.a > 0.97f && vectorIrradiance.a < 0.5f;
  // The neighbours are within the region known to be smooth.
  gl_FragData[0] = vec4(irradiance.rgb, VTKI_ILLUMINATION_SMOOTH);
  gl_FragData[1] = vec4(vectorIrradiance.xyz, 0.0f);
#ifdef VTKI_REPROJECTED
  bool needed = texelFetch(vtkiFinerDeviation, ivec2(gl_FragCoord.xy), 0).y >= 0.0f;
  gl_FragData[0] = needed ? gl_FragData[0] : vec4(0.0f, 0.0f, 0.0f, VTKI_ILLUMINATION_NONE);
  gl_FragData[1] = needed ? gl_FragData[1] : vec4(0.0f);
  inside = inside || !needed;
#endif
  if (!inside)
  {
    discard;
  }
#else
#ifdef VTKI_REPROJECTED
  // Samples beside the pixel's own may have been left out.
  const float least = 0.97f;
#else
  const float least = 0.5f;
#endif
  bool inside = irradiance.a > least && vectorIrradiance.a < 0.5f;
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
