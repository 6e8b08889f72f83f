// Receivers for pixels that no coarse receiver represents, and these pixels: a dispatch command for
// each list, then entries.
const int VTKI_PROXY_RECEIVERS = 0;
const int VTKI_PROXY_SERVED = 1;

layout(std430) buffer vtkiProxyPixels
{
  uvec4 vtkiCommands[2]; // groups of 256 and the number of entries
  uint vtkiEntries[];    // receivers, from vtkiSize.x * vtkiSize.y on pixels: x, y in 14 bits each;
                         // place among the tile's receivers, or VTKI_PROXY_SHARED: its own receiver
};

void vtkiAppend(int list, ivec2 pixel, int number)
{
  uint place = atomicAdd(vtkiCommands[list].w, 1u);
  vtkiEntries[uint(list * vtkiSize.x * vtkiSize.y) + place] =
    uint(pixel.x) | (uint(pixel.y) << 14) | (uint(number) << 28);
  if (place % 256u == 0u)
  {
    atomicAdd(vtkiCommands[list].x, 1u);
  }
}

// Returns false past the end of the list.
bool vtkiFetchEntry(int list, uint place, out ivec2 pixel, out int number)
{
  bool inside = place < vtkiCommands[list].w;
  uint entry = vtkiEntries[uint(list * vtkiSize.x * vtkiSize.y) + (inside ? place : 0u)];
  pixel = ivec2(int(entry & 16383u), int((entry >> 14) & 16383u));
  number = int(entry >> 28);
  return inside;
}
