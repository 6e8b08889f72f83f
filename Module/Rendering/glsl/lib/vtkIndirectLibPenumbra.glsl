// Points of a light with a size, whose visibility is the mean over them.
#ifndef vtkIndirectLibPenumbra
#define vtkIndirectLibPenumbra
#include "vtkIndirectLibPortable.glsl"

// Points come in opposite pairs, so that their mean is the light's centre, and a shadow's edge
// stays in the middle of its penumbra from all directions.
const int VTKI_LIGHT_PAIRS = 16;
const int VTKI_LIGHT_POINTS = 2 * VTKI_LIGHT_PAIRS;
// Angles from pair to pair, irrational parts of a turn: half a turn by the golden ratio across the
// light, because a pair is a line, and a turn by the root of two along it.
const float VTKI_LIGHT_TURN_ACROSS = 0.61803398875f * VTKI_PI;
const float VTKI_LIGHT_TURN_ALONG = 0.82842712475f * VTKI_PI;

// Parallel maps of a light's points are shifted by this many half widths, perspective ones turned
// by an angle of this sine, times the point's place in the unit disk, which is a few texels:
// otherwise all maps would round an outline alike.
const float VTKI_LIGHT_SHIFT = 1.0f / 64.0f;

/* This is the rotation from pair to pair: cosines and sines of both angles. */
struct vtkiLightPairs
{
  vec2 across;
  vec2 along;
};

vtkiLightPairs vtkiBeginLightPairs()
{
  vtkiLightPairs pairs;
  pairs.across = vec2(1.0f, 0.0f);
  pairs.along = vec2(cos(0.5f * VTKI_LIGHT_TURN_ALONG), sin(0.5f * VTKI_LIGHT_TURN_ALONG));
  return pairs;
}

vec2 vtkiTurn(vec2 direction, float angle)
{
  float c = cos(angle);
  float s = sin(angle);
  return vec2(c * direction.x - s * direction.y, s * direction.x + c * direction.y);
}

/* Returns the first point of pair i in the unit ball; advances to the next pair. Seen from any
 * direction such points fill the unit disk evenly, because their density in the ball is 1 / sqrt(1
 * - r^2) (the inverse Abel transform of a constant). x and y are uniform in the disk; over a point
 * of it, at distance q from the centre, that density is an arcsine's, that of sqrt(1 - q^2) sin(t)
 * with t uniform. */
vec3 vtkiNextLightPoint(VTKI_INOUT(vtkiLightPairs) pairs, int i)
{
  float share = (float(i) + 0.5f) / float(VTKI_LIGHT_PAIRS);
  float q = sqrt(share);
  vec3 point = vec3(q * pairs.across.x, q * pairs.across.y, sqrt(1.0f - share) * pairs.along.y);
  pairs.across = vtkiTurn(pairs.across, VTKI_LIGHT_TURN_ACROSS);
  pairs.along = vtkiTurn(pairs.along, VTKI_LIGHT_TURN_ALONG);
  return point;
}

/* Axes of a parallel map from a point of the light at infinity: z towards the point, offset (sines)
 * in the image of the light's axis; x and y across it, continuous up to 90 degrees. */
void vtkiLightPointAxes(vec2 offset, VTKI_OUT(vec3) x, VTKI_OUT(vec3) y, VTKI_OUT(vec3) z)
{
  z = vec3(offset.x, offset.y, sqrt(max(1.0f - offset.x * offset.x - offset.y * offset.y, 0.0f)));
  // vtkiFrameAlong for z >= 0.
  float a = -1.0f / (1.0f + z.z);
  float b = z.x * z.y * a;
  x = vec3(1.0f + z.x * z.x * a, b, -z.x);
  y = vec3(b, 1.0f + z.y * z.y * a, -z.y);
}
#endif
