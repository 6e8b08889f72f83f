//VTK::System::Dec
// Irradiance of pixels that no coarse receiver represents, one invocation each, from the receivers
// of the four surrounding tiles: bilinear between the tiles' middles, weighted by planes and
// normals. Receivers of the pixel's own tile represent it, so that the weights are not zero.
#include "vtkIndirectReceiverGrid.glsl"
#include "vtkIndirectProxySum.glsl"
#include "vtkIndirectProxyTile.glsl"
#include "vtkIndirectProxyList.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(rgba32f, binding = 0) uniform image2D vtkiSkyImage;
layout(rgba32f, binding = 1) uniform image2D vtkiBounceImage;
uniform sampler2D vtkiSharedCount;
uniform sampler2D vtkiShared0; // a colour's irradiance a + b n: b, a
uniform sampler2D vtkiShared1;
uniform sampler2D vtkiShared2;
uniform sampler2D vtkiShared3; // light that proxies send; number of the tile's pixel

void main()
{
  ivec2 pixel;
  int unused;
  vtkiReceiver receiver;
  // Pixels summed by themselves have their value already.
  bool inside =
    vtkiFetchEntry(VTKI_PROXY_SERVED, gl_WorkGroupID.x * 256u + gl_LocalInvocationIndex, pixel, unused) &&
    imageLoad(vtkiSkyImage, pixel).a < 0.0f;
  if (vtkiFetchReceiver(pixel, receiver) && inside)
  {
    float distance = vtkiSampleDistance(receiver.depth);
    vec2 place = (vec2(pixel) + 0.5f) / float(VTKI_PROXY_TILE) - 0.5f;
    ivec2 low = ivec2(floor(place));
    vec2 blend = place - vec2(low);
    ivec2 last = (vtkiSize - 1) / VTKI_PROXY_TILE;
    vec4 sky[3] = vec4[3](vec4(0.0f), vec4(0.0f), vec4(0.0f));
    vec3 bounce = vec3(0.0f);
    float sum = 0.0f;
    vec2 texel = 1.0f / vec2(VTKI_PROXY_BLOCK * (last + 1));
    for (int i = 0; i < 4; ++i)
    {
      ivec2 shift = ivec2(i & 1, i >> 1);
      ivec2 tile = clamp(low + shift, ivec2(0), last);
      vec2 w = mix(1.0f - blend, blend, vec2(shift));
      int count = int(texelFetch(vtkiSharedCount, tile, 0).r);
      for (int k = 0; k < count; ++k)
      {
        vec2 at = (vec2(vtkiSharedTexel(tile, k)) + 0.5f) * texel;
        vec4 sent = textureLod(vtkiShared3, at, 0.0f);
        int number = int(sent.a);
        vtkiReceiver other;
        vtkiFetchReceiver(tile * VTKI_PROXY_TILE + ivec2(number % VTKI_PROXY_TILE, number / VTKI_PROXY_TILE), other);
        float weight = w.x * w.y * vtkiAgreement(receiver, other, distance);
        sum += weight;
        sky[0] += weight * textureLod(vtkiShared0, at, 0.0f);
        sky[1] += weight * textureLod(vtkiShared1, at, 0.0f);
        sky[2] += weight * textureLod(vtkiShared2, at, 0.0f);
        bounce += weight * sent.rgb;
      }
    }
    float scale = 1.0f / max(sum, 1.0e-30f);
    imageStore(vtkiSkyImage, pixel, vec4(scale * vtkiProxyIrradiance(sky, receiver.normal), 1.0f));
#ifdef VTKI_PROXY_LIGHT
    imageStore(vtkiBounceImage, pixel, vec4(scale * bounce, 1.0f));
#endif
  }
}
