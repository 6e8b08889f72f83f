//VTK::System::Dec
//VTK::Output::Dec
// Irradiance at every vtkiStep-th pixel. VTKI_GATHER names the file that sums over the senders.
#include "vtkIndirectReceiver.glsl"
#include VTKI_GATHER

uniform int vtkiStep;

void main()
{
  ivec2 pixel = min(ivec2(gl_FragCoord.xy) * vtkiStep, vtkiSize - 1);
  vtkiReceiver receiver;
  vec3 irradiance = vec3(0.0f);
  if (vtkiFetchReceiver(pixel, receiver))
  {
    irradiance = vtkiGather(receiver.position, receiver.normal, receiver.facet);
  }
  gl_FragData[0] = vec4(irradiance, 1.0f);
}
