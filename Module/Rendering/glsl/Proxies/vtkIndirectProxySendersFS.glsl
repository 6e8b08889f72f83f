//VTK::System::Dec
//VTK::Output::Dec
// The light that falls on senders, one fragment each; or with VTKI_PROXY_MEANS all of it in pairs, followed
// from row vtkiMeanRow on by means of several.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectProxySum.glsl"
#include "vtkIndirectProxySenders.glsl"

uniform sampler2D vtkiSenderLight0; // of a sphere's irradiance a + b n: a, b.x; b.y, b.z of each colour
uniform sampler2D vtkiSenderLight1;
uniform sampler2D vtkiSenderLight2;
uniform sampler2D vtkiSenderLight3; // of the share of its half space that is open among spheres, the same
uniform sampler2D vtkiMeanRange;    // first, number
uniform int vtkiMeanRow;

// Of more senders so many stand for all.
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
  bool single = texel.y < vtkiMeanRow;
  if (single)
  {
    light[0] = texelFetch(vtkiSenderLight0, texel, 0);
    light[1] = texelFetch(vtkiSenderLight1, texel, 0);
    light[2] = texelFetch(vtkiSenderLight2, texel, 0);
    light[3] = texelFetch(vtkiSenderLight3, texel, 0);
  }
  vec2 range = single ? vec2(0.0f) : texelFetch(vtkiMeanRange, texel - ivec2(0, vtkiMeanRow), 0).xy;
  int first = int(range.x);
  int count = int(range.y);
  float weights = 0.0f;
  int samples = min(count, VTKI_MEAN_SAMPLES);
  for (int i = 0; i < samples; ++i)
  {
    // In the middles of equal parts.
    int sender = first + min(int((float(i) + 0.5f) * float(count) / float(samples)), count - 1);
    ivec2 at = vtkiTableTexel(sender);
    // What is open is what is seen of them.
    vec4 open = texelFetch(vtkiSenderLight3, at, 0);
    float weight = max(open.x, 0.02f);
    light[0] += weight * texelFetch(vtkiSenderLight0, at, 0);
    light[1] += weight * texelFetch(vtkiSenderLight1, at, 0);
    light[2] += weight * texelFetch(vtkiSenderLight2, at, 0);
    light[3] += open / float(samples);
    weights += weight;
  }
  for (int i = 0; i < 3; ++i)
  {
    light[i] /= single ? 1.0f : max(weights, 1.0e-6f);
  }
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
  }
  gl_FragData[0] = light[0];
  gl_FragData[1] = light[1];
  gl_FragData[2] = light[2];
  gl_FragData[3] = light[3];
#endif
}
