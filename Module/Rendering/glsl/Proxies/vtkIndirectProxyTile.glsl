// Receivers of a tile's pixels that no coarse receiver stands for.
#include "vtkIndirectLibTable.glsl"

// At most; the last texel of a block is for none.
const int VTKI_PROXY_SHARED = VTKI_PROXY_BLOCK * VTKI_PROXY_BLOCK - 1;

ivec2 vtkiSharedTexel(ivec2 tile, int number)
{
  return VTKI_PROXY_BLOCK * tile + ivec2(number % VTKI_PROXY_BLOCK, number / VTKI_PROXY_BLOCK);
}
