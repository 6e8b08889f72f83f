//VTK::System::Dec
//VTK::Output::Dec
// Irradiance from the hints at pixels without an interpolated value.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectHintLookup.glsl"

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  vec3 e = max(vtkiHintIrradiance(receiver.position, receiver.normal, pixel, lit), vec3(0.0f));
  gl_FragData[0] = vec4(lit ? e : vec3(0.0f), 1.0f);
}
