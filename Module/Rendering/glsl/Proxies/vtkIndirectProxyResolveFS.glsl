//VTK::System::Dec
//VTK::Output::Dec
// Light of coarse receivers, or with VTKI_PROXY_PIXELS irradiance, from blended sums.
#include "vtkIndirectReceiverGrid.glsl"
#include "vtkIndirectProxySum.glsl"

uniform sampler2D vtkiHidden0;
uniform sampler2D vtkiHidden1;
uniform sampler2D vtkiHidden2;
uniform sampler2D vtkiHidden3;
uniform sampler2D vtkiSent;

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(vtkiSamplePixel(at), receiver);
  vtkiProxySums sums = vtkiNoProxies();
  sums.hidden.A = texelFetch(vtkiHidden0, at, 0);
  sums.hidden.B = texelFetch(vtkiHidden1, at, 0);
  sums.hidden.C = texelFetch(vtkiHidden2, at, 0);
  sums.hidden.D = texelFetch(vtkiHidden3, at, 0);
  sums.sent = texelFetch(vtkiSent, at, 0);
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
