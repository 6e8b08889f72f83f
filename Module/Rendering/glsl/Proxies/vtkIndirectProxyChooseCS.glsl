//VTK::System::Dec
// Chooses receivers for the pixels whose alpha is negative, one invocation for each tile of 8 x 8
// pixels: among pixels that no receiver represents, the one that faces the eye most, until none is
// left. If the tile has too few receivers, each remaining pixel is summed by itself.
#include "vtkIndirectReceiverGrid.glsl"
#include "vtkIndirectProxyTile.glsl"
#include "vtkIndirectProxyList.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba32f, binding = 0) uniform image2D vtkiSkyImage;
layout(r32f, binding = 1) uniform image2D vtkiCountImage;

float vtkiFacesEye(vtkiReceiver receiver)
{
  return -dot(receiver.normalVC, normalize(receiver.positionVC));
}

void main()
{
  ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
  ivec2 corner = tile * VTKI_PROXY_TILE;
  ivec2 end = min(corner + VTKI_PROXY_TILE, vtkiSize);
  uint left[2] = uint[2](0u, 0u);
  int best = -1;
  float facing = -2.0f;
  vtkiReceiver receiver;
  for (int y = corner.y; y < end.y; ++y)
  {
    for (int x = corner.x; x < end.x; ++x)
    {
      int number = (y - corner.y) * VTKI_PROXY_TILE + x - corner.x;
      uint bit = imageLoad(vtkiSkyImage, ivec2(x, y)).a < 0.0f ? 1u << uint(number & 31) : 0u;
      left[0] |= number < 32 ? bit : 0u;
      left[1] |= number < 32 ? 0u : bit;
    }
  }
  for (int word = 0; word < 2; ++word)
  {
    uint bits = left[word];
    while (bits != 0u)
    {
      int number = 32 * word + findLSB(bits);
      bits &= bits - 1u;
      ivec2 at = corner + ivec2(number % VTKI_PROXY_TILE, number / VTKI_PROXY_TILE);
      vtkiAppend(VTKI_PROXY_SERVED, at, 0);
      vtkiFetchReceiver(at, receiver);
      float own = vtkiFacesEye(receiver);
      best = own > facing ? number : best;
      facing = max(own, facing);
    }
  }
  int count = 0;
  while (best >= 0 && count < VTKI_PROXY_SHARED)
  {
    ivec2 at = corner + ivec2(best % VTKI_PROXY_TILE, best / VTKI_PROXY_TILE);
    vtkiAppend(VTKI_PROXY_RECEIVERS, at, count);
    ++count;
    vtkiReceiver chosen;
    vtkiFetchReceiver(at, chosen);
    float distance = vtkiSampleDistance(chosen.depth);
    left[best >> 5] &= ~(1u << uint(best & 31));
    best = -1;
    facing = -2.0f;
    for (int word = 0; word < 2; ++word)
    {
      uint bits = left[word];
      while (bits != 0u)
      {
        int number = findLSB(bits);
        uint bit = 1u << uint(number);
        bits &= ~bit;
        number += 32 * word;
        vtkiFetchReceiver(corner + ivec2(number % VTKI_PROXY_TILE, number / VTKI_PROXY_TILE), receiver);
        bool served = vtkiAgreement(receiver, chosen, distance) > VTKI_LEAST_ALIKE;
        left[word] &= served ? ~bit : 0xffffffffu;
        float own = served ? -2.0f : vtkiFacesEye(receiver);
        best = own > facing ? number : best;
        facing = max(own, facing);
      }
    }
  }
  for (int word = 0; word < 2; ++word)
  {
    uint bits = left[word];
    while (bits != 0u)
    {
      int number = findLSB(bits);
      bits &= bits - 1u;
      number += 32 * word;
      ivec2 at = corner + ivec2(number % VTKI_PROXY_TILE, number / VTKI_PROXY_TILE);
      vtkiAppend(VTKI_PROXY_RECEIVERS, at, VTKI_PROXY_SHARED);
    }
  }
  if (all(lessThan(corner, vtkiSize)))
  {
    imageStore(vtkiCountImage, tile, vec4(float(count)));
  }
}
