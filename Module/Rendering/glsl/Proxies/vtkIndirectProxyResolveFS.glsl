//VTK::System::Dec
//VTK::Output::Dec
// Light that comes to receivers, from sums that have been blended: planes of coefficients of coarse receivers, or with
// VTKI_PROXY_PIXELS irradiance of the sky or, by VTKI_PROXY_COLUMN 1, of what proxies send.
#include "vtkIndirectStep.glsl"
#include "vtkIndirectProxySum.glsl"
#include "vtkIndirectProxyPlanes.glsl"

uniform sampler2D vtkiHidden0;
uniform sampler2D vtkiHidden1;
uniform sampler2D vtkiHidden2;
uniform sampler2D vtkiHidden3;
uniform sampler2D vtkiSent0;
uniform sampler2D vtkiSent1;
uniform sampler2D vtkiSent2;
uniform sampler2D vtkiSent3;
uniform sampler2D vtkiSent4;
uniform sampler2D vtkiSent5;
uniform sampler2D vtkiSent6;

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
#ifdef VTKI_PROXY_PIXELS
  ivec2 at = texel;
  ivec2 pixel = texel;
#else
  ivec2 plane = texel / vtkiCoarseSize;
  ivec2 at = texel - plane * vtkiCoarseSize;
  ivec2 pixel = min(at * vtkiStep, vtkiSize - 1);
#endif
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  vtkiProxySums sums = vtkiNoProxies();
  sums.hidden.A = texelFetch(vtkiHidden0, at, 0);
  sums.hidden.B = texelFetch(vtkiHidden1, at, 0);
  sums.hidden.C = texelFetch(vtkiHidden2, at, 0);
  sums.hidden.D = texelFetch(vtkiHidden3, at, 0);
#ifdef VTKI_PROXY_LIGHT
  vec4 s0 = texelFetch(vtkiSent0, at, 0);
  vec4 s1 = texelFetch(vtkiSent1, at, 0);
  vec4 s2 = texelFetch(vtkiSent2, at, 0);
  vec4 s3 = texelFetch(vtkiSent3, at, 0);
  vec4 s4 = texelFetch(vtkiSent4, at, 0);
  vec4 s5 = texelFetch(vtkiSent5, at, 0);
  vec4 s6 = texelFetch(vtkiSent6, at, 0);
  sums.light0 = s0.rgb;
  sums.solidAngle = s0.a;
  sums.light1[0] = s1.rgb;
  sums.light1[1] = vec3(s1.a, s2.rg);
  sums.light1[2] = vec3(s2.ba, s3.r);
  sums.light2[0] = s3.gba;
  sums.light2[1] = s4.rgb;
  sums.light2[2] = vec3(s4.a, s5.rg);
  sums.light2[3] = vec3(s5.ba, s6.r);
  sums.light2[4] = s6.gba;
#endif
  vtkiProxyLit result = vtkiResolveProxies(receiver.position, receiver.normal, sums);
#ifdef VTKI_PROXY_PIXELS
#if VTKI_PROXY_COLUMN == 1
  vec3 value = vtkiProxyIrradiance(result.bounce, receiver.normal);
#else
  vec3 value = vtkiProxyIrradiance(result.sky, receiver.normal);
#endif
  gl_FragData[0] = vec4(lit ? value : vec3(0.0f), 1.0f);
#else
  vec3 value = result.sky[plane.y];
#ifdef VTKI_PROXY_LIGHT
  value = plane.x == 1 ? result.bounce[plane.y] : value;
#endif
  gl_FragData[0] = vec4(value, 1.0f);
#endif
}
