// Interpolation between samples around a pixel that lie on its surface.
#include "vtkIndirectLibInterpolation.glsl"

// Light is interpolated if it comes from at least this many sample distances away: an inverse power
// of the distance is then off by less than half a hundredth. If not all four samples are on the
// surface, so that their mean position is off the pixel, three times that distance is required.
#ifndef VTKI_AREA_DISTANCES
#define VTKI_AREA_DISTANCES 14.0f
#endif
const float VTKI_AREA_DISTANCES_BESIDE = 3.0f * VTKI_AREA_DISTANCES;

// Least cosine between normals over which light is interpolated; other normals may be shadowed by
// other surfaces.
const float VTKI_AREA_COSINE = 0.99f;

// Pixels between samples.
const int VTKI_AREA_BLOCK = 4;

// Width of a pixel on a plane that faces the eye.
float vtkiPixelWidth(float depth)
{
  vec3 dx = vtkiRayOrigin[0] + depth * vtkiRayDirection[0];
  return length(dx) * (2.0f / float(vtkiSize.x));
}

// True if a surface, given by its facet's normal and its height along that normal, is the
// receiver's surface. cosine: least cosine of the normals.
bool vtkiIsOnPlane(vec4 plane, vtkiReceiver receiver, float tolerance, float cosine)
{
  return abs(dot(plane.xyz, receiver.positionVC) - plane.w) <= tolerance &&
    dot(plane.xyz, receiver.facetVC) >= cosine;
}

// Place of a pixel between samples that are step pixels apart; the last samples lie on the border.
vec2 vtkiBetween(ivec2 pixel, ivec2 cell, int step)
{
  ivec2 width = max(min(step * (cell + 1), vtkiSize - 1) - step * cell, ivec2(1));
  return vec2(pixel - step * cell) / vec2(width);
}

// Bilinear weight of sample k of four.
float vtkiBilinear(vec2 between, int k)
{
  return ((k & 1) == 1 ? between.x : 1.0f - between.x) * (k > 1 ? between.y : 1.0f - between.y);
}
