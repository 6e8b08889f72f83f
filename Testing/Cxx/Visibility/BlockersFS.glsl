//VTK::System::Dec
//VTK::Output::Dec
// Test stage: the sum over virtual lights at a pixel's receiver, as in the gather. Visibility is
// tested with voxels, spheres or depth maps (VTKI_VISIBILITY and the definitions of
// vtkIndirectVisibility.glsl), or not at all.
#include "vtkIndirectLibPortable.glsl"
#ifdef VTKI_VISIBILITY
#include "vtkIndirectVisibility.glsl"
#endif

uniform sampler2D vtkiPlaces;  // positions of receivers
uniform sampler2D vtkiNormals; // 0 for a missing receiver
uniform sampler2D vtkiLights;  // positions and areas; in the second row normals
uniform int vtkiLightCount;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 place = texelFetch(vtkiPlaces, pixel, 0).xyz;
  vec3 normal = texelFetch(vtkiNormals, pixel, 0).xyz;
  bool there = dot(normal, normal) > 0.5f;
  vec3 open = place;
#ifdef VTKI_VISIBILITY
  open = vtkiOpenPlace(place, normal);
#endif
  float sum = 0.0f;
  for (int i = 0; there && i < vtkiLightCount; ++i)
  {
    vec4 light = texelFetch(vtkiLights, ivec2(i, 0), 0);
    vec3 lightNormal = texelFetch(vtkiLights, ivec2(i, 1), 0).xyz;
    vec3 way = light.xyz - place;
    float atReceiver = dot(normal, way);
    float atLight = -dot(lightNormal, way);
    bool facing = atReceiver > 0.0f && atLight > 0.0f;
    float distance2 = max(dot(way, way), 1.0e-12f);
    bool seen = facing;
#ifdef VTKI_VISIBILITY
    seen = vtkiIsSenderVisible(i, open, place, normal, vec4(light.xyz, 1.0f), lightNormal, facing) && facing;
#endif
    sum += seen ? atReceiver * atLight / (distance2 * (VTKI_PI * distance2 + light.w)) : 0.0f;
  }
  gl_FragData[0] = vec4(sum, 0.0f, 0.0f, 1.0f);
}
