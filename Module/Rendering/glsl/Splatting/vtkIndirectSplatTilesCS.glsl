//VTK::System::Dec
// A group of invocations for each tile of 16 x 16 pixels lists the splats that meet the bounding
// box of the tile's surfaces, a bit set for 256 of them at a time, and sums those in the order of
// their numbers.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectSplatLobe.glsl"
#include "vtkIndirectSplatBounds.glsl"
#include "vtkIndirectSplatTile.glsl"
#include "vtkIndirectTileBox.glsl"

#ifdef VTKI_DIVIDED
const int vtkiAtOnce = VTKI_NEAR_LIGHTS;
#else
const int vtkiAtOnce = VTKI_ROW_LENGTH;
#endif

// Sums the listed splats of a row from one number on: clusters as a whole, which tell what the
// receiver sees, and then the branches of those it is near to. The fourth component counts splats.
vec4 vtkiSumListed(vtkiReceiver receiver, vec3 open, int firstOfRow, int first, float low)
{
  vec4 sum = vec4(0.0f);
  uvec4 near = uvec4(0u);
  for (int word = first / 32; word < (first + vtkiAtOnce) / 32; ++word)
  {
    uint bits = vtkiListed[word];
    while (bits != 0u)
    {
      int number = 32 * word + findLSB(bits);
      bits &= bits - 1u;
      bool isNear =
        vtkiAddSplat(receiver.position, receiver.normal, open, firstOfRow + number, low, sum.rgb);
      sum.a += 1.0f;
#ifdef VTKI_DIVIDED
      vtkiKeepNear(near, number - first, isNear);
#endif
    }
  }
#ifdef VTKI_DIVIDED
  while (vtkiHasNear(near))
  {
    int number = first + vtkiTakeNear(near);
    vtkiAddSplatBelow(receiver.position, receiver.normal, open, firstOfRow + number, low, sum.rgb);
  }
#endif
  return sum;
}

void main()
{
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  int number = int(gl_LocalInvocationIndex);
  vtkiReceiver receiver;
  bool inside = pixel.x < vtkiSize.x && pixel.y < vtkiSize.y;
  bool lit = vtkiFetchReceiver(min(pixel, vtkiSize - 1), receiver) && inside;
  vtkiBeginBox();
  if (lit)
  {
    vtkiAddToBox(receiver.position);
  }
  vec3 middle;
  vec3 halfSize;
  bool any = vtkiEndBox(middle, halfSize);

  float low = vtkiSplatLow();
  vec3 open = receiver.position;
  if (lit)
  {
    open = vtkiSplatOpenPlace(receiver.position, receiver.normal, receiver.facet, min(pixel, vtkiSize - 1));
  }
  vec4 total = vec4(0.0f);
#ifdef VTKI_DIVIDED
  vtkiStartSight();
#endif
  for (int row = vtkiLightRows.x; row < vtkiLightRows.y && any; ++row)
  {
    vtkiClearLists(number);
    int light = row * VTKI_ROW_LENGTH + number;
    if (light < vtkiLightCount && vtkiSplatMeetsBox(vtkiFetchSplat(light), middle, halfSize))
    {
      atomicOr(vtkiListed[number >> 5], 1u << uint(number & 31));
    }
#ifdef VTKI_SPLAT_LOBES
    if (light < vtkiLightCount && vtkiSplatMeetsBox(vtkiFetchLobeSplat(light), middle, halfSize))
    {
      atomicOr(vtkiListedLobes[number >> 5], 1u << uint(number & 31));
    }
#endif
    barrier();
    // Sums by row keep rounding errors of long sums small.
    vec4 partial = vec4(0.0f);
    for (int first = 0; first < VTKI_ROW_LENGTH; first += vtkiAtOnce)
    {
      partial += vtkiSumListed(receiver, open, row * VTKI_ROW_LENGTH, first, low);
    }
#ifdef VTKI_SPLAT_LOBES
    for (int word = 0; word < VTKI_ROW_LENGTH / 32; ++word)
    {
      uint bits = vtkiListedLobes[word];
      while (bits != 0u)
      {
        int next = row * VTKI_ROW_LENGTH + 32 * word + findLSB(bits);
        bits &= bits - 1u;
        ivec2 at = vtkiTableTexel(next);
        partial += vec4(vtkiSplatLobe(receiver.position, receiver.normal, open, next,
          texelFetch(vtkiLightPosition, at, 0), texelFetch(vtkiLightNormal, at, 0).xyz,
          texelFetch(vtkiLobeDirection, at, 0), texelFetch(vtkiLobeDensity, at, 0).rgb, low), 1.0f);
      }
    }
#endif
    total += partial;
    barrier();
  }
  if (inside)
  {
    vtkiStoreSum(pixel, vec4(0.0f), lit ? total : vec4(0.0f));
  }
}
