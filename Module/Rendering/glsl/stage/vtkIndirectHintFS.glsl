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
  vtkiReceiver receivers[4];
  vec3 places[4];
  float heights[4];
  bool lit[4];
  bool free = true;
  ivec3 least = ivec3(1 << 20);
  ivec3 most = ivec3(-1);
  for (int i = 0; i < 4; ++i)
  {
    ivec2 pixel = min((coarse + ivec2(i & 1, i >> 1)) * vtkiStep, vtkiSize - 1);
    lit[i] = vtkiFetchReceiver(pixel, receivers[i]);
    places[i] = vtkiToVoxels(receivers[i].position);
    // So high that the surface itself, if flat, touches none of the voxels there.
    heights[i] = dot(abs(receivers[i].normal), vec3(1.0f)) + 0.01f;
    ivec3 voxel = ivec3(floor(places[i] + heights[i] * receivers[i].normal));
    free = free && !(lit[i] && vtkiIsOccupied(voxel));
    least = lit[i] ? min(least, voxel) : least;
    most = lit[i] ? max(most, voxel) : most;
  }
  // Nothing is between free voxels that touch.
  bool divided = false;
  if (!free || any(greaterThan(most - least, ivec3(1))))
  {
    vec3 open[4];
    bool found[4];
    for (int i = 0; i < 4; ++i)
    {
      vec3 aside;
      found[i] = vtkiFindOpen(places[i], receivers[i].normal, heights[i], open[i], aside);
    }
    for (int i = 0; i < 3; ++i)
    {
      vec3 dx =
        (vtkiRayOrigin[0] + receivers[i].depth * vtkiRayDirection[0]) * (2.0f / float(vtkiSize.x));
      float tolerance = vtkiPlaneTolerance * float(vtkiStep) * length(dx);
      for (int j = i + 1; j < 4; ++j)
      {
        bool same = lit[i] && lit[j] &&
          vtkiSameSurface(receivers[j].positionVC - receivers[i].positionVC, receivers[i].normalVC,
            receivers[j].normalVC, vtkiMinimumCosine, tolerance);
        bool clear = vtkiIsFree(open[i], open[j], same && found[i] && found[j]);
        divided = divided || (same && (found[i] != found[j] || !clear));
      }
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
