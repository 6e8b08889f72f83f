// Regions in which spheres and groups of spheres count, and flat polygons as seen from a receiver.
#ifndef vtkIndirectLibProxyRegion
#define vtkIndirectLibProxyRegion
#include "vtkIndirectLibPortable.glsl"

/* This is the share of a region's radius within which an entry counts fully. */
const float VTKI_PROXY_BAND = 0.8f;

/* Returns the weight within a region of that radius: one up to VTKI_PROXY_BAND, zero from the
 * border on, smooth in between. */
float vtkiProxyWithin(float distance, float radius)
{
  float t = min(max((radius - distance) / max((1.0f - VTKI_PROXY_BAND) * radius, 1.0e-30f), 0.0f), 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

/* Returns the weight of an entry of the tree of spheres: positive in the region where its parent
 * does not represent it, and not deep inside its own inner region, where its children represent it.
 */
float vtkiProxyWeight(float toOuter, float outer, float toCenter, float inner)
{
  float within = vtkiProxyWithin(toOuter, outer);
  return inner > 0.0f ? within * (1.0f - vtkiProxyWithin(toCenter, inner)) : within;
}

/* Packs two numbers into one float, 8 bits of mantissa each: texels cost more than unpacking. The
 * float has the first number's exponent, so it is a finite number or zero. */
float vtkiPair(float first, float second)
{
  uint high = floatBitsToUint(abs(first) < 1.0e-30f && second != 0.0f ? 1.0e-30f : first) + 0x8000u;
  uint low = floatBitsToUint(second) + 0x8000u;
  return uintBitsToFloat((high & 0xffff0000u) | (low >> 16u));
}

float vtkiFirstOf(float pair)
{
  return uintBitsToFloat(floatBitsToUint(pair) & 0xffff0000u);
}

float vtkiSecondOf(float pair)
{
  return uintBitsToFloat(floatBitsToUint(pair) << 16u);
}

/* Returns the least number of a pair that is not below a positive one. */
float vtkiPairedAbove(float number)
{
  return uintBitsToFloat((floatBitsToUint(number) + 0xffffu) & 0xffff0000u);
}

/* This is the region in which an entry of the tree of spheres counts, in one texel. */
struct vtkiRegion
{
  vec3 ToOuter; // vector from the entry's centre to the region's
  float Outer;  // radius of the region
  // radius about its own centre within which its children represent it; 0: it has none, -1: it is a
  // drawn sphere
  float Inner;
  float Bound;  // radius about it that bounds the entry and its descendants
  float Share;  // hidden share of its disk
  float Next;   // the entry after it and its descendants
};

/* Radii are representable numbers of pairs, or rounded to them. The offset of the region's centre,
 * at most its radius, is exact to a 500th of that; its bits make a finite number. */
vec4 vtkiPackRegion(vtkiRegion region)
{
  vec3 way = region.ToOuter / max(region.Outer, 1.0e-30f);
  uint x = uint(min(max(511.0f * way.x, -511.0f), 511.0f) + 511.5f);
  uint y = uint(min(max(511.0f * way.y, -511.0f), 511.0f) + 511.5f);
  uint z = uint(min(max(255.0f * way.z, -255.0f), 255.0f) + 511.5f);
  return vec4(vtkiPair(region.Outer, region.Inner), vtkiPair(region.Bound, region.Share), region.Next,
    uintBitsToFloat(x | (y << 10u) | (z << 20u)));
}

vtkiRegion vtkiUnpackRegion(vec4 texel)
{
  vtkiRegion region;
  region.Outer = vtkiFirstOf(texel.x);
  region.Inner = vtkiSecondOf(texel.x);
  region.Bound = vtkiFirstOf(texel.y);
  region.Share = vtkiSecondOf(texel.y);
  region.Next = texel.z;
  uint way = floatBitsToUint(texel.w);
  region.ToOuter = (vec3(float(way & 1023u), float((way >> 10u) & 1023u), float(way >> 20u)) - 511.0f) *
    (region.Outer * vec3(1.0f / 511.0f, 1.0f / 511.0f, 1.0f / 255.0f));
  return region;
}

/* Returns the squared distances from a point to the nearest and farthest point of a box. */
vec2 vtkiBoxDistances(vec3 middle, vec3 halfSize, vec3 point)
{
  vec3 away = abs(point - middle);
  vec3 nearest = max(away - halfSize, vec3(0.0f));
  vec3 farthest = away + halfSize;
  return vec2(dot(nearest, nearest), dot(farthest, farthest));
}

/* Returns true if an entry may count somewhere in a box. */
bool vtkiProxyMeetsBox(vec3 middle, vec3 halfSize, vec3 outerCenter, float outer, vec3 center, float inner)
{
  vec2 toOuter = vtkiBoxDistances(middle, halfSize, outerCenter);
  vec2 toCenter = vtkiBoxDistances(middle, halfSize, center);
  float least = VTKI_PROXY_BAND * max(inner, 0.0f);
  return toOuter.x < outer * outer && toCenter.y >= least * least;
}

/* One edge's part of the vector sum of a polygon's directions (Lambert): the angle of the edge,
 * about the normal of the plane through it. a, b: unit directions to its corners. */
vec3 vtkiPolygonEdge(vec3 a, vec3 b)
{
  vec3 across = cross(a, b);
  float s = length(across);
  return s > 1.0e-12f ? (atan(s, dot(a, b)) / s) * across : vec3(0.0f);
}

/* Returns a disk around +z, by the sine of half its angle, in spherical harmonics of order 4. */
vec4 vtkiZonalDisk(float sine)
{
  float s2 = sine * sine;
  float c = sqrt(max(1.0f - s2, 0.0f));
  return VTKI_PI *
    vec4(0.56418958f * s2 / (1.0f + c), 0.48860251f * s2, 0.63078313f * c * s2, 0.18658817f * s2 * (4.0f - 5.0f * s2));
}

/* Returns the logarithm of the visibility left by a disk that hides the share p of the light;
 * `whole` is that of an opaque disk. log(1 - p D) begins with -p D, and the remainder goes with the
 * square of p. */
vec4 vtkiZonalShare(vec4 whole, float sine, float share)
{
  return share * (share * whole - (1.0f - share) * vtkiZonalDisk(sine));
}

/* Returns the disk of equal vector irradiance: direction, and the sine of half its angle. sum: over
 * all edges. */
vec4 vtkiPolygonDisk(vec3 sum)
{
  float size = length(sum);
  // Half the sum over pi is the squared sine.
  float sine = sqrt(min(size / (2.0f * VTKI_PI), 1.0f));
  vec3 direction = sum / max(size, 1.0e-30f);
  return vec4(direction.x, direction.y, direction.z, size > 0.0f ? sine : 0.0f);
}
#endif
