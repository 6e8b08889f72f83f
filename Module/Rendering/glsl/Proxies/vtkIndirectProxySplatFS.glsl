//VTK::System::Dec
//VTK::Output::Dec
// What an entry of the tree of spheres hides from a receiver, or sends to it, to be added.
#include "vtkIndirectStep.glsl"
#include "vtkIndirectProxySum.glsl"

flat in int vtkiProxyNumber;

void main()
{
  vtkiReceiver receiver;
  vtkiProxySums sums = vtkiNoProxies();
  if (vtkiFetchReceiver(min(ivec2(gl_FragCoord.xy) * vtkiStep, vtkiSize - 1), receiver))
  {
    vtkiAddProxy(receiver.position, receiver.normal, vtkiProxyNumber, sums);
  }
#ifdef VTKI_PROXY_LIGHT
  gl_FragData[0] = vec4(sums.light0, sums.solidAngle);
  gl_FragData[1] = vec4(sums.light1[0], sums.light1[1].x);
  gl_FragData[2] = vec4(sums.light1[1].yz, sums.light1[2].xy);
  gl_FragData[3] = vec4(sums.light1[2].z, sums.light2[0]);
  gl_FragData[4] = vec4(sums.light2[1], sums.light2[2].x);
  gl_FragData[5] = vec4(sums.light2[2].yz, sums.light2[3].xy);
  gl_FragData[6] = vec4(sums.light2[3].z, sums.light2[4]);
#else
  gl_FragData[0] = sums.hidden.A;
  gl_FragData[1] = sums.hidden.B;
  gl_FragData[2] = sums.hidden.C;
  gl_FragData[3] = sums.hidden.D;
#endif
}
