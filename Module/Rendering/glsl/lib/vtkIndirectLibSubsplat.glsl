// Subsplats: square groups of pixels that share one evaluation of the lights.
// Nichols and Wyman 2009, "Multiresolution splatting for indirect illumination".
#ifndef vtkIndirectLibSubsplat
#define vtkIndirectLibSubsplat
#include "vtkIndirectLibPortable.glsl"

// States of a texel in the pyramid of subsplats, multiples of one half. The fraction beyond tells at
// which pixel the texel is evaluated, see vtkiSubsplatPixel.
const float VTKI_SUBSPLAT_EMPTY = -1.0f; // no lit surface
const float VTKI_SUBSPLAT_WHOLE = 0.0f;  // one evaluation represents the texel
const float VTKI_SUBSPLAT_MIXED = 0.5f;  // several surfaces, but not split
const float VTKI_SUBSPLAT_SPLIT = 1.0f;  // its four children are evaluated
const float VTKI_SUBSPLAT_PARTED = 2.0f; // one surface, its four children are evaluated

// A texel is evaluated at one of so many pixels along an edge, at least every second one.
const int VTKI_SUBSPLAT_PIXELS = 4;
// The state's fraction is a pixel's number over this.
const float VTKI_SUBSPLAT_FRACTION = 1024.0f;

/* Returns a texel's state without the fraction. */
float vtkiSubsplatState(float coded)
{
  return 0.5f * floor(2.0f * coded);
}

/* Returns the number of the pixel at which a texel is evaluated, from 1 along rows; 0: in its middle,
 * on its plane. */
int vtkiSubsplatPixel(float coded)
{
  return int((coded - vtkiSubsplatState(coded)) * VTKI_SUBSPLAT_FRACTION + 0.5f);
}

/* Returns true if a texel's four children are evaluated. */
bool vtkiSubsplatIsSplit(float state)
{
  return state >= VTKI_SUBSPLAT_SPLIT;
}

/* Returns true if a texel has an illumination of its own: unsplit neighbours of a parted texel
 * interpolate with it. */
bool vtkiSubsplatIsSample(float state)
{
  float whole = vtkiSubsplatState(state);
  return whole != VTKI_SUBSPLAT_EMPTY && whole != VTKI_SUBSPLAT_SPLIT;
}

// This is the state of a texel's illumination, in its alpha: a bilinear filter of it shows whether
// the own texel, of weight 9/16, is smooth, and whether all four are. The alpha of the vector
// irradiance is 1 for a split texel.
const float VTKI_ILLUMINATION_NONE = 0.0f;
const float VTKI_ILLUMINATION_HERE = 0.0625f;
const float VTKI_ILLUMINATION_SMOOTH = 1.0f; // all eight neighbours lie on the same surface, too

/* Returns the centre of a level's texel in normalized device coordinates: of its pixels inside the
 * image. texel: index; edge: pixels along the texel's edge; size: the image's. */
vec2 vtkiSubsplatCenter(vec2 texel, float edge, vec2 size)
{
  vec2 lower = vec2(texel.x * edge, texel.y * edge);
  vec2 upper = vec2(min(lower.x + edge, size.x), min(lower.y + edge, size.y));
  return vec2((lower.x + upper.x) / size.x - 1.0f, (lower.y + upper.y) / size.y - 1.0f);
}

/* Returns the depth at which the ray origin + depth * direction meets the plane through p with
 * normal n, clamped to bounds: a ray along the plane has no such depth. */
float vtkiPlaneDepth(
  vec3 n, vec3 p, vec3 origin, vec3 direction, float lower, float upper)
{
  float slope = dot(n, direction);
  float along = dot(n, p) - dot(n, origin);
  float depth = slope != 0.0f ? along / slope : upper;
  return min(max(depth, lower), upper);
}

/* Returns the irradiance at a receiver whose normal differs from that of the evaluation, to first
 * order. irradiance: as evaluated, of luminance > 0; projection: dot product of the vector
 * irradiance with the receiver's normal. Lights above only one of the two horizons cause an error,
 * so the correction is limited to a factor from an eighth to two. */
float vtkiNormalCorrection(float luminance, float projection)
{
  return luminance > 0.0f ? min(max(projection / luminance, 0.125f), 2.0f) : 1.0f;
}

/* Returns the curvature that one virtual light gives to the irradiance at a receiver, over the
 * irradiance there: times the square of the distance between samples, over eight, it is the
 * relative error of linear interpolation midway. A light at height a over the line along which a
 * receiver's plane leaves the sender's, r along that line, gives E = a r / (pi (r^2 + a^2)^2); the
 * second derivative of E is 6 E / d^2 in size where E is largest, at r^2 = a^2 / 3. The disk keeps
 * d from vanishing. toSender, normalR, area: see vtkiVirtualLightWeight; densityS: the light's
 * normal times its reflected density and area, over the irradiance of nearby receivers from all
 * lights. Per square of the scene's unit. */
float vtkiVirtualLightCurvature(vec3 toSender, vec3 densityS, vec3 normalR, float area)
{
  // The light's share e = p / q of the light of all is e / (1 + e), that is p / (p + q).
  float r2 = dot(toSender, toSender);
  float p = max(-dot(densityS, toSender), 0.0f) * max(dot(normalR, toSender), 0.0f);
  float q = r2 * (VTKI_PI * r2 + area);
  float denominator = (p + q) * (r2 + area / VTKI_PI);
  return denominator > 0.0f ? 6.0f * p / denominator : 0.0f;
}

/* Returns the relative luminance of linear Rec. 709 colours. */
float vtkiLuminance(vec3 c)
{
  return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}
#endif
