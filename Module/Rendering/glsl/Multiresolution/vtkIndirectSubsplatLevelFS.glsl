//VTK::System::Dec
//VTK::Output::Dec
// Illumination of a level near edges: evaluated at leaves, here or afterwards in blocks, and
// interpolated if the level above is whole. Below the finest level that is split, texels without a
// sample of the level above on their surface are evaluated here. Marks texels inside one surface.
#include "vtkIndirectSubsplatTexel.glsl"
#include "vtkIndirectSubsplatInterpolate.glsl"

uniform bool vtkiSplits; // the level above is split

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(vtkiLevelSurface, texel, 0);
  float coarser = texelFetch(vtkiCoarserSurface, texel >> 1, 0).w;
  bool covered = vtkiSubsplatState(coarser) == VTKI_SUBSPLAT_WHOLE;
  bool here = vtkiSubsplatIsSample(surface.w);
  vec3 position = vtkiTexelPosition(texel, surface.z);
  vec3 normal = vtkiOctahedralDecode(surface.xy);
  vec3 irradiance;
  vec3 vectorIrradiance;
  bool interpolated = vtkiInterpolateSubsplat(texel,
    vtkiMakeTangentPlane(position, normal, surface.xy, surface.z, vtkiCoarserEdge), vtkiSplits,
    irradiance, vectorIrradiance);
  bool leaf = here && (vtkiSplits ? !covered : !interpolated);
#ifdef VTKI_EVALUATE
  vec3 evaluated;
  vec3 evaluatedVector;
  vec3 samplePosition;
  vec3 facet;
  vtkiFindSample(texel, surface, normal, samplePosition, facet);
  vtkiEvaluateStored(
    samplePosition, normal, facet, vtkiTexelPixel(texel), leaf, evaluated, evaluatedVector);
  irradiance = leaf ? evaluated : irradiance;
  vectorIrradiance = leaf ? evaluatedVector : vectorIrradiance;
#elif defined(VTKI_NEAREST)
  // The vector of samples on other surfaces does not tell how light changes with the normal here.
  vectorIrradiance = interpolated ? vectorIrradiance : vtkiLuminance(irradiance) * normal;
#else
  irradiance = leaf ? vec3(0.0f) : irradiance;
  vectorIrradiance = leaf ? vec3(0.0f) : vectorIrradiance;
#endif

  bool inside = vtkiIsInsideSurface(texel, surface, position, normal);
  gl_FragData[0] = vec4(irradiance,
    here ? (inside ? VTKI_ILLUMINATION_SMOOTH : VTKI_ILLUMINATION_HERE)
         : VTKI_ILLUMINATION_NONE);
  gl_FragData[1] = vec4(vectorIrradiance, vtkiSubsplatIsSplit(surface.w) ? 1.0f : 0.0f);
}
