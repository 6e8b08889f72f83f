//VTK::System::Dec
//VTK::Output::Dec
// What splats leave, at every pixel, to be added: interpolated from the four samples around, and summed anew where
// none of them faces the pixel's way. It comes from afar and varies slowly with the place, so that samples on other
// surfaces serve where there are none on the pixel's own. With the normal it varies as the vector irradiance does.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectLibInterpolation.glsl"
#include "vtkIndirectStep.glsl"
#include "vtkIndirectFarField.glsl"

uniform sampler2D vtkiCoarse;
uniform sampler2D vtkiCoarseVector;
uniform ivec2 vtkiCoarseSize;

// What a sample on another surface counts, of one on the pixel's own. Normals must agree either way: lights that one
// of them has below its horizon and the other has not are not told.
const float VTKI_OTHER_SURFACE = 0.01f;
// Weights together that say nothing.
const float VTKI_LEAST_WEIGHT = 1.0e-6f;

// Irradiance at the pixel by one sample, its weight in the fourth component.
vec4 vtkiFarFieldBySample(vtkiReceiver receiver, ivec2 at, float weight)
{
  vtkiReceiver other;
  if (!vtkiFetchReceiver(min(at * vtkiStep, vtkiSize - 1), other))
  {
    return vec4(0.0f);
  }
  float distance = vtkiSampleDistance(receiver.depth);
  vec3 offset = other.positionVC - receiver.positionVC;
  bool same = vtkiSameSurface(offset, receiver.normalVC, other.normalVC, VTKI_INTERPOLATION_COSINE,
    VTKI_INTERPOLATION_DISTANCE * distance);
  float facing = max(dot(receiver.normal, other.normal), 0.0f);
  float away = dot(offset, offset) / max(distance * distance, 1.0e-30f);
  float elsewhere = facing >= VTKI_INTERPOLATION_COSINE ? VTKI_OTHER_SURFACE * facing * facing / (1.0f + away) : 0.0f;
  weight *= same ? 1.0f : elsewhere;
  vec3 vector = texelFetch(vtkiCoarseVector, at, 0).rgb;
  float correction = vtkiNormalCorrection(dot(vector, other.normal), dot(vector, receiver.normal));
  // A light's cosine is convex in the normal: between samples values lie above it by as much as tangents lie below.
  correction = same ? 0.5f * (1.0f + correction) : correction;
  return weight * vec4(correction * texelFetch(vtkiCoarse, at, 0).rgb, 1.0f);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  vec3 left = vec3(0.0f);
  if (vtkiFetchReceiver(pixel, receiver))
  {
    // The last samples may lie closer.
    ivec2 corner = pixel / vtkiStep;
    ivec2 first = corner * vtkiStep;
    vec2 blend = vec2(pixel - first) / vec2(max(min(first + vtkiStep, vtkiSize - 1) - first, 1));
    vec4 sum = vec4(0.0f);
    for (int i = 0; i < 4; ++i)
    {
      ivec2 shift = ivec2(i & 1, i >> 1);
      vec2 w = mix(1.0f - blend, blend, vec2(shift));
      // A sample next to the pixel may be the only one.
      sum += vtkiFarFieldBySample(receiver, min(corner + shift, vtkiCoarseSize - 1), w.x * w.y + 1.0e-3f);
    }
    if (sum.a > VTKI_LEAST_WEIGHT)
    {
      left = sum.rgb / sum.a;
    }
#ifndef VTKI_SPLAT_MANY
    else
    {
      left = vtkiSumFarField(receiver.position, receiver.normal, receiver.facet, 0, vtkiLightCount).irradiance;
    }
#endif
  }
  gl_FragData[0] = vec4(left, 0.0f);
}
