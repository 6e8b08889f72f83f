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

const int VTKI_BOX = 24; // columns of voxels that cost less than comparing pairs

// Sample i of the four around a square of pixels, and where it looks from in voxels: so high that the
// surface itself, if flat, touches none of the voxels there.
bool vtkiFetchSample(ivec2 coarse, int i, out vtkiReceiver receiver, out vec3 place, out float height)
{
  ivec2 pixel = min((coarse + ivec2(i & 1, i >> 1)) * vtkiStep, vtkiSize - 1);
  bool lit = vtkiFetchReceiver(pixel, receiver);
  place = vtkiToVoxels(receiver.position);
  height = dot(abs(receiver.normal), vec3(1.0f)) + 0.01f;
  return lit;
}

// Whether something stands between two of these samples that lie on one surface: interpolation there
// would carry light through it, however finely the hints tell its sides apart.
bool vtkiIsDivided(ivec2 coarse)
{
  vtkiReceiver a;
  vec3 place;
  float height;
  bool free = true;
  ivec3 least = ivec3(1 << 20);
  ivec3 most = ivec3(-1);
  for (int i = 0; i < 4; ++i)
  {
    bool lit = vtkiFetchSample(coarse, i, a, place, height);
    ivec3 voxel = ivec3(floor(place + height * a.normal));
    free = free && !(lit && vtkiIsOccupied(voxel));
    least = lit ? min(least, voxel) : least;
    most = lit ? max(most, voxel) : most;
  }
  // Nothing is between free voxels that touch, nor between any in a box without surface.
  if (free && any(greaterThan(most - least, ivec3(1))))
  {
    ivec2 size = most.xy - least.xy + 1;
    int columns = size.x * size.y;
    free = columns <= VTKI_BOX;
    for (int i = 0; i < columns && free; ++i)
    {
      ivec2 at = clamp(least.xy + ivec2(i % size.x, i / size.x), ivec2(0),
        ivec2(vtkiOccupancySize.xy) - 1);
      free = !vtkiAnyBit(texelFetch(vtkiOccupancy, at, 0), vtkiBitRange(least.z, most.z));
    }
  }
  // All others by pairs: 01 02 03 12 13 23.
  int pairs = free ? 0 : 6;
  bool divided = false;
  for (int pair = 0; pair < pairs && !divided; ++pair)
  {
    int first = pair < 3 ? 0 : (pair < 5 ? 1 : 2);
    int second = pair < 3 ? pair + 1 : (pair < 5 ? pair - 1 : 3);
    vtkiReceiver b;
    vec3 placeB;
    float heightB;
    bool lit = vtkiFetchSample(coarse, first, a, place, height);
    lit = vtkiFetchSample(coarse, second, b, placeB, heightB) && lit;
    vec3 dx = (vtkiRayOrigin[0] + a.depth * vtkiRayDirection[0]) * (2.0f / float(vtkiSize.x));
    float tolerance = vtkiPlaneTolerance * float(vtkiStep) * length(dx);
    if (lit && vtkiSameSurface(b.positionVC - a.positionVC, a.normalVC, b.normalVC,
                 vtkiMinimumCosine, tolerance))
    {
      vec3 open;
      vec3 openB;
      vec3 aside;
      bool found = vtkiFindOpen(place, a.normal, height, open, aside);
      bool foundB = vtkiFindOpen(placeB, b.normal, heightB, openB, aside);
      divided = found != foundB || !vtkiIsFree(open, openB, found && foundB);
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
