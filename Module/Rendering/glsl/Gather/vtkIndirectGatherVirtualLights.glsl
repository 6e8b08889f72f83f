// Sum over a block of virtual lights. VTKI_VISIBILITY: only visible lights count.
#include "vtkIndirectLightRow.glsl"
#ifdef VTKI_DIVIDED
#include "vtkIndirectBranches.glsl"
#endif
#ifdef VTKI_VISIBILITY
#include "vtkIndirectVisibility.glsl"
#endif

uniform sampler2D vtkiLightPosition; // position, area
uniform sampler2D vtkiLightNormal;   // normal, child distance
uniform sampler2D vtkiLightDensity;  // reflected density times area, source
uniform ivec2 vtkiLightRows; // first row, one past the last row
uniform int vtkiLightCount;

void vtkiFetchLight(int light, out vec4 sender, out vec4 senderNormal, out vec3 density)
{
  ivec2 at = vtkiTableTexel(light);
  sender = texelFetch(vtkiLightPosition, at, 0);
  senderNormal = texelFetch(vtkiLightNormal, at, 0);
  density = texelFetch(vtkiLightDensity, at, 0).rgb;
}

// Adds the light of a cluster as a whole, with this density. Returns true if the receiver is near
// to the cluster, so that its branches are to be added.
bool vtkiAddSender(vec3 position, vec3 normal, vec3 open, int light, vec4 sender, vec4 senderNormal, vec3 density,
  inout vec3 irradiance)
{
  vec3 toSender = vtkiToSender(sender, position);
  float weight = vtkiSenderWeight(toSender, senderNormal, normal, sender.w, vtkiSoftening(senderNormal.w, sender.w));
  float division = 0.0f;
#ifdef VTKI_DIVIDED
  division = vtkiDivision(dot(toSender, toSender), senderNormal.w);
#endif
  bool seen = true;
#ifdef VTKI_VISIBILITY
  bool lit = (weight > 0.0f || division > 0.0f) && max(max(density.r, density.g), density.b) > 0.0f;
  seen = vtkiIsSenderVisible(light, open, position, normal, sender, senderNormal.xyz, lit);
#endif
  irradiance += seen ? density * (weight * (1.0f - division)) : vec3(0.0f);
#ifdef VTKI_DIVIDED
  return vtkiKeepSight(vtkiReceiverSight, open, normal, toSender, senderNormal, division, seen ? 1.0f : 0.0f);
#else
  return false;
#endif
}

bool vtkiAddLight(vec3 position, vec3 normal, vec3 open, int light, inout vec3 irradiance)
{
  vec4 sender;
  vec4 senderNormal;
  vec3 density;
  vtkiFetchLight(light, sender, senderNormal, density);
  return vtkiAddSender(position, normal, open, light, sender, senderNormal, density, irradiance);
}

#ifdef VTKI_DIVIDED
// Adds the light of the branches of a cluster that the receiver is near to and sees.
void vtkiAddBelow(vec3 position, vec3 normal, vec3 open, int light, inout vec3 irradiance)
{
  vec4 sender;
  vec4 senderNormal;
  vec3 density;
  vtkiFetchLight(light, sender, senderNormal, density);
  vec3 toSender = sender.xyz - position;
  float share = vtkiShareOfBranches(vtkiReceiverSight, open, toSender, 1.0f) *
    vtkiDivision(dot(toSender, toSender), senderNormal.w);
  float below = 0.0f;
  int place = 0;
  while (place < VTKI_BRANCHES)
  {
    vec4 branch;
    vtkiFetchBranch(light, place, sender, senderNormal, branch);
    toSender = sender.xyz - position;
    bool isChild = vtkiIsChild(place);
    below = isChild ? share * vtkiDivisionOfChild(normal, toSender, senderNormal.xyz, senderNormal.w) : below;
    float weight = vtkiSenderWeight(toSender, senderNormal, normal, sender.w, branch.w);
    irradiance += branch.rgb * (weight * (isChild ? share - below : below));
    place = vtkiNextBranch(place, senderNormal.w, below > 0.0f);
  }
}
#endif

vec3 vtkiGather(vec3 position, vec3 normal, vec3 facet, ivec2 pixel)
{
  vec3 total = vec3(0.0f);
#ifdef VTKI_DIVIDED
  vtkiStartSight();
#endif
  vec3 open = position;
#ifdef VTKI_VISIBILITY
  open = vtkiOpenPlace(position, normal, facet, pixel);
#endif
  for (int row = vtkiLightRows.x; row < vtkiLightRows.y; ++row)
  {
    // Sums by row keep rounding errors of long sums small.
    vec3 partial = vec3(0.0f);
    int endOfRow = min((row + 1) * VTKI_ROW_LENGTH, vtkiLightCount);
#ifdef VTKI_DIVIDED
    const int atOnce = VTKI_NEAR_LIGHTS;
#else
    const int atOnce = VTKI_ROW_LENGTH;
#endif
    for (int first = row * VTKI_ROW_LENGTH; first < endOfRow; first += atOnce)
    {
      int end = min(first + atOnce, endOfRow);
      uvec4 near = uvec4(0u);
      for (int light = first; light < end; ++light)
      {
        bool isNear = vtkiAddLight(position, normal, open, light, partial);
#ifdef VTKI_DIVIDED
        vtkiKeepNear(near, light - first, isNear);
#endif
      }
#ifdef VTKI_DIVIDED
      while (vtkiHasNear(near))
      {
        vtkiAddBelow(position, normal, open, first + vtkiTakeNear(near), partial);
      }
#endif
    }
    total += partial;
  }
  return total;
}
