//VTK::System::Dec
//VTK::Output::Dec
// At one pixel of each block: irradiance of area lights, which is the interpolated unoccluded
// irradiance times the visible share; and that share, which four surrounding pixels find by testing
// all points between them.
#include "vtkIndirectAreaLamps.glsl"
#include "vtkIndirectAreaSamples.glsl"

uniform sampler2D vtkiAreaOpen; // at every vtkiStep-th pixel
uniform sampler2D vtkiAreaOpenFront;

#ifdef VTKI_VISIBILITY
vec3 vtkiFindShare(ivec2 pixel, vtkiReceiver receiver, float width, bool lit)
{
  vec3 seen = vec3(0.0f);
  vec3 all = vec3(0.0f);
  int count = lit ? 4 : 0;
  for (int k = 0; k < count; ++k)
  {
    ivec2 at = pixel + 2 * ivec2(k & 1, k >> 1) - 1;
    vtkiReceiver probe;
    bool same = vtkiFetchReceiver(clamp(at, ivec2(0), vtkiSize - 1), probe) &&
      vtkiLiesOnPlane(probe.positionVC - receiver.positionVC, probe.facetVC, receiver.facetVC,
        VTKI_INTERPOLATION_COSINE, VTKI_INTERPOLATION_DISTANCE * width);
    // Beside thin things the block's pixel tests the points of its four neighbours.
    probe.position = same ? probe.position : receiver.position;
    probe.normal = same ? probe.normal : receiver.normal;
    probe.facet = same ? probe.facet : receiver.facet;
    vtkiAddShares(k * (VTKI_AREA_POINTS / 4), VTKI_AREA_POINTS / 4, probe, seen, all);
  }
  return vtkiShareOf(seen, all);
}
#endif

void main()
{
  ivec2 pixel = min(VTKI_AREA_BLOCK * ivec2(gl_FragCoord.xy), vtkiSize - 1);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  float width = vtkiSampleDistance(receiver.depth) / float(vtkiStep);
  float tolerance = VTKI_INTERPOLATION_DISTANCE * width;
  vtkiGridCell cell = vtkiFindCell(pixel);
  vec3 open = vec3(0.0f);
  float weights = 0.0f;
  float nearest = 1.0e30f;
  float least = 1.0e30f;
  float most = 0.0f;
  for (int k = 0; k < 4; ++k)
  {
    vtkiSample other = vtkiFetchSample(cell, k);
    vec4 light = textureLod(vtkiAreaOpen, other.place, 0.0f);
    bool same = vtkiIsNear(receiver, other, tolerance, VTKI_AREA_COSINE);
    open += same ? other.weight * light.rgb : vec3(0.0f);
    weights += same ? other.weight : 0.0f;
    nearest = same ? min(nearest, light.a) : nearest;
    float front = textureLod(vtkiAreaOpenFront, other.place, 0.0f).r;
    least = same ? min(least, front) : least;
    most = same ? max(most, front) : most;
  }
  // The receivers cross a lamp's plane, where its light ends: do not interpolate across it.
  bool crossed = weights > 0.0f && least != most;
  bool even = !crossed && weights > 0.99f &&
    nearest >= VTKI_AREA_DISTANCES * float(vtkiStep) * width;
  float ownFront;
  vec4 own = vtkiFindOpen(receiver, lit && !even, ownFront);
  crossed = crossed || (!even && weights > 0.0f && ownFront != least);
  open = even ? open / weights : own.rgb;
  nearest = even ? nearest : own.a;
  vec3 share = vec3(1.0f);
#ifdef VTKI_VISIBILITY
  share = vtkiFindShare(pixel, receiver, width, lit);
#endif
  gl_FragData[0] = vec4(open * share, crossed ? 0.0f : nearest / (float(VTKI_AREA_BLOCK) * width));
  gl_FragData[1] = vec4(share, 1.0f);
}
