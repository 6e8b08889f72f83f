//VTK::System::Dec
//VTK::Output::Dec
// Smooths the visible share of the sky along rows (VTKI_SKY_ROWS) or along columns; the last
// smoothing makes the share irradiance (VTKI_SKY_LAST). A direction represents a part of the sky,
// and the sum has the sharp shadow of its middle alone; the shadows of the part lie beside each
// other, as far as the part is wide at the distance of what hides the sky. A pixel takes the mean of
// its neighbours within this radius, the smaller one of both: light does not spread into contacts.
// Few neighbours leave copies of a shadow's edge as far apart as they are, a weave: a second
// smoothing fills these gaps.
#define VTKI_STEP 1
#include "vtkIndirectReceiverGrid.glsl"
#include "vtkIndirectLibSky.glsl"

uniform sampler2D vtkiSkyShares; // visible shares of the colours; radius, negative: smoothed already
#ifdef VTKI_SKY_KEPT
uniform sampler2D vtkiSkyKept; // shares of the last frame, with negative radius, where there are some
#endif
uniform float vtkiSkyTurn; // one over the square of the angle between normals that ends the mean
uniform float vtkiSkyMost; // largest radius in pixels
uniform float vtkiSkyScale; // radius of the smoothing over the shares' radius
uniform int vtkiSkyNeighbors; // to either side
#ifdef VTKI_SKY_ROWS
const int VTKI_AXIS = 0;
#else
const int VTKI_AXIS = 1;
#endif
#ifdef VTKI_SKY_LAST
uniform sampler2D vtkiOpenSky; // see vtkIndirectSkyFilterFS.glsl
uniform vec3 vtkiOpenFlux;
uniform float vtkiSkyUnit;
#endif

// Largest height of a neighbour over the receiver's plane, over its distance.
const float VTKI_SKY_SLOPE = 0.15f;
// A mean over one side is off where light falls off evenly along the surface, as beside a
// silhouette: where a neighbour has no partner across, this share of its weight counts.
const float VTKI_SKY_ALONE = 0.3f;

struct vtkiSkyNeighbor
{
  vec3 share;
  float weight;
};

// step: pixels along the axis; width: the receiver's radius; ray: its direction, see
// vtkiReconstruct; footprint: distance between pixels.
vtkiSkyNeighbor vtkiFetchNeighbor(
  ivec2 pixel, int step, vtkiReceiver receiver, float width, vec3 ray, float footprint)
{
  ivec2 at = pixel;
  at[VTKI_AXIS] += step;
  bool inside = at[VTKI_AXIS] >= 0 && at[VTKI_AXIS] < vtkiSize[VTKI_AXIS];
  vec2 place = (vec2(at) + 0.5f) / vec2(vtkiSize);
  vec4 surface = textureLod(vtkiSurface, place, 0.0f);
  vec4 share = textureLod(vtkiSkyShares, place, 0.0f);
#ifdef VTKI_SKY_KEPT
  vec4 kept = textureLod(vtkiSkyKept, place, 0.0f);
  share = kept.a < 0.0f ? kept : share;
#endif
  // The offset in the scene is affine in that of pixels and in the neighbour's depth.
  float depth = vtkiSurfaceDepth(surface);
  float along = float(step) * 2.0f / float(vtkiSize[VTKI_AXIS]);
  vec3 offset = along * (vtkiRayOrigin[VTKI_AXIS] + depth * vtkiRayDirection[VTKI_AXIS]) +
    (depth - receiver.depth) * ray;
  float distance2 = dot(offset, offset);
  float tolerance = VTKI_INTERPOLATION_DISTANCE * footprint + VTKI_SKY_SLOPE * sqrt(distance2);
  bool same = inside && vtkiSurfaceIsLit(surface) &&
    abs(dot(receiver.facetVC, offset)) <= tolerance;
  float radius = max(min(width, vtkiSkyScale * abs(share.a)), 1.0e-20f);
  vec3 turn = receiver.normalVC - vtkiSurfaceNormal(surface);
  float part = sqrt(distance2 / (radius * radius) + vtkiSkyTurn * dot(turn, turn));
  return vtkiSkyNeighbor(share.rgb, same ? max(1.0f - part, 0.0f) : 0.0f);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  vec2 at = (vec2(pixel) + 0.5f) / vec2(vtkiSize);
  vec4 own = textureLod(vtkiSkyShares, at, 0.0f);
  vec3 ray = vtkiRayDirection * vec3(2.0f * at - 1.0f, 1.0f);
  float footprint = vtkiSampleDistance(receiver.depth);
  float width = vtkiSkyScale * min(own.a, vtkiSkyMost * footprint);
  float stride = max(width / (footprint * float(vtkiSkyNeighbors + 1)), 1.0f);
  vec3 sum = own.rgb;
  float weights = 1.0f;
  // Within a pixel's radius nothing is smoothed.
  int count = lit && width > footprint ? vtkiSkyNeighbors : 0;
  for (int k = 1; k <= count; ++k)
  {
    int step = int(float(k) * stride + 0.5f);
    vtkiSkyNeighbor a = vtkiFetchNeighbor(pixel, step, receiver, width, ray, footprint);
    vtkiSkyNeighbor b = vtkiFetchNeighbor(pixel, -step, receiver, width, ray, footprint);
    float both = min(a.weight, b.weight);
    a.weight = mix(both, a.weight, VTKI_SKY_ALONE);
    b.weight = mix(both, b.weight, VTKI_SKY_ALONE);
    sum += a.weight * a.share + b.weight * b.share;
    weights += a.weight + b.weight;
  }
  sum /= weights;
#ifdef VTKI_SKY_LAST
  float open = textureLod(vtkiOpenSky, vtkiOpenSkyPlace(receiver.normal), 0.0f).r +
    dot(vtkiOpenFlux, receiver.normal);
  gl_FragData[0] = vec4(lit ? vtkiSkyUnit * max(open, 0.0f) * sum : vec3(0.0f), 1.0f);
#else
  gl_FragData[0] = lit ? vec4(sum, own.a) : vec4(0.0f);
#endif
}
