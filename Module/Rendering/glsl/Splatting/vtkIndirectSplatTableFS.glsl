//VTK::System::Dec
//VTK::Output::Dec
// One fragment a virtual light: the bounding ellipsoids of the light and of its lobe, outside of
// which they do not count.
#include "vtkIndirectSplatLobe.glsl"

void main()
{
  int light = vtkiTableEntry(ivec2(gl_FragCoord.xy));
  vec4 sender;
  vec4 senderNormal;
  vec3 density;
  vtkiFetchLight(min(light, max(vtkiLightCount - 1, 0)), sender, senderNormal, density);
  float low = vtkiSplatLow();
  float intensity = vtkiGreatestIntensity(senderNormal.xyz, density);
  vtkiSplat splat = vtkiWholeScene();
  if (sender.w >= 0.0f && low > 0.0f)
  {
#ifdef VTKI_DIVIDED
    // Cosine of a single normal, or a light spread to all sides.
    float exponent = vtkiSpreadOfNormals(senderNormal.xyz) > 0.0f ? 0.0f : 1.0f;
#else
    const float exponent = 1.0f;
#endif
    vec3 axis = senderNormal.xyz / max(length(senderNormal.xyz), 1.0e-20f);
    splat = vtkiWithinScene(
      vtkiMakeSplat(sender.xyz, axis, exponent, sqrt(vtkiSquaredReach(intensity, low)),
      vtkiBall(sender, senderNormal)));
  }
  bool sends = light < vtkiLightCount && max(max(density.r, density.g), density.b) > 0.0f;
  gl_FragData[0] = vec4(splat.center, splat.along);
  gl_FragData[1] = vec4(splat.axis, sends ? splat.across : -1.0f);
#ifdef VTKI_SPLAT_LOBES
  ivec2 at = vtkiTableTexel(min(light, max(vtkiLightCount - 1, 0)));
  vec4 direction = texelFetch(vtkiLobeDirection, at, 0);
  vec3 flux = texelFetch(vtkiLobeDensity, at, 0).rgb;
  bool reflects = light < vtkiLightCount && max(max(flux.r, flux.g), flux.b) > 0.0f;
  vtkiSplat lobe = vtkiWholeScene();
  if (reflects && low > 0.0f)
  {
    float upright = dot(senderNormal.xyz, direction.xyz) / max(length(senderNormal.xyz), 1.0e-20f);
    lobe = vtkiWithinScene(
      vtkiMakeLobeSplat(sender.xyz, direction.xyz, upright, direction.w, sender.w, vtkiLobeFlux(flux, low)));
  }
  gl_FragData[2] = vec4(lobe.center, lobe.along);
  gl_FragData[3] = vec4(lobe.axis, reflects ? lobe.across : -1.0f);
#endif
}
