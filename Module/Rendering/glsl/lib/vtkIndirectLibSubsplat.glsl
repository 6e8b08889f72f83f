// Subsplats: square groups of pixels that share one evaluation of the lights.
// Nichols and Wyman 2009, "Multiresolution splatting for indirect illumination".
#ifndef vtkIndirectLibSubsplat
#define vtkIndirectLibSubsplat
#include "vtkIndirectLibPortable.glsl"

// States of a texel in the pyramid of subsplats.
const float VTKI_SUBSPLAT_EMPTY = -1.0f; // nothing lit in it
const float VTKI_SUBSPLAT_WHOLE = 0.0f;  // one evaluation serves all of it
const float VTKI_SUBSPLAT_MIXED = 0.5f;  // not of one surface, but not split either
const float VTKI_SUBSPLAT_SPLIT = 1.0f;  // its four children are looked at
const float VTKI_SUBSPLAT_PARTED = 2.0f; // so are they, though it is of one surface

/* Whether a texel's four children are looked at. */
bool vtkiSubsplatIsSplit(float state)
{
  return state >= VTKI_SUBSPLAT_SPLIT;
}

/* Whether a texel has an illumination of its own: neighbours that are not split interpolate with
 * one that is parted. */
bool vtkiSubsplatIsSample(float state)
{
  return state != VTKI_SUBSPLAT_EMPTY && state != VTKI_SUBSPLAT_SPLIT;
}

// Illumination at a texel, in its alpha; by it a bilinear filter shows whether the own texel, of weight
// 9/16, is smooth, and whether all four are. The alpha of the vector irradiance is 1 where it is split.
const float VTKI_ILLUMINATION_NONE = 0.0f;
const float VTKI_ILLUMINATION_HERE = 0.0625f;
const float VTKI_ILLUMINATION_SMOOTH = 1.0f; // and all eight neighbours lie on the same surface

/* Centre of a texel of a level in normalized device coordinates: of those of its pixels that the
 * image has. texel: index; edge: pixels along the texel's edge; size: the image's. */
vec2 vtkiSubsplatCenter(vec2 texel, float edge, vec2 size)
{
  vec2 lower = vec2(texel.x * edge, texel.y * edge);
  vec2 upper = vec2(min(lower.x + edge, size.x), min(lower.y + edge, size.y));
  return vec2((lower.x + upper.x) / size.x - 1.0f, (lower.y + upper.y) / size.y - 1.0f);
}

/* Depth at which the ray origin + depth * direction meets the plane through p with normal n, kept
 * within bounds: a plane that the ray grazes has no such depth. */
float vtkiPlaneDepth(
  vec3 n, vec3 p, vec3 origin, vec3 direction, float lower, float upper)
{
  float slope = dot(n, direction);
  float along = dot(n, p) - dot(n, origin);
  float depth = slope != 0.0f ? along / slope : upper;
  return min(max(depth, lower), upper);
}

/* Irradiance at a receiver whose normal differs from that of the evaluation, to first order.
 * irradiance: as evaluated, of luminance > 0; projection: dot product of the vector irradiance
 * with the receiver's normal. Lights that rise above one of the two horizons only are the error,
 * so the correction is at most a factor of two. */
float vtkiNormalCorrection(float luminance, float projection)
{
  return luminance > 0.0f ? min(max(projection / luminance, 0.0f), 2.0f) : 1.0f;
}

/* Curvature that one virtual light gives to the irradiance at a receiver, over the irradiance there:
 * times the square of the distance between samples, over eight, it is the relative error of linear
 * interpolation midway. A light at height a over the line along which a receiver's plane leaves the
 * sender's, r along that line, gives E = a r / (pi (r^2 + a^2)^2); of that the second derivative is
 * 6 E / d^2 in size where E is greatest, at r^2 = a^2 / 3. The disk keeps d from vanishing.
 * toSender, normalR, area: see vtkiVirtualLightWeight; densityS: the light's normal times its
 * reflected density and area, over the irradiance that receivers nearby have from all lights. Per
 * square of the scene's unit. */
float vtkiVirtualLightCurvature(vec3 toSender, vec3 densityS, vec3 normalR, float area)
{
  // The light's share e = p / q of what it and the others give is e / (1 + e), that is p / (p + q).
  float r2 = dot(toSender, toSender);
  float p = max(-dot(densityS, toSender), 0.0f) * max(dot(normalR, toSender), 0.0f);
  float q = r2 * (VTKI_PI * r2 + area);
  float denominator = (p + q) * (r2 + area / VTKI_PI);
  return denominator > 0.0f ? 6.0f * p / denominator : 0.0f;
}

/* Relative luminance of linear Rec. 709 colours. */
float vtkiLuminance(vec3 c)
{
  return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}
#endif
