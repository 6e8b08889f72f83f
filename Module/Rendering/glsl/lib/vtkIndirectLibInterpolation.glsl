// When a coarse sample may stand for a pixel.
#ifndef vtkIndirectLibInterpolation
#define vtkIndirectLibInterpolation
#include "vtkIndirectLibPortable.glsl"

/* True when a sample lies on the pixel's surface: normals agree and each lies near the other's
 * tangent plane. offset: sample minus pixel position; footprint: distance between samples there. */
bool vtkiSameSurface(
  vec3 offset, vec3 normal, vec3 sampleNormal, float minimumCosine, float planeTolerance)
{
  return dot(normal, sampleNormal) >= minimumCosine &&
    max(abs(dot(normal, offset)), abs(dot(sampleNormal, offset))) <= planeTolerance;
}
#endif
