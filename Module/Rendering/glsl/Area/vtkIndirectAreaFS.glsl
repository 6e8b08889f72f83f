//VTK::System::Dec
//VTK::Output::Dec
// Irradiance of an area light of one radiance in closed form, without occlusion.
#include "vtkIndirectAreaLamps.glsl"

void main()
{
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(ivec2(gl_FragCoord.xy), receiver);
  float front;
  vec3 open = vtkiFindOpen(receiver, lit, front).rgb;
  gl_FragData[0] = vec4(open, front);
}
