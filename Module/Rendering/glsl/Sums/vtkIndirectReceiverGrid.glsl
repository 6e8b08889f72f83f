// Receivers at every vtkiStep-th pixel, from border to border: samples of light that other pixels
// interpolate. vtkIndirectReceiverGrid sets the uniforms.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectLibReceiverGrid.glsl"

// A literal if the stage is built for one step: a division by a uniform takes as long as a texel.
#ifdef VTKI_STEP
const int vtkiStep = VTKI_STEP;
#else
uniform int vtkiStep;
#endif
uniform ivec2 vtkiCoarseSize; // samples

// Distance between two samples on a plane that faces the eye.
float vtkiSampleDistance(float depth)
{
  vec3 dx = (vtkiRayOrigin[0] + depth * vtkiRayDirection[0]) * (2.0f / float(vtkiSize.x));
  return float(vtkiStep) * length(dx);
}

// Returns the pixel of a sample.
ivec2 vtkiSamplePixel(ivec2 at)
{
  return min(at * vtkiStep, vtkiSize - 1);
}

// One of the four samples around a pixel.
struct vtkiSample
{
  bool lit; // there is a lit surface, which is the receiver
  vtkiReceiver receiver;
  vec2 place;   // in the images of samples, from 0 to 1
  float weight; // bilinear
};

vtkiGridCell vtkiFindCell(ivec2 pixel)
{
  return vtkiFindCell(pixel, vtkiStep, vtkiSize - 1);
}

vtkiSample vtkiFetchSample(vtkiGridCell cell, int i)
{
  ivec2 at = min(cell.corner + ivec2(i & 1, i >> 1), vtkiCoarseSize - 1);
  vtkiSample found;
  found.lit = vtkiFetchReceiver(vtkiSamplePixel(at), found.receiver);
  found.place = (vec2(at) + 0.5f) / vec2(vtkiCoarseSize);
  found.weight = vtkiCellWeight(cell, i);
  return found;
}

// Returns the agreement of two receivers, between 0 and 1; distance: between samples.
float vtkiAgreement(vtkiReceiver receiver, vtkiReceiver other, float distance)
{
  return vtkiAgreement(
    other.positionVC - receiver.positionVC, receiver.normalVC, other.normalVC, distance);
}

// Returns true if a sample is on the receiver's surface. The normals decide as well as the facets:
// light depends on the former, and the latter tell what a surface is.
bool vtkiIsSameSurface(vtkiReceiver receiver, vtkiSample other)
{
  return other.lit &&
    dot(receiver.normalVC, other.receiver.normalVC) >= VTKI_INTERPOLATION_COSINE &&
    vtkiSameSurface(other.receiver.positionVC - receiver.positionVC, receiver.facetVC,
      other.receiver.facetVC, VTKI_INTERPOLATION_COSINE,
      VTKI_INTERPOLATION_DISTANCE * vtkiSampleDistance(receiver.depth));
}
