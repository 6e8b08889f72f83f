//VTK::System::Dec
// The paper's splats: one point for each subsplat and virtual light, the light an instance.
#include "vtkIndirectSubsplatTexel.glsl"

in uint vtkiSplitTexel; // x, y in 16 bits each, one level up
uniform ivec2 vtkiChild;
#ifdef VTKI_PIXELS
uniform sampler2D vtkiSurface;
#endif
flat out vec3 vtkiPointIrradiance;
flat out vec3 vtkiPointVector;

void main()
{
  ivec2 texel =
    2 * ivec2(int(vtkiSplitTexel & 0xffffu), int(vtkiSplitTexel >> 16)) + vtkiChild;
  ivec2 inside = min(texel, vtkiLevelSize - 1);
#ifdef VTKI_PIXELS
  vec4 surface = texelFetch(vtkiSurface, inside, 0);
  vec2 ndc = 2.0f * (vec2(texel) + 0.5f) / vec2(vtkiSize) - 1.0f;
  vec3 position = vtkiReconstruct(ndc, surface.z, vtkiRayOrigin, vtkiRayDirection);
  vec3 normal = vtkiSurfaceNormal(surface);
  bool leaf = vtkiSurfaceIsLit(surface);
#else
  vec4 surface = texelFetch(vtkiLevelSurface, inside, 0);
  vec3 position = vtkiTexelPosition(texel, surface.z);
  vec3 normal = vtkiOctahedralDecode(surface.xy);
  bool leaf = surface.w == VTKI_SUBSPLAT_WHOLE || surface.w == VTKI_SUBSPLAT_MIXED;
#endif
  leaf = leaf && texel == inside;
  position = (vtkiViewToScene * vec4(position, 1.0f)).xyz;
  normal = mat3(vtkiViewToScene) * normal;
  ivec2 at = ivec2(gl_InstanceID % vtkiRowLength, gl_InstanceID / vtkiRowLength);
  vec3 irradiance = vec3(0.0f);
  vec3 vectorIrradiance = vec3(0.0f);
  vtkiAddLight(position, normal, texelFetch(vtkiLightPosition, at, 0),
    texelFetch(vtkiLightNormal, at, 0).xyz, texelFetch(vtkiLightDensity, at, 0).rgb, irradiance,
    vectorIrradiance);
#ifdef VTKI_PIXELS
  irradiance *= vtkiDetail(ndc, normal * mat3(vtkiViewToScene));
#endif
  vtkiPointIrradiance = irradiance * vtkiStorageScale;
  vtkiPointVector = (vectorIrradiance * mat3(vtkiViewToScene)) * vtkiStorageScale;
  vec2 place = 2.0f * (vec2(texel) + 0.5f) / vec2(vtkiLevelSize) - 1.0f;
  gl_Position = leaf ? vec4(place, 0.0f, 1.0f) : vec4(2.0f, 2.0f, 2.0f, 1.0f);
}
