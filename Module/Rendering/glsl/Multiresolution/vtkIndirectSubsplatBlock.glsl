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

// What all blocks get of a light.
void vtkiAddToBlocks(int light, vec4 sender, vec3 senderNormal, vec3 density, vec3 position[4 * VTKI_BLOCKS],
  vec3 normal[4 * VTKI_BLOCKS],
#ifdef VTKI_SHARES_LOOKS
  vtkiLooks looks[VTKI_BLOCKS],
#endif
  inout vec3 irradiance[4 * VTKI_BLOCKS], inout vec3 vectorIrradiance[4 * VTKI_BLOCKS])
{
#ifdef VTKI_SHARES_LOOKS
  vtkiTile tile = vtkiFetchTile(light, sender.xyz, senderNormal);
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
      vtkiAddSeenLight(position[child], normal[child], looks[block].second[i] ? seen[1] : seen[0], sender,
        senderNormal, density, irradiance[child], vectorIrradiance[child]);
    }
  }
#else
  for (int i = 0; i < 4 * VTKI_BLOCKS; ++i)
  {
    vtkiAddLight(position[i], normal[i], position[i], light, sender, senderNormal, density, irradiance[i],
      vectorIrradiance[i]);
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
    vec3 senderNormal = vtkiBlockNormal[light].xyz;
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
    vec3 senderNormal;
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
