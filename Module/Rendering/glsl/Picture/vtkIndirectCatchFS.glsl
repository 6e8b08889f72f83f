//VTK::System::Dec
//VTK::Output::Dec
// Factors on the background at surfaces that catch light, by which blending multiplies it: the
// share that is kept, and in alpha one minus the share that is kept of all colours; or with
// VTKI_BRIGHTENS the share that is added.
#include "vtkIndirectAddedLight.glsl"
#include "vtkIndirectAlbedo.glsl"
#include "vtkIndirectBalance.glsl"
#include "vtkIndirectLibColor.glsl"
#include "vtkIndirectCaught.glsl"

uniform sampler2D vtkiDepth;
uniform ivec2 vtkiOrigin;
uniform float vtkiIndirectScale;

void main()
{
  vec2 position = gl_FragCoord.xy - vec2(vtkiOrigin);
  vec2 place = position / vec2(vtkiSize);
  vec4 surface = textureLod(vtkiSurface, place, 0.0f);
  if (!vtkiSurfaceCatches(surface))
  {
    discard;
  }
  vec3 share = vtkiFindCaught(position, surface, textureLod(vtkiLit, place, 0.0f).rgb,
    vtkiFetchAlbedo(ivec2(position)), vtkiIndirectScale);
#ifdef VTKI_BRIGHTENS
  vec3 more = max(share - 1.0f, vec3(0.0f));
  if (more == vec3(0.0f))
  {
    discard;
  }
  gl_FragData[0] = vec4(more, 0.0f);
#else
  share = min(share, vec3(1.0f));
  if (share == vec3(1.0f))
  {
    discard;
  }
  gl_FragData[0] = vec4(share, 1.0f - min(share.r, min(share.g, share.b)));
#endif
  gl_FragDepth = textureLod(vtkiDepth, place, 0.0f).r;
}
