//VTK::System::Dec
//VTK::Output::Dec
// Adds albedo times irradiance to direct light. VTKI_SKY adds the irradiance of the environment,
// VTKI_SKY_BOUNCE its reflection by surfaces, VTKI_AREA the irradiance of area lights,
// VTKI_AREA_GLOSSY their specular reflection, VTKI_GLOSSY specular reflection of indirect light.
// The background stays as it was drawn. Writes depth unless VTKI_DEPTH_COPIED says that the target
// has it. VTKI_ALBEDO_IN_ALPHA: the lit image has the albedo in place of alpha; VTKI_ENCODED: the
// scene has physically based materials, whose colours are encoded; VTKI_GATHER names the file that
// fetches the irradiance.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectAlbedo.glsl"
#include "vtkIndirectBounded.glsl"
#include "vtkIndirectLibColor.glsl"
#include VTKI_GATHER

#ifdef VTKI_GLOSSY
uniform sampler2D vtkiSpecular;
uniform sampler2D vtkiGlossy;
#endif
#ifndef VTKI_DEPTH_COPIED
uniform sampler2D vtkiDepth;
#endif
uniform ivec2 vtkiOrigin;
uniform float vtkiIndirectScale;
uniform float vtkiIrradianceUnit;
#ifdef VTKI_SKY
uniform sampler2D vtkiSky;
#endif
#ifdef VTKI_SKY_BOUNCE
uniform sampler2D vtkiSkyBounce;
#endif
#ifdef VTKI_AREA
uniform sampler2D vtkiArea;
#endif
#ifdef VTKI_AREA_GLOSSY
uniform sampler2D vtkiAreaGlossy;
#endif

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
  if (!drawn)
  {
    discard;
  }
  // Estimators write zero where no lit surface was drawn.
  if (vtkiIndirectScale > 0.0f)
  {
    vec3 bounce = vtkiFetchIrradiance(position) * vtkiIrradianceUnit;
    vec3 irradiance = vec3(0.0f);
#ifdef VTKI_SKY
    irradiance += textureLod(vtkiSky, pixel, 0.0f).rgb;
#endif
#ifdef VTKI_SKY_BOUNCE
    bounce += textureLod(vtkiSkyBounce, pixel, 0.0f).rgb;
#endif
#ifdef VTKI_AREA
    irradiance += textureLod(vtkiArea, pixel, 0.0f).rgb;
#endif
    irradiance += vtkiBoundBounce(bounce, irradiance);
    vec3 indirect = albedo * irradiance * (vtkiIndirectScale * lit.a);
#ifdef VTKI_AREA_GLOSSY
    indirect += textureLod(vtkiAreaGlossy, pixel, 0.0f).rgb * (vtkiIndirectScale * lit.a);
#endif
#ifdef VTKI_GLOSSY
    indirect += textureLod(vtkiSpecular, pixel, 0.0f).rgb *
      textureLod(vtkiGlossy, pixel, 0.0f).rgb * (vtkiIrradianceUnit * vtkiIndirectScale * lit.a);
#endif
#ifdef VTKI_ENCODED
    float kind = vtkiSurfaceKind(textureLod(vtkiSurface, pixel, 0.0f));
    lit.rgb = kind == VTKI_SURFACE_ENCODED ? vtkiEncodeGamma(vtkiDecodeGamma(lit.rgb) + indirect)
                                           : lit.rgb + indirect;
#else
    lit.rgb += indirect;
#endif
  }
  gl_FragData[0] = lit;
#ifndef VTKI_DEPTH_COPIED
  gl_FragDepth = depth;
#endif
}
