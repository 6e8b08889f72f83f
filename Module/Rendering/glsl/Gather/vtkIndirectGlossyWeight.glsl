// Sums over senders as of the irradiance, in a receiver's specular lobe: includes that follow take these weights.
#include "vtkIndirectLibGlossy.glsl"

// Set by main; compilers warn of values that functions before it use.
vec3 vtkiReceiverMirror = vec3(0.0f);
float vtkiReceiverPower = 0.0f;
float vtkiWeightInLobe(vec3 toSender, vec3 normalS, vec3 normalR, float area)
{
  return vtkiGlossyWeight(
    toSender, normalS, normalR, vtkiReceiverMirror, vtkiReceiverPower, area);
}
float vtkiPatchInLobe(vec3 toSender, vec3 normalS, vec3 normalR, float area, float bluntArea)
{
  return vtkiWeightInLobe(toSender, normalS, normalR, area);
}
float vtkiDirectionInLobe(vec3 toLight, vec3 normalR)
{
  float mirrored = dot(normalR, toLight) > 0.0f ? dot(vtkiReceiverMirror, toLight) : 0.0f;
  return mirrored > 0.0f ? pow(min(mirrored, 1.0f), vtkiReceiverPower) / VTKI_PI : 0.0f;
}
#define vtkiVirtualLightWeight vtkiWeightInLobe
#define vtkiPatchLightWeight vtkiPatchInLobe
#define vtkiDirectionWeight vtkiDirectionInLobe
