//VTK::System::Dec
// Specular reflection of virtual lights by the receivers: a group of invocations for each tile of
// 16 x 16 pixels lists the lights that any of its receivers' lobes can see, and the lobes of lights
// that extend to it, and sums these.
#include "vtkIndirectReceiver.glsl"

uniform sampler2D vtkiSpecular;

#include "vtkIndirectGlossyWeight.glsl"
#include "vtkIndirectSplatLobe.glsl"
#include "vtkIndirectSplatTile.glsl"
#include "vtkIndirectTileBox.glsl"

shared uint vtkiLowestMirror[3];
shared uint vtkiHighestMirror[3];
shared uint vtkiLeastPower;
shared uint vtkiLeastCosine; // least cosine of the mirror directions to their middle

// Returns true if any of the tile's receivers may see a light, or its branches if they are near to
// it.
bool vtkiTileSeesLight(
  vec4 sender, vec4 senderNormal, vec3 middle, float radius, vec3 mirror, float cosine, float power)
{
  bool direction = sender.w < 0.0f;
  vec3 toSender = vtkiToSender(sender, middle);
  bool near = false;
#ifdef VTKI_DIVIDED
  near = length(toSender) < senderNormal.w + radius;
#endif
  return near || !vtkiIsBesideMirrors(toSender, direction ? 0.0f : radius, mirror, cosine, power);
}

#ifdef VTKI_SPLAT_LOBES
bool vtkiTileSeesLobe(ivec2 at, vec4 sender, vec3 senderNormal, vec3 middle, vec3 halfSize, float low)
{
  vec3 flux = texelFetch(vtkiLobeDensity, at, 0).rgb;
  vec4 direction = texelFetch(vtkiLobeDirection, at, 0);
  vtkiSplat lobe = vtkiWholeScene();
  if (low > 0.0f)
  {
    float upright = dot(senderNormal, direction.xyz) / max(length(senderNormal), 1.0e-20f);
    lobe = vtkiWithinScene(vtkiMakeLobeSplat(sender.xyz, direction.xyz, upright, direction.w, sender.w,
      vtkiLobeFlux(flux, low)));
  }
  return max(max(flux.r, flux.g), flux.b) > 0.0f && vtkiSplatMeetsBox(lobe, middle, halfSize);
}

vec3 vtkiLobeInLobe(vtkiReceiver receiver, vec3 open, int light)
{
  ivec2 at = vtkiTableTexel(light);
  vec4 sender = texelFetch(vtkiLightPosition, at, 0);
  vec3 senderNormal = texelFetch(vtkiLightNormal, at, 0).xyz;
  vec4 direction = texelFetch(vtkiLobeDirection, at, 0);
  vec3 toSender = sender.xyz - receiver.position;
  float r = length(toSender);
  float mirrored = r > 0.0f ? min(dot(vtkiReceiverMirror, toSender) / r, 1.0f) : 0.0f;
  if (!(mirrored > 0.0f) || !(dot(receiver.normal, toSender) > 0.0f) ||
    vtkiIsBesideLobe(toSender, direction.xyz, direction.w, sender.w))
  {
    return vec3(0.0f);
  }
  float weight = pow(mirrored, vtkiReceiverPower) * r *
    vtkiSenderLobeStrength(toSender, senderNormal, direction.xyz, direction.w, sender.w);
#ifdef VTKI_VISIBILITY
  bool seen = vtkiIsSenderVisible(
    light, open, receiver.position, receiver.normal, sender, senderNormal, weight > 0.0f);
  weight = seen ? weight : 0.0f;
#endif
  return weight * texelFetch(vtkiLobeDensity, at, 0).rgb;
}
#endif

