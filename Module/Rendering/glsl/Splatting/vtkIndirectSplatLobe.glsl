// Light of a virtual light's lobe, within its splat (VTKI_SPLAT_LOBES: lights have lobes).
#include "vtkIndirectSplatLight.glsl"
#include "vtkIndirectLibLobeSplat.glsl"
#include "vtkIndirectLibSubsplat.glsl"

#ifdef VTKI_SPLAT_LOBES
uniform sampler2D vtkiLobeDirection; // direction, exponent
uniform sampler2D vtkiLobeDensity;   // flux density times area

// Returns the flux over the lowest intensity over a squared distance that counts. Only this
// quotient is of order one.
float vtkiLobeFlux(vec3 density, float low)
{
  return vtkiSquaredReach(max(max(density.r, density.g), density.b), low);
}

// Returns the light of a lobe: its splat's part, or the rest; adds the luminance of both to all.
vec3 vtkiAddSplatLobe(vec3 position, vec3 normal, vec3 open, int light, vec4 sender, vec3 senderNormal, vec4 direction,
  vec3 density, float low, bool rest, inout float all)
{
  vec3 toSender = sender.xyz - position;
  float cosine = dot(normal, toSender);
  if (!(cosine > 0.0f) || vtkiIsBesideLobe(toSender, direction.xyz, direction.w, sender.w))
  {
    return vec3(0.0f);
  }
  float strength = vtkiSenderLobeStrength(toSender, senderNormal, direction.xyz, direction.w, sender.w);
  float level = vtkiLobeFlux(density, low) * length(toSender) * strength;
  float share = low > 0.0f ? vtkiSplatShare(level, vtkiSplatFades) : 1.0f;
  float counts = rest ? 1.0f - share : share;
  float weight = cosine * strength;
#ifdef VTKI_VISIBILITY
  bool seen = vtkiIsSenderVisible(
    light, open, position, normal, sender, senderNormal, weight > 0.0f && (rest || counts > 0.0f));
  weight = seen ? weight : 0.0f;
#endif
  all += weight * vtkiLuminance(density);
  return (counts * weight) * density;
}

vec3 vtkiSplatLobe(vec3 position, vec3 normal, vec3 open, int light, vec4 sender, vec3 senderNormal, vec4 direction,
  vec3 density, float low)
{
  float all = 0.0f;
  return vtkiAddSplatLobe(
    position, normal, open, light, sender, senderNormal, direction, density, low, false, all);
}
#endif
