// Evaluates up to four texels, or pixels, under each of VTKI_BLOCKS split texels. Lights are
// fetched once for all of them: llvmpipe spends most time on these fetches and is three times as
// fast with two blocks as with single texels. VTKI_SHARES_LOOKS: two of the four texels test
// visibility for all.
#include "vtkIndirectSubsplatLeaf.glsl"

#ifndef VTKI_PIXELS
layout(VTKI_FORMAT) uniform image2D vtkiVectorImage;
#endif
layout(VTKI_FORMAT) uniform image2D vtkiIrradianceImage;

void vtkiStoreLeaf(ivec2 texel, vec3 normal, vec3 irradiance, vec3 vectorIrradiance)
{
  mat3 rotation = mat3(vtkiViewToScene);
  vec3 value = irradiance * vtkiStorageScale;
#ifdef VTKI_PIXELS
  vec2 ndc = 2.0f * (vec2(texel) + 0.5f) / vec2(vtkiSize) - 1.0f;
  value *= vtkiDetail(ndc, normal * rotation);
  imageStore(vtkiIrradianceImage, texel, vec4(value, 1.0f));
#else
  // The alpha of both images was written before; keep it.
  float state = imageLoad(vtkiIrradianceImage, texel).a;
  float parted = imageLoad(vtkiVectorImage, texel).a;
  imageStore(vtkiIrradianceImage, texel, vec4(value, state));
  imageStore(vtkiVectorImage, texel,
    vec4((vectorIrradiance * rotation) * vtkiStorageScale, parted));
#endif
}

#ifdef VTKI_SEGMENTS
// One child at a time: the walks to the lights take most time and differ between children.
void vtkiEvaluateChild(ivec2 block, int child, bool exists)
{
  ivec2 texel = 2 * block + ivec2(child & 1, child >> 1);
  vec3 position;
  vec3 normal;
  vec3 facet;
  bool wanted = vtkiFetchLeaf(texel, position, normal, facet) && exists;
  vec3 irradiance;
  vec3 vectorIrradiance;
  vtkiEvaluateSubsplat(position, normal, facet, vtkiTexelPixel(texel), wanted, irradiance, vectorIrradiance);
  if (wanted)
  {
    vtkiStoreLeaf(texel, normal, irradiance, vectorIrradiance);
  }
}
#else
#ifdef VTKI_SHARES_LOOKS
#include "vtkIndirectSubsplatLooks.glsl"
#endif

#ifdef VTKI_DEPTH_TILES
vtkiCrease vtkiCreasesOfBlocks[4 * VTKI_BLOCKS]; // of the receivers

// Written in a function before the functions that read the array: Mesa 26 warns otherwise.
void vtkiKeepCrease(int i, ivec2 pixel)
{
  vtkiCreasesOfBlocks[i] = vtkiFetchCrease(pixel);
}
#endif

#ifdef VTKI_SHARES_LOOKS
#define VTKI_LOOKS_OF_BLOCKS , vtkiLooks looks[VTKI_BLOCKS]
#define VTKI_WITH_LOOKS , looks
#else
#define VTKI_LOOKS_OF_BLOCKS
#define VTKI_WITH_LOOKS
#endif

// Share of a light that each receiver sees.
void vtkiFindShares(int light, vec4 sender, vec4 senderNormal, vec3 position[4 * VTKI_BLOCKS],
  vec3 normal[4 * VTKI_BLOCKS], vec3 facet[4 * VTKI_BLOCKS] VTKI_LOOKS_OF_BLOCKS, out float share[4 * VTKI_BLOCKS])
{
#ifdef VTKI_SHARES_LOOKS
  vtkiTile tile = vtkiFetchTile(light, sender.xyz, senderNormal.xyz);
  for (int block = 0; block < VTKI_BLOCKS; ++block)
  {
    bool seen[VTKI_LOOKS];
    for (int i = 0; i < VTKI_LOOKS; ++i)
    {
      // Directions have no tile and are not tested.
      seen[i] = sender.w < 0.0f ||
        vtkiIsSeenInTile(tile, looks[block].position[i], looks[block].normal[i]);
    }
    for (int i = 0; i < 4; ++i)
    {
      share[4 * block + i] = (looks[block].second[i] ? seen[1] : seen[0]) ? 1.0f : 0.0f;
    }
  }
#else
  for (int i = 0; i < 4 * VTKI_BLOCKS; ++i)
  {
    share[i] = 1.0f;
#ifdef VTKI_VISIBILITY
    share[i] = vtkiIsSenderVisible(light, vtkiOpenPlace(position[i], normal[i], facet[i]), position[i], normal[i], sender,
      senderNormal.xyz, true) ? 1.0f : 0.0f;
#endif
  }
#endif
#ifdef VTKI_DEPTH_TILES
  for (int i = 0; i < 4 * VTKI_BLOCKS; ++i)
  {
    bool hidden = sender.w >= 0.0f &&
      vtkiHidesInCrease(vtkiCreasesOfBlocks[i], position[i], sender.xyz - position[i]);
    share[i] = hidden ? 0.0f : share[i];
  }
#endif
}

