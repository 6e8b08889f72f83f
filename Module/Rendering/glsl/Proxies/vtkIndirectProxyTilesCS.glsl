//VTK::System::Dec
// A group of invocations for each tile of 16 x 16 receivers. If spheres are in groups
// (VTKI_PROXY_TREE) each invocation descends their tree by itself; otherwise the group lists the
// spheres whose regions meet the bounding box of its receivers, a bit set for a block of 256 at a
// time, and sums those in order.
//
// The receivers are every vtkiStep-th pixel, whose light goes to coarse images; with
// VTKI_PROXY_PIXELS all pixels, or with VTKI_PROXY_REST those of a list, whose light goes to images
// of tiles' receivers; or with VTKI_PROXY_SENDERS the spheres themselves, 256 in a row, whose
// irradiance goes to their table.
#include "vtkIndirectReceiverGrid.glsl"
#include "vtkIndirectProxySum.glsl"
#include "vtkIndirectProxySenders.glsl"
#ifdef VTKI_PROXY_REST
#include "vtkIndirectProxyTile.glsl"
#include "vtkIndirectProxyList.glsl"
#endif

layout(local_size_x = 16, local_size_y = 16) in;
#ifdef VTKI_PROXY_SENDERS
layout(rgba32f, binding = 0) uniform image2D vtkiLight0;
layout(rgba32f, binding = 1) uniform image2D vtkiLight1;
layout(rgba32f, binding = 2) uniform image2D vtkiLight2;
layout(rgba32f, binding = 3) uniform image2D vtkiLight3;
#else
#if defined(VTKI_PROXY_PIXELS) || defined(VTKI_PROXY_REST)
layout(rgba32f, binding = 4) uniform image2D vtkiSkyImage;
layout(rgba32f, binding = 5) uniform image2D vtkiBounceImage;
#endif
#ifndef VTKI_PROXY_PIXELS
layout(rgba32f, binding = 0) uniform image2D vtkiCoarseImage0;
layout(rgba32f, binding = 1) uniform image2D vtkiCoarseImage1;
layout(rgba32f, binding = 2) uniform image2D vtkiCoarseImage2;
layout(rgba32f, binding = 3) uniform image2D vtkiCoarseImage3;
#endif
#endif

#ifdef VTKI_PROXY_TREE
vtkiProxySums vtkiSumTile(vec3 position, vec3 normal, bool lit)
{
  return vtkiSumProxies(position, normal, lit);
}
#else
#include "vtkIndirectTileBox.glsl"
shared uint vtkiListed[VTKI_ROW_LENGTH / 32];

// Returns the sums for each invocation's receiver, if `lit`.
vtkiProxySums vtkiSumTile(vec3 position, vec3 normal, bool lit)
{
  int number = int(gl_LocalInvocationIndex);
  barrier();
  vtkiBeginBox();
  if (lit)
  {
    vtkiAddToBox(position);
  }
  vec3 middle;
  vec3 halfSize;
  bool some = vtkiEndBox(middle, halfSize);

  vtkiProxySums sums = vtkiNoProxies();
  for (int block = 0; block < vtkiBlockCount && some; ++block)
  {
    if (!vtkiMeetsBlock(block, middle, halfSize))
    {
      continue; // uniform over the group
    }
    if (number < VTKI_ROW_LENGTH / 32)
    {
      vtkiListed[number] = 0u;
    }
    barrier();
    int entry = block * VTKI_ROW_LENGTH + number;
    if (entry < vtkiProxyCount)
    {
      ivec2 at = vtkiTableTexel(entry);
      vec3 center = texelFetch(vtkiProxyCenter, at, 0).xyz;
      vtkiRegion region = vtkiUnpackRegion(texelFetch(vtkiProxyRegion, at, 0));
      if (vtkiProxyMeetsBox(middle, halfSize, center + region.ToOuter, region.Outer, center, region.Inner))
      {
        atomicOr(vtkiListed[number >> 5], 1u << uint(number & 31));
      }
    }
    barrier();
    for (int word = 0; word < VTKI_ROW_LENGTH / 32; ++word)
    {
      uint bits = lit ? vtkiListed[word] : 0u;
      while (bits != 0u)
      {
        int next = block * VTKI_ROW_LENGTH + 32 * word + findLSB(bits);
        bits &= bits - 1u;
        vtkiAddProxy(position, normal, next, sums);
      }
    }
    barrier();
  }
  return sums;
}
#endif

