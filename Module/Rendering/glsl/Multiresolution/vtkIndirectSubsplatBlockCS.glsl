//VTK::System::Dec
// One invocation for VTKI_BLOCKS split texels evaluates the four texels below each. With
// VTKI_SEGMENTS each of the four has its own invocation.
#include "vtkIndirectSubsplatStorage.glsl"
#include "vtkIndirectSubsplatBlock.glsl"

ivec2 vtkiListedTexel(uint place, out bool listed)
{
  listed = place < vtkiCommand[vtkiList].w;
  uint entry = vtkiEntry[uint(vtkiListFirst) + (listed ? place : 0u)];
  return ivec2(int(entry & 0xffffu), int(entry >> 16));
}

#ifdef VTKI_SEGMENTS
layout(local_size_x = VTKI_GROUP, local_size_y = 4) in;

void main()
{
  bool listed;
  ivec2 block = vtkiListedTexel(gl_GlobalInvocationID.x, listed);
  vtkiEvaluateChild(block, int(gl_LocalInvocationID.y), listed);
}
#else
// VTKI_GROUP / VTKI_BLOCKS: before 4.40, GLSL allows no expression here.
layout(local_size_x = VTKI_INVOCATIONS) in;

void main()
{
  ivec2 blocks[VTKI_BLOCKS];
  bool listed[VTKI_BLOCKS];
  for (int i = 0; i < VTKI_BLOCKS; ++i)
  {
    blocks[i] = vtkiListedTexel(uint(VTKI_BLOCKS) * gl_GlobalInvocationID.x + uint(i), listed[i]);
  }
  vtkiEvaluateBlocks(blocks, listed);
}
#endif
