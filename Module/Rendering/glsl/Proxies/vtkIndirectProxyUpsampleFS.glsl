//VTK::System::Dec
//VTK::Output::Dec
// Irradiance at the pixel's own normal from the four surrounding coarse receivers: bilinear,
// weighted by the distance of each from the other's plane and by normals. With VTKI_UPSAMPLING it is
// the irradiance at the receivers' normals instead, weighted as in Eq 11 (1) or bilinear alone (2).
// If none agrees, alpha is -1 and the pixel is summed from scratch: here with VTKI_PROXY_GATHER,
// otherwise by further receivers.
#include "vtkIndirectReceiverGrid.glsl"
#include "vtkIndirectProxySum.glsl"
#include "vtkIndirectProxyTile.glsl"

uniform sampler2D vtkiCoarse0; // a colour's irradiance a + b n: b, a
uniform sampler2D vtkiCoarse1;
uniform sampler2D vtkiCoarse2;
uniform sampler2D vtkiCoarse3; // light that proxies send

// Returns the agreement of a coarse receiver with the pixel's. distance: between receivers.
float vtkiCoarseAgreement(vtkiReceiver receiver, vtkiReceiver other, float distance)
{
#ifndef VTKI_UPSAMPLING
  return vtkiAgreement(receiver, other, distance);
#elif VTKI_UPSAMPLING == 1
  // Eq 11: (N N_i)^32 / (e + |z - z_i|). The paper prints no e: here the distance.
  float cosine = max(dot(receiver.normalVC, other.normalVC), 0.0f);
  return pow(cosine, 32.0f) * distance / (distance + abs(receiver.depth - other.depth));
#else
  return 1.0f;
#endif
}

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
#ifdef VTKI_UPSAMPLING
    vec3 irradiance = vec3(0.0f);
#endif
    for (int i = 0; i < 4; ++i)
    {
      vtkiSample found = vtkiFetchSample(cell, i);
      float same = vtkiCoarseAgreement(receiver, found.receiver, distance);
      // The constant keeps a single agreeing sample at the cell's other end.
      float weight = found.lit && same > VTKI_LEAST_ALIKE ? (found.weight + 1.0e-3f) * same : 0.0f;
      sum += weight;
#ifdef VTKI_UPSAMPLING
      sky[0] = textureLod(vtkiCoarse0, found.place, 0.0f);
      sky[1] = textureLod(vtkiCoarse1, found.place, 0.0f);
      sky[2] = textureLod(vtkiCoarse2, found.place, 0.0f);
      irradiance += weight * vtkiProxyIrradiance(sky, found.receiver.normal);
#else
      sky[0] += weight * textureLod(vtkiCoarse0, found.place, 0.0f);
      sky[1] += weight * textureLod(vtkiCoarse1, found.place, 0.0f);
      sky[2] += weight * textureLod(vtkiCoarse2, found.place, 0.0f);
#endif
#ifdef VTKI_PROXY_LIGHT
      bounce += weight * textureLod(vtkiCoarse3, found.place, 0.0f).rgb;
#endif
    }
    float scale = 1.0f / max(sum, 1.0e-30f);
    bounce *= scale;
#ifdef VTKI_UPSAMPLING
    result = vec4(scale * irradiance, 1.0f);
#else
    result = vec4(scale * vtkiProxyIrradiance(sky, receiver.normal), 1.0f);
#endif
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
