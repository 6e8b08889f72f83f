// Samples at every vtkiStep-th pixel.
#include "vtkIndirectReceiver.glsl"

// A literal where the stage is built for it: divisions by a uniform take as long as a texel.
#ifdef VTKI_STEP
const int vtkiStep = VTKI_STEP;
#else
uniform int vtkiStep;
#endif

// Distance between two samples on a plane that faces the eye.
float vtkiSampleDistance(float depth)
{
  vec3 dx = (vtkiRayOrigin[0] + depth * vtkiRayDirection[0]) * (2.0f / float(vtkiSize.x));
  return float(vtkiStep) * length(dx);
}
