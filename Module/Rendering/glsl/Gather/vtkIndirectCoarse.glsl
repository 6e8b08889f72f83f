// Irradiance from coarse samples: one at every vtkiStep-th pixel, from border to border.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectLibInterpolation.glsl"
#include "vtkIndirectStep.glsl"

uniform sampler2D vtkiCoarse;
uniform ivec2 vtkiCoarseSize;

// Bilinear sum of the four surrounding samples that lie on the receiver's surface, the sum of their
// weights, and their number.
void vtkiInterpolateCoarse(
  ivec2 pixel, vtkiReceiver receiver, out vec3 sum, out float weights, out int agreeing)
{
  float tolerance = VTKI_INTERPOLATION_DISTANCE * vtkiSampleDistance(receiver.depth);

  // The last samples may be closer together.
  ivec2 corner = pixel / vtkiStep;
  ivec2 first = corner * vtkiStep;
  vec2 blend = vec2(pixel - first) / vec2(max(min(first + vtkiStep, vtkiSize - 1) - first, 1));
  sum = vec3(0.0f);
  weights = 0.0f;
  agreeing = 0;
  for (int i = 0; i < 4; ++i)
  {
    ivec2 shift = ivec2(i & 1, i >> 1);
    ivec2 at = min(corner + shift, vtkiCoarseSize - 1);
    vtkiReceiver other;
    bool lit = vtkiFetchReceiver(min(at * vtkiStep, vtkiSize - 1), other);
    if (lit && dot(receiver.normalVC, other.normalVC) >= VTKI_INTERPOLATION_COSINE &&
      vtkiSameSurface(other.positionVC - receiver.positionVC, receiver.facetVC, other.facetVC,
        VTKI_INTERPOLATION_COSINE, tolerance))
    {
      vec2 w = mix(1.0f - blend, blend, vec2(shift));
      sum += w.x * w.y * textureLod(vtkiCoarse, (vec2(at) + 0.5f) / vec2(vtkiCoarseSize), 0.0f).rgb;
      weights += w.x * w.y;
      ++agreeing;
    }
  }
}
