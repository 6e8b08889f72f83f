// Receivers for a tile's pixels that no coarse receiver represents.
#include "vtkIndirectLibTable.glsl"

// Greatest number of a tile's receivers; the block's last texel marks none.
const int VTKI_PROXY_SHARED = VTKI_PROXY_BLOCK * VTKI_PROXY_BLOCK - 1;

ivec2 vtkiSharedTexel(ivec2 tile, int number)
{
  return VTKI_PROXY_BLOCK * tile + ivec2(number % VTKI_PROXY_BLOCK, number / VTKI_PROXY_BLOCK);
}
