// Coarse receivers at every vtkiStep-th pixel.
#include "vtkIndirectReceiver.glsl"

// A literal if the stage is built for one step: a division by a uniform takes as long as a texel.
#ifdef VTKI_STEP
const int vtkiStep = VTKI_STEP;
#else
uniform int vtkiStep;
#endif

// Distance between two coarse receivers on a plane that faces the eye.
float vtkiSampleDistance(float depth)
{
  vec3 dx = (vtkiRayOrigin[0] + depth * vtkiRayDirection[0]) * (2.0f / float(vtkiSize.x));
  return float(vtkiStep) * length(dx);
}
