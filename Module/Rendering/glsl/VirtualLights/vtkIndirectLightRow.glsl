// How a row of the table of virtual lights is read: a place, or, where the frame has such
// (VTKI_DIRECTIONS), a direction with minus its solid angle for an area.
#include "vtkIndirectLibTable.glsl"
#include "vtkIndirectLibVirtualLight.glsl"

vec3 vtkiToSender(vec4 sender, vec3 position)
{
#ifdef VTKI_DIRECTIONS
  return sender.w < 0.0f ? sender.xyz : sender.xyz - position;
#else
  return sender.xyz - position;
#endif
}

// Times the receiver's cosine and the density it is the light's irradiance; see
// vtkiVirtualLightStrength. Only lights with branches (VTKI_DIVIDED) stand for surfaces that differ.
float vtkiSenderStrength(vec3 toSender, vec3 senderNormal, float area)
{
#ifdef VTKI_DIVIDED
  float strength = vtkiMeanLightStrength(toSender, senderNormal, area);
#else
  float strength = vtkiVirtualLightStrength(toSender, senderNormal, area);
#endif
#ifdef VTKI_DIRECTIONS
  return area < 0.0f ? 1.0f / VTKI_PI : strength;
#else
  return strength;
#endif
}

float vtkiSenderWeight(vec3 toSender, vec3 senderNormal, vec3 normal, float area)
{
#ifdef VTKI_DIRECTIONS
  if (area < 0.0f)
  {
    return vtkiDirectionWeight(toSender, normal);
  }
#endif
#ifdef VTKI_DIVIDED
  return vtkiMeanLightWeight(toSender, senderNormal, normal, area);
#else
  return vtkiVirtualLightWeight(toSender, senderNormal, normal, area);
#endif
}
