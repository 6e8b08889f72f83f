// Evaluates up to four texels, or pixels, under each of VTKI_BLOCKS texels that are split. Lights are
// fetched once for all of them: on llvmpipe, where the fetch is what takes time, with two of them
// three times as fast as one by one. VTKI_SHARES_LOOKS: two of the four ask for all whether lights are seen.
#include "vtkIndirectSubsplatLeaf.glsl"

#ifndef VTKI_PIXELS
layout(VTKI_FORMAT) uniform image2D vtkiVectorImage;
#endif
layout(VTKI_FORMAT) uniform image2D vtkiIrradianceImage;

// Stores what was summed for a texel.
void vtkiStoreLeaf(ivec2 texel, vec3 normal, vec3 irradiance, vec3 vectorIrradiance)
{
  mat3 rotation = mat3(vtkiViewToScene);
  vec3 value = irradiance * vtkiStorageScale;
#ifdef VTKI_PIXELS
  vec2 ndc = 2.0f * (vec2(texel) + 0.5f) / vec2(vtkiSize) - 1.0f;
  value *= vtkiDetail(ndc, normal * rotation);
  imageStore(vtkiIrradianceImage, texel, vec4(value, 1.0f));
#else
  // What lies around was marked before.
  float state = imageLoad(vtkiIrradianceImage, texel).a;
  float parted = imageLoad(vtkiVectorImage, texel).a;
  imageStore(vtkiIrradianceImage, texel, vec4(value, state));
  imageStore(vtkiVectorImage, texel,
    vec4((vectorIrradiance * rotation) * vtkiStorageScale, parted));
#endif
}

#ifdef VTKI_SEGMENTS
// One at a time: the ways to the lights are what takes time, and differ.
void vtkiEvaluateChild(ivec2 block, int child, bool exists)
{
  ivec2 texel = 2 * block + ivec2(child & 1, child >> 1);
  vec3 position;
  vec3 normal;
  bool wanted = vtkiFetchLeaf(texel, position, normal) && exists;
  vec3 irradiance;
  vec3 vectorIrradiance;
  vtkiEvaluateSubsplat(position, normal, wanted, irradiance, vectorIrradiance);
  if (wanted)
  {
    vtkiStoreLeaf(texel, normal, irradiance, vectorIrradiance);
  }
}
#else
#ifdef VTKI_SHARES_LOOKS
#include "vtkIndirectSubsplatLooks.glsl"
#endif

#ifdef VTKI_DIVIDED
// What all receivers get of a node and what is below it, where they take a share of that.
void vtkiAddBranchesToBlocks(int light, vec3 position[4 * VTKI_BLOCKS], vec3 normal[4 * VTKI_BLOCKS],
  float share[4 * VTKI_BLOCKS], inout vec3 irradiance[4 * VTKI_BLOCKS], inout vec3 vectorIrradiance[4 * VTKI_BLOCKS])
{
  for (int child = 0; child < VTKI_BRANCHES_PER_NODE; ++child)
  {
    vec4 sender;
    vec4 senderNormal;
    vec3 density;
    vtkiFetchBranch(VTKI_BRANCHES * light + child, sender, senderNormal, density);
    float below[4 * VTKI_BLOCKS];
    float most = 0.0f;
    for (int i = 0; i < 4 * VTKI_BLOCKS; ++i)
    {
      below[i] = share[i] * vtkiDivision(sender.xyz - position[i], senderNormal.w);
      most = max(most, below[i]);
      vtkiAddNode(position[i], normal[i], share[i] - below[i], sender, senderNormal.xyz, density, irradiance[i],
        vectorIrradiance[i]);
    }
    int leaves = most > 0.0f ? VTKI_BRANCHES_PER_NODE : 0;
    int first = VTKI_BRANCHES * light + VTKI_BRANCHES_PER_NODE * (1 + child);
    for (int leaf = 0; leaf < leaves; ++leaf)
    {
      vtkiFetchBranch(first + leaf, sender, senderNormal, density);
      for (int i = 0; i < 4 * VTKI_BLOCKS; ++i)
      {
        vtkiAddNode(position[i], normal[i], below[i], sender, senderNormal.xyz, density, irradiance[i],
          vectorIrradiance[i]);
      }
    }
  }
}
#endif

