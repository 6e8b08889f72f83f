//VTK::System::Dec
//VTK::Output::Dec
// Luminance of the irradiance at one pixel in each texel of the coarsest level, to see how the
// lighting varies before the image is cut up.
#include "vtkIndirectSubsplatTexel.glsl"

uniform sampler2D vtkiSurface;

void main()
{
  vec2 center =
    vtkiSubsplatCenter(floor(gl_FragCoord.xy), vtkiEdge, vec2(vtkiSize));
  vec4 surface = textureLod(vtkiSurface, 0.5f * center + 0.5f, 0.0f);
  vec3 irradiance;
  vec3 vectorIrradiance;
  vtkiEvaluateStored(vtkiReconstruct(center, surface.z, vtkiRayOrigin, vtkiRayDirection),
    vtkiSurfaceNormal(surface), vtkiSurfaceIsLit(surface), irradiance, vectorIrradiance);
  gl_FragData[0] = vec4(vtkiLuminance(irradiance), 0.0f, 0.0f, 1.0f);
}
