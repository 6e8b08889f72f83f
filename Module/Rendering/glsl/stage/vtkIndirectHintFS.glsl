//VTK::System::Dec
//VTK::Output::Dec
// Irradiance from the hints at every vtkiStep-th pixel, or at those of all pixels that interpolation
// left; mixed with that of the last frame.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectHintLookup.glsl"

uniform int vtkiStep;
uniform float vtkiKeep; // share of the last frame
uniform sampler2D vtkiLast;
#ifdef VTKI_HINT_OCCUPANCY
#include "vtkIndirectLibInterpolation.glsl"

uniform float vtkiMinimumCosine;
uniform float vtkiPlaneTolerance;

// Whether something stands between two of the four samples around a square of pixels that lie on one
// surface: interpolation there would carry light through it, however finely the hints tell its sides
// apart.
bool vtkiIsDivided(ivec2 coarse)
{
  vtkiReceiver sample4[4];
  vec3 open[4];
  bool lit[4];
  bool found[4];
  for (int i = 0; i < 4; ++i)
  {
    ivec2 pixel = min((coarse + ivec2(i & 1, i >> 1)) * vtkiStep, vtkiSize - 1);
    vec3 aside;
    lit[i] = vtkiFetchReceiver(pixel, sample4[i]);
    found[i] = vtkiFindOpen(vtkiToVoxels(sample4[i].position), sample4[i].normal, open[i], aside);
  }
  bool divided = false;
  for (int i = 0; i < 3; ++i)
  {
    vec3 dx = (vtkiRayOrigin[0] + sample4[i].depth * vtkiRayDirection[0]) * (2.0f / float(vtkiSize.x));
    float tolerance = vtkiPlaneTolerance * float(vtkiStep) * length(dx);
    for (int j = i + 1; j < 4; ++j)
    {
      bool same = lit[i] && lit[j] &&
        vtkiSameSurface(sample4[j].positionVC - sample4[i].positionVC, sample4[i].normalVC,
          sample4[j].normalVC, vtkiMinimumCosine, tolerance);
      bool free = vtkiIsFree(open[i], open[j], same && found[i] && found[j]);
      divided = divided || (same && (found[i] != found[j] || !free));
    }
  }
  return divided;
}
#endif

void main()
{
  ivec2 coarse = ivec2(gl_FragCoord.xy);
  ivec2 pixel = min(coarse * vtkiStep, vtkiSize - 1);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  vec3 e = max(vtkiHintIrradiance(receiver.position, receiver.normal, coarse, lit), vec3(0.0f));
  vec4 last = texelFetch(vtkiLast, coarse, 0);
  float keep = last.a > 0.5f ? vtkiKeep : 0.0f;
  bool divided = false;
#ifdef VTKI_HINT_OCCUPANCY
  if (vtkiStep > 1)
  {
    divided = vtkiIsDivided(coarse);
  }
#endif
  // Alpha: 1 lit, 0 not; a quarter nearer to the other where the samples are divided.
  float alpha = divided ? 0.25f : 0.0f;
  gl_FragData[0] = lit ? vec4(keep > 0.0f ? mix(e, last.rgb, keep) : e, 1.0f - alpha)
                       : vec4(0.0f, 0.0f, 0.0f, alpha);
}
