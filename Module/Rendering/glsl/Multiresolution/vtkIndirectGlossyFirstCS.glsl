//VTK::System::Dec
// Lists the coarsest texels that have a specular pixel, with all lights.
#include "vtkIndirectGlossyState.glsl"
#include "vtkIndirectGlossyStorage.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D vtkiLevelLobe;
uniform int vtkiSplitList;
uniform int vtkiSplitFirst;

void main()
{
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = textureSize(vtkiLevelLobe, 0);
  if (texel.x >= size.x || texel.y >= size.y ||
    texelFetch(vtkiLevelLobe, texel, 0).y == VTKI_GLOSSY_NONE)
  {
    return;
  }
  uint entry = vtkiAppendGlossy(vtkiSplitList, vtkiSplitFirst, texel, 0.0f);
  for (int word = 0; word < vtkiGlossyWords; ++word)
  {
    int rest = vtkiLightCount - 32 * word;
    vtkiGlossyEntry[entry + VTKI_GLOSSY_HEADER + uint(word)] =
      rest >= 32 ? 0xffffffffu : (1u << uint(rest)) - 1u;
  }
}
