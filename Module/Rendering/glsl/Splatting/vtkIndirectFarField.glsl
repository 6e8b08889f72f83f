// What splats leave of virtual lights.
#include "vtkIndirectSplatLight.glsl"
#include "vtkIndirectLibSubsplat.glsl"

// Cut off, and luminance of all that comes.
vec4 vtkiSumFarField(vec3 position, vec3 normal, int first, int end)
{
  float low = vtkiSplatLow();
  vec3 open = vtkiSplatOpenPlace(position, normal);
  vec4 total = vec4(0.0f);
  for (int light = first; light < end; ++light)
  {
    vec4 sender;
    vec4 senderNormal;
    vec3 density;
    vtkiFetchLight(light, sender, senderNormal, density);
    float level = vtkiSplatLevel(vtkiToSender(sender, position), sender, senderNormal.xyz, density, low);
    vec3 whole = vtkiWholeSender(position, normal, open, light, sender, senderNormal, density);
    total += vec4((1.0f - vtkiSplatShare(level, vtkiSplatFades)) * whole, vtkiLuminance(whole));
  }
  return total;
}
