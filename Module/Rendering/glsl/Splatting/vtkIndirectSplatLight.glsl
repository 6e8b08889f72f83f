// Distance to which a virtual light counts, from its intensity and the lowest intensity that
// counts.
#include "vtkIndirectGatherVirtualLights.glsl"
#include "vtkIndirectLibSplat.glsl"
#include "vtkIndirectSplatLow.glsl"

// Returns the intensity along the normal, in the brightest colour. With branches a light represents
// various normals and sends some light to all sides.
float vtkiGreatestIntensity(vec3 senderNormal, vec3 density)
{
  float intensity = max(max(density.r, density.g), density.b) / VTKI_PI;
#ifdef VTKI_DIVIDED
  intensity *= vtkiMeanProjection(-senderNormal / max(length(senderNormal), 1.0e-20f), senderNormal, 1.0f);
#endif
  return max(intensity, 0.0f);
}

// Returns the squared distance to which the light counts along its normal. Both intensities scale
// with the scene's light, which is arbitrary: only their quotient is of order one.
float vtkiSquaredReach(float intensity, float low)
{
  return low > 0.0f ? min(intensity / low, 1.0e12f) : 1.0e12f;
}

// Returns the intensity over the squared distance at a position, over the lowest that counts.
float vtkiSplatLevel(vec3 toSender, vec4 sender, vec3 senderNormal, vec3 density, float low)
{
  float r2 = max(dot(toSender, toSender), 1.0e-20f);
#ifdef VTKI_DIVIDED
  float projected = vtkiMeanProjection(toSender, senderNormal, r2);
#else
  float projected = max(-dot(senderNormal, toSender), 0.0f);
#endif
  float intensity = max(max(density.r, density.g), density.b) / VTKI_PI;
  float level = vtkiSquaredReach(intensity, low) * (projected / (sqrt(r2) * r2));
  // Light from a direction has no distance; with a lowest intensity of zero nothing is cut off.
  return sender.w < 0.0f || !(low > 0.0f) ? 2.0f : level;
}

#ifdef VTKI_SPLAT_FADES
const bool vtkiSplatFades = true;
#else
const bool vtkiSplatFades = false;
#endif

// Returns the distance within which the splat has all of a light: with branches, which lie
// elsewhere than the light's middle and vary as fast as any near light, the distance to which these
// are summed; with a far field the light's neighbourhood.
float vtkiBall(vec4 sender, vec4 senderNormal)
{
  float ball = vtkiSplatFades ? vtkiNearReach(sender.w) : 0.0f;
#ifdef VTKI_DIVIDED
  ball = max(ball, senderNormal.w);
#endif
  return ball;
}

// Share of a light at a position that its splat has; the far field has the rest.
float vtkiShareOfSplat(vec3 toSender, vec4 sender, vec4 senderNormal, vec3 density, float low)
{
  float level = vtkiSplatLevel(toSender, sender, senderNormal.xyz, density, low);
  float share = vtkiSplatShare(level, vtkiSplatFades);
  float near = vtkiNearShare(dot(toSender, toSender), vtkiBall(sender, senderNormal));
  return max(share, vtkiSplatFades || near <= 0.0f ? near : 1.0f);
}

// The light of a sender, not cut off. Splats that are drawn and the far field sum one sender at a
// time, so that no other cluster tells whether a receiver whose plane a cluster reaches through sees
// that cluster: the cluster counts as seen, and inside closed bodies 0.5 to 1 % of the light outside
// arrives by splats that are drawn.
vec3 vtkiWholeSender(vec3 position, vec3 normal, vec3 open, int light, vec4 sender, vec4 senderNormal, vec3 density)
{
  vec3 irradiance = vec3(0.0f);
#ifdef VTKI_DIVIDED
  vtkiStartSight();
#endif
  bool below = vtkiAddSender(position, normal, open, light, sender, senderNormal, density, irradiance);
#ifdef VTKI_DIVIDED
  if (below)
  {
    vtkiAddBelow(position, normal, open, light, irradiance);
  }
#endif
  return irradiance;
}

// Returns the splat's part of that light.
vec3 vtkiSplatSender(
  vec3 position, vec3 normal, vec3 open, int light, vec4 sender, vec4 senderNormal, vec3 density, float low)
{
  float share = vtkiShareOfSplat(vtkiToSender(sender, position), sender, senderNormal, density, low);
  vec3 irradiance = vec3(0.0f);
  if (share > 0.0f)
  {
    irradiance = share * vtkiWholeSender(position, normal, open, light, sender, senderNormal, density);
  }
  return irradiance;
}

float vtkiShareOfLight(vec3 position, int light, float low)
{
  vec4 sender;
  vec4 senderNormal;
  vec3 density;
  vtkiFetchLight(light, sender, senderNormal, density);
  return vtkiShareOfSplat(vtkiToSender(sender, position), sender, senderNormal, density, low);
}

// Adds the splat's part of a cluster as a whole. Returns true if the receiver is near to the
// cluster, so that its branches are to be added.
bool vtkiAddSplat(vec3 position, vec3 normal, vec3 open, int light, float low, inout vec3 irradiance)
{
  float share = vtkiShareOfLight(position, light, low);
  vec3 whole = vec3(0.0f);
  bool isNear = share > 0.0f && vtkiAddLight(position, normal, open, light, whole);
  irradiance += share * whole;
  return isNear;
}

#ifdef VTKI_DIVIDED
// Adds the splat's part of the branches of such a cluster.
void vtkiAddSplatBelow(vec3 position, vec3 normal, vec3 open, int light, float low, inout vec3 irradiance)
{
  vec3 below = vec3(0.0f);
  vtkiAddBelow(position, normal, open, light, below);
  irradiance += vtkiShareOfLight(position, light, low) * below;
}
#endif

vec3 vtkiSplatOpenPlace(vec3 position, vec3 normal, vec3 facet, ivec2 pixel)
{
#ifdef VTKI_VISIBILITY
  return vtkiOpenPlace(position, normal, facet, pixel);
#else
  return position;
#endif
}
