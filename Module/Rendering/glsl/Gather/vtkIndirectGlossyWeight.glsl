// Replaces the irradiance weight of the files included after this one by the weight of the
// receiver's specular lobe.
#include "vtkIndirectLibGlossy.glsl"

// main() sets these; the initial values avoid warnings about functions that precede it.
vec3 vtkiReceiverMirror = vec3(0.0f);
float vtkiReceiverPower = 0.0f;
float vtkiWeightInLobe(vec3 toSender, vec3 normalS, vec3 normalR, float area)
{
  return vtkiGlossyWeight(
    toSender, normalS, normalR, vtkiReceiverMirror, vtkiReceiverPower, area);
}
float vtkiPatchInLobe(vec3 toSender, vec3 normalS, vec3 normalR, float area, float softening)
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
