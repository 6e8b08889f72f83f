// Importance sampling from sums over squares of cells: hierarchical warping, after Clarberg,
// Jarosz, Akenine-Moller and Jensen 2005, "Wavelet importance sampling", as used by Dachsbacher and
// Stamminger 2006, "Splatting indirect illumination", section 3.5.
//
// A chart is the unit square in which a light's map is sampled, with a power of two of cells along
// an edge. A node's quadrants are the sums over its four quarters: x at the lower left, y at the
// lower right, z at the upper left, w at the upper right.
#ifndef vtkIndirectLibImportance
#define vtkIndirectLibImportance
#include "vtkIndirectLibPortable.glsl"

// These are the methods of warping a node's columns. its upper and lower half by their own sums:
// the paper's method A
const int VTKI_WARP_APART = 0;
const int VTKI_WARP_TOGETHER = 1; // both halves by their common sums: method B
const int VTKI_WARP_EVENLY = 2;   // all nonempty parts of a node are equally likely

// This is the largest number below one.
const float VTKI_BELOW_ONE = 0.99999994f;

/* Makes one step of warping: selects the part, returns true for the second, and maps a coordinate
 * in [0,1) to its place in the part, in [0,1). Equation (5) of the paper, counted within the halves
 * that it maps to; multiplies the probability by that of the part, the inverse of equation (6) but
 * for the factor two of the halves. One of the parts must be nonempty; an empty part is never
 * chosen. */
bool vtkiWarp(float first, float second, VTKI_INOUT(float) coordinate, VTKI_INOUT(float) probability)
{
  float both = max(first + second, 1.0e-37f);
  float share = second > 0.0f ? first / both : 1.0f;
  bool isSecond = !(coordinate < share);
  float part = isSecond ? second / both : share;
  coordinate = min((isSecond ? coordinate - share : coordinate) / max(part, 1.0e-30f), VTKI_BELOW_ONE);
  probability *= part;
  return isSecond;
}

float vtkiOneWhereAny(float sum)
{
  return sum > 0.0f ? 1.0f : 0.0f;
}

/* Returns the quarter of a node that contains a place in it, in [0,1)^2; place and probability as
 * in vtkiWarp. */
ivec2 vtkiWarpQuadrant(vec4 quadrants, int method, VTKI_INOUT(vec2) place, VTKI_INOUT(float) probability)
{
  bool evenly = method == VTKI_WARP_EVENLY;
  float x = place.x;
  float y = place.y;
  float lower = quadrants.x + quadrants.y;
  float upper = quadrants.z + quadrants.w;
  bool isUpper = vtkiWarp(evenly ? vtkiOneWhereAny(lower) : lower, evenly ? vtkiOneWhereAny(upper) : upper,
    y, probability);
  float left = isUpper ? quadrants.z : quadrants.x;
  float right = isUpper ? quadrants.w : quadrants.y;
  bool together = method == VTKI_WARP_TOGETHER && left > 0.0f && right > 0.0f;
  left = evenly ? vtkiOneWhereAny(left) : (together ? quadrants.x + quadrants.z : left);
  right = evenly ? vtkiOneWhereAny(right) : (together ? quadrants.y + quadrants.w : right);
  bool isRight = vtkiWarp(left, right, x, probability);
  place = vec2(x, y);
  return ivec2(isRight ? 1 : 0, isUpper ? 1 : 0);
}

/* Direction in a light's frame for a place in the chart of a map with faces: an equal-area map of
 * the cone of light about -z with this cosine (-1: all directions). */
vec3 vtkiChartDirection(vec2 place, float cosCone)
{
  float depth = place.x * (1.0f - cosCone);
  float radius = sqrt(max(depth * (2.0f - depth), 0.0f));
  float angle = 2.0f * VTKI_PI * place.y;
  return vec3(radius * cos(angle), radius * sin(angle), depth - 1.0f);
}

// This is the distance, scene units, within which other surfaces count for accessibility.
const float VTKI_NEIGHBOR_RADIUS = 0.1f;

/* Returns the occlusion at a position by a surface at this offset, in [0,1]: the cosine at the
 * position, decreasing with the distance. */
float vtkiHiddenBy(vec3 toSurface, vec3 normal)
{
  float distance = length(toSurface);
  float cosine = max(dot(normal, toSurface), 0.0f) / max(distance, 1.0e-20f);
  return cosine * max(1.0f - distance / (2.0f * VTKI_NEIGHBOR_RADIUS), 0.0f);
}

/* Returns the factor from a texel's flux to its importance. accessibility: open share of the
 * hemisphere. */
float vtkiNeighborFactor(float occlusion, float accessibility)
{
  return 0.015625f + max(1.0f - occlusion * accessibility, 0.0f);
}

/* Returns the column at which the nodes of a level begin in its texture: levels lie in two textures
 * in turn, each to the right of the one before. width: that of the nodes of level 0; each level has
 * half as many. */
int vtkiNodesBegin(int width, int level)
{
  int begin = 0;
  for (int i = level - 2; i >= 0; i -= 2)
  {
    begin += width >> i;
  }
  return begin;
}
#endif
