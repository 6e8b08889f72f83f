// Bounds of a virtual light: ellipsoids around the iso-surfaces of its intensity over the squared
// distance.
#ifndef vtkIndirectLibSplat
#define vtkIndirectLibSplat
#include "vtkIndirectLibPortable.glsl"

// This is the length of IntensityThreshold: the lowest intensity over a squared distance that
// counts is IntensityThreshold * mean intensity / VTKI_SPLAT_LENGTH^2. In scene units, the diagonal
// of the scene's bounds: a threshold of 0.05 bounds the mean light at 0.22 diagonals.
const float VTKI_SPLAT_LENGTH = 0.05f;

// Margin of bounds for rounding.
const float VTKI_SPLAT_MARGIN = 1.0001f;

// With a far field a light counts within this many radii of its own disk, however dim it is: there
// its irradiance is up to that of the surface that it represents, and varies at the scale of the
// disk. Beyond, one such light adds at most a sixteenth of that.
const float VTKI_SPLAT_NEAR = 4.0f;

// This is an ellipsoid of revolution that encloses the light's iso-surface.
struct vtkiSplat
{
  vec3 center;
  float along; // half its length along the axis
  vec3 axis;   // unit
  float across; // half its width; negative: empty
};

/* Returns the logarithm of n / (n + 2), n > 0. For large n the quotient would round to one: the
 * logarithm is -2 atanh(1 / (n + 1)). */
float vtkiSplatLogarithm(float n)
{
  float t = 1.0f / (n + 1.0f);
  float t2 = t * t;
  float series = -2.0f * t * (1.0f + t2 * (1.0f / 3.0f + t2 * (0.2f + t2 / 7.0f)));
  return n > 8.0f ? series : log(n / (n + 2.0f));
}

/* Returns the widest point of the iso-surface r(a) = cos(a)^(n/2) of an intensity cos(a)^n: its
 * place along the axis, and its distance from the axis (Dachsbacher and Stamminger 2006, "Splatting
 * indirect illumination", equations (7) and (8)). With k = n / (n + 2) these are k^((n+2)/4), where
 * the printed equation lacks an exponent, and k^(n/4) sqrt(2 / (n + 2)). n: 0 and above. */
vec2 vtkiSplatWidest(float n)
{
  float logarithm = n > 1.0e-6f ? vtkiSplatLogarithm(n) : 0.0f;
  vec2 widest = vec2(exp(0.25f * (n + 2.0f) * logarithm), exp(0.25f * n * logarithm) * sqrt(2.0f / (n + 2.0f)));
  return n > 1.0e-6f ? widest : vec2(0.0f, 1.0f);
}

/* Returns the ellipsoid around that surface scaled to `size`: the appendix's own, with centre and
 * width at the surface's widest point, and long enough for its ends. It encloses the surface for
 * every exponent from 0 on, not from 1 on only. ball: radius about the light within which the
 * exponent may be lower: the ellipsoid encloses this ball, too. With both halves at least sqrt(2)
 * times the ball's extent along and across, any of its points p has (p.along / along)^2 <= 1/2 and
 * (p.across / across)^2 <= 1/2. */
vtkiSplat vtkiMakeSplat(vec3 position, vec3 axis, float exponent, float size, float ball)
{
  vec2 widest = size * vtkiSplatWidest(exponent);
  const float root2 = 1.41421357f;
  vtkiSplat splat;
  splat.center = position + widest.x * axis;
  splat.along = max(max(widest.x, size - widest.x), ball > 0.0f ? root2 * (widest.x + ball) : 0.0f);
  splat.across = max(widest.y, root2 * ball);
  splat.along *= VTKI_SPLAT_MARGIN;
  splat.across *= VTKI_SPLAT_MARGIN;
  splat.axis = axis;
  return splat;
}

/* A ball around the whole scene, whose bounds are one across, replaces any larger ellipsoid. */
vtkiSplat vtkiWholeScene()
{
  vtkiSplat splat;
  splat.center = vec3(0.0f);
  splat.along = 1.0f;
  splat.axis = vec3(0.0f, 0.0f, 1.0f);
  splat.across = 1.0f;
  return splat;
}

/* Returns the splat, or the whole scene if that is smaller: a light lies within half a diagonal of
 * the middle, and an ellipsoid of twice the size is equivalent to an infinite one. */
