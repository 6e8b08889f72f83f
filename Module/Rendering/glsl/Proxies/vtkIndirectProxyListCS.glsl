//VTK::System::Dec
// Lists the pixels whose alpha is below zero.
#include "vtkIndirectProxyList.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(rgba32f, binding = 0) uniform image2D vtkiSkyImage;
uniform ivec2 vtkiSize;

void main()
{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (pixel.x < vtkiSize.x && pixel.y < vtkiSize.y && imageLoad(vtkiSkyImage, pixel).a < 0.0f)
  {
    vtkiAppend(pixel);
  }
}
