// Pixels that no coarse receiver stands for: a command of a dispatch, then an entry each.
layout(std430) buffer vtkiProxyPixels
{
  uvec4 vtkiCommand; // groups of 256 and the number of entries
  uint vtkiEntry[];  // x, y in 16 bits each
};

void vtkiAppend(ivec2 pixel)
{
  uint place = atomicAdd(vtkiCommand.w, 1u);
  vtkiEntry[place] = uint(pixel.x) | (uint(pixel.y) << 16);
  if (place % 256u == 0u)
  {
    atomicAdd(vtkiCommand.x, 1u);
  }
}
