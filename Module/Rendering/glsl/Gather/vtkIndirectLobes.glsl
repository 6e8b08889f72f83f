// Sum over the lobes of virtual lights. VTKI_VISIBILITY: only visible lights count.
#include "vtkIndirectLibTable.glsl"
#include "vtkIndirectLibSenderLobe.glsl"
#ifdef VTKI_VISIBILITY
#include "vtkIndirectVisibility.glsl"
#endif

uniform sampler2D vtkiLightPosition; // position, area
uniform sampler2D vtkiLightNormal;   // normal, child distance
uniform sampler2D vtkiLobeDirection; // direction, exponent
uniform sampler2D vtkiLobeDensity;   // flux density times area
uniform ivec2 vtkiLightRows; // first row, one past the last row
uniform int vtkiLightCount;

struct vtkiLobeSum
{
  vec3 light;
  float variation; // possible error of interpolation over the receiver's patch, brightest component
};

// Adds one light's lobe. radius: of the surface patch that the receiver represents, 0 for a point.
void vtkiAddLobe(vec3 position, vec3 normal, vec3 open, float radius, int light, inout vtkiLobeSum sum)
{
  ivec2 at = vtkiTableTexel(light);
  vec3 density = texelFetch(vtkiLobeDensity, at, 0).rgb;
  float brightest = max(max(density.r, density.g), density.b);
  if (!(brightest > 0.0f))
  {
    return;
  }
  vec4 sender = texelFetch(vtkiLightPosition, at, 0);
  vec3 senderNormal = texelFetch(vtkiLightNormal, at, 0).xyz;
  vec4 lobe = texelFetch(vtkiLobeDirection, at, 0);
  vec3 toSender = sender.xyz - position;
  if (radius == 0.0f && vtkiIsBesideLobe(toSender, lobe.xyz, lobe.w, sender.w))
  {
    return;
  }
  float weight = vtkiLobeWeight(toSender, senderNormal, normal, lobe.xyz, lobe.w, sender.w);
  float variation = radius > 0.0f
    ? vtkiSenderLobeVariation(toSender, senderNormal, lobe.xyz, lobe.w, sender.w, radius)
    : 0.0f;
#ifdef VTKI_VISIBILITY
  bool seen =
    vtkiIsSenderVisible(light, open, position, normal, sender, senderNormal, weight > 0.0f);
  weight = seen ? weight : 0.0f;
#endif
  sum.light += density * weight;
  sum.variation += brightest * variation;
}

vtkiLobeSum vtkiSumLobes(vec3 position, vec3 normal, vec3 facet, ivec2 pixel, float radius)
{
  vtkiLobeSum total = vtkiLobeSum(vec3(0.0f), 0.0f);
  vec3 open = position;
#ifdef VTKI_VISIBILITY
  open = vtkiOpenPlace(position, normal, facet, pixel);
#endif
  for (int row = vtkiLightRows.x; row < vtkiLightRows.y; ++row)
  {
    // Sums by row keep rounding errors of long sums small.
    vtkiLobeSum partial = vtkiLobeSum(vec3(0.0f), 0.0f);
    int end = min((row + 1) * VTKI_ROW_LENGTH, vtkiLightCount);
    for (int light = row * VTKI_ROW_LENGTH; light < end; ++light)
    {
      vtkiAddLobe(position, normal, open, radius, light, partial);
    }
    total.light += partial.light;
    total.variation += partial.variation;
  }
  return total;
}
