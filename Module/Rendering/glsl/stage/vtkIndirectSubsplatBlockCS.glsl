//VTK::System::Dec
// One invocation a split texel evaluates the four below it; with VTKI_OCCUPANCY each has its own.
#include "vtkIndirectSubsplatStorage.glsl"
#include "vtkIndirectSubsplatBlock.glsl"

#ifdef VTKI_OCCUPANCY
layout(local_size_x = VTKI_GROUP, local_size_y = 4) in;
#else
layout(local_size_x = VTKI_GROUP) in;
#endif

void main()
{
  uint place = gl_GlobalInvocationID.x;
  bool listed = place < vtkiCommand[vtkiList].w;
  uint entry = vtkiEntry[uint(vtkiListFirst) + (listed ? place : 0u)];
  ivec2 block = ivec2(int(entry & 0xffffu), int(entry >> 16));
#ifdef VTKI_OCCUPANCY
  vtkiEvaluateChild(block, int(gl_LocalInvocationID.y), listed);
#else
  vtkiEvaluateBlock(block, listed);
#endif
}
