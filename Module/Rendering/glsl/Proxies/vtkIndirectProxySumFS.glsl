//VTK::System::Dec
//VTK::Output::Dec
// Light of coarse receivers, or with VTKI_PROXY_PIXELS irradiance of pixels. Each fragment descends
// the tree of spheres by itself.
#include "vtkIndirectReceiverGrid.glsl"
#include "vtkIndirectProxySum.glsl"

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(vtkiSamplePixel(at), receiver);
  vtkiProxySums sums = vtkiSumProxies(receiver.position, receiver.normal, lit);
  vtkiProxyLit result = vtkiResolveProxies(receiver.position, receiver.normal, sums);
#ifdef VTKI_PROXY_PIXELS
  gl_FragData[0] = vec4(lit ? vtkiProxyIrradiance(result.sky, receiver.normal) : vec3(0.0f), 1.0f);
#ifdef VTKI_PROXY_LIGHT
  gl_FragData[1] = vec4(lit ? result.bounce : vec3(0.0f), 1.0f);
#endif
#else
  gl_FragData[0] = result.sky[0];
  gl_FragData[1] = result.sky[1];
  gl_FragData[2] = result.sky[2];
#ifdef VTKI_PROXY_LIGHT
  gl_FragData[3] = vec4(result.bounce, 1.0f);
#endif
#endif
}
