// Sum over the virtual lights at a subsplat.
#include "vtkIndirectLightRow.glsl"
#include "vtkIndirectLibSubsplat.glsl"
#include "vtkIndirectLightUniforms.glsl"
#ifdef VTKI_DIVIDED
#include "vtkIndirectBranches.glsl"
#endif
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

// A light from the textures: its position with the area, normal with its reach, and density times area.
void vtkiFetchLight(int i, out vec4 sender, out vec4 senderNormal, out vec3 density)
{
  ivec2 at = vtkiTableTexel(vtkiFirstLight + i);
  sender = texelFetch(vtkiLightPosition, at, 0);
  senderNormal = texelFetch(vtkiLightNormal, at, 0);
  density = texelFetch(vtkiLightDensity, at, 0).rgb;
}

// share: of the light as a whole, 0 where something hides it.
void vtkiAddSeenLight(vec3 position, vec3 normal, float share, vec4 sender, vec3 senderNormal, vec3 density,
  inout vec3 irradiance, inout vec3 vectorIrradiance)
{
  vec3 toSender = vtkiToSender(sender, position);
  float cosine = dot(normal, toSender);
  float strength =
    cosine > 0.0f ? share * vtkiSenderStrength(toSender, senderNormal, sender.w) : 0.0f;
  irradiance += (strength * cosine) * density;
  vectorIrradiance += (strength * vtkiLuminance(density)) * toSender;
}

// open: see vtkiOpenPlace; light: its number in the table; both of no meaning without VTKI_VISIBILITY.
void vtkiAddLight(vec3 position, vec3 normal, vec3 open, int light, vec4 sender, vec4 senderNormal, vec3 density,
  inout vec3 irradiance, inout vec3 vectorIrradiance)
{
  bool seen = true;
  float division = 0.0f;
#ifdef VTKI_DIVIDED
  division = vtkiDivision(sender.xyz - position, senderNormal.w);
#endif
#ifdef VTKI_VISIBILITY
  // Nothing to walk where there is nothing to get.
  vec3 toSender = vtkiToSender(sender, position);
  bool lit = max(max(density.r, density.g), density.b) > 0.0f && (division > 0.0f ||
    (dot(normal, toSender) > 0.0f && vtkiSenderStrength(toSender, senderNormal.xyz, sender.w) > 0.0f));
  seen = vtkiIsSenderVisible(light, open, position, normal, sender, senderNormal.xyz, lit);
#endif
  vtkiAddSeenLight(position, normal, seen ? 1.0f - division : 0.0f, sender, senderNormal.xyz, density, irradiance,
    vectorIrradiance);
#ifdef VTKI_DIVIDED
  vtkiAddBranches(light, position, normal, seen ? division : 0.0f, irradiance, vectorIrradiance);
#endif
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
    vtkiAddLight(position, normal, open, vtkiFirstLight + i, vtkiBlockPosition[i], vtkiBlockNormal[i],
      vtkiBlockDensity[i].rgb, irradiance, vectorIrradiance);
  }
  count = wanted ? vtkiLightCount : 0;
  for (int i = vtkiBlockCount; i < count; ++i)
  {
    vec4 sender;
    vec4 senderNormal;
    vec3 density;
    vtkiFetchLight(i, sender, senderNormal, density);
    vtkiAddLight(position, normal, open, vtkiFirstLight + i, sender, senderNormal, density, irradiance, vectorIrradiance);
  }
}
