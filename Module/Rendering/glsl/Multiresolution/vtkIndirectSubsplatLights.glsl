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
vec3 vtkiOpenPlace(vec3 position, vec3 normal, vec3 facet, ivec2 pixel)
{
  return position;
}
#endif

uniform int vtkiLightCount;

// share: of the light as a whole, 0 if it is occluded.
void vtkiAddSeenLight(vec3 position, vec3 normal, float share, float softening, vec4 sender, vec4 senderNormal,
  vec3 density, inout vec3 irradiance, inout vec3 vectorIrradiance)
{
  vec3 toSender = vtkiToSender(sender, position);
  vtkiPatchLight light = vtkiFindSender(toSender, senderNormal, normal, sender.w, softening);
  float cosine = dot(normal, light.toPlace);
  float strength = cosine > 0.0f ? share * light.strength : 0.0f;
  irradiance += (strength * cosine) * density;
  vectorIrradiance += (strength * vtkiLuminance(density)) * light.toPlace;
}

// Returns true if a receiver sees a light. open: see vtkiOpenPlace; light: its number in the table;
// both are unused without VTKI_VISIBILITY. division: share of the light that comes from its
// branches.
bool vtkiSees(vec3 position, vec3 normal, vec3 open, int light, vec4 sender, vec4 senderNormal, vec3 density,
  float division)
{
#ifdef VTKI_VISIBILITY
  // A light that gives the receiver nothing needs no walk.
  vec3 toSender = vtkiToSender(sender, position);
  vtkiPatchLight sent = vtkiFindSender(toSender, senderNormal, normal, sender.w, sender.w);
  bool lit = max(max(density.r, density.g), density.b) > 0.0f &&
    (division > 0.0f || (dot(normal, sent.toPlace) > 0.0f && sent.strength > 0.0f));
  return vtkiIsSenderVisible(light, open, position, normal, sender, senderNormal.xyz, lit);
#else
  return true;
#endif
}

// Adds the light of a cluster as a whole. Returns true if the receiver is near to it, so that its
// branches are to be added.
bool vtkiAddLight(vec3 position, vec3 normal, vec3 open, int light, vec4 sender, vec4 senderNormal, vec3 density,
  inout vec3 irradiance, inout vec3 vectorIrradiance)
{
  float division = 0.0f;
#ifdef VTKI_DIVIDED
  vec3 toSender = sender.xyz - position;
  division = vtkiDivision(dot(toSender, toSender), senderNormal.w);
#endif
  bool seen = vtkiSees(position, normal, open, light, sender, senderNormal, density, division);
  vtkiAddSeenLight(position, normal, seen ? 1.0f - division : 0.0f, vtkiSoftening(senderNormal.w, sender.w), sender,
    senderNormal, density, irradiance, vectorIrradiance);
#ifdef VTKI_DIVIDED
  return vtkiKeepSight(vtkiReceiverSight, open, normal, toSender, senderNormal, division, seen ? 1.0f : 0.0f);
#else
  return false;
#endif
}

#ifdef VTKI_DIVIDED
// Adds the branches of a cluster that the receiver is near to and sees. open: see vtkiOpenPlace;
// light: its number in the table.
void vtkiAddBelow(vec3 position, vec3 normal, vec3 open, int light, vec4 sender, float childDistance, inout vec3 irradiance,
  inout vec3 vectorIrradiance)
{
  vec3 toSender = sender.xyz - position;
  float share = vtkiShareOfBranches(vtkiReceiverSight, open, toSender, 1.0f) *
    vtkiDivision(dot(toSender, toSender), childDistance);
  float below = 0.0f;
  int place = share > 0.0f ? 0 : VTKI_BRANCHES;
  while (place < VTKI_BRANCHES)
  {
    vec4 node;
    vec4 nodeNormal;
    vec4 density;
    vtkiFetchBranch(light, place, node, nodeNormal, density);
    vec3 toNode = node.xyz - position;
    bool isChild = vtkiIsChild(place);
    below = isChild ? share * vtkiDivisionOfChild(normal, toNode, nodeNormal.xyz, nodeNormal.w) : below;
    vtkiAddSeenLight(position, normal, isChild ? share - below : below, density.w, node, nodeNormal, density.rgb,
      irradiance, vectorIrradiance);
    place = vtkiNextBranch(place, nodeNormal.w, below > 0.0f);
  }
}
#endif

// Adds a cluster and its branches.
void vtkiAddWholeLight(vec3 position, vec3 normal, vec3 open, int light, vec4 sender, vec4 senderNormal, vec3 density,
  inout vec3 irradiance, inout vec3 vectorIrradiance)
{
#ifdef VTKI_DIVIDED
  vtkiStartSight();
#endif
  bool isNear =
    vtkiAddLight(position, normal, open, light, sender, senderNormal, density, irradiance, vectorIrradiance);
#ifdef VTKI_DIVIDED
  vtkiAddBelow(position, normal, open, light, sender, isNear ? senderNormal.w : 0.0f, irradiance, vectorIrradiance);
#endif
}

// Irradiance, and the luminance of the vector irradiance; if not wanted, zero without any work.
void vtkiEvaluateSubsplat(
  vec3 position, vec3 normal, vec3 facet, ivec2 pixel, bool wanted, out vec3 irradiance, out vec3 vectorIrradiance)
{
  irradiance = vec3(0.0f);
  vectorIrradiance = vec3(0.0f);
  vec3 open = vtkiOpenPlace(position, normal, facet, pixel);
  int count = wanted ? vtkiLightCount : 0;
#ifdef VTKI_DIVIDED
  vtkiStartSight();
  const int atOnce = VTKI_NEAR_LIGHTS;
#else
  int atOnce = max(count, 1);
#endif
  for (int first = 0; first < count; first += atOnce)
  {
    int end = min(first + atOnce, count);
    uvec4 near = uvec4(0u);
    for (int i = first; i < end; ++i)
    {
      vec4 sender;
      vec4 senderNormal;
      vec3 density;
      vtkiFetchLight(i, sender, senderNormal, density);
      bool isNear = vtkiAddLight(position, normal, open, vtkiFirstLight + i, sender, senderNormal, density,
        irradiance, vectorIrradiance);
#ifdef VTKI_DIVIDED
      vtkiKeepNear(near, i - first, isNear);
#endif
    }
#ifdef VTKI_DIVIDED
    while (vtkiHasNear(near))
    {
      int light = first + vtkiTakeNear(near);
      vec4 sender;
      vec4 senderNormal;
      vec3 unused;
      vtkiFetchLight(light, sender, senderNormal, unused);
      vtkiAddBelow(
        position, normal, open, vtkiFirstLight + light, sender, senderNormal.w, irradiance, vectorIrradiance);
    }
#endif
  }
}