#ifdef VTKI_PROXY_SENDERS
void main()
{
  int number = int(gl_WorkGroupID.x) * VTKI_ROW_LENGTH + int(gl_LocalInvocationIndex);
  bool inside = number < vtkiSenderCount;
  vec4 place;
  vec4 normal;
  vtkiFetchSender(inside ? number : 0, place, normal);
  vtkiProxySums around = vtkiSumTile(place.xyz, vec3(0.0f), inside && !(normal.w > 0.0f));
  vtkiOpenSender(around, place, normal);
  vtkiProxySums sums = vtkiSumTile(place.xyz, normal.xyz, inside);
  vec4 light[4];
  vtkiLightOfSender(sums, place, normal, light);
  bool sphere = !(normal.w > 0.0f);
  if (sphere)
  {
    vtkiTurnSender(place, normal);
  }
  sums = vtkiSumTile(place.xyz, normal.xyz, inside && sphere);
  if (sphere)
  {
    vec4 front[4] = light;
    vec4 back[4];
    vtkiLightOfSender(sums, place, normal, back);
    vtkiLightOfSides(front, back, -normal.xyz, light);
  }
  if (inside)
  {
    imageStore(vtkiLight0, vtkiTableTexel(number), light[0]);
    imageStore(vtkiLight1, vtkiTableTexel(number), light[1]);
    imageStore(vtkiLight2, vtkiTableTexel(number), light[2]);
    imageStore(vtkiLight3, vtkiTableTexel(number), light[3]);
  }
}
#else
void main()
{
  ivec2 place = ivec2(gl_GlobalInvocationID.xy);
#if defined(VTKI_PROXY_REST)
  uint number = gl_WorkGroupID.x * 256u + gl_LocalInvocationIndex;
  ivec2 pixel;
  int slot;
  bool inside = vtkiFetchEntry(VTKI_PROXY_RECEIVERS, number, pixel, slot);
  ivec2 tile = pixel / VTKI_PROXY_TILE;
  place = vtkiSharedTexel(tile, slot);
#elif defined(VTKI_PROXY_PIXELS)
  ivec2 pixel = min(place, vtkiSize - 1);
  bool inside = place.x < vtkiSize.x && place.y < vtkiSize.y;
#else
  ivec2 pixel = vtkiSamplePixel(place);
  bool inside = place.x < vtkiCoarseSize.x && place.y < vtkiCoarseSize.y;
#endif
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver) && inside;
  vtkiProxySums sums = vtkiSumTile(receiver.position, receiver.normal, lit);
  vtkiProxyLit result = vtkiResolveProxies(receiver.position, receiver.normal, sums);
#if defined(VTKI_PROXY_PIXELS) || defined(VTKI_PROXY_REST)
#ifdef VTKI_PROXY_REST
  bool alone = slot == VTKI_PROXY_SHARED;
#else
  bool alone = true;
#endif
  if (inside && alone)
  {
    vec3 sky = lit ? vtkiProxyIrradiance(result.sky, receiver.normal) : vec3(0.0f);
    imageStore(vtkiSkyImage, pixel, vec4(sky, 1.0f));
#ifdef VTKI_PROXY_LIGHT
    imageStore(vtkiBounceImage, pixel, vec4(lit ? result.bounce : vec3(0.0f), 1.0f));
#endif
  }
  inside = inside && !alone;
#endif
#ifndef VTKI_PROXY_PIXELS
#ifdef VTKI_PROXY_REST
  ivec2 own = pixel - tile * VTKI_PROXY_TILE;
  float marked = float(own.y * VTKI_PROXY_TILE + own.x);
#else
  float marked = 1.0f;
#endif
  if (inside)
  {
    imageStore(vtkiCoarseImage0, place, result.sky[0]);
    imageStore(vtkiCoarseImage1, place, result.sky[1]);
    imageStore(vtkiCoarseImage2, place, result.sky[2]);
#if defined(VTKI_PROXY_LIGHT) || defined(VTKI_PROXY_REST)
    imageStore(vtkiCoarseImage3, place, vec4(result.bounce, marked));
#endif
  }
#endif
}
#endif
