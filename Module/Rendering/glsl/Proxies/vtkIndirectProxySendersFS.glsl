//VTK::System::Dec
//VTK::Output::Dec
// The light that falls on senders, one fragment each; or with VTKI_PROXY_MEANS the light that each
// entry sends, of its own sender or the mean of several, in pairs, and from row vtkiSenderRow on
// the light that falls on each sender.
#ifndef VTKI_PROXY_MEANS
#define VTKI_PROXY_SENDERS
#endif
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectProxySum.glsl"
#include "vtkIndirectProxySenders.glsl"

// of a sphere's irradiance a + b n: a, b.x; b.y, b.z of each colour
uniform sampler2D vtkiSenderLight0;
uniform sampler2D vtkiSenderLight1;
uniform sampler2D vtkiSenderLight2;
uniform sampler2D vtkiSenderLight3; // the same for the open share of its half space among spheres
uniform sampler2D vtkiMeanRange;    // first, number
uniform int vtkiFirstMean;          // place of the first sender

// At most this many senders represent an entry.
const int VTKI_MEAN_SAMPLES = 16;

void main()
{
  int number = vtkiTableEntry(ivec2(gl_FragCoord.xy));
  vec4 light[4];
  light[0] = vec4(0.0f);
  light[1] = vec4(0.0f);
  light[2] = vec4(0.0f);
  light[3] = vec4(0.0f);
#ifdef VTKI_PROXY_MEANS
  ivec2 texel = ivec2(gl_FragCoord.xy);
  bool entry = texel.y < vtkiSenderRow;
  // Rows may extend beyond the end of the table.
  vec4 albedo =
    entry && number < vtkiProxyCount ? texelFetch(vtkiProxyAlbedo, texel, 0) : vec4(1.0f, 1.0f, 1.0f, 0.0f);
  int own = int(albedo.a);
  bool single = !entry || own < vtkiFirstMean;
  if (single)
  {
    texel = entry ? vtkiTableTexel(own) : texel - ivec2(0, vtkiSenderRow);
    light[0] = texelFetch(vtkiSenderLight0, texel, 0);
    light[1] = texelFetch(vtkiSenderLight1, texel, 0);
    light[2] = texelFetch(vtkiSenderLight2, texel, 0);
    light[3] = texelFetch(vtkiSenderLight3, texel, 0);
  }
  vec2 range = single ? vec2(0.0f) : texelFetch(vtkiMeanRange, vtkiTableTexel(own - vtkiFirstMean), 0).xy;
  int first = int(range.x);
  int count = int(range.y);
  int samples = min(count, VTKI_MEAN_SAMPLES);
  // Weights senders by their openness, because open ones are visible: products of light and
  // openness, both a + b n, to first order in n.
  vec3 sentA = vec3(0.0f);
  vec3 sent[3] = vec3[3](vec3(0.0f), vec3(0.0f), vec3(0.0f));
  vec4 open = vec4(0.0f);
  for (int i = 0; i < samples; ++i)
  {
    // Samples lie in the middles of equal parts.
    int sender = first + min(int((float(i) + 0.5f) * float(count) / float(samples)), count - 1);
    ivec2 at = vtkiTableTexel(sender);
    vec4 l0 = texelFetch(vtkiSenderLight0, at, 0);
    vec4 l1 = texelFetch(vtkiSenderLight1, at, 0);
    vec4 l2 = texelFetch(vtkiSenderLight2, at, 0);
    vec4 free = texelFetch(vtkiSenderLight3, at, 0);
    free.x = max(free.x, 0.02f);
    vec3 b[3] = vec3[3](vec3(l0.a, l1.rg), vec3(l1.ba, l2.r), l2.gba);
    sentA += free.x * l0.rgb + (free.y * b[0] + free.z * b[1] + free.w * b[2]) / 3.0f;
    for (int k = 0; k < 3; ++k)
    {
      sent[k] += free.x * b[k] + free[k + 1] * l0.rgb;
    }
    open += free;
  }
  if (!single && samples > 0)
  {
    // The light whose product with the mean openness is that sum.
    vec3 a = (sentA - (open.y * sent[0] + open.z * sent[1] + open.w * sent[2]) / (3.0f * open.x)) /
      max(open.x - dot(open.yzw, open.yzw) / (3.0f * open.x), 0.1f * open.x);
    vec3 bx = (sent[0] - open.y * a) / open.x;
    vec3 by = (sent[1] - open.z * a) / open.x;
    vec3 bz = (sent[2] - open.w * a) / open.x;
    light[0] = vec4(a, bx.r);
    light[1] = vec4(bx.gb, by.rg);
    light[2] = vec4(by.b, bz);
    light[3] = open / float(samples);
  }
  light[0] *= albedo.rgbr;
  light[1] *= albedo.gbrg;
  light[2] *= albedo.brgb;
  vec4 pairs[2];
  vtkiPairLight(light, pairs);
  gl_FragData[0] = pairs[0];
  gl_FragData[1] = pairs[1];
#else
  if (number < vtkiSenderCount)
  {
    vec4 place;
    vec4 normal;
    vtkiFetchSender(number, place, normal);
    vtkiProxySums around = vtkiNoProxies();
    if (!(normal.w > 0.0f))
    {
      around = vtkiSumProxies(place.xyz, vec3(0.0f), true);
    }
    vtkiOpenSender(around, place, normal);
    vtkiProxySums sums = vtkiSumProxies(place.xyz, normal.xyz, true);
    vtkiLightOfSender(sums, place, normal, light);
    if (!(normal.w > 0.0f))
    {
      vec4 front[4] = light;
      vec4 back[4];
      vtkiTurnSender(place, normal);
      sums = vtkiSumProxies(place.xyz, normal.xyz, true);
      vtkiLightOfSender(sums, place, normal, back);
      vtkiLightOfSides(front, back, -normal.xyz, light);
    }
  }
  gl_FragData[0] = light[0];
  gl_FragData[1] = light[1];
  gl_FragData[2] = light[2];
  gl_FragData[3] = light[3];
#endif
}