void main()
{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  int number = int(gl_LocalInvocationIndex);
  vtkiReceiver receiver;
  bool inside = pixel.x < vtkiSize.x && pixel.y < vtkiSize.y;
  bool lit = vtkiFetchReceiver(min(pixel, vtkiSize - 1), receiver) && inside;
  vec4 specular = texelFetch(vtkiSpecular, min(pixel, vtkiSize - 1), 0);
  // Negative powers are roughnesses of VTK's PBR; only area lights support these.
  bool wanted = lit && specular.a >= 0.0f && max(max(specular.r, specular.g), specular.b) > 0.0f;
  vtkiReceiverMirror = mat3(vtkiViewToScene) * vtkiMirror(receiver.positionVC, receiver.normalVC);
  vtkiReceiverPower = specular.a;
  if (number < 3)
  {
    vtkiLowestMirror[number] = 0xffffffffu;
    vtkiHighestMirror[number] = 0u;
    vtkiLeastPower = 0xffffffffu;
    vtkiLeastCosine = 0xffffffffu;
  }
  vtkiBeginBox();
  if (wanted)
  {
    vtkiAddToBox(receiver.position);
    for (int i = 0; i < 3; ++i)
    {
      uint mirror = vtkiOrdered(vtkiReceiverMirror[i]);
      atomicMin(vtkiLowestMirror[i], mirror);
      atomicMax(vtkiHighestMirror[i], mirror);
    }
    atomicMin(vtkiLeastPower, vtkiOrdered(specular.a));
  }
  vec3 middle;
  vec3 halfSize;
  bool any = vtkiEndBox(middle, halfSize);
  vec3 between = any ? vtkiFromOrdered(vtkiLowestMirror) + vtkiFromOrdered(vtkiHighestMirror) : vec3(0.0f);
  vec3 mirror = between / max(length(between), 1.0e-20f);
  if (wanted)
  {
    atomicMin(vtkiLeastCosine, vtkiOrdered(dot(mirror, vtkiReceiverMirror)));
  }
  barrier();
  float cosine = any ? vtkiFromOrdered(vtkiLeastCosine) : 1.0f;
  float power = any ? vtkiFromOrdered(vtkiLeastPower) : 0.0f;

  const float highest = VTKI_LOBE_SPLAT_GLOSSY / (VTKI_SPLAT_LENGTH * VTKI_SPLAT_LENGTH);
  float low = min(vtkiSplatThreshold, highest) * texelFetch(vtkiSplatMean, ivec2(0), 0).r;
  vec3 open = receiver.position;
  if (wanted)
  {
    open = vtkiSplatOpenPlace(receiver.position, receiver.normal, receiver.facet, min(pixel, vtkiSize - 1));
  }
  vec3 total = vec3(0.0f);
  for (int row = vtkiLightRows.x; row < vtkiLightRows.y && any; ++row)
  {
    vtkiClearLists(number);
    int light = row * VTKI_ROW_LENGTH + number;
    vec4 sender;
    vec4 senderNormal;
    vec3 density;
    vtkiFetchLight(min(light, max(vtkiLightCount - 1, 0)), sender, senderNormal, density);
    if (light < vtkiLightCount &&
      vtkiTileSeesLight(sender, senderNormal, middle, length(halfSize), mirror, cosine, power))
    {
      uint bit = 1u << uint(number & 31);
      if (max(max(density.r, density.g), density.b) > 0.0f)
      {
        atomicOr(vtkiListed[number >> 5], bit);
      }
#ifdef VTKI_SPLAT_LOBES
      if (vtkiTileSeesLobe(vtkiTableTexel(light), sender, senderNormal.xyz, middle, halfSize, low))
      {
        atomicOr(vtkiListedLobes[number >> 5], bit);
      }
#endif
    }
    barrier();
    // Sums by row keep rounding errors of long sums small.
    vec3 partial = vec3(0.0f);
    for (int word = 0; word < VTKI_ROW_LENGTH / 32; ++word)
    {
      uint bits = wanted ? vtkiListed[word] : 0u;
      while (bits != 0u)
      {
        int next = row * VTKI_ROW_LENGTH + 32 * word + findLSB(bits);
        bits &= bits - 1u;
        vtkiFetchLight(next, sender, senderNormal, density);
        partial += vtkiWholeSender(receiver.position, receiver.normal, open, next, sender, senderNormal, density);
      }
#ifdef VTKI_SPLAT_LOBES
      bits = wanted ? vtkiListedLobes[word] : 0u;
      while (bits != 0u)
      {
        int next = row * VTKI_ROW_LENGTH + 32 * word + findLSB(bits);
        bits &= bits - 1u;
        partial += vtkiLobeInLobe(receiver, open, next);
      }
#endif
    }
    total += partial;
    barrier();
  }
  if (inside)
  {
    vtkiStoreSum(pixel, vec4(0.0f, 0.0f, 0.0f, 1.0f), vec4(wanted ? total : vec3(0.0f), 0.0f));
  }
}
