//VTK::System::Dec
// One invocation a listed texel evaluates the texel's set of lights at its four children. Under a
// split texel (VTKI_UNDER_SPLIT) each light counts in full. Under a whole texel the interpolated
// picture of the level above is present; only the residual against the light's own coarse samples,
// interpolated with the same weights, is added, so that lights that end on different levels leave
// no error. A child is listed with the lights that it does not resolve.
#include "vtkIndirectGlossyTexel.glsl"
#include "vtkIndirectGlossyStorage.glsl"
#include "vtkIndirectLightUniforms.glsl"
#include "vtkIndirectLibTable.glsl"
#ifdef VTKI_VISIBILITY
#include "vtkIndirectVisibility.glsl"
#endif

layout(local_size_x = 64) in;

uniform mat4 vtkiViewToScene;
uniform float vtkiStorageScale;
uniform int vtkiList;
uniform int vtkiListFirst;
layout(VTKI_FORMAT) uniform image2D vtkiGlossyImage;
#ifndef VTKI_PIXELS
uniform int vtkiSplitList; // list of the children's level
uniform int vtkiSplitFirst;
uniform int vtkiWholeList;
uniform int vtkiWholeFirst;
uniform float vtkiGlossyThreshold; // over the number of lights
uniform sampler2D vtkiIrradiance;  // irradiance of the image, as stored
#ifdef VTKI_DEPTH_RANGE
uniform sampler2D vtkiFinerMinimum;
uniform sampler2D vtkiFinerMaximum;
#else
uniform sampler2D vtkiFinerDeviation;
uniform float vtkiPlaneThreshold;
#endif
uniform float vtkiNormalThreshold;
#endif

struct vtkiPoint
{
  vec3 position; // scene coordinates
  vec3 normal;
  vec3 mirror;
};

vtkiPoint vtkiMakePoint(vec3 positionVC, vec3 normalVC)
{
  mat3 rotation = mat3(vtkiViewToScene);
  return vtkiPoint((vtkiViewToScene * vec4(positionVC, 1.0f)).xyz, rotation * normalVC,
    rotation * vtkiMirror(positionVC, normalVC));
}

float vtkiWeightAt(vtkiPoint point, float power, vec4 sender, vec3 senderNormal)
{
  return vtkiGlossyWeight(
    sender.xyz - point.position, senderNormal, point.normal, point.mirror, power, sender.w);
}

// Returns true if a point sees a light; `light` is its number in the table.
bool vtkiSeesLight(vtkiPoint point, int light, vec4 sender, vec3 senderNormal)
{
#ifdef VTKI_VISIBILITY
  return vtkiIsSenderVisible(
    light, vtkiOpenPlace(point.position, point.normal, point.normal), point.position, point.normal, sender, senderNormal, true);
#else
  return true;
#endif
}

// Weight of a light at a sample: zero if occluded. Also notes the unoccluded weight and which
// samples see the light.
float vtkiSeenWeight(vtkiPoint point, int light, vec4 sender, vec3 senderNormal, float weight,
  inout float open, inout bool someSee, inout bool someDoNot)
{
  bool sees = true;
  if (weight > 0.0f)
  {
    sees = vtkiSeesLight(point, light, sender, senderNormal);
    open = max(open, weight);
    someSee = someSee || sees;
    someDoNot = someDoNot || !sees;
  }
  return sees ? weight : 0.0f;
}

