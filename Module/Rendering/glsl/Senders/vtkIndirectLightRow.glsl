// Reads a row of the table of virtual lights: a position, or, where the frame has them
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

// Returns the area by which contacts of a cluster are softened: with branches of two generations,
// the area of the last generation.
float vtkiSoftening(float childDistance, float area)
{
  const float share = 1.0f / float(VTKI_BRANCHES_PER_NODE * VTKI_BRANCHES_PER_NODE);
  return childDistance > 0.0f ? share * area : area;
}

// Returns the light that arrives from a virtual light: times the receiver's cosine and the density
// it is the irradiance; see vtkiVirtualLightStrength. Only lights with branches (VTKI_DIVIDED)
// represent patches of surfaces. VTKI_POINT_FORM_FACTOR: all lights are points.
vtkiPatchLight vtkiFindSender(vec3 toSender, vec4 senderNormal, vec3 normal, float area, float softening)
{
#ifdef VTKI_POINT_FORM_FACTOR
  vtkiPatchLight light =
    vtkiPatchLight(toSender, vtkiPointLightStrength(toSender, senderNormal.xyz, normal, area));
#elif defined(VTKI_DIVIDED)
  vtkiPatchLight light = vtkiFindPatchLight(toSender, senderNormal.xyz, normal, area, softening);
#else
  vtkiPatchLight light = vtkiPatchLight(toSender, vtkiVirtualLightStrength(toSender, senderNormal.xyz, area));
#endif
#ifdef VTKI_DIRECTIONS
  light.toPlace = area < 0.0f ? toSender : light.toPlace;
  light.strength = area < 0.0f ? 1.0f / VTKI_PI : light.strength;
#endif
  return light;
}

float vtkiSenderWeight(vec3 toSender, vec4 senderNormal, vec3 normal, float area, float softening)
{
#ifdef VTKI_DIRECTIONS
  if (area < 0.0f)
  {
    return vtkiDirectionWeight(toSender, normal);
  }
#endif
#ifdef VTKI_DIVIDED
  return vtkiPatchLightWeight(toSender, senderNormal.xyz, normal, area, softening);
#else
  return vtkiVirtualLightWeight(toSender, senderNormal.xyz, normal, area);
#endif
}
