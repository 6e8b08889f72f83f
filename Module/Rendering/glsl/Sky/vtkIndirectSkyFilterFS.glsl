//VTK::System::Dec
//VTK::Output::Dec
// Filters the visible share of the sky: pixels of a block have each summed other directions.
// VTKI_SKY_STEP: edge of the blocks, whose pixels together sum all directions. The filter is a tent
// of a block's edge to either side, along rows with VTKI_SKY_ROWS, then along columns. Weights of
// pixels that summed the same directions add up to one, so that each direction's shadow is
// interpolated between these pixels and no pattern of blocks remains. Neighbours on other surfaces
// take no part. Along columns it also finds how far vtkIndirectSkySmoothFS.glsl smooths the share.
#ifndef VTKI_SKY_STEP
#define VTKI_SKY_STEP 2
#define VTKI_SKY_BLOCK 16
#endif
#define VTKI_STEP VTKI_SKY_STEP
#include "vtkIndirectReceiverGrid.glsl"
#include "vtkIndirectLibSky.glsl"
#if VTKI_SKY_STEP > 1 && !defined(VTKI_SKY_ROWS)
#include "vtkIndirectSkyDirections.glsl"

uniform int vtkiSkyCount; // directions in the block

// Least share of the light of all directions that the neighbours must have summed: a pixel alone has
// a quarter, a pixel at a corner of a surface nine sixteenths. All directions give less where the
// facet leans away from the shading normal: a cosine lobe keeps half of one plus the cosine between
// the two above the facet's plane.
const float VTKI_SKY_COVERAGE = 0.3f;
#endif

uniform sampler2D vtkiSkySums;
uniform sampler2D vtkiSkyNear; // what is hidden over the distance of what hides it
#if VTKI_SKY_STEP == 1
uniform sampler2D vtkiSkySums1; // other pixels of the squares: right, above, right above
uniform sampler2D vtkiSkySums2;
uniform sampler2D vtkiSkySums3;
#endif
#ifdef VTKI_SKY_ROWS
uniform ivec2 vtkiSkyPart; // pixels of a part, which holds the pixels of one place in their blocks
#ifdef VTKI_SKY_FRESH
uniform sampler2D vtkiSkyFresh; // blocks of pixels that sum directions
#endif
#else
// irradiance without occlusion; sum of all directions without occlusion
uniform sampler2D vtkiOpenSky;
uniform vec3 vtkiOpenFlux;     // the odd halves of these, see vtkIndirectLibSky.glsl
uniform vec3 vtkiSummedFlux;
uniform float vtkiSkyReach; // radius over the distance of what hides the sky
#endif

#ifdef VTKI_SKY_ROWS
const int VTKI_AXIS = 0;
#else
const int VTKI_AXIS = 1;
#endif

vec4 vtkiFetchSum(ivec2 pixel, out float nearness)
{
#ifdef VTKI_SKY_ROWS
  ivec2 texel = (pixel & (VTKI_SKY_STEP - 1)) * vtkiSkyPart + pixel / VTKI_SKY_STEP;
  vec2 at = (vec2(texel) + 0.5f) / vec2(VTKI_SKY_STEP * vtkiSkyPart);
  nearness = textureLod(vtkiSkyNear, at, 0.0f).r;
  return textureLod(vtkiSkySums, at, 0.0f);
#elif VTKI_SKY_STEP == 1
  // Squares of four pixels, one in each image.
  vec2 at = (vec2(pixel / 2) + 0.5f) / vec2((vtkiSize + 1) / 2);
  vec4 lower = (pixel.x & 1) == 0 ? textureLod(vtkiSkySums, at, 0.0f) : textureLod(vtkiSkySums1, at, 0.0f);
  vec4 upper = (pixel.x & 1) == 0 ? textureLod(vtkiSkySums2, at, 0.0f) : textureLod(vtkiSkySums3, at, 0.0f);
  vec4 near = textureLod(vtkiSkyNear, at, 0.0f);
  vec2 row = (pixel.y & 1) == 0 ? near.xy : near.zw;
  nearness = (pixel.x & 1) == 0 ? row.x : row.y;
  return (pixel.y & 1) == 0 ? lower : upper;
#else
  vec2 at = (vec2(pixel) + 0.5f) / vec2(vtkiSize);
  nearness = textureLod(vtkiSkyNear, at, 0.0f).r;
  return textureLod(vtkiSkySums, at, 0.0f);
#endif
}

