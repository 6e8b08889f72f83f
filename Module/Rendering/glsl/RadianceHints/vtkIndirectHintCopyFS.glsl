//VTK::System::Dec
//VTK::Output::Dec
// Copies the first bounce, to which later bounces are added.
#include "vtkIndirectHintTexture.glsl"
#include "vtkIndirectHintOutput.glsl"

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  vtkiField f = vtkiZeroField();
  vtkiAddHint(f, vtkiTableEntry(at), 1.0f);
  vtkiWriteField(f, texelFetch(vtkiHintDistance, at, 0));
}
