//VTK::System::Dec
//VTK::Output::Dec
// Irradiance at every pixel: joint bilateral interpolation of the coarse samples that lie on the same
// surface. Where none does nothing is written, nor depth: a second draw finds those pixels by it.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectLibInterpolation.glsl"

uniform sampler2D vtkiCoarse;
uniform ivec2 vtkiCoarseSize;
uniform int vtkiStep;
uniform float vtkiMinimumCosine;
uniform float vtkiPlaneTolerance; // as a fraction of the distance between samples

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  vec3 dx = (vtkiRayOrigin[0] + receiver.depth * vtkiRayDirection[0]) * (2.0f / float(vtkiSize.x));
  float tolerance = vtkiPlaneTolerance * float(vtkiStep) * length(dx);
  ivec2 corner = pixel / vtkiStep;
  ivec2 first = corner * vtkiStep;
  vec2 blend = vec2(pixel - first) / vec2(max(min(first + vtkiStep, vtkiSize - 1) - first, 1));
  vec3 sum = vec3(0.0f);
  float weights = 0.0f;
  for (int i = 0; i < 4; ++i)
  {
    ivec2 shift = ivec2(i & 1, i >> 1);
    ivec2 at = min(corner + shift, vtkiCoarseSize - 1);
    vtkiReceiver other;
    bool otherLit = vtkiFetchReceiver(min(at * vtkiStep, vtkiSize - 1), other);
    if (otherLit && vtkiSameSurface(other.positionVC - receiver.positionVC, receiver.normalVC,
                      other.normalVC, vtkiMinimumCosine, tolerance))
    {
      vec2 w = mix(1.0f - blend, blend, vec2(shift));
      sum += w.x * w.y * texelFetch(vtkiCoarse, at, 0).rgb;
      weights += w.x * w.y;
    }
  }
  if (lit && weights < 0.05f)
  {
    discard;
  }
  gl_FragData[0] = vec4(lit ? sum / weights : vec3(0.0f), 1.0f);
}
