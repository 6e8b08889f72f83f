//VTK::System::Dec
// One invocation a split texel: evaluates the four below it.
#include "vtkIndirectSubsplatStorage.glsl"
#include "vtkIndirectSubsplatBlock.glsl"

layout(local_size_x = VTKI_GROUP) in;

void main()
{
  uint place = gl_GlobalInvocationID.x;
  bool listed = place < vtkiCommand[vtkiList].w;
  uint entry = vtkiEntry[uint(vtkiListFirst) + (listed ? place : 0u)];
  vtkiEvaluateBlock(ivec2(int(entry & 0xffffu), int(entry >> 16)), listed);
}