void main()
{
  uint place = gl_GlobalInvocationID.x;
  if (place >= vtkiGlossyCommand[vtkiList].w)
  {
    return;
  }
  uint entry = uint(vtkiListFirst) + place * vtkiGlossyStride();
  uint where = vtkiGlossyEntry[entry];
  ivec2 parent = ivec2(int(where & 0xffffu), int(where >> 16));

  vtkiPoint child[4];
  float power[4];
  float state[4];
  vec3 sum[4];
#ifndef VTKI_PIXELS
  float inherited = uintBitsToFloat(vtkiGlossyEntry[entry + 1u]);
  float limit[4];
  float radius[4];
  float turn[4];
  float toEye[4];
  uint listed[4];
#endif
#ifndef VTKI_UNDER_SPLIT
  vtkiPoint coarse[9];
  float coarsePower = texelFetch(vtkiCoarserLobe, parent, 0).x;
  for (int i = 0; i < 9; ++i)
  {
    ivec2 at =
      clamp(parent + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), vtkiCoarserSize - 1);
    vec4 surface = texelFetch(vtkiCoarserSurface, at, 0);
    vec2 center = vtkiSubsplatCenter(vec2(at), vtkiCoarserEdge, vec2(vtkiSize));
    coarse[i] = vtkiMakePoint(
      vtkiReconstruct(center, surface.z, vtkiRayOrigin, vtkiRayDirection),
      vtkiOctahedralDecode(surface.xy));
  }
  vec4 weights[4];
