//VTK::System::Dec
//VTK::Output::Dec
// Finds the blocks of pixels that sum directions of the sky: blocks with pixels that have no share
// of the last frame; with VTKI_SKY_SPREAD these blocks and those beside them.
#include "vtkIndirectLibReprojection.glsl"

uniform ivec2 vtkiSize; // of the image that is read
#ifdef VTKI_SKY_SPREAD
uniform sampler2D vtkiSkyFresh;
#else
uniform int vtkiEdge; // pixels along an edge of a block
uniform sampler2D vtkiSkyShares;
#endif

void main()
{
  ivec2 block = ivec2(gl_FragCoord.xy);
  bool fresh = false;
#ifdef VTKI_SKY_SPREAD
  for (int i = 0; i < 9; ++i)
  {
    ivec2 beside = clamp(block + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), vtkiSize - 1);
    fresh = fresh || texelFetch(vtkiSkyFresh, beside, 0).r > 0.5f;
  }
#else
  for (int y = 0; y < vtkiEdge; ++y)
  {
    for (int x = 0; x < vtkiEdge; ++x)
    {
      ivec2 pixel = min(vtkiEdge * block + ivec2(x, y), vtkiSize - 1);
      fresh = fresh || texelFetch(vtkiSkyShares, pixel, 0).a == VTKI_REPROJECTED_NONE;
    }
  }
#endif
  gl_FragData[0] = vec4(fresh ? 1.0f : 0.0f, 0.0f, 0.0f, 1.0f);
}
