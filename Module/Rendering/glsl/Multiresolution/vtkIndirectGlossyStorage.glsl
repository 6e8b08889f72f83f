// Lists of texels, each with the set of lights that it still has to resolve; see
// vtkIndirectGlossyLists.h. Each level has two lists: split texels and whole ones.
#define VTKI_GLOSSY_LISTS 32
#define VTKI_GLOSSY_GROUP 64u
#define VTKI_GLOSSY_HEADER 2u // x, y in 16 bits each; the limit below which a light is not refined

layout(std430) buffer vtkiGlossyLists
{
  uvec4 vtkiGlossyCommand[VTKI_GLOSSY_LISTS]; // groups of the dispatch, and the number of entries
  uint vtkiGlossyEntry[];                     // header, then a bit a light
};
uniform int vtkiGlossyWords; // words of a set
uniform int vtkiLightCount;

uint vtkiGlossyStride()
{
  return VTKI_GLOSSY_HEADER + uint(vtkiGlossyWords);
}

// Opens an entry, whose set is written word by word, and returns its begin.
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