#endif
  for (int i = 0; i < 4; ++i)
  {
    ivec2 texel = 2 * parent + ivec2(i & 1, i >> 1);
    vtkiGlossyReceiver receiver = vtkiFetchGlossyReceiver(texel);
    child[i] = vtkiMakePoint(receiver.position, receiver.normal);
    power[i] = receiver.power;
    state[i] = receiver.state;
    sum[i] = vec3(0.0f);
#ifndef VTKI_UNDER_SPLIT
    weights[i] = vtkiCoarserWeights(
      texel, receiver.position, receiver.normal, receiver.depth, receiver.power);
#endif
#ifndef VTKI_PIXELS
    ivec2 inside = min(texel, vtkiLevelSize - 1);
#ifdef VTKI_DEPTH_RANGE
    vec4 range = texelFetch(vtkiFinerMaximum, inside, 0) - texelFetch(vtkiFinerMinimum, inside, 0);
    float width = vtkiPixelWidth(receiver.depth) * vtkiEdge;
    float deviation = range.w / width;
    turn[i] = length(range.xyz);
    bool mixed = turn[i] > vtkiNormalThreshold || deviation > 1.0f;
#else
    vec2 spread = abs(texelFetch(vtkiFinerDeviation, inside, 0).xy);
    float width = vtkiPixelWidth(receiver.depth) * vtkiEdge;
    float deviation = spread.x;
    turn[i] = spread.y;
    bool mixed = spread.x > vtkiPlaneThreshold || spread.y > vtkiNormalThreshold;
#endif
    // Normals are known at the centres of pixels, which do not extend to the texel's border.
    turn[i] *= vtkiEdge / (vtkiEdge - 1.0f);
    toEye[i] = length(receiver.position);
    // Half the diagonal, stretched where the surface is inclined to the view.
    float facing = toEye[i] > 0.0f ? -dot(receiver.normal, receiver.position) / toEye[i] : 1.0f;
    radius[i] = width * (0.7072f / max(facing, 0.05f) + deviation);
    // A mixture of surfaces has no position: it passes its lights on.
    radius[i] = mixed ? 1.0e6f : radius[i];
    vec2 center = vtkiSubsplatCenter(vec2(inside), vtkiEdge, vec2(vtkiSize));
    float irradiance = vtkiLuminance(textureLod(vtkiIrradiance, 0.5f * center + 0.5f, 0.0f).rgb);
    limit[i] =
      irradiance > 0.0f ? irradiance / vtkiStorageScale * vtkiGlossyThreshold : inherited;
    listed[i] = 0u;
    if (state[i] == VTKI_GLOSSY_SPLIT)
    {
      listed[i] = vtkiAppendGlossy(vtkiSplitList, vtkiSplitFirst, texel, limit[i]);
    }
    else if (state[i] == VTKI_GLOSSY_WHOLE)
    {
      listed[i] = vtkiAppendGlossy(vtkiWholeList, vtkiWholeFirst, texel, limit[i]);
    }
#endif
  }

  for (int word = 0; word < vtkiGlossyWords; ++word)
  {
    uint set = vtkiGlossyEntry[entry + VTKI_GLOSSY_HEADER + uint(word)];
#ifndef VTKI_PIXELS
    uint kept[4];
    kept[0] = kept[1] = kept[2] = kept[3] = 0u;
#endif
    while (set != 0u)
    {
      int bit = findLSB(set);
      set &= set - 1u;
      int light = 32 * word + bit;
      vec4 sender;
      vec4 normalAndDistance;
      vec3 density;
      vtkiFetchLight(light, sender, normalAndDistance, density);
      vec3 senderNormal = normalAndDistance.xyz;
      float open = 0.0f;
      bool someSee = false;
      bool someDoNot = false;
#ifndef VTKI_UNDER_SPLIT
      float above[9];
      for (int i = 0; i < 9; ++i)
      {
        above[i] = vtkiSeenWeight(coarse[i], light, sender, senderNormal,
          vtkiWeightAt(coarse[i], coarsePower, sender, senderNormal), open, someSee, someDoNot);
      }
#endif
      float value[4];
      float greatest = 0.0f;
      for (int i = 0; i < 4; ++i)
      {
        float weight = state[i] == VTKI_GLOSSY_NONE
          ? 0.0f
          : vtkiWeightAt(child[i], power[i], sender, senderNormal);
        value[i] = vtkiSeenWeight(
          child[i], light, sender, senderNormal, weight, open, someSee, someDoNot);
#ifndef VTKI_UNDER_SPLIT
        int x = i & 1;
        int y = i >> 1;
        value[i] -= weights[i].x * above[4] + weights[i].y * above[3 + 2 * x] +
          weights[i].z * above[1 + 6 * y] + weights[i].w * above[2 * x + 6 * y];
        greatest = max(greatest, state[i] == VTKI_GLOSSY_WHOLE ? abs(value[i]) : 0.0f);
#endif
        sum[i] += value[i] * density;
      }
#ifndef VTKI_PIXELS
      float brightness = vtkiLuminance(density);
      // A shadow's edge runs between the samples: no sample represents the others.
      float atEdge = someSee && someDoNot ? open * brightness : 0.0f;
      for (int i = 0; i < 4; ++i)
      {
        bool mixed = radius[i] > 1.0e5f;
        vec3 toSender = sender.xyz - child[i].position;
        float horizon = vtkiGlossyHorizon(
          toSender, child[i].normal, 2.0f * radius[i], 2.0f * turn[i]);
        float variation = vtkiGlossyVariation(toSender, senderNormal,
          child[i].mirror, power[i], sender.w, radius[i], turn[i], toEye[i],
          state[i] == VTKI_GLOSSY_WHOLE && horizon > 0.0f);
        bool further = mixed || (horizon >= 0.0f && variation * brightness > limit[i]);
#ifndef VTKI_UNDER_SPLIT
        // If samples are closer than the lobe is wide, their residuals predict those of the next
        // level: a quarter of these, taken as half to be safe.
        float shift = 2.0f * turn[i] + (toEye[i] > radius[i] ? radius[i] / toEye[i] : 1.0f);
        bool resolved = horizon > 0.0f && power[i] * 4.0f * shift * shift < 1.0f;
        further = further && !(resolved && 0.5f * greatest * brightness <= limit[i]);
#endif
        further = further || atEdge > limit[i];
        kept[i] |= further ? 1u << uint(bit) : 0u;
      }
#endif
    }
#ifndef VTKI_PIXELS
    for (int i = 0; i < 4; ++i)
    {
      if (state[i] != VTKI_GLOSSY_NONE)
      {
        vtkiGlossyEntry[listed[i] + VTKI_GLOSSY_HEADER + uint(word)] = kept[i];
      }
    }
#endif
  }
  for (int i = 0; i < 4; ++i)
  {
    if (state[i] == VTKI_GLOSSY_WHOLE)
    {
      ivec2 texel = 2 * parent + ivec2(i & 1, i >> 1);
      vec3 value = sum[i] * vtkiStorageScale;
#ifndef VTKI_UNDER_SPLIT
      value += imageLoad(vtkiGlossyImage, texel).rgb;
#endif
#ifdef VTKI_PIXELS
      // Rounding may leave residuals below zero.
      value = max(value, vec3(0.0f));
#endif
      imageStore(vtkiGlossyImage, texel, vec4(value, 1.0f));
    }
  }
}
