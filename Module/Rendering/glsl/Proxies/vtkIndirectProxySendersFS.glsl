//VTK::System::Dec
//VTK::Output::Dec
// The light that falls on senders, one fragment each; or with VTKI_PROXY_MEANS all of it, followed from row
// vtkiMeanRow on by means of several.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectProxySum.glsl"
#include "vtkIndirectProxySenders.glsl"

uniform sampler2D vtkiMeanRange; // first, number
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
  if (texel.y < vtkiMeanRow)
  {
    gl_FragData[0] = texelFetch(vtkiSenderLight0, texel, 0);
    gl_FragData[1] = texelFetch(vtkiSenderLight1, texel, 0);
    gl_FragData[2] = texelFetch(vtkiSenderLight2, texel, 0);
    gl_FragData[3] = texelFetch(vtkiSenderLight3, texel, 0);
    return;
  }
  vec2 range = texelFetch(vtkiMeanRange, texel - ivec2(0, vtkiMeanRow), 0).xy;
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
    light[i] /= max(weights, 1.0e-6f);
  }
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
#endif
  gl_FragData[0] = light[0];
  gl_FragData[1] = light[1];
  gl_FragData[2] = light[2];
  gl_FragData[3] = light[3];
}
