//VTK::System::Dec
//VTK::Output::Dec
// Irradiance of the pixel's own normal in the light of the four coarse receivers around (Eq 11): bilinear, by how far
// each is from the pixel's plane and the pixel from its, and by normals. Light depends on the place; receivers that
// face elsewhere serve too, but where spheres stand for the surface itself. Where none of them does, alpha is -1 and
// the pixel is summed from scratch: here with VTKI_PROXY_GATHER, else in tiles.
#include "vtkIndirectStep.glsl"
#include "vtkIndirectProxySum.glsl"
#include "vtkIndirectProxyPlanes.glsl"

uniform sampler2D vtkiPlanes;

// Weights together that say nothing.
const float VTKI_LEAST_WEIGHT = 1.0e-3f;
// The plane's distance, over that of samples, at which a sample counts half.
const float VTKI_PROXY_DEPTH = 0.5f;

// What a receiver counts that faces elsewhere: power 8 of the cosine, as light is interpolated, not irradiance.
float vtkiProxyFacing(float cosine)
{
  float c = max(cosine, 0.0f);
  float c2 = c * c;
  float c4 = c2 * c2;
  return c4 * c4;
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  vec4 result = vec4(0.0f, 0.0f, 0.0f, 1.0f);
  if (vtkiFetchReceiver(pixel, receiver))
  {
    float distance = vtkiSampleDistance(receiver.depth);
    // The last samples may lie closer.
    ivec2 corner = pixel / vtkiStep;
    ivec2 first = corner * vtkiStep;
    vec2 blend = vec2(pixel - first) / vec2(max(min(first + vtkiStep, vtkiSize - 1) - first, 1));
    float weights[4];
    float sum = 0.0f;
    for (int i = 0; i < 4; ++i)
    {
      ivec2 shift = ivec2(i & 1, i >> 1);
      ivec2 at = min(corner + shift, vtkiCoarseSize - 1);
      vtkiReceiver other;
      bool lit = vtkiFetchReceiver(min(at * vtkiStep, vtkiSize - 1), other);
      vec2 w = mix(1.0f - blend, blend, vec2(shift));
      vec3 offset = other.positionVC - receiver.positionVC;
      float away = max(abs(dot(offset, receiver.normalVC)), abs(dot(offset, other.normalVC))) /
        max(VTKI_PROXY_DEPTH * distance, 1.0e-30f);
      float same = vtkiProxyFacing(dot(receiver.normalVC, other.normalVC)) / (1.0f + away * away * away * away);
      // A sample next to the pixel may be the only one.
      weights[i] = lit ? (w.x * w.y + 1.0e-3f) * same : 0.0f;
      sum += weights[i];
    }
    if (sum > VTKI_LEAST_WEIGHT)
    {
      vec3 light[9];
      for (int k = 0; k < 9; ++k)
      {
        light[k] = vec3(0.0f);
        for (int i = 0; i < 4; ++i)
        {
          ivec2 at = min(corner + ivec2(i & 1, i >> 1), vtkiCoarseSize - 1);
          light[k] += (weights[i] / sum) * texelFetch(vtkiPlanes, vtkiPlaneTexel(at, VTKI_PROXY_COLUMN, k), 0).rgb;
        }
      }
      result = vec4(vtkiProxyIrradiance(light, receiver.normal), 1.0f);
    }
    else
    {
#ifdef VTKI_PROXY_GATHER
      vtkiProxySums sums = vtkiSumProxies(receiver.position, receiver.normal, true);
      vtkiProxyLit lit = vtkiResolveProxies(receiver.position, receiver.normal, sums);
#if VTKI_PROXY_COLUMN == 1
      result.rgb = vtkiProxyIrradiance(lit.bounce, receiver.normal);
#else
      result.rgb = vtkiProxyIrradiance(lit.sky, receiver.normal);
#endif
#else
      result.a = -1.0f;
#endif
    }
  }
  gl_FragData[0] = result;
}
