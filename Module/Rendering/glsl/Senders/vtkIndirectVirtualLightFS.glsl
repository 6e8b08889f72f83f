//VTK::System::Dec
//VTK::Output::Dec
// Makes one virtual light a fragment from a pattern of map coordinates.
#include "vtkIndirectMapTexel.glsl"
#ifdef VTKI_AMBIENT_OCCLUSION
#include "vtkIndirectLibImportance.glsl"
#include "vtkIndirectAccessibility.glsl"
#endif

// map coordinates in [0,1)^2, layer, texels that the sample represents
uniform sampler2D vtkiPattern;
uniform float vtkiShareOfArea; // share of the light's area that its disk has

void main()
{
  vec4 sampled = texelFetch(vtkiPattern, ivec2(gl_FragCoord.xy), 0);
  vtkiVirtualLight light;
  int layer = int(sampled.z + 0.5f);
  float texels = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_SHAPE, max(layer, 0)), 0).z;
  ivec2 texel = ivec2(min(sampled.xy * texels, vec2(texels - 1.0f)));
  float weight = sampled.w;
  // The pattern has weight zero after its last sample.
  if (!(weight > 0.0f) || !vtkiVirtualLightFromTexel(layer, texel, light))
  {
    light.area = 1.0f;
    light.densityArea = vec3(0.0f);
    light.position = vec3(0.0f);
    light.normal = vec3(0.0f, 0.0f, 1.0f);
    weight = 1.0f;
  }
#ifdef VTKI_AMBIENT_OCCLUSION
  // Not physical: removes the light of open surfaces.
  if (light.densityArea != vec3(0.0f))
  {
    light.densityArea *= 1.0f - vtkiAccessibility(layer, texel);
  }
#endif
  // Several lights on one texel share its light; each is a disk of the texel's size.
  gl_FragData[0] = vec4(light.position, light.area * max(vtkiShareOfArea * weight, 1.0f));
  gl_FragData[1] = vec4(light.normal, 0.0f);
  gl_FragData[2] = vec4(light.densityArea * weight, light.source);
}
