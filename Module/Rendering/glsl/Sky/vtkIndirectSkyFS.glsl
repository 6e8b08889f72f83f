//VTK::System::Dec
//VTK::Output::Dec
// Direct irradiance from the sky: the sum over a block's visible directions, each with its own
// parallel depth map. VTKI_SKY_STEP: edge of a block of pixels, each of which sums other
// directions; pixels of one place in their blocks lie together in a part of the target and are
// drawn together. VTKI_SKY_PIXELS: 1, or the 4 pixels of a square, each into its own image:
// software spends most of its time on fetching directions, which are then fetched once for four
// pixels.
#ifndef VTKI_SKY_STEP
#define VTKI_SKY_STEP 2
#define VTKI_SKY_BLOCK 16
#endif
#ifndef VTKI_SKY_PIXELS
#define VTKI_SKY_PIXELS 1
#endif
#include "vtkIndirectSkyDirections.glsl"

uniform int vtkiSkyCount; // directions in the block
#if VTKI_SKY_STEP > 1
uniform ivec2 vtkiSkyPart;  // pixels of a part
uniform ivec2 vtkiSkyClass; // place of the pixels in their blocks
#endif
#ifdef VTKI_SKY_FRESH
uniform sampler2D vtkiSkyFresh; // blocks of pixels that sum directions
#endif

void main()
{
  ivec2 place = ivec2(gl_FragCoord.xy);
#if VTKI_SKY_STEP > 1
  ivec2 block = place - vtkiSkyClass * vtkiSkyPart;
  place = block * VTKI_SKY_STEP + vtkiSkyClass;
#endif
  vec3 position[VTKI_SKY_PIXELS];
  vec3 normal[VTKI_SKY_PIXELS];
  vec3 facet[VTKI_SKY_PIXELS];
  vtkiCrease crease[VTKI_SKY_PIXELS];
  bool lit[VTKI_SKY_PIXELS];
  vec4 sum[VTKI_SKY_PIXELS];
  float nearness[VTKI_SKY_PIXELS];
  bool any = false;
  for (int k = 0; k < VTKI_SKY_PIXELS; ++k)
  {
#if VTKI_SKY_PIXELS > 1
    ivec2 pixel = 2 * place + ivec2(k & 1, k >> 1);
#else
    ivec2 pixel = place;
#endif
    vtkiReceiver receiver;
    lit[k] = vtkiFetchReceiver(pixel, receiver);
    position[k] = receiver.position;
    normal[k] = receiver.normal;
    facet[k] = receiver.facet;
    crease[k] = vtkiFetchCrease(pixel);
    sum[k] = vec4(0.0f);
    nearness[k] = 0.0f;
    any = any || lit[k];
  }
#ifdef VTKI_SKY_FRESH
  any = any && texelFetch(vtkiSkyFresh, block, 0).r > 0.5f;
#endif
  int count = any ? vtkiSkyCount : 0;
  for (int i = 0; i < count; ++i)
  {
    vtkiSkyDirection sky = vtkiFetchSkyDirection(i);
    for (int k = 0; k < VTKI_SKY_PIXELS; ++k)
    {
      sum[k] += vtkiFromSky(sky, position[k], normal[k], facet[k], crease[k], nearness[k]);
    }
  }
  gl_FragData[0] = lit[0] ? sum[0] : vec4(0.0f);
#if VTKI_SKY_PIXELS == 1
#ifndef VTKI_FILTERED
  gl_FragData[1] = vec4(lit[0] ? nearness[0] : 0.0f, 0.0f, 0.0f, 0.0f);
#endif
#else
  gl_FragData[1] = lit[1] ? sum[1] : vec4(0.0f);
  gl_FragData[2] = lit[2] ? sum[2] : vec4(0.0f);
  gl_FragData[3] = lit[3] ? sum[3] : vec4(0.0f);
  gl_FragData[4] = vec4(lit[0] ? nearness[0] : 0.0f, lit[1] ? nearness[1] : 0.0f,
    lit[2] ? nearness[2] : 0.0f, lit[3] ? nearness[3] : 0.0f);
#endif
}
