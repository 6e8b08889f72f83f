// The far field: light of virtual lights that their splats cut off.
#include "vtkIndirectSplatLobe.glsl"

struct vtkiFarField
{
  vec3 irradiance; // irradiance of the light cut off
  float all;       // luminance of all light
  vec3 vector;     // luminance of the vector irradiance of the light cut off
};

vtkiFarField vtkiSumFarField(vec3 position, vec3 normal, vec3 facet, ivec2 pixel, int first, int end)
{
  float low = vtkiSplatLow();
  vec3 open = vtkiSplatOpenPlace(position, normal, facet, pixel);
  vtkiFarField sum = vtkiFarField(vec3(0.0f), 0.0f, vec3(0.0f));
  for (int light = first; light < end; ++light)
  {
    vec4 sender;
    vec4 senderNormal;
    vec3 density;
    vtkiFetchLight(light, sender, senderNormal, density);
    vec3 toSender = vtkiToSender(sender, position);
    float share = vtkiShareOfSplat(toSender, sender, senderNormal, density, low);
    vec3 whole = vtkiWholeSender(position, normal, open, light, sender, senderNormal, density);
    vec3 left = (1.0f - share) * whole;
    sum.all += vtkiLuminance(whole);
#ifdef VTKI_SPLAT_LOBES
    ivec2 at = vtkiTableTexel(light);
    vec3 flux = texelFetch(vtkiLobeDensity, at, 0).rgb;
    if (max(max(flux.r, flux.g), flux.b) > 0.0f)
    {
      left += vtkiAddSplatLobe(position, normal, open, light, sender, senderNormal.xyz,
        texelFetch(vtkiLobeDirection, at, 0), flux, low, true, sum.all);
    }
#endif
    sum.irradiance += left;
    // Over the cosine. The branches of a cluster lie elsewhere than its middle, which may be at the
    // horizon.
    float across = max(dot(normal, toSender), 0.05f * length(toSender));
    sum.vector += across > 0.0f ? (vtkiLuminance(left) / across) * toSender : vec3(0.0f);
  }
  return sum;
}
