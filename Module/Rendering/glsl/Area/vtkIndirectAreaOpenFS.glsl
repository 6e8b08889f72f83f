//VTK::System::Dec
//VTK::Output::Dec
// At samples: irradiance of area lights without occlusion; distance of the nearest lamp; a bit for
// each lamp that sends light to the surface's side of the lamp's plane.
#include "vtkIndirectReceiverGrid.glsl"
#include "vtkIndirectAreaLamps.glsl"

void main()
{
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(vtkiSamplePixel(ivec2(gl_FragCoord.xy)), receiver);
  float front;
  gl_FragData[0] = vtkiFindOpen(receiver, lit, front);
  gl_FragData[1] = vec4(front);
}
