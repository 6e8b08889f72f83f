// Interpolates illumination at a texel or pixel from the level above.
#include "vtkIndirectSubsplatPlane.glsl"

uniform sampler2D vtkiCoarserSurface;
uniform sampler2D vtkiCoarserIrradiance; // irradiance; 1 where there is one
uniform sampler2D vtkiCoarserVector;     // luminance of the vector irradiance
uniform ivec2 vtkiCoarserSize;
uniform float vtkiCoarserEdge; // pixels along the edge of a coarser texel

uniform bool vtkiContinuesSlopes; // beyond the last texel of a surface; false: as Nichols and Wyman 2009

#ifdef VTKI_NEAREST
// A sample on the surface has a weight of one.
const float vtkiEnoughNearness = 0.25f;
#endif

struct vtkiCoarser
{
  bool counts; // has illumination, on the same surface
  vec3 irradiance;
  vec3 vectorIrradiance;
#ifdef VTKI_NEAREST
  float weight; // falls with the distance from the surface; 0 without illumination
#endif
};

// Fetches a texel of the level above, whose plane is not tested if it is trusted.
vtkiCoarser vtkiFetchCoarser(ivec2 place, vtkiTangentPlane plane, bool trusted)
{
  ivec2 at = clamp(place, ivec2(0), vtkiCoarserSize - 1);
  vec4 sampled = texelFetch(vtkiCoarserIrradiance, at, 0);
  vec2 center = vtkiSubsplatCenter(vec2(at), vtkiCoarserEdge, vec2(vtkiSize));
  vec4 surface = texelFetch(vtkiCoarserSurface, at, 0);
  bool same = trusted || vtkiIsOnPlane(plane, center, surface);
#ifdef VTKI_NEAREST
  float weight = sampled.a > 0.0f ? vtkiNearness(plane, center, surface) : 0.0f;
  return vtkiCoarser(sampled.a > 0.0f && same, sampled.rgb,
    texelFetch(vtkiCoarserVector, at, 0).xyz, weight);
#else
  return vtkiCoarser(
    sampled.a > 0.0f && same, sampled.rgb, texelFetch(vtkiCoarserVector, at, 0).xyz);
#endif
}

// Returns the difference to the nearer neighbour; if that is on another surface, to the one across,
// where slopes continue towards an edge at which surfaces meet.
vec3 vtkiSlopeTowards(vec3 own, vec3 near, bool nearCounts, vec3 across, bool acrossCounts)
{
  return nearCounts ? near - own : (acrossCounts && vtkiContinuesSlopes ? own - across : vec3(0.0f));
}

// Returns the slope of irradiance, which falls by no more than all of it: a steeper slope,
// continued over a quarter of a texel along both axes, would end below zero in a corner and draw a
// black pixel.
vec3 vtkiIrradianceSlope(vec3 own, vec3 near, bool nearCounts, vec3 across, bool acrossCounts)
{
  return max(vtkiSlopeTowards(own, near, nearCounts, across, acrossCounts), -own);
}

// Returns the same for the vector irradiance, whose continued slope is no longer than the vector:
// its dot product with the pixel's normal is to stay positive.
vec3 vtkiVectorSlope(vec3 own, vec3 near, bool nearCounts, vec3 across, bool acrossCounts)
{
  vec3 slope = vtkiSlopeTowards(own, near, nearCounts, across, acrossCounts);
  return nearCounts ? slope
                    : min(1.0f, sqrt(dot(own, own) / max(dot(slope, slope), 1.0e-30f))) * slope;
}

// Interpolates linearly along both axes from the coarser texel that holds this one; if that is
// missing, the mean of the nearer neighbours; with VTKI_NEAREST the mean of all of them, where those
// near the surface count most. trusted: the own texel counts in any case. Returns false if no texel
// counts.
bool vtkiInterpolateSubsplat(ivec2 texel, vtkiTangentPlane plane, bool trusted,
  out vec3 irradiance, out vec3 vectorIrradiance)
{
  ivec2 place = texel >> 1;
  ivec2 alongX = ivec2(2 * (texel.x & 1) - 1, 0);
  ivec2 alongY = ivec2(0, 2 * (texel.y & 1) - 1);
  vtkiCoarser own = vtkiFetchCoarser(place, plane, trusted);
  vtkiCoarser x = vtkiFetchCoarser(place + alongX, plane, false);
  vtkiCoarser y = vtkiFetchCoarser(place + alongY, plane, false);
  vtkiCoarser acrossX = vtkiFetchCoarser(place - alongX, plane, false);
  vtkiCoarser acrossY = vtkiFetchCoarser(place - alongY, plane, false);
  if (own.counts)
  {
    // The centres are a quarter of the coarser edge apart.
    irradiance = own.irradiance + 0.25f *
        (vtkiIrradianceSlope(
           own.irradiance, x.irradiance, x.counts, acrossX.irradiance, acrossX.counts) +
          vtkiIrradianceSlope(
            own.irradiance, y.irradiance, y.counts, acrossY.irradiance, acrossY.counts));
    vectorIrradiance = own.vectorIrradiance + 0.25f *
        (vtkiVectorSlope(own.vectorIrradiance, x.vectorIrradiance, x.counts,
           acrossX.vectorIrradiance, acrossX.counts) +
          vtkiVectorSlope(own.vectorIrradiance, y.vectorIrradiance, y.counts,
            acrossY.vectorIrradiance, acrossY.counts));
    return true;
  }
#ifdef VTKI_NEAREST
  float weights = own.weight + x.weight + y.weight + acrossX.weight + acrossY.weight;
  irradiance = own.weight * own.irradiance + x.weight * x.irradiance + y.weight * y.irradiance +
    acrossX.weight * acrossX.irradiance + acrossY.weight * acrossY.irradiance;
  vectorIrradiance = own.weight * own.vectorIrradiance + x.weight * x.vectorIrradiance +
    y.weight * y.vectorIrradiance + acrossX.weight * acrossX.vectorIrradiance +
    acrossY.weight * acrossY.vectorIrradiance;
  // Beside an outline all five may lie on the surface in front, whose light is another: the others
  // of 5 x 5 texels may hold the surface behind. Loops end early where branches do not.
  int others = weights < vtkiEnoughNearness ? 25 : 0;
  for (int i = 0; i < others; ++i)
  {
    ivec2 shift = ivec2(i % 5 - 2, i / 5 - 2);
    vtkiCoarser other = vtkiFetchCoarser(place + shift, plane, false);
    float weight = abs(shift.x) + abs(shift.y) < 2 ? 0.0f : other.weight;
    weights += weight;
    irradiance += weight * other.irradiance;
    vectorIrradiance += weight * other.vectorIrradiance;
  }
  float perWeight = 1.0f / max(weights, 1.0e-30f);
  irradiance *= perWeight;
  vectorIrradiance *= perWeight;
  return false;
#else
  float weightX = x.counts ? 1.0f : 0.0f;
  float weightY = y.counts ? 1.0f : 0.0f;
  float scale = 1.0f / max(weightX + weightY, 1.0f);
  irradiance = scale * (weightX * x.irradiance + weightY * y.irradiance);
  vectorIrradiance = scale * (weightX * x.vectorIrradiance + weightY * y.vectorIrradiance);
  return x.counts || y.counts;
#endif
}
