// Receivers of a tile's pixels that no coarse receiver stands for.
const int VTKI_PROXY_TILE = 8;    // pixels along an edge
const int VTKI_PROXY_SHARED = 15; // at most, in a block of 4 x 4 texels

ivec2 vtkiSharedTexel(ivec2 tile, int number)
{
  return 4 * tile + ivec2(number & 3, number >> 2);
}
