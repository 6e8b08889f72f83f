//VTK::System::Dec
//VTK::Output::Dec
// Makes the first level of the pyramid from pixels of the geometry buffer.
#include "vtkIndirectSubsplatJoin.glsl"
#ifdef VTKI_REPROJECTED
#include "vtkIndirectLibReprojection.glsl"

uniform sampler2D vtkiReprojected; // irradiance of the last frame
#endif

#ifndef VTKI_DEPTH_RANGE
// These are the criteria of a corner: heights over the tangent plane in pixel widths, above
// rounding and below those of surfaces that only overlap in the view; normals that differ by 41
// degrees.
const float VTKI_LEAST_RISE = 0.05f;
const float VTKI_GREATEST_RISE = 8.0f;
const float VTKI_LEAST_TURN = 0.7f;
#endif

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vtkiJoin children;
  for (int i = 0; i < 4; ++i)
  {
    ivec2 pixel = 2 * texel + ivec2(i & 1, i >> 1);
    vec4 surface = textureLod(vtkiSurface, (vec2(pixel) + 0.5f) / vec2(vtkiSize), 0.0f);
    vec2 ndc = 2.0f * (vec2(pixel) + 0.5f) / vec2(vtkiSize) - 1.0f;
    children.position[i] = vtkiReconstruct(ndc, vtkiSurfaceDepth(surface), vtkiRayOrigin, vtkiRayDirection);
    children.normal[i] = vtkiSurfaceNormal(surface);
#ifdef VTKI_DEPTH_RANGE
    children.minimum[i] = vec4(children.normal[i], vtkiSurfaceDepth(surface));
    children.maximum[i] = children.minimum[i];
#else
    children.deviation[i] = 0.0f;
    children.spread[i] = 0.0f;
#endif
    children.present[i] =
      vtkiSurfaceIsLit(surface) && pixel.x < vtkiSize.x && pixel.y < vtkiSize.y;
  }
  children.split = false;
#ifndef VTKI_DEPTH_RANGE
  // Irradiance bends within a pixel where a second surface rises over the first, even if no texel
  // holds both surfaces: test one pixel on each side.
  vec3 alongOrigin = children.normal[0] * vtkiRayOrigin;
  vec3 alongDirection = children.normal[0] * vtkiRayDirection;
  float offset = dot(children.normal[0], children.position[0]);
  float width = vtkiPixelWidth(-children.position[0].z);
  for (int i = 0; i < 4; ++i)
  {
    ivec2 shift = i < 2 ? ivec2(3 * i - 1, i) : ivec2(3 - i, 3 * i - 7);
    vec2 pixel = vec2(clamp(2 * texel + shift, ivec2(0), vtkiSize - 1)) + 0.5f;
    vec4 surface = textureLod(vtkiSurface, pixel / vec2(vtkiSize), 0.0f);
    vec3 ray = vec3(2.0f * pixel / vec2(vtkiSize) - 1.0f, 1.0f);
    float rise = dot(alongOrigin, ray) + vtkiSurfaceDepth(surface) * dot(alongDirection, ray) - offset;
    vec3 turn = vtkiSurfaceNormal(surface) - children.normal[0];
    children.split = children.split || (vtkiSurfaceIsLit(surface) && rise > VTKI_LEAST_RISE * width &&
      rise < VTKI_GREATEST_RISE * width && dot(turn, turn) > VTKI_LEAST_TURN * VTKI_LEAST_TURN);
  }
#endif
#ifdef VTKI_REPROJECTED
  children.needed = false;
  for (int i = 0; i < 16; ++i)
  {
    ivec2 pixel = clamp(2 * texel + ivec2((i & 3) - 1, (i >> 2) - 1), ivec2(0), vtkiSize - 1);
    children.needed =
      children.needed || texelFetch(vtkiReprojected, pixel, 0).a == VTKI_REPROJECTED_NONE;
  }
#endif
  vtkiWriteJoin(children, texel);
}