vtkiSplat vtkiWithinScene(vtkiSplat splat)
{
  vtkiSplat whole = vtkiWholeScene();
  bool larger = min(splat.along, splat.across) >= 2.0f;
  splat.center = larger ? whole.center : splat.center;
  splat.axis = larger ? whole.axis : splat.axis;
  splat.along = larger ? whole.along : splat.along;
  splat.across = larger ? whole.across : splat.across;
  return splat;
}

/* Maps a point of the unit ball to the ellipsoid; a polyhedron around the ball maps to one around
 * the ellipsoid. */
vec3 vtkiSplatPoint(vtkiSplat splat, vec3 unit)
{
  float along = dot(unit, splat.axis);
  return splat.center + splat.across * unit + ((splat.along - splat.across) * along) * splat.axis;
}

/* Returns false only if the ellipsoid does not meet a box. Uses the box's nearest points along and
 * across, which may differ. */
bool vtkiSplatMeetsBox(vtkiSplat splat, vec3 middle, vec3 halfSize)
{
  vec3 d = middle - splat.center;
  float along = dot(d, splat.axis);
  vec3 aside = d - along * splat.axis;
  float a = max(abs(along) - dot(abs(splat.axis), halfSize), 0.0f) / splat.along;
  float b = max(length(aside) - length(halfSize), 0.0f) / splat.across;
  return splat.across > 0.0f && a * a + b * b <= 1.0f;
}

/* u Q v of the ellipsoid's half axes: Q = sum of e e^T over them. */
float vtkiSplatForm(vtkiSplat splat, vec3 u, vec3 v)
{
  float difference = splat.along * splat.along - splat.across * splat.across;
  return splat.across * splat.across * dot(u, v) + difference * dot(u, splat.axis) * dot(v, splat.axis);
}

/* Returns the least and largest value of x / w over the ellipsoid, x and w affine in the position:
 * rows of a projection. Exact if all of it lies in front of the eye's plane w = 0. Returns 1 then,
 * -1 if all of it lies behind, and 0 if it meets that plane, so that there is no range. The
 * discriminant avoids the difference of its squares, which would cancel for a small ellipsoid. */
int vtkiSplatRange(vtkiSplat splat, vec4 rowX, vec4 rowW, VTKI_OUT(vec2) range)
{
  vec3 x = vec3(rowX.x, rowX.y, rowX.z);
  vec3 w = vec3(rowW.x, rowW.y, rowW.z);
  float px = dot(x, splat.center) + rowX.w;
  float pw = dot(w, splat.center) + rowW.w;
  float xx = vtkiSplatForm(splat, x, x);
  float xw = vtkiSplatForm(splat, x, w);
  float ww = vtkiSplatForm(splat, w, w);
  // The point nearest to the eye's plane is pw - sqrt(ww) away; an ellipsoid within a thousandth
  // counts as meeting the plane.
  float clear = pw * pw * 0.998f - ww;
  vec3 across = px * w - pw * x;
  float root = sqrt(max(vtkiSplatForm(splat, across, across) - max(xx * ww - xw * xw, 0.0f), 0.0f));
  float scale = 1.0f / max(pw * pw - ww, 1.0e-30f);
  float middle = px * pw - xw;
  range = vec2((middle - root) * scale, (middle + root) * scale);
  return clear > 0.0f ? (pw > 0.0f ? 1 : -1) : 0;
}

/* Share of a light at a position that its splat has; the far field has the rest. level: intensity
 * over the squared distance, over the lowest that counts. Zero below one; fades: one from two on,
 * otherwise from one on. */
float vtkiSplatShare(float level, bool fades)
{
  float t = min(max(level - 1.0f, 0.0f), 1.0f);
  return fades ? t * t * (3.0f - 2.0f * t) : (level >= 1.0f ? 1.0f : 0.0f);
}

/* Returns the radius within which a light of that area always counts. */
float vtkiNearReach(float area)
{
  return VTKI_SPLAT_NEAR * sqrt(max(area, 0.0f) / VTKI_PI);
}

/* Returns the share that counts by that radius: one within eight tenths of the reach, zero beyond
 * it. */
float vtkiNearShare(float distance2, float reach)
{
  float reach2 = max(reach * reach, 1.0e-30f);
  return min(max((reach2 - distance2) / (0.36f * reach2), 0.0f), 1.0f);
}
#endif
