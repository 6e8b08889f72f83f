// Lists of split texels; see vtkIndirectSubsplatList.h.
#define VTKI_LISTS 16
#define VTKI_GROUP 64u

layout(std430) buffer vtkiSubsplatLists
{
  uvec4 vtkiCommand[VTKI_LISTS]; // groups of the dispatch, and the number of entries
  uint vtkiEntry[];              // x, y in 16 bits each
};
uniform int vtkiList;
uniform int vtkiListFirst;

void vtkiAppend(ivec2 texel)
{
  uint place = atomicAdd(vtkiCommand[vtkiList].w, 1u);
  vtkiEntry[uint(vtkiListFirst) + place] = uint(texel.x) | (uint(texel.y) << 16);
  if (place % VTKI_GROUP == 0u)
  {
    atomicAdd(vtkiCommand[vtkiList].x, 1u);
  }
}
