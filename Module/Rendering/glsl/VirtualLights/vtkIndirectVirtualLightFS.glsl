//VTK::System::Dec
//VTK::Output::Dec
// One fragment a virtual light: a pattern of map coordinates in, lights out.
#include "vtkIndirectMapTexel.glsl"
#ifdef VTKI_AMBIENT_OCCLUSION
#include "vtkIndirectLibImportance.glsl"
#include "vtkIndirectAccessibility.glsl"
#endif

uniform sampler2D vtkiPattern; // map coordinates in [0,1)^2, layer, texels that the sample stands for
uniform float vtkiShareOfArea; // of what a light stands for, that its disk has

void main()
{
  vec4 sampled = texelFetch(vtkiPattern, ivec2(gl_FragCoord.xy), 0);
  vtkiVirtualLight light;
  int layer = int(sampled.z + 0.5f);
  float texels = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_SHAPE, max(layer, 0)), 0).z;
  ivec2 texel = ivec2(min(sampled.xy * texels, vec2(texels - 1.0f)));
  float weight = sampled.w;
  // Past the last sample the pattern holds weight zero.
  if (!(weight > 0.0f) || !vtkiVirtualLightFromTexel(layer, texel, light))
  {
    light.area = 1.0f;
    light.densityArea = vec3(0.0f);
    light.position = vec3(0.0f);
    light.normal = vec3(0.0f, 0.0f, 1.0f);
    weight = 1.0f;
  }
#ifdef VTKI_AMBIENT_OCCLUSION
  // Not physical: light of open surfaces is left out.
  if (light.densityArea != vec3(0.0f))
  {
    light.densityArea *= 1.0f - vtkiAccessibility(layer, texel);
  }
#endif
  // Several lights on one texel share its light; each of them is a disk as large as it.
  gl_FragData[0] = vec4(light.position, light.area * max(vtkiShareOfArea * weight, 1.0f));
  gl_FragData[1] = vec4(light.normal, 0.0f);
  gl_FragData[2] = vec4(light.densityArea * weight, light.source);
}
