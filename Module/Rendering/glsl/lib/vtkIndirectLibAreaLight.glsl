// Irradiance at a surface element from a rectangle of one radiance: E = radiance times form factor
// (VTK units).
#ifndef vtkIndirectLibAreaLight
#define vtkIndirectLibAreaLight
#include "vtkIndirectLibVirtualLight.glsl"

// A rectangle at this many times its longer edge is treated as a disk, if its heights over the
// receiver's horizon differ from their mean by no more than this share: the form factor is then off
// by less than 0.5 %.
const float VTKI_AREA_FAR = 30.0f;
const float VTKI_AREA_EVEN = 0.2f;

/* Returns the angle subtended by the edge from a to b at the origin, times the cosine between the
 * normal and that of the plane through both and the origin. Computed from the edge, which keeps
 * precision for short edges. */
float vtkiEdgeTerm(vec3 a, vec3 b, vec3 normal)
{
  vec3 c = cross(a, b - a);
  float sine = length(c);
  return sine > 0.0f ? atan(sine, dot(a, b)) / sine * dot(normal, c) : 0.0f;
}

/* Returns the form factor from a surface element at the origin to the part of a parallelogram above
 * its horizon (Lambert 1760), whichever way the parallelogram faces. corner: one of its corners,
 * relative to the element; normal: unit. */
float vtkiRectangleFormFactor(vec3 corner, vec3 edge1, vec3 edge2, vec3 normal)
{
  vec3 middle = corner + 0.5f * (edge1 + edge2);
  float least = dot(normal, corner) + min(dot(normal, edge1), 0.0f) + min(dot(normal, edge2), 0.0f);
  vec3 span = cross(edge1, edge2);
  float square = dot(middle, middle);
  float area = length(span);
  if (least >= (1.0f - VTKI_AREA_EVEN) * abs(dot(normal, middle)) &&
    square > VTKI_AREA_FAR * VTKI_AREA_FAR * max(dot(edge1, edge1), dot(edge2, edge2)))
  {
    float denominator = square * (VTKI_PI * square + area);
    return abs(dot(span, middle)) * dot(normal, middle) / denominator;
  }
  float sum = 0.0f;
  vec3 leave = vec3(0.0f);
  vec3 enter = vec3(0.0f);
  vec3 from = corner;
  float fromHeight = dot(normal, corner);
  for (int i = 0; i < 4; ++i)
  {
    vec3 edge = i == 0 ? edge1 : (i == 1 ? edge2 : (i == 2 ? -edge1 : -edge2));
    vec3 to = from + edge;
    float toHeight = dot(normal, to);
    if (max(fromHeight, toHeight) > 0.0f)
    {
      // The edge crosses the horizon, or ends on it.
      bool rises = fromHeight <= 0.0f;
      bool falls = toHeight <= 0.0f;
      vec3 crossing =
        rises || falls ? from + (fromHeight / (fromHeight - toHeight)) * edge : from;
      sum += vtkiEdgeTerm(rises ? crossing : from, falls ? crossing : to, normal);
      enter = rises ? crossing : enter;
      leave = falls ? crossing : leave;
    }
    from = to;
    fromHeight = toHeight;
  }
  // The horizon closes the outline.
  sum += vtkiEdgeTerm(leave, enter, normal);
  return abs(sum) * (0.5f / VTKI_PI);
}

// From this many times its longer edge on, a piece of a rectangle is far: vtkiPieceMean replaces
// its form factor.
const float VTKI_PIECE_FAR = 3.0f;

/* Returns the mean height over the horizon, clamped to zero below it, of a piece that extends by
 * reach up and down from its middle. */
float vtkiMeanHeight(float height, float reach)
{
  float above = max(height + reach, 0.0f);
  return height >= reach ? height : 0.25f * above * above / max(reach, 1.0e-30f);
}

// This is a far piece of a rectangle, seen from a receiver.
struct vtkiPiece
{
  float square; // squared distance to its middle
  float height; // height of the middle over the horizon, at least the piece's extent
  vec2 rise;    // heights of both edges over the horizon
  vec2 along;   // products of both edges with the vector to the middle
  vec2 length2; // squares of both edges
};

/* Returns the mean irradiance of a far piece over that of its middle: height / distance^4 to second
 * order, with an error in the fourth power of edge over distance. */
float vtkiPieceMean(vtkiPiece piece)
{
  float a1 = piece.along.x / piece.square;
  float a2 = piece.along.y / piece.square;
  float l2 = (piece.length2.x + piece.length2.y) / piece.square;
  return 1.0f + (a1 * a1 + a2 * a2) - l2 / 6.0f -
    (piece.rise.x * a1 + piece.rise.y * a2) / (3.0f * piece.height);
}

/* Variance of a far piece's irradiance over the square of its mean, from the slope along both edges
 * and the decrease with distance. A uniform variable along an edge has the variance 1 / 12, its
 * square 1 / 180. */
float vtkiPieceVariance(vtkiPiece piece)
{
  float slope1 = piece.rise.x / piece.height - 4.0f * piece.along.x / piece.square;
  float slope2 = piece.rise.y / piece.height - 4.0f * piece.along.y / piece.square;
  float share = max(piece.length2.x, piece.length2.y) / piece.square;
  return (slope1 * slope1 + slope2 * slope2) / 12.0f + 0.045f * share * share;
}
#endif
