//VTK::System::Dec
//VTK::Output::Dec
// Irradiance at the pixel's own normal from the four surrounding coarse receivers (Eq 11):
// bilinear, weighted by the distance of each from the other's plane and by normals. If none agrees,
// alpha is -1 and the pixel is summed from scratch: here with VTKI_PROXY_GATHER, otherwise by
// further receivers.
#include "vtkIndirectStep.glsl"
#include "vtkIndirectProxySum.glsl"
#include "vtkIndirectProxyAlike.glsl"

uniform ivec2 vtkiCoarseSize;
uniform sampler2D vtkiCoarse0; // a colour's irradiance a + b n: b, a
uniform sampler2D vtkiCoarse1;
uniform sampler2D vtkiCoarse2;
uniform sampler2D vtkiCoarse3; // light that proxies send

// Below this sum of weights no receiver agrees.
const float VTKI_LEAST_WEIGHT = 1.0e-3f;
void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  vec4 result = vec4(0.0f, 0.0f, 0.0f, 1.0f);
  vec3 bounce = vec3(0.0f);
  if (vtkiFetchReceiver(pixel, receiver))
  {
    float distance = vtkiSampleDistance(receiver.depth);
    // The last samples may be closer together.
    ivec2 corner = pixel / vtkiStep;
    ivec2 first = corner * vtkiStep;
    vec2 blend = vec2(pixel - first) / vec2(max(min(first + vtkiStep, vtkiSize - 1) - first, 1));
    vec4 sky[3];
    sky[0] = vec4(0.0f);
    sky[1] = vec4(0.0f);
    sky[2] = vec4(0.0f);
    float sum = 0.0f;
    for (int i = 0; i < 4; ++i)
    {
      ivec2 shift = ivec2(i & 1, i >> 1);
      ivec2 at = min(corner + shift, vtkiCoarseSize - 1);
      vec2 place = (vec2(at) + 0.5f) / vec2(vtkiCoarseSize);
      vtkiReceiver other;
      bool lit = vtkiFetchReceiver(min(at * vtkiStep, vtkiSize - 1), other);
      vec2 w = mix(1.0f - blend, blend, vec2(shift));
      float same = vtkiProxyAlike(receiver, other, distance);
      // The constant keeps a single agreeing sample at the cell's other end.
      float weight = lit ? (w.x * w.y + 1.0e-3f) * same : 0.0f;
      sum += weight;
      sky[0] += weight * textureLod(vtkiCoarse0, place, 0.0f);
      sky[1] += weight * textureLod(vtkiCoarse1, place, 0.0f);
      sky[2] += weight * textureLod(vtkiCoarse2, place, 0.0f);
#ifdef VTKI_PROXY_LIGHT
      bounce += weight * textureLod(vtkiCoarse3, place, 0.0f).rgb;
#endif
    }
    float scale = 1.0f / max(sum, 1.0e-30f);
    bounce *= scale;
    result = vec4(scale * vtkiProxyIrradiance(sky, receiver.normal), 1.0f);
    if (!(sum > VTKI_LEAST_WEIGHT))
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
