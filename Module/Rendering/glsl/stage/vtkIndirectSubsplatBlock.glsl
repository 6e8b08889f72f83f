// Evaluates up to four texels, or pixels, under one texel that is split. Lights are fetched once
// for the four: on llvmpipe, where the fetch is what takes time, 2.6 times as fast as one by one.
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
  imageStore(vtkiIrradianceImage, texel, vec4(value, state));
  imageStore(vtkiVectorImage, texel,
    vec4((vectorIrradiance * rotation) * vtkiStorageScale, 0.0f));
#endif
}

#ifdef VTKI_OCCUPANCY
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
// block: index of the texel that is split, one level above those that are evaluated; exists: whether
// there is one.
void vtkiEvaluateBlock(ivec2 block, bool exists)
{
  vec3 position[4];
  vec3 normal[4];
  vec3 irradiance[4];
  vec3 vectorIrradiance[4];
  bool wanted[4];
  for (int i = 0; i < 4; ++i)
  {
    ivec2 texel = 2 * block + ivec2(i & 1, i >> 1);
    wanted[i] = vtkiFetchLeaf(texel, position[i], normal[i]) && exists;
    irradiance[i] = vec3(0.0f);
    vectorIrradiance[i] = vec3(0.0f);
  }
  for (int light = 0; light < vtkiBlockCount; ++light)
  {
    vec4 sender = vtkiBlockPosition[light];
    vec3 senderNormal = vtkiBlockNormal[light].xyz;
    vec3 density = vtkiBlockDensity[light].rgb;
    for (int i = 0; i < 4; ++i)
    {
      vtkiAddLight(position[i], normal[i], position[i], sender, senderNormal, density, irradiance[i],
        vectorIrradiance[i]);
    }
  }
  for (int light = vtkiBlockCount; light < vtkiLightCount; ++light)
  {
    vec4 sender;
    vec3 senderNormal;
    vec3 density;
    vtkiFetchLight(light, sender, senderNormal, density);
    for (int i = 0; i < 4; ++i)
    {
      vtkiAddLight(position[i], normal[i], position[i], sender, senderNormal, density, irradiance[i],
        vectorIrradiance[i]);
    }
  }
  for (int i = 0; i < 4; ++i)
  {
    ivec2 texel = 2 * block + ivec2(i & 1, i >> 1);
    if (wanted[i])
    {
      vtkiStoreLeaf(texel, normal[i], irradiance[i], vectorIrradiance[i]);
    }
  }
}
#endif
