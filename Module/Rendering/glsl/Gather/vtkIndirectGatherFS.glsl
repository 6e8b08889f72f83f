//VTK::System::Dec
//VTK::Output::Dec
// Irradiance at every vtkiStep-th pixel. VTKI_GATHER names the file that sums over the senders.
#include "vtkIndirectReceiverGrid.glsl"
#include VTKI_GATHER

void main()
{
  ivec2 pixel = vtkiSamplePixel(ivec2(gl_FragCoord.xy));
  vtkiReceiver receiver;
  vec3 irradiance = vec3(0.0f);
  if (vtkiFetchReceiver(pixel, receiver))
  {
    irradiance = vtkiGather(receiver.position, receiver.normal, receiver.facet, pixel);
  }
  gl_FragData[0] = vec4(irradiance, 1.0f);
}
