// Real spherical harmonics up to order three, and irradiance from a field projected on them.
// Coefficients in the order (l,m) = 00, 1-1, 10, 11 | 2-2, 2-1, 20, 21 | 22.
#ifndef vtkIndirectLibHarmonics
#define vtkIndirectLibHarmonics
#include "vtkIndirectLibPortable.glsl"

/* Bands 0 and 1 at a unit direction. */
vec4 vtkiHarmonicsLow(vec3 d)
{
  return vec4(0.28209479f, 0.48860251f * d.y, 0.48860251f * d.z, 0.48860251f * d.x);
}

/* Returns band 2 without its last function. */
vec4 vtkiHarmonicsHigh(vec3 d)
{
  return vec4(1.09254843f * d.x * d.y, 1.09254843f * d.y * d.z,
    0.31539157f * (3.0f * d.z * d.z - 1.0f), 1.09254843f * d.x * d.z);
}

/* Returns the last function of band 2. */
float vtkiHarmonicsLast(vec3 d)
{
  return 0.54627422f * (d.x * d.x - d.y * d.y);
}

/* Returns the irradiance (VTK units: constant radiance L gives L) of a field of order 2 on a
 * surface of unit normal n: the clamped cosine over pi has the factors 1, 2/3, 1/4 in bands 0, 1,
 * 2. Ramamoorthi and Hanrahan 2001, "An efficient representation for irradiance environment maps".
 */
float vtkiIrradianceLow(vec4 c, vec3 n)
{
  vec4 y = vtkiHarmonicsLow(n);
  return c.x * y.x + (c.y * y.y + c.z * y.z + c.w * y.w) * (2.0f / 3.0f);
}

/* Returns the contribution of band 2 to vtkiIrradianceLow. */
float vtkiIrradianceHigh(vec4 high, float last, vec3 n)
{
  return 0.25f * (dot(high, vtkiHarmonicsHigh(n)) + last * vtkiHarmonicsLast(n));
}

/* vtkiIrradianceLow without ringing. Band 1 over band 0 tells how concentrated the light is: r =
 * |c1| / (sqrt 3 c0) is 0 for uniform light, 1/2 for a hemisphere, 1 for one direction. Up to 1/2
 * the linear form is exact for such light and never negative. Beyond 1/2 it would be negative on
 * the far side and too dark in front: there it blends into the clamped cosine of one direction,
 * which is exact again for the front of a cone of light (4 r times the mean). */
float vtkiIrradianceLobe(vec4 c, vec3 n)
{
  float mean = c.x * 0.28209479f;
  vec3 first = vec3(c.w, c.y, c.z);
  float size = length(first);
  if (!(mean > 0.0f) || !(size > 0.0f))
  {
    return max(mean, 0.0f);
  }
  float r = min(size / (1.73205081f * c.x), 1.0f);
  float x = dot(first, n) / size;
  if (r <= 0.5f)
  {
    return mean * (1.0f + 2.0f * r * x);
  }
  float t = 2.0f * r - 1.0f;
  return mean * ((1.0f - t) * (1.0f + x) + 4.0f * t * max(x, 0.0f));
}

/* Returns the offset to a patch from a moved point: a point at offset toSender (patch minus point)
 * in front of the patch's plane moves back along its normal, from the height h to sqrt(h^2 + s), s
 * = area / (2 pi). So no patch covers more than half of all directions, and a plane of patches
 * covers just that half, seen from any height: light that a patch loses at points right above it
 * comes from its neighbours. At a distance the move has no effect. */
vec3 vtkiPatchOffset(vec3 toSender, vec3 normalS, float softening)
{
  float height = -dot(normalS, toSender);
  return height > 0.0f
    ? toSender - (sqrt(height * height + softening) - height) * normalS
    : toSender;
}

/* Returns the factor from a patch's radiance times area to radiance times solid angle: cosS / r^2,
 * at most 2 pi / area with the offset of vtkiPatchOffset. */
float vtkiPatchSolidAngle(vec3 toSender, vec3 normalS)
{
  float r2 = dot(toSender, toSender);
  float projected = max(-dot(normalS, toSender), 0.0f);
  float denominator = r2 * sqrt(r2);
  return denominator > 0.0f ? projected / denominator : 0.0f;
}
#endif
