// Texels of the pyramid of subsplats.
#include "vtkIndirectLibSurface.glsl"
#include "vtkIndirectLibSubsplat.glsl"

uniform ivec2 vtkiSize; // pixels of the image
uniform mat3 vtkiRayOrigin;
uniform mat3 vtkiRayDirection;

// Equation (2) of the paper: guesses unresolved detail from the angle to the eye.
#ifdef VTKI_SURFACE_DETAIL
uniform float vtkiSurfaceDetail;
float vtkiDetail(vec2 ndc, vec3 normal)
{
  vec3 toEye = -normalize(vtkiRayDirection * vec3(ndc, 1.0f));
  return vtkiSurfaceDetail * max(dot(toEye, normal), 0.0f) + 1.0f - vtkiSurfaceDetail;
}
#else
float vtkiDetail(vec2 ndc, vec3 normal)
{
  return 1.0f;
}
#endif

// Returns the centre of a texel's pixel, in pixels. number: see vtkiSubsplatPixel; 0: in the middle.
vec2 vtkiPixelInTexel(ivec2 texel, float edge, int number)
{
  int at = number > 0 ? number - 1 : VTKI_SUBSPLAT_PIXELS / 2 * (VTKI_SUBSPLAT_PIXELS + 1);
  vec2 step = vec2(ivec2(at % VTKI_SUBSPLAT_PIXELS, at / VTKI_SUBSPLAT_PIXELS));
  vec2 pixel = floor(edge * (vec2(texel) + step / float(VTKI_SUBSPLAT_PIXELS)));
  return min(pixel, vec2(vtkiSize - 1)) + 0.5f;
}

// Returns the width of a pixel on a surface that faces the eye at this depth, scene units.
float vtkiPixelWidth(float depth)
{
  return (2.0f / float(vtkiSize.x)) * length(vtkiRayOrigin[0] + depth * vtkiRayDirection[0]);
}
