// Samples at every vtkiStep-th pixel.
#include "vtkIndirectReceiver.glsl"

uniform int vtkiStep;

// Distance between two samples on a plane that faces the eye.
float vtkiSampleDistance(float depth)
{
  vec3 dx = (vtkiRayOrigin[0] + depth * vtkiRayDirection[0]) * (2.0f / float(vtkiSize.x));
  return float(vtkiStep) * length(dx);
}
