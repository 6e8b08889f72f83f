//VTK::System::Dec
//VTK::Output::Dec
// Light that each surface reflects under the current hints.
#include "vtkIndirectHintLookup.glsl"

uniform sampler2D vtkiSurfelPosition;
uniform sampler2D vtkiSurfelNormal;
uniform sampler2D vtkiSurfelAlbedo;
uniform int vtkiSurfelCount;
uniform vec4 vtkiMeanAlbedo; // 1 in the last component: for all surfaces

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  bool there = vtkiTableEntry(at) < vtkiSurfelCount;
  vec3 normal = texelFetch(vtkiSurfelNormal, at, 0).xyz;
  vec3 e = vtkiHintIrradiance(texelFetch(vtkiSurfelPosition, at, 0).xyz,
    there ? normal : vec3(0.0f, 0.0f, 1.0f), at, there);
  vec3 albedo =
    vtkiMeanAlbedo.w > 0.0f ? vtkiMeanAlbedo.rgb : texelFetch(vtkiSurfelAlbedo, at, 0).rgb;
  gl_FragData[0] = vec4(there ? albedo * max(e, vec3(0.0f)) : vec3(0.0f), 1.0f);
}