// What all blocks get of a light.
void vtkiAddToBlocks(int light, vec4 sender, vec4 senderNormal, vec3 density, vec3 position[4 * VTKI_BLOCKS],
  vec3 normal[4 * VTKI_BLOCKS],
#ifdef VTKI_SHARES_LOOKS
  vtkiLooks looks[VTKI_BLOCKS],
#endif
  inout vec3 irradiance[4 * VTKI_BLOCKS], inout vec3 vectorIrradiance[4 * VTKI_BLOCKS])
{
#ifdef VTKI_DIVIDED
  float division[4 * VTKI_BLOCKS];
  float most = 0.0f;
  for (int i = 0; i < 4 * VTKI_BLOCKS; ++i)
  {
    division[i] = vtkiDivision(sender.xyz - position[i], senderNormal.w);
    most = max(most, division[i]);
  }
#endif
#ifdef VTKI_SHARES_LOOKS
  vtkiTile tile = vtkiFetchTile(light, sender.xyz, senderNormal.xyz);
  for (int block = 0; block < VTKI_BLOCKS; ++block)
  {
    bool seen[VTKI_LOOKS];
    for (int i = 0; i < VTKI_LOOKS; ++i)
    {
      // A direction has no tile.
      seen[i] = sender.w < 0.0f ||
        vtkiIsSeenInTile(tile, looks[block].position[i], looks[block].normal[i]);
    }
    for (int i = 0; i < 4; ++i)
    {
      int child = 4 * block + i;
      float share = (looks[block].second[i] ? seen[1] : seen[0]) ? 1.0f : 0.0f;
#ifdef VTKI_DIVIDED
      division[child] *= share;
      share -= division[child];
#endif
      vtkiAddSeenLight(position[child], normal[child], share, sender, senderNormal.xyz, density, irradiance[child],
        vectorIrradiance[child]);
    }
  }
#else
  for (int i = 0; i < 4 * VTKI_BLOCKS; ++i)
  {
    float share = 1.0f;
#ifdef VTKI_VISIBILITY
    share = vtkiIsSenderVisible(light, position[i], position[i], normal[i], sender, senderNormal.xyz, true)
      ? 1.0f : 0.0f;
#endif
#ifdef VTKI_DIVIDED
    division[i] *= share;
    share -= division[i];
#endif
    vtkiAddSeenLight(position[i], normal[i], share, sender, senderNormal.xyz, density, irradiance[i],
      vectorIrradiance[i]);
  }
#endif
#ifdef VTKI_DIVIDED
  if (most > 0.0f)
  {
    vtkiAddBranchesToBlocks(light, position, normal, division, irradiance, vectorIrradiance);
  }
#endif
}

// blocks: indices of texels that are split, one level above those that are evaluated; exists: whether
// there is one.
void vtkiEvaluateBlocks(ivec2 blocks[VTKI_BLOCKS], bool exists[VTKI_BLOCKS])
{
  vec3 position[4 * VTKI_BLOCKS];
  vec3 normal[4 * VTKI_BLOCKS];
  vec3 irradiance[4 * VTKI_BLOCKS];
  vec3 vectorIrradiance[4 * VTKI_BLOCKS];
  bool wanted[4 * VTKI_BLOCKS];
  for (int i = 0; i < 4 * VTKI_BLOCKS; ++i)
  {
    ivec2 texel = 2 * blocks[i >> 2] + ivec2(i & 1, (i >> 1) & 1);
    wanted[i] = vtkiFetchLeaf(texel, position[i], normal[i]) && exists[i >> 2];
    irradiance[i] = vec3(0.0f);
    vectorIrradiance[i] = vec3(0.0f);
  }
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
      normals[i] = normal[4 * block + i];
      leaves[i] = wanted[4 * block + i];
    }
    looks[block] = vtkiMakeLooks(positions, normals, leaves);
  }
#endif
  for (int light = 0; light < vtkiBlockCount; ++light)
  {
    vec4 sender = vtkiBlockPosition[light];
    vec4 senderNormal = vtkiBlockNormal[light];
    vec3 density = vtkiBlockDensity[light].rgb;
    vtkiAddToBlocks(vtkiFirstLight + light, sender, senderNormal, density, position, normal,
#ifdef VTKI_SHARES_LOOKS
      looks,
#endif
      irradiance, vectorIrradiance);
  }
  for (int light = vtkiBlockCount; light < vtkiLightCount; ++light)
  {
    vec4 sender;
    vec4 senderNormal;
    vec3 density;
    vtkiFetchLight(light, sender, senderNormal, density);
    vtkiAddToBlocks(vtkiFirstLight + light, sender, senderNormal, density, position, normal,
#ifdef VTKI_SHARES_LOOKS
      looks,
#endif
      irradiance, vectorIrradiance);
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
