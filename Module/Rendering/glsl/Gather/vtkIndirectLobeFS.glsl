//VTK::System::Dec
//VTK::Output::Dec
// Light from the lobes of virtual lights. VTKI_COARSE: at every vtkiStep-th pixel, with the error
// that interpolation may have there; VTKI_INTERPOLATED: at every pixel, interpolated where that
// error is small; VTKI_GLOSSY: in the receiver's specular lobe; otherwise at every pixel.
#include "vtkIndirectReceiverGrid.glsl"
#ifdef VTKI_INTERPOLATED
#include "vtkIndirectCoarse.glsl"
uniform float vtkiLeast;     // light that is worth a sum
uniform float vtkiTolerance; // error of interpolation, relative to the light
#endif
#include "vtkIndirectLibSenderLobe.glsl"
uniform float vtkiStorageScale;

#ifdef VTKI_GLOSSY
#include "vtkIndirectLibGlossy.glsl"
uniform sampler2D vtkiSpecular;
// main() sets these; the initial values avoid warnings about functions that precede it.
vec3 vtkiReceiverMirror = vec3(0.0f);
float vtkiReceiverPower = 0.0f;
float vtkiLobeWeight(vec3 toSender, vec3 normalS, vec3 normalR, vec3 direction, float exponent, float area)
{
  float r = length(toSender);
  float mirrored = r > 0.0f ? min(dot(vtkiReceiverMirror, toSender) / r, 1.0f) : 0.0f;
  float lobe =
    mirrored > 0.0f && dot(normalR, toSender) > 0.0f ? pow(mirrored, vtkiReceiverPower) : 0.0f;
  return lobe > 0.0f ? lobe * r * vtkiSenderLobeStrength(toSender, normalS, direction, exponent, area) : 0.0f;
}
#else
#define vtkiLobeWeight vtkiSenderLobeWeight
#endif
#include "vtkIndirectLobes.glsl"

#ifdef VTKI_INTERPOLATED
// The largest variation among the surrounding samples.
float vtkiCoarseVariation(ivec2 pixel)
{
  vtkiGridCell cell = vtkiFindCell(pixel);
  float most = 0.0f;
  for (int i = 0; i < 4; ++i)
  {
    most = max(most, textureLod(vtkiCoarse, vtkiFetchSample(cell, i).place, 0.0f).a);
  }
  return most;
}
#endif

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef VTKI_COARSE
  pixel = vtkiSamplePixel(pixel);
#endif
  vtkiReceiver receiver;
  bool wanted = vtkiFetchReceiver(pixel, receiver);
  float radius = 0.0f;
  vec3 light = vec3(0.0f);
#ifdef VTKI_COARSE
  // Half the diagonal of the square between samples, stretched where the surface is inclined to the
  // view.
  vec3 right = (vtkiRayOrigin[0] + receiver.depth * vtkiRayDirection[0]) * (2.0f / float(vtkiSize.x));
  float facing = abs(dot(receiver.normalVC, normalize(vtkiRayOrigin[2] + receiver.depth * vtkiRayDirection[2])));
  radius = 0.7071f * float(vtkiStep) * length(right) / max(facing, 0.1f);
#endif
#ifdef VTKI_GLOSSY
  vec4 specular = texelFetch(vtkiSpecular, pixel, 0);
  // Negative powers are roughnesses of VTK's PBR; only area lights support these.
  wanted = wanted && specular.a >= 0.0f && max(max(specular.r, specular.g), specular.b) > 0.0f;
  vtkiReceiverMirror = mat3(vtkiViewToScene) * vtkiMirror(receiver.positionVC, receiver.normalVC);
  vtkiReceiverPower = specular.a;
#endif
#ifdef VTKI_INTERPOLATED
  vec3 sum = vec3(0.0f);
  float weights = 0.0f;
  int agreeing = 0;
  if (wanted)
  {
    vtkiInterpolateCoarse(pixel, receiver, sum, weights, agreeing);
  }
  vec3 mean = sum / max(weights, 1.0e-6f);
  bool even = agreeing >= 3 && weights > 0.0f &&
    vtkiCoarseVariation(pixel) <= vtkiLeast + vtkiTolerance * max(max(mean.r, mean.g), mean.b);
  light = even ? mean : light;
  wanted = wanted && !even;
#endif
  float variation = 0.0f;
  if (wanted)
  {
    vtkiLobeSum sums = vtkiSumLobes(receiver.position, receiver.normal, receiver.facet, pixel, radius);
    light = sums.light;
    variation = sums.variation;
  }
  gl_FragData[0] = vec4(light * vtkiStorageScale, variation);
}
