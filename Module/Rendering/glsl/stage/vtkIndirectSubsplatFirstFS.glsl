//VTK::System::Dec
//VTK::Output::Dec
// First level of the pyramid: from pixels of the geometry buffer.
#include "vtkIndirectSubsplatJoin.glsl"

uniform sampler2D vtkiSurface;

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vtkiJoin children;
  for (int i = 0; i < 4; ++i)
  {
    ivec2 pixel = 2 * texel + ivec2(i & 1, i >> 1);
    vec4 surface = textureLod(vtkiSurface, (vec2(pixel) + 0.5f) / vec2(vtkiSize), 0.0f);
    vec2 ndc = 2.0f * (vec2(pixel) + 0.5f) / vec2(vtkiSize) - 1.0f;
    children.position[i] = vtkiReconstruct(ndc, surface.z, vtkiRayOrigin, vtkiRayDirection);
    children.normal[i] = vtkiSurfaceNormal(surface);
#ifdef VTKI_DEPTH_RANGE
    children.minimum[i] = vec4(children.normal[i], surface.z);
    children.maximum[i] = children.minimum[i];
#else
    children.deviation[i] = 0.0f;
    children.spread[i] = 0.0f;
#endif
    children.present[i] =
      vtkiSurfaceIsLit(surface) && pixel.x < vtkiSize.x && pixel.y < vtkiSize.y;
  }
  children.split = false;
  vtkiWriteJoin(children, texel);
}
