// The crease at a pixel, see vtkIndirectLibCrease.glsl. vtkIndirectCreases sets the image.
#include "vtkIndirectLibCrease.glsl"
#include "vtkIndirectLibSurface.glsl"

uniform sampler2D vtkiCreases;

vtkiCrease vtkiFetchCrease(ivec2 pixel)
{
  vec4 texel = texelFetch(vtkiCreases, min(pixel, textureSize(vtkiCreases, 0) - 1), 0);
  vtkiCrease crease;
  crease.normal = texel.w > 0.0f ? vtkiOctahedralDecode(vtkiUnpackCode(texel.x)) : vec3(0.0f);
  crease.plane = texel.y;
  crease.extent2 = texel.z;
  return crease;
}