#ifdef VTKI_DIVIDED
vtkiSight vtkiSights[4 * VTKI_BLOCKS];  // of the receivers
uvec4 vtkiSeenLights[4 * VTKI_BLOCKS]; // bits of the lights that each receiver sees

void vtkiStartSights()
{
  for (int i = 0; i < 4 * VTKI_BLOCKS; ++i)
  {
    vtkiSights[i] = vtkiSight(0.0f, 0.0f);
  }
}

void vtkiForgetLights()
{
  for (int i = 0; i < 4 * VTKI_BLOCKS; ++i)
  {
    vtkiSeenLights[i] = uvec4(0u);
  }
}
#endif

// Adds the light of a cluster as a whole to all blocks. Returns true if one of them is near to it.
// place: of the light among those that are summed at once.
bool vtkiAddToBlocks(int light, int place, vec4 sender, vec4 senderNormal, vec3 density, vec3 position[4 * VTKI_BLOCKS],
  vec3 normal[4 * VTKI_BLOCKS], vec3 facet[4 * VTKI_BLOCKS] VTKI_LOOKS_OF_BLOCKS, inout vec3 irradiance[4 * VTKI_BLOCKS],
  inout vec3 vectorIrradiance[4 * VTKI_BLOCKS])
{
  float share[4 * VTKI_BLOCKS];
  vtkiFindShares(light, sender, senderNormal, position, normal, facet VTKI_WITH_LOOKS, share);
  bool isNear = false;
  for (int i = 0; i < 4 * VTKI_BLOCKS; ++i)
  {
#ifdef VTKI_DIVIDED
    vec3 toSender = sender.xyz - position[i];
    float division = vtkiDivision(dot(toSender, toSender), senderNormal.w);
    vtkiSeenLights[i] |= share[i] > 0.0f ? vtkiLightBit(place) : uvec4(0u);
    isNear = vtkiKeepSight(vtkiSights[i], facet[i], normal[i], toSender, senderNormal, division, share[i]) || isNear;
    share[i] -= share[i] * division;
#endif
    vtkiAddSeenLight(position[i], normal[i], share[i], vtkiSoftening(senderNormal.w, sender.w), sender, senderNormal,
      density, irradiance[i], vectorIrradiance[i]);
  }
  return isNear;
}

#ifdef VTKI_DIVIDED
// Adds the light of a cluster's branches to all blocks.
void vtkiAddBranchesToBlocks(int light, int place, vec3 position[4 * VTKI_BLOCKS], vec3 normal[4 * VTKI_BLOCKS],
  vec3 facet[4 * VTKI_BLOCKS], inout vec3 irradiance[4 * VTKI_BLOCKS], inout vec3 vectorIrradiance[4 * VTKI_BLOCKS])
{
  vec4 sender;
  vec4 senderNormal;
  vec3 density;
  vtkiFetchLight(light, sender, senderNormal, density);
  float share[4 * VTKI_BLOCKS];
  float below[4 * VTKI_BLOCKS];
  for (int i = 0; i < 4 * VTKI_BLOCKS; ++i)
  {
    vec3 toSender = sender.xyz - position[i];
    float seen = any(notEqual(vtkiSeenLights[i] & vtkiLightBit(place), uvec4(0u))) ? 1.0f : 0.0f;
    share[i] = vtkiShareOfBranches(vtkiSights[i], facet[i], toSender, seen) *
      vtkiDivision(dot(toSender, toSender), senderNormal.w);
    below[i] = 0.0f;
  }
  int node = 0;
  while (node < VTKI_BRANCHES)
  {
    vec4 branch;
    vtkiFetchBranch(vtkiFirstLight + light, node, sender, senderNormal, branch);
    bool isChild = vtkiIsChild(node);
    float nearest = 0.0f;
    for (int i = 0; i < 4 * VTKI_BLOCKS; ++i)
    {
      vec3 toSender = sender.xyz - position[i];
      below[i] = isChild
        ? share[i] * vtkiDivisionOfChild(normal[i], toSender, senderNormal.xyz, senderNormal.w)
        : below[i];
      nearest = max(nearest, below[i]);
      vtkiAddSeenLight(position[i], normal[i], isChild ? share[i] - below[i] : below[i], branch.w, sender, senderNormal,
        branch.rgb, irradiance[i], vectorIrradiance[i]);
    }
    node = vtkiNextBranch(node, senderNormal.w, nearest > 0.0f);
  }
}
#endif

