// Receivers for a tile's pixels that no coarse receiver represents.
#include "vtkIndirectLibTable.glsl"

// This is the greatest number of a tile's receivers; the block's last texel marks none.
const int VTKI_PROXY_SHARED = VTKI_PROXY_BLOCK * VTKI_PROXY_BLOCK - 1;

ivec2 vtkiSharedTexel(ivec2 tile, int number)
{
  return VTKI_PROXY_BLOCK * tile + ivec2(number % VTKI_PROXY_BLOCK, number / VTKI_PROXY_BLOCK);
}

// A receiver with a smaller agreement represents no pixel: farther than 46 degrees from its normal
// its irradiance a + b n exceeds that of an open sky.
const float VTKI_LEAST_ALIKE = 0.05f;
