//VTK::System::Dec
//VTK::Output::Dec
// Irradiance from the hints at every vtkiStep-th pixel, or at those of all pixels that interpolation
// left; mixed with that of the last frame.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectHintLookup.glsl"

uniform int vtkiStep;
uniform float vtkiKeep; // share of the last frame
uniform sampler2D vtkiLast;

void main()
{
  ivec2 coarse = ivec2(gl_FragCoord.xy);
  ivec2 pixel = min(coarse * vtkiStep, vtkiSize - 1);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  vec3 e = max(vtkiHintIrradiance(receiver.position, receiver.normal, coarse, lit), vec3(0.0f));
  vec4 last = texelFetch(vtkiLast, coarse, 0);
  float keep = last.a > 0.5f ? vtkiKeep : 0.0f;
  gl_FragData[0] = lit ? vec4(keep > 0.0f ? mix(e, last.rgb, keep) : e, 1.0f) : vec4(0.0f);
}
