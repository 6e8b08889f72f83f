// Albedo at a pixel of the geometry buffer. With VTKI_ALBEDO_IN_ALPHA the lit image has it in place
// of alpha, which is one.
#include "vtkIndirectLibAlbedo.glsl"

uniform sampler2D vtkiLit;
#ifndef VTKI_ALBEDO_IN_ALPHA
uniform sampler2D vtkiAlbedo;
#endif

vec3 vtkiFetchAlbedo(ivec2 pixel)
{
#ifdef VTKI_ALBEDO_IN_ALPHA
  return vtkiUnpackAlbedo(texelFetch(vtkiLit, pixel, 0).a);
#else
  return vtkiUnpackAlbedo(texelFetch(vtkiAlbedo, pixel, 0).r);
#endif
}
