//VTK::System::Dec
//VTK::Output::Dec
// Indirect light in the specular lobe, at every pixel that is specular. VTKI_GATHER names the file
// that sums over the senders: the sum of the irradiance, with another weight.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectLibGlossy.glsl"

uniform sampler2D vtkiSpecular;
uniform float vtkiStorageScale;

// Set by main; compilers warn of values that functions before it use.
vec3 vtkiReceiverMirror = vec3(0.0f);
float vtkiReceiverPower = 0.0f;
float vtkiWeightInLobe(vec3 toSender, vec3 normalS, vec3 normalR, float area)
{
  return vtkiGlossyWeight(
    toSender, normalS, normalR, vtkiReceiverMirror, vtkiReceiverPower, area);
}
float vtkiDirectionInLobe(vec3 toLight, vec3 normalR)
{
  float mirrored = dot(normalR, toLight) > 0.0f ? dot(vtkiReceiverMirror, toLight) : 0.0f;
  return mirrored > 0.0f ? pow(min(mirrored, 1.0f), vtkiReceiverPower) / VTKI_PI : 0.0f;
}
#define vtkiVirtualLightWeight vtkiWeightInLobe
#define vtkiMeanLightWeight vtkiWeightInLobe
#define vtkiDirectionWeight vtkiDirectionInLobe
#include VTKI_GATHER

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 specular = texelFetch(vtkiSpecular, pixel, 0);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  vtkiReceiverMirror =
    mat3(vtkiViewToScene) * vtkiMirror(receiver.positionVC, receiver.normalVC);
  vtkiReceiverPower = specular.a;
  vec3 sum = vec3(0.0f);
  // Powers below zero are roughnesses of VTK's PBR, which area lights alone know.
  if (lit && specular.a >= 0.0f && max(max(specular.r, specular.g), specular.b) > 0.0f)
  {
    sum = vtkiGather(receiver.position, receiver.normal);
  }
  gl_FragData[0] = vec4(sum * vtkiStorageScale, 1.0f);
}
