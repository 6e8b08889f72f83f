//VTK::System::Dec
// One invocation for two split texels: evaluates the four below each.
#include "vtkIndirectSubsplatStorage.glsl"
#include "vtkIndirectSubsplatBlock.glsl"

// VTKI_GROUP / VTKI_BLOCKS, which GLSL before 4.40 does not work out here.
layout(local_size_x = 32) in;

void main()
{
  ivec2 blocks[VTKI_BLOCKS];
  bool listed[VTKI_BLOCKS];
  for (int i = 0; i < VTKI_BLOCKS; ++i)
  {
    uint place = uint(VTKI_BLOCKS) * gl_GlobalInvocationID.x + uint(i);
    listed[i] = place < vtkiCommand[vtkiList].w;
    uint entry = vtkiEntry[uint(vtkiListFirst) + (listed[i] ? place : 0u)];
    blocks[i] = ivec2(int(entry & 0xffffu), int(entry >> 16));
  }
  vtkiEvaluateBlocks(blocks, listed);
}
