// Sum over the virtual lights at a subsplat.
#include "vtkIndirectLightRow.glsl"
#include "vtkIndirectLibSubsplat.glsl"
#include "vtkIndirectLightUniforms.glsl"
#ifdef VTKI_VISIBILITY
#include "vtkIndirectVisibility.glsl"
#else
vec3 vtkiOpenPlace(vec3 position, vec3 normal)
{
  return position;
}
#endif

uniform sampler2D vtkiLightPosition; // lights beyond the block's
uniform sampler2D vtkiLightNormal;
uniform sampler2D vtkiLightDensity;
uniform int vtkiFirstLight; // in the table
uniform int vtkiLightCount;

// A light from the textures: its position with the area, normal, and density times area.
void vtkiFetchLight(int i, out vec4 sender, out vec3 senderNormal, out vec3 density)
{
  ivec2 at = vtkiTableTexel(vtkiFirstLight + i);
  sender = texelFetch(vtkiLightPosition, at, 0);
  senderNormal = texelFetch(vtkiLightNormal, at, 0).xyz;
  density = texelFetch(vtkiLightDensity, at, 0).rgb;
}

// seen: whether nothing hides the light.
void vtkiAddSeenLight(vec3 position, vec3 normal, bool seen, vec4 sender, vec3 senderNormal, vec3 density,
  inout vec3 irradiance, inout vec3 vectorIrradiance)
{
  vec3 toSender = vtkiToSender(sender, position);
  float cosine = dot(normal, toSender);
  float strength =
    seen && cosine > 0.0f ? vtkiSenderStrength(toSender, senderNormal, sender.w) : 0.0f;
  irradiance += (strength * cosine) * density;
  vectorIrradiance += (strength * vtkiLuminance(density)) * toSender;
}

// open: see vtkiOpenPlace; light: its number in the table; both of no meaning without VTKI_VISIBILITY.
void vtkiAddLight(vec3 position, vec3 normal, vec3 open, int light, vec4 sender, vec3 senderNormal, vec3 density,
  inout vec3 irradiance, inout vec3 vectorIrradiance)
{
  bool seen = true;
#ifdef VTKI_VISIBILITY
  // Nothing to walk where there is nothing to get.
  vec3 toSender = vtkiToSender(sender, position);
  bool lit = dot(normal, toSender) > 0.0f && vtkiSenderStrength(toSender, senderNormal, sender.w) > 0.0f &&
    max(max(density.r, density.g), density.b) > 0.0f;
  seen = vtkiIsSenderVisible(light, open, position, normal, sender, senderNormal, lit);
#endif
  vtkiAddSeenLight(position, normal, seen, sender, senderNormal, density, irradiance, vectorIrradiance);
}

// Irradiance, and the luminance of the vector irradiance; zero, and no work, where not wanted.
void vtkiEvaluateSubsplat(
  vec3 position, vec3 normal, bool wanted, out vec3 irradiance, out vec3 vectorIrradiance)
{
  irradiance = vec3(0.0f);
  vectorIrradiance = vec3(0.0f);
  vec3 open = vtkiOpenPlace(position, normal);
  int count = wanted ? vtkiBlockCount : 0;
  for (int i = 0; i < count; ++i)
  {
    vtkiAddLight(position, normal, open, vtkiFirstLight + i, vtkiBlockPosition[i], vtkiBlockNormal[i].xyz,
      vtkiBlockDensity[i].rgb, irradiance, vectorIrradiance);
  }
  count = wanted ? vtkiLightCount : 0;
  for (int i = vtkiBlockCount; i < count; ++i)
  {
    vec4 sender;
    vec3 senderNormal;
    vec3 density;
    vtkiFetchLight(i, sender, senderNormal, density);
    vtkiAddLight(position, normal, open, vtkiFirstLight + i, sender, senderNormal, density, irradiance, vectorIrradiance);
  }
}
