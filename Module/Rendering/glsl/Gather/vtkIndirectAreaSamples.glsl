// Samples around a pixel that lie on its surface.
#include "vtkIndirectLibInterpolation.glsl"

// Between samples light is interpolated that comes from so many times their distance at least: what falls with a
// power of the distance is then off by less than half a hundredth. Where not all samples around are on the surface, so that
// their middle is elsewhere, from three times that.
#ifndef VTKI_AREA_DISTANCES
#define VTKI_AREA_DISTANCES 14.0f
#endif
const float VTKI_AREA_DISTANCES_BESIDE = 3.0f * VTKI_AREA_DISTANCES;

// Least cosine of normals between which light is interpolated; what hides it may be between others.
const float VTKI_AREA_COSINE = 0.99f;

// Pixels between samples.
const int VTKI_AREA_BLOCK = 4;

// Width of a pixel on a plane that faces the eye.
float vtkiPixelWidth(float depth)
{
  vec3 dx = vtkiRayOrigin[0] + depth * vtkiRayDirection[0];
  return length(dx) * (2.0f / float(vtkiSize.x));
}

// Whether a surface, its facet's normal and its height along it, is that of a receiver. cosine: least of the normals.
bool vtkiIsOnPlane(vec4 plane, vtkiReceiver receiver, float tolerance, float cosine)
{
  return abs(dot(plane.xyz, receiver.positionVC) - plane.w) <= tolerance &&
    dot(plane.xyz, receiver.facetVC) >= cosine;
}

// Where a pixel is between samples that are so many pixels apart, but the last ones, which are at the border.
vec2 vtkiBetween(ivec2 pixel, ivec2 cell, int step)
{
  ivec2 width = max(min(step * (cell + 1), vtkiSize - 1) - step * cell, ivec2(1));
  return vec2(pixel - step * cell) / vec2(width);
}

// Weight of one of four samples, k, around a place between them.
float vtkiBilinear(vec2 between, int k)
{
  return ((k & 1) == 1 ? between.x : 1.0f - between.x) * (k > 1 ? between.y : 1.0f - between.y);
}
