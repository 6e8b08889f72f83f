//VTK::System::Dec
//VTK::Output::Dec
// Irradiance at the pixel's own normal from the four surrounding coarse receivers (Eq 11):
// bilinear, weighted by the distance of each from the other's plane and by normals. If none agrees,
// alpha is -1 and the pixel is summed from scratch: here with VTKI_PROXY_GATHER, otherwise by
// further receivers.
#include "vtkIndirectReceiverGrid.glsl"
#include "vtkIndirectProxySum.glsl"
#include "vtkIndirectProxyTile.glsl"

uniform sampler2D vtkiCoarse0; // a colour's irradiance a + b n: b, a
uniform sampler2D vtkiCoarse1;
uniform sampler2D vtkiCoarse2;
uniform sampler2D vtkiCoarse3; // light that proxies send

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  vec4 result = vec4(0.0f, 0.0f, 0.0f, 1.0f);
  vec3 bounce = vec3(0.0f);
  if (vtkiFetchReceiver(pixel, receiver))
  {
    float distance = vtkiSampleDistance(receiver.depth);
    vtkiGridCell cell = vtkiFindCell(pixel);
    vec4 sky[3];
    sky[0] = vec4(0.0f);
    sky[1] = vec4(0.0f);
    sky[2] = vec4(0.0f);
    float sum = 0.0f;
    for (int i = 0; i < 4; ++i)
    {
      vtkiSample found = vtkiFetchSample(cell, i);
      float same = vtkiAgreement(receiver, found.receiver, distance);
      // The constant keeps a single agreeing sample at the cell's other end.
      float weight = found.lit && same > VTKI_LEAST_ALIKE ? (found.weight + 1.0e-3f) * same : 0.0f;
      sum += weight;
      sky[0] += weight * textureLod(vtkiCoarse0, found.place, 0.0f);
      sky[1] += weight * textureLod(vtkiCoarse1, found.place, 0.0f);
      sky[2] += weight * textureLod(vtkiCoarse2, found.place, 0.0f);
#ifdef VTKI_PROXY_LIGHT
      bounce += weight * textureLod(vtkiCoarse3, found.place, 0.0f).rgb;
#endif
    }
    float scale = 1.0f / max(sum, 1.0e-30f);
    bounce *= scale;
    result = vec4(scale * vtkiProxyIrradiance(sky, receiver.normal), 1.0f);
    if (sum == 0.0f)
    {
#ifdef VTKI_PROXY_GATHER
      vtkiProxySums sums = vtkiSumProxies(receiver.position, receiver.normal, true);
      vtkiProxyLit lit = vtkiResolveProxies(receiver.position, receiver.normal, sums);
      result.rgb = vtkiProxyIrradiance(lit.sky, receiver.normal);
      bounce = lit.bounce;
#else
      result.a = -1.0f;
#endif
    }
  }
  gl_FragData[0] = result;
#ifdef VTKI_PROXY_LIGHT
  gl_FragData[1] = vec4(bounce, 1.0f);
#endif
}
