//VTK::System::Dec
// The paper's splats: one point for each subsplat and virtual light, the light an instance.
#include "vtkIndirectSubsplatLeaf.glsl"

in uint vtkiSplitTexel; // x, y in 16 bits each, one level up
uniform ivec2 vtkiChild;
flat out vec3 vtkiPointIrradiance;
flat out vec3 vtkiPointVector;

void main()
{
  ivec2 texel =
    2 * ivec2(int(vtkiSplitTexel & 0xffffu), int(vtkiSplitTexel >> 16)) + vtkiChild;
  vec3 position;
  vec3 normal;
  vec3 facet;
  bool leaf = vtkiFetchLeaf(texel, position, normal, facet);
  vec4 sender;
  vec4 senderNormal;
  vec3 density;
  vtkiFetchLight(gl_InstanceID, sender, senderNormal, density);
  vec3 irradiance = vec3(0.0f);
  vec3 vectorIrradiance = vec3(0.0f);
  vtkiAddWholeLight(position, normal, vtkiOpenPlace(position, normal, facet), vtkiFirstLight + gl_InstanceID, sender,
    senderNormal, density, irradiance, vectorIrradiance);
#ifdef VTKI_PIXELS
  vec2 ndc = 2.0f * (vec2(texel) + 0.5f) / vec2(vtkiSize) - 1.0f;
  irradiance *= vtkiDetail(ndc, normal * mat3(vtkiViewToScene));
#endif
  vtkiPointIrradiance = irradiance * vtkiStorageScale;
  vtkiPointVector = (vectorIrradiance * mat3(vtkiViewToScene)) * vtkiStorageScale;
  vec2 place = 2.0f * (vec2(texel) + 0.5f) / vec2(vtkiLevelSize) - 1.0f;
  gl_Position = leaf ? vec4(place, 0.0f, 1.0f) : vec4(2.0f, 2.0f, 2.0f, 1.0f);
}
