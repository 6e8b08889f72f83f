//VTK::System::Dec
//VTK::Output::Dec
// Adds an entry of the tree of spheres to a receiver: its occlusion and its light.
#include "vtkIndirectReceiverGrid.glsl"
#include "vtkIndirectProxySum.glsl"

flat in int vtkiProxyNumber;

void main()
{
  vtkiReceiver receiver;
  vtkiProxySums sums = vtkiNoProxies();
  if (vtkiFetchReceiver(vtkiSamplePixel(ivec2(gl_FragCoord.xy)), receiver))
  {
    vtkiAddProxy(receiver.position, receiver.normal, vtkiProxyNumber, sums);
  }
  gl_FragData[0] = sums.hidden.A;
  gl_FragData[1] = sums.hidden.B;
  gl_FragData[2] = sums.hidden.C;
  gl_FragData[3] = sums.hidden.D;
  gl_FragData[4] = sums.sent;
}
