//VTK::System::Dec
//VTK::Output::Dec
// Irradiance at a pixel near an edge: interpolated from samples of the first level that lie on its
// surface, evaluated if that level is split or has no such sample.
#include "vtkIndirectSubsplatTexel.glsl"
#include "vtkIndirectSubsplatInterpolate.glsl"

uniform bool vtkiSplits; // pixels are the finest level
uniform bool vtkiCorrectNormals;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(vtkiSurface, pixel, 0);
  vec2 ndc = 2.0f * (vec2(pixel) + 0.5f) / vec2(vtkiSize) - 1.0f;
  vec3 position = vtkiReconstruct(ndc, vtkiSurfaceDepth(surface), vtkiRayOrigin, vtkiRayDirection);
  vec3 normal = vtkiSurfaceNormal(surface);
  bool split = vtkiSubsplatIsSplit(texelFetch(vtkiCoarserSurface, pixel >> 1, 0).w);
  vec3 irradiance;
  vec3 vectorIrradiance;
  bool interpolated = vtkiInterpolateSubsplat(pixel,
    vtkiMakeTangentPlane(
      position, normal, vtkiSurfaceCode(surface), vtkiSurfaceDepth(surface), vtkiCoarserEdge),
    vtkiSplits, irradiance, vectorIrradiance);
  // The normal of a sample on another surface says nothing about the pixel's.
  if (vtkiCorrectNormals && interpolated)
  {
    irradiance *=
      vtkiNormalCorrection(vtkiLuminance(irradiance), dot(normal, vectorIrradiance));
  }
#ifdef VTKI_EVALUATE
  bool evaluate = (vtkiSplits && split) || !interpolated;
  vec3 evaluated;
  vec3 evaluatedVector;
  vtkiEvaluateStored(position, normal, vtkiSurfaceFacet(surface), pixel, evaluate, evaluated, evaluatedVector);
  irradiance = evaluate ? evaluated : irradiance;
#elif !defined(VTKI_NEAREST)
  irradiance = vtkiSplits && split ? vec3(0.0f) : irradiance;
#endif
  gl_FragData[0] = vec4(irradiance * vtkiDetail(ndc, normal), 1.0f);
}
