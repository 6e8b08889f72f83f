// The crease at a pixel, see vtkIndirectLibCrease.glsl. vtkIndirectCreases sets the image.
#include "vtkIndirectLibCrease.glsl"
#include "vtkIndirectLibSurface.glsl"

uniform sampler2D vtkiCreases;
uniform int vtkiCreaseStep; // pixels along the edge of a texel

// Returns the crease at a pixel, or at the middle of the texel that holds the pixel. The plane of the
// crease is a surface's: a pixel of another surface there is merely not hidden by its own crease.
vtkiCrease vtkiFetchCrease(ivec2 pixel)
{
  vec4 texel =
    texelFetch(vtkiCreases, min(pixel / vtkiCreaseStep, textureSize(vtkiCreases, 0) - 1), 0);
  vtkiCrease crease;
  crease.normal = texel.w > 0.0f ? vtkiOctahedralDecode(vtkiUnpackCode(texel.x)) : vec3(0.0f);
  crease.plane = texel.y;
  crease.extent2 = texel.z;
  return crease;
}