// blocks: indices of split texels, one level above the evaluated texels; exists: false for an
// unused index.
void vtkiEvaluateBlocks(ivec2 blocks[VTKI_BLOCKS], bool exists[VTKI_BLOCKS])
{
  vec3 position[4 * VTKI_BLOCKS];
  vec3 normal[4 * VTKI_BLOCKS];
  vec3 facet[4 * VTKI_BLOCKS];
  vec3 irradiance[4 * VTKI_BLOCKS];
  vec3 vectorIrradiance[4 * VTKI_BLOCKS];
  bool wanted[4 * VTKI_BLOCKS];
  for (int i = 0; i < 4 * VTKI_BLOCKS; ++i)
  {
    ivec2 texel = 2 * blocks[i >> 2] + ivec2(i & 1, (i >> 1) & 1);
    wanted[i] = vtkiFetchLeaf(texel, position[i], normal[i], facet[i]) && exists[i >> 2];
    irradiance[i] = vec3(0.0f);
    vectorIrradiance[i] = vec3(0.0f);
#ifdef VTKI_DEPTH_TILES
    vtkiKeepCrease(i, vtkiTexelPixel(texel));
#endif
  }
#ifdef VTKI_DIVIDED
  vtkiStartSights();
#endif
#ifdef VTKI_SHARES_LOOKS
  vtkiLooks looks[VTKI_BLOCKS];
  for (int block = 0; block < VTKI_BLOCKS; ++block)
  {
    vec3 positions[4];
    vec3 normals[4];
    bool leaves[4];
    for (int i = 0; i < 4; ++i)
    {
      positions[i] = position[4 * block + i];
      normals[i] = facet[4 * block + i];
      leaves[i] = wanted[4 * block + i];
    }
    looks[block] = vtkiMakeLooks(positions, normals, leaves);
  }
#endif
#ifdef VTKI_DIVIDED
  const int atOnce = VTKI_NEAR_LIGHTS;
#else
  int atOnce = vtkiLightCount;
#endif
  for (int first = 0; first < vtkiLightCount; first += atOnce)
  {
    int end = min(first + atOnce, vtkiLightCount);
    uvec4 near = uvec4(0u);
#ifdef VTKI_DIVIDED
    vtkiForgetLights();
#endif
    for (int light = first; light < end; ++light)
    {
      vec4 sender;
      vec4 senderNormal;
      vec3 density;
      vtkiFetchLight(light, sender, senderNormal, density);
      bool isNear = vtkiAddToBlocks(vtkiFirstLight + light, light - first, sender, senderNormal, density,
        position, normal, facet VTKI_WITH_LOOKS, irradiance, vectorIrradiance);
#ifdef VTKI_DIVIDED
      vtkiKeepNear(near, light - first, isNear);
#endif
    }
#ifdef VTKI_DIVIDED
    while (vtkiHasNear(near))
    {
      int place = vtkiTakeNear(near);
      vtkiAddBranchesToBlocks(first + place, place, position, normal, facet, irradiance, vectorIrradiance);
    }
#endif
  }
  for (int i = 0; i < 4 * VTKI_BLOCKS; ++i)
  {
    ivec2 texel = 2 * blocks[i >> 2] + ivec2(i & 1, (i >> 1) & 1);
    if (wanted[i])
    {
      vtkiStoreLeaf(texel, normal[i], irradiance[i], vectorIrradiance[i]);
    }
  }
}
#endif
