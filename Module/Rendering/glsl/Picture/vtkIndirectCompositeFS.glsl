//VTK::System::Dec
//VTK::Output::Dec
// Adds albedo times irradiance, and specular reflection, to direct light
// (vtkIndirectAddedLight.glsl). The background stays as it was drawn. Writes depth unless
// VTKI_DEPTH_COPIED says that the target has it. VTKI_ALBEDO_IN_ALPHA: the lit image has the albedo
// in place of alpha; VTKI_ENCODED: the scene has physically based materials, whose colours are
// encoded; VTKI_CATCHERS: some surfaces catch light.
#include "vtkIndirectAddedLight.glsl"
#include "vtkIndirectAlbedo.glsl"
#include "vtkIndirectBalance.glsl"
#include "vtkIndirectLibColor.glsl"

#ifndef VTKI_DEPTH_COPIED
uniform sampler2D vtkiDepth;
#endif
uniform ivec2 vtkiOrigin;
uniform float vtkiIndirectScale;

void main()
{
  vec2 position = gl_FragCoord.xy - vec2(vtkiOrigin);
  vec2 pixel = position / vec2(vtkiSize);
  vec4 lit = textureLod(vtkiLit, pixel, 0.0f);
#ifdef VTKI_ALBEDO_IN_ALPHA
  bool drawn = lit.a != 0.0f;
  vec3 albedo = vtkiUnpackAlbedo(lit.a);
  lit.a = 1.0f;
#else
  // Surfaces that emit light without covering the background have no alpha.
  bool drawn = any(greaterThan(lit, vec4(0.0f)));
  vec3 albedo = vtkiUnpackAlbedo(textureLod(vtkiAlbedo, pixel, 0.0f).r);
#endif
#ifndef VTKI_DEPTH_COPIED
  float depth = textureLod(vtkiDepth, pixel, 0.0f).r;
  drawn = drawn || depth < 1.0f;
#endif
#ifdef VTKI_CATCHERS
  // Surfaces that catch light show the background: vtkIndirectCatchFS.glsl.
  drawn = drawn && !vtkiSurfaceCatches(textureLod(vtkiSurface, pixel, 0.0f));
#endif
  if (!drawn)
  {
    discard;
  }
  // Estimators write zero where no lit surface was drawn.
  if (vtkiIndirectScale > 0.0f)
  {
#if defined(VTKI_ENCODED) || defined(VTKI_LAMPS)
    vec4 surface = textureLod(vtkiSurface, pixel, 0.0f);
#else
    vec4 surface = vec4(0.0f);
#endif
    vec3 sky = vec3(0.0f);
    vec3 area = vec3(0.0f);
    vec3 bounce = vec3(0.0f);
    vtkiAddIrradiance(position, surface, sky, area, bounce);
    vec3 indirect = albedo * (sky + area + bounce) * (vtkiIndirectScale * lit.a);
    vtkiAddRadiance(position, vtkiIndirectScale * lit.a, indirect);
    vec3 direct = vtkiKeepLamps(surface, albedo * lit.a, vtkiDecodeShading(surface, lit.rgb));
    lit.rgb = vtkiEncodeShading(surface, direct + indirect);
  }
  gl_FragData[0] = lit;
#ifndef VTKI_DEPTH_COPIED
  gl_FragDepth = depth;
#endif
}
