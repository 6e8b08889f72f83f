// Lists of texels with the set of lights that each still has to be resolved for; see
// vtkIndirectGlossyLists.h. Two lists a level: texels that are split, and whole ones.
#define VTKI_GLOSSY_LISTS 32
#define VTKI_GLOSSY_GROUP 64u
#define VTKI_GLOSSY_HEADER 2u // x, y in 16 bits each; the limit below which a light is left alone

layout(std430) buffer vtkiGlossyLists
{
  uvec4 vtkiGlossyCommand[VTKI_GLOSSY_LISTS]; // groups of the dispatch, and the number of entries
  uint vtkiGlossyEntry[];                     // header, then a bit a light
};
uniform int vtkiGlossyWords; // of a set
uniform int vtkiLightCount;

uint vtkiGlossyStride()
{
  return VTKI_GLOSSY_HEADER + uint(vtkiGlossyWords);
}

// Opens an entry; its set is written word by word. Returns where it begins.
uint vtkiAppendGlossy(int list, int first, ivec2 texel, float limit)
{
  uint place = atomicAdd(vtkiGlossyCommand[list].w, 1u);
  if (place % VTKI_GLOSSY_GROUP == 0u)
  {
    atomicAdd(vtkiGlossyCommand[list].x, 1u);
  }
  uint at = uint(first) + place * vtkiGlossyStride();
  vtkiGlossyEntry[at] = uint(texel.x) | (uint(texel.y) << 16);
  vtkiGlossyEntry[at + 1u] = floatBitsToUint(limit);
  return at;
}
