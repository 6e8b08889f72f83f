// Irradiance interpolated from samples.
#include "vtkIndirectReceiverGrid.glsl"

uniform sampler2D vtkiCoarse;

// Bilinear sum of the four surrounding samples that lie on the receiver's surface, the sum of their
// weights, and their number.
void vtkiInterpolateCoarse(
  ivec2 pixel, vtkiReceiver receiver, out vec3 sum, out float weights, out int agreeing)
{
  vtkiGridCell cell = vtkiFindCell(pixel);
  sum = vec3(0.0f);
  weights = 0.0f;
  agreeing = 0;
  for (int i = 0; i < 4; ++i)
  {
    vtkiSample other = vtkiFetchSample(cell, i);
    if (vtkiIsSameSurface(receiver, other))
    {
      sum += other.weight * textureLod(vtkiCoarse, other.place, 0.0f).rgb;
      weights += other.weight;
      ++agreeing;
    }
  }
}
