//VTK::System::Dec
//VTK::Output::Dec
// Irradiance at every pixel: interpolated from the coarse samples where at least three of the four
// around lie on the same surface, gathered anew elsewhere (Dachsbacher and Stamminger 2005, 5.2).
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectLibInterpolation.glsl"
#include VTKI_GATHER

uniform sampler2D vtkiCoarse;
uniform ivec2 vtkiCoarseSize;
uniform int vtkiStep;
uniform float vtkiMinimumCosine;
uniform float vtkiPlaneTolerance; // as a fraction of the distance between samples

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  if (!vtkiFetchReceiver(pixel, receiver))
  {
    gl_FragData[0] = vec4(0.0f, 0.0f, 0.0f, 1.0f);
    return;
  }
  // Distance between two samples on a plane that faces the eye here.
  vec3 dx = (vtkiRayOrigin[0] + receiver.depth * vtkiRayDirection[0]) * (2.0f / float(vtkiSize.x));
  float tolerance = vtkiPlaneTolerance * float(vtkiStep) * length(dx);

  // Samples reach from border to border; the last ones may lie closer.
  ivec2 corner = pixel / vtkiStep;
  ivec2 first = corner * vtkiStep;
  vec2 blend = vec2(pixel - first) / vec2(max(min(first + vtkiStep, vtkiSize - 1) - first, 1));
  vec3 sum = vec3(0.0f);
  float weights = 0.0f;
  int agreeing = 0;
  for (int i = 0; i < 4; ++i)
  {
    ivec2 shift = ivec2(i & 1, i >> 1);
    ivec2 at = min(corner + shift, vtkiCoarseSize - 1);
    vtkiReceiver other;
    bool lit = vtkiFetchReceiver(min(at * vtkiStep, vtkiSize - 1), other);
    if (lit && vtkiSameSurface(other.positionVC - receiver.positionVC, receiver.normalVC,
                 other.normalVC, vtkiMinimumCosine, tolerance))
    {
      vec2 w = mix(1.0f - blend, blend, vec2(shift));
      sum += w.x * w.y * texelFetch(vtkiCoarse, at, 0).rgb;
      weights += w.x * w.y;
      ++agreeing;
    }
  }
  // Three of four agreeing always leave more than zero weight, except exactly on a sample.
  if (agreeing >= 3 && weights > 0.0f)
  {
    gl_FragData[0] = vec4(sum / weights, 1.0f);
  }
  else
  {
    gl_FragData[0] = vec4(vtkiGather(receiver.position, receiver.normal), 1.0f);
  }
}
