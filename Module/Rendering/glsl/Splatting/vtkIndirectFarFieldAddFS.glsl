//VTK::System::Dec
//VTK::Output::Dec
// Adds the far field at every pixel: interpolated from the four surrounding samples, and summed
// anew if none of them faces the pixel's way. It varies slowly with the position, because it comes
// from a distance: samples on other surfaces serve if there are none on the pixel's own. With the
// normal it varies as the vector irradiance does.
#include "vtkIndirectReceiverGrid.glsl"
#include "vtkIndirectFarField.glsl"

uniform sampler2D vtkiCoarse;
uniform sampler2D vtkiCoarseVector;

// This is the weight of a sample on another surface, relative to one on the pixel's own. Normals
// must agree in both cases: samples do not show lights that are below the horizon of one normal and
// not of the other.
const float VTKI_OTHER_SURFACE = 0.01f;
// Below this sum of weights no sample serves.
const float VTKI_LEAST_WEIGHT = 1.0e-6f;

// Returns the irradiance at the pixel from one sample; in the fourth component its weight.
vec4 vtkiFarFieldBySample(vtkiReceiver receiver, vtkiSample found)
{
  vtkiReceiver other = found.receiver;
  if (!found.lit)
  {
    return vec4(0.0f);
  }
  float distance = vtkiSampleDistance(receiver.depth);
  vec3 offset = other.positionVC - receiver.positionVC;
  bool same = vtkiIsSameSurface(receiver, found);
  float facing = max(dot(receiver.normal, other.normal), 0.0f);
  float away = dot(offset, offset) / max(distance * distance, 1.0e-30f);
  float elsewhere = facing >= VTKI_INTERPOLATION_COSINE ? VTKI_OTHER_SURFACE * facing * facing / (1.0f + away) : 0.0f;
  // The constant keeps a single agreeing sample at the cell's other end.
  float weight = (found.weight + 1.0e-3f) * (same ? 1.0f : elsewhere);
  vec3 vector = textureLod(vtkiCoarseVector, found.place, 0.0f).rgb;
  float correction = vtkiNormalCorrection(dot(vector, other.normal), dot(vector, receiver.normal));
  // A light's cosine is convex in the normal: between samples it is as far above the interpolated
  // value as tangents are below.
  correction = same ? 0.5f * (1.0f + correction) : correction;
  return weight * vec4(correction * textureLod(vtkiCoarse, found.place, 0.0f).rgb, 1.0f);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  vec3 left = vec3(0.0f);
  if (vtkiFetchReceiver(pixel, receiver))
  {
    vtkiGridCell cell = vtkiFindCell(pixel);
    vec4 sum = vec4(0.0f);
    for (int i = 0; i < 4; ++i)
    {
      sum += vtkiFarFieldBySample(receiver, vtkiFetchSample(cell, i));
    }
    if (sum.a > VTKI_LEAST_WEIGHT)
    {
      left = sum.rgb / sum.a;
    }
#ifndef VTKI_SPLAT_MANY
    else
    {
      left = vtkiSumFarField(receiver.position, receiver.normal, receiver.facet, pixel, 0, vtkiLightCount).irradiance;
    }
#endif
  }
  gl_FragData[0] = vec4(left, 0.0f);
}