// Returns the sum over the pixel's neighbours along the axis that lie on its surface.
vec4 vtkiSumAlong(ivec2 pixel, vtkiReceiver receiver, out float nearness)
{
#if VTKI_SKY_STEP == 1
  return vtkiFetchSum(pixel, nearness);
#else
  // Height of a neighbour over the receiver's plane: affine in the pixel's offset and in its depth.
  float pixelWidth = 2.0f / float(vtkiSize[VTKI_AXIS]);
  vec3 ndc = vec3(2.0f * (vec2(pixel) + 0.5f) / vec2(vtkiSize) - 1.0f, 1.0f);
  float along = dot(receiver.facetVC, vtkiRayDirection * ndc);
  float originStep = dot(receiver.facetVC, vtkiRayOrigin[VTKI_AXIS]) * pixelWidth;
  float directionStep = dot(receiver.facetVC, vtkiRayDirection[VTKI_AXIS]) * pixelWidth;
  float tolerance = VTKI_INTERPOLATION_DISTANCE * vtkiSampleDistance(receiver.depth);
  vec4 sum = vec4(0.0f);
  nearness = 0.0f;
  int end = VTKI_SKY_STEP;
#ifdef VTKI_SKY_FRESH
  end = texelFetch(vtkiSkyFresh, pixel / VTKI_SKY_STEP, 0).r > 0.5f ? end : -VTKI_SKY_STEP;
#endif
  for (int i = 1 - VTKI_SKY_STEP; i < end; ++i)
  {
    ivec2 at = pixel;
    at[VTKI_AXIS] += i;
    bool inside = at[VTKI_AXIS] >= 0 && at[VTKI_AXIS] < vtkiSize[VTKI_AXIS];
    vec4 surface = textureLod(vtkiSurface, (vec2(at) + 0.5f) / vec2(vtkiSize), 0.0f);
    float depth = vtkiSurfaceDepth(surface);
    float height =
      float(i) * (originStep + depth * directionStep) + (depth - receiver.depth) * along;
    bool same = inside && vtkiSurfaceIsLit(surface) && abs(height) <= tolerance &&
      dot(receiver.normalVC, vtkiSurfaceNormal(surface)) >= VTKI_INTERPOLATION_COSINE;
    float weight = 1.0f - abs(float(i)) / float(VTKI_SKY_STEP);
    float near;
    vec4 fetched = vtkiFetchSum(at, near);
    sum += same ? weight * fetched : vec4(0.0f);
    nearness += same ? weight * near : 0.0f;
  }
  return sum;
#endif
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  float nearness;
  vec4 sum = vtkiSumAlong(pixel, receiver, nearness);
#ifdef VTKI_SKY_ROWS
  gl_FragData[0] = lit ? sum : vec4(0.0f);
  gl_FragData[1] = vec4(lit ? nearness : 0.0f, 0.0f, 0.0f, 0.0f);
#else
  vec2 open = textureLod(vtkiOpenSky, vtkiOpenSkyPlace(receiver.normal), 0.0f).rg +
    vec2(dot(vtkiOpenFlux, receiver.normal), dot(vtkiSummedFlux, receiver.normal));
#if VTKI_SKY_STEP > 1
  // Thin and small things have too few neighbours: their pixels sum all directions.
  bool covered = !lit || sum.w >=
      VTKI_SKY_COVERAGE * open.g * 0.5f * (1.0f + dot(receiver.normal, receiver.facet));
  vec4 own = vec4(0.0f);
  float ownNearness = 0.0f;
  vtkiCrease crease = vtkiFetchCrease(pixel);
  int count = covered ? 0 : vtkiSkyCount;
  for (int i = 0; i < count; ++i)
  {
    own += vtkiFromSky(vtkiFetchSkyDirection(i), receiver.position, receiver.normal, receiver.facet, crease,
      ownNearness);
  }
  sum = covered ? sum : own;
  nearness = covered ? nearness : ownNearness;
#endif
  // The mean of the distances of what hides the sky, of which the near ones count most. Nothing ends
  // the smoothing where nothing hides the sky.
  float hidden = max(sum.w - sum.r - sum.g - sum.b, 0.0f);
  float radius = hidden > 1.0e-4f * sum.w ? vtkiSkyReach * hidden / nearness : 1.0e30f;
  gl_FragData[0] = vec4(vtkiSkyIrradiance(sum.rgb, sum.w, 1.0f), lit ? radius : 0.0f);
#endif
}
