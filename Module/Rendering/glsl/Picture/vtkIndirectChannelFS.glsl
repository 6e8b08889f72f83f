//VTK::System::Dec
//VTK::Output::Dec
// Copies one channel of the frame as floats, in world units and world coordinates; background 0.
#include "vtkIndirectAddedLight.glsl"
#include "vtkIndirectAlbedo.glsl"
#include "vtkIndirectBalance.glsl"
#include "vtkIndirectLibChannel.glsl"
#include "vtkIndirectLibColor.glsl"
#ifdef VTKI_CATCHES
#include "vtkIndirectCaught.glsl"
#endif

uniform ivec2 vtkiOrigin;
uniform float vtkiIndirectScale;
uniform mat3 vtkiViewToWorldDirection;
uniform float vtkiSceneScale;
uniform int vtkiChannel; // VTKI_CHANNEL_...

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - vtkiOrigin;
  vec4 surface = texelFetch(vtkiSurface, pixel, 0);
  float kind = vtkiSurfaceKind(surface);
  bool lit = vtkiSurfaceIsLit(surface);
  vec3 albedo = lit ? vtkiFetchAlbedo(pixel) : vec3(0.0f);
  vec3 shaded = texelFetch(vtkiLit, pixel, 0).rgb;
  vec3 direct = vtkiKeepLamps(surface, albedo, vtkiDecodeShading(surface, shaded));
  vec3 sky = vec3(0.0f);
  vec3 area = vec3(0.0f);
  vec3 bounce = vec3(0.0f);
  vec3 glossy = vec3(0.0f);
  if (lit)
  {
    vtkiAddIrradiance(vec2(pixel) + 0.5f, surface, sky, area, bounce);
    vtkiAddRadiance(vec2(pixel) + 0.5f, 1.0f, glossy);
  }
  vec3 irradiance = bounce + sky + area;
  vec4 specular = vec4(0.0f);
#ifdef VTKI_SPECULAR
  specular = lit ? texelFetch(vtkiSpecular, pixel, 0) : vec4(0.0f);
#endif
  vec3 indirect =
    vtkiIndirectScale > 0.0f ? (albedo * irradiance + glossy) * vtkiIndirectScale : vec3(0.0f);
  vec3 value = vec3(0.0f);
  bool catches = vtkiSurfaceCatches(surface);
  if (catches && vtkiChannel <= VTKI_CHANNEL_INDIRECT)
  {
    value = vec3(0.0f); // it shows the background
  }
  else if (vtkiChannel == VTKI_CHANNEL_FINAL)
  {
    value = vtkiEncodeShading(surface, direct + indirect);
  }
  else if (vtkiChannel == VTKI_CHANNEL_DIRECT)
  {
    value = vtkiEncodeShading(surface, direct);
  }
  else if (vtkiChannel == VTKI_CHANNEL_INDIRECT)
  {
    value = indirect;
  }
  else if (vtkiChannel == VTKI_CHANNEL_IRRADIANCE)
  {
    value = irradiance;
  }
  else if (vtkiChannel == VTKI_CHANNEL_SKY)
  {
    value = sky;
  }
  else if (vtkiChannel == VTKI_CHANNEL_AREA)
  {
    value = area;
  }
  else if (vtkiChannel == VTKI_CHANNEL_BOUNCE)
  {
    value = bounce;
  }
  else if (vtkiChannel == VTKI_CHANNEL_GLOSSY)
  {
    value = glossy;
  }
  else if (vtkiChannel == VTKI_CHANNEL_ALBEDO)
  {
    value = albedo;
  }
  else if (vtkiChannel == VTKI_CHANNEL_NORMAL && lit)
  {
    value = vtkiViewToWorldDirection * vtkiSurfaceNormal(surface);
  }
  else if (vtkiChannel == VTKI_CHANNEL_DEPTH)
  {
    value = vec3(vtkiSurfaceDepth(surface) / vtkiSceneScale);
  }
  else if (vtkiChannel == VTKI_CHANNEL_SPECULAR)
  {
    value = specular.rgb;
  }
  else if (vtkiChannel == VTKI_CHANNEL_CAUGHT && catches)
  {
#ifdef VTKI_CATCHES
    value = vtkiFindCaught(vec2(pixel) + 0.5f, surface, shaded, albedo, vtkiIndirectScale);
#else
    value = vec3(1.0f);
#endif
  }
  gl_FragData[0] = vec4(value, vtkiChannel == VTKI_CHANNEL_SPECULAR ? specular.a : 1.0f);
}
