// Where spheres and groups of spheres count, and flat polygons as seen from a receiver.
#ifndef vtkIndirectLibProxyRegion
#define vtkIndirectLibProxyRegion
#include "vtkIndirectLibPortable.glsl"

/* Share of a region's radius within which all counts. */
const float VTKI_PROXY_BAND = 0.8f;

/* How much counts within a region of that radius: all of it up to VTKI_PROXY_BAND, nothing from the border on,
 * smooth in between. */
float vtkiProxyWithin(float distance, float radius)
{
  float t = min(max((radius - distance) / max((1.0f - VTKI_PROXY_BAND) * radius, 1.0e-30f), 0.0f), 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

/* Weight of an entry of the tree of spheres: within the region in which its parent does not stand for it, and not
 * well within its own, where its children stand for it. */
float vtkiProxyWeight(float toOuter, float outer, float toCenter, float inner)
{
  float within = vtkiProxyWithin(toOuter, outer);
  return inner > 0.0f ? within * (1.0f - vtkiProxyWithin(toCenter, inner)) : within;
}

/* Squared distances of a box's nearest and farthest place from a point. */
vec2 vtkiBoxDistances(vec3 middle, vec3 halfSize, vec3 point)
{
  vec3 away = abs(point - middle);
  vec3 nearest = max(away - halfSize, vec3(0.0f));
  vec3 farthest = away + halfSize;
  return vec2(dot(nearest, nearest), dot(farthest, farthest));
}

/* Whether an entry may count somewhere in a box. */
bool vtkiProxyMeetsBox(vec3 middle, vec3 halfSize, vec3 outerCenter, float outer, vec3 center, float inner)
{
  vec2 toOuter = vtkiBoxDistances(middle, halfSize, outerCenter);
  vec2 toCenter = vtkiBoxDistances(middle, halfSize, center);
  float least = VTKI_PROXY_BAND * max(inner, 0.0f);
  return toOuter.x < outer * outer && toCenter.y >= least * least;
}

/* One edge's part of what a polygon's disk of directions sums to, as a vector (Lambert): the angle that the edge
 * takes, about the normal of the plane through it. a, b: unit directions to its corners. */
vec3 vtkiPolygonEdge(vec3 a, vec3 b)
{
  vec3 across = cross(a, b);
  float s = length(across);
  return s > 1.0e-12f ? (atan(s, dot(a, b)) / s) * across : vec3(0.0f);
}

/* A disk around +z of the sine of half its angle, in spherical harmonics of order 4. */
vec4 vtkiZonalDisk(float sine)
{
  float s2 = sine * sine;
  float c = sqrt(max(1.0f - s2, 0.0f));
  return VTKI_PI *
    vec4(0.56418958f * s2 / (1.0f + c), 0.48860251f * s2, 0.63078313f * c * s2, 0.18658817f * s2 * (4.0f - 5.0f * s2));
}

/* The logarithm of what a disk leaves to be seen that hides the share p of the light: `whole` is that of an opaque
 * one. log(1 - p D) begins with -p D, and what exceeds that goes with the square of p. */
vec4 vtkiZonalShare(vec4 whole, float sine, float share)
{
  return share * (share * whole - (1.0f - share) * vtkiZonalDisk(sine));
}

/* The disk of equal vector irradiance: direction, and the sine of half its angle. sum: over all edges. */
vec4 vtkiPolygonDisk(vec3 sum)
{
  float size = length(sum);
  // Half the sum over pi is the squared sine.
  float sine = sqrt(min(size / (2.0f * VTKI_PI), 1.0f));
  vec3 direction = sum / max(size, 1.0e-30f);
  return vec4(direction.x, direction.y, direction.z, size > 0.0f ? sine : 0.0f);
}
#endif
