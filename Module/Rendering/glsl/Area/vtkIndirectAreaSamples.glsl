// Limits of interpolation between samples around a pixel that lie on its surface.
#include "vtkIndirectReceiverGrid.glsl"

// Light is interpolated if it comes from at least this many sample distances away: an inverse power
// of the distance is then off by less than half a hundredth. If not all four samples are on the
// surface, so that their mean position is off the pixel, three times that distance is required.
#ifndef VTKI_AREA_DISTANCES
#define VTKI_AREA_DISTANCES 14.0f
#endif
const float VTKI_AREA_DISTANCES_BESIDE = 3.0f * VTKI_AREA_DISTANCES;

// This is the least cosine between normals over which light is interpolated; other normals may be
// shadowed by other surfaces.
const float VTKI_AREA_COSINE = 0.99f;

// Pixels between samples.
const int VTKI_AREA_BLOCK = 4;

// Returns true if the receiver is on the surface of a sample. The sample's plane alone decides:
// where the receiver's own plane turns samples away, shares of the receiver alone have 1.8 times
// the error. cosine: least cosine of the facets' normals.
bool vtkiIsNear(vtkiReceiver receiver, vtkiSample other, float tolerance, float cosine)
{
  return other.lit &&
    vtkiLiesOnPlane(other.receiver.positionVC - receiver.positionVC, receiver.facetVC,
      other.receiver.facetVC, cosine, tolerance);
}
