// Albedo at a pixel of the geometry buffer: beside the light with VTKI_SOLID, in place of alpha, which is one.
#include "vtkIndirectLibAlbedo.glsl"

uniform sampler2D vtkiLit;
#ifndef VTKI_SOLID
uniform sampler2D vtkiAlbedo;
#endif

vec3 vtkiFetchAlbedo(ivec2 pixel)
{
#ifdef VTKI_SOLID
  return vtkiUnpackAlbedo(texelFetch(vtkiLit, pixel, 0).a);
#else
  return vtkiUnpackAlbedo(texelFetch(vtkiAlbedo, pixel, 0).r);
#endif
}
