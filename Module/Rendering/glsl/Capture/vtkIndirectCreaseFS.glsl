//VTK::System::Dec
//VTK::Output::Dec
// Finds the nearest surface around each pixel that meets the pixel's own in a concave crease, and how
// far the other surface goes on; see vtkIndirectLibCrease.glsl. Both must be flat: the planes of
// curved surfaces and of relief hide too much. Any other facet that meets the receiver's own in a fold
// hides nothing and has no extent, but tells that what rises over the receiver is its neighbour.
#define VTKI_STEP 1
#include "vtkIndirectReceiverGrid.glsl"
#include "vtkIndirectLibCrease.glsl"

uniform int vtkiCreaseStep; // pixels from one whose crease is found to the next

// These are the distances in the image at which the other surface is looked for, in pixels: the
// least, four times the least and so on, up to half the reach.
const int VTKI_CREASE_NEAR = 2;
const int VTKI_CREASE_FAR = 8;
const int VTKI_CREASE_FARTHEST = 64;
// Halvings of the other surface's extent until its border is beyond.
const int VTKI_CREASE_HALVINGS = 4;
// This is the least height of another surface over the receiver's plane, over its distance in the
// image.
const float VTKI_CREASE_RISE = 0.05f;

ivec2 vtkiCreasePixel()
{
  return min(vtkiCreaseStep * ivec2(gl_FragCoord.xy) + vtkiCreaseStep / 2, vtkiSize - 1);
}

// Returns one of the eight pixels at a distance, kept within the image.
ivec2 vtkiPixelBeside(ivec2 pixel, int i, int distance)
{
  int turn = i < 4 ? i : i + 1;
  return clamp(pixel + (ivec2(turn % 3, turn / 3) - 1) * distance, ivec2(0), vtkiSize - 1);
}

// Returns false where no lit surface was drawn, or beyond the image.
bool vtkiFetchNeighbor(ivec2 at, out vec3 position, out vec3 facet)
{
  vtkiReceiver neighbor;
  bool lit = vtkiFetchReceiver(at, neighbor);
  position = neighbor.positionVC;
  facet = neighbor.facetVC;
  return lit && clamp(at, ivec2(0), vtkiSize - 1) == at;
}

// Returns true if the surface at a pixel goes on as a plane to the pixel that lies `way` further
// on, or at the image's border beside it.
bool vtkiIsFlatAround(ivec2 at, ivec2 way, vec3 position, vec3 facet)
{
  ivec2 ahead = clamp(at + way, ivec2(0), vtkiSize - 1);
  ivec2 beside = clamp(at + way.yx, ivec2(0), vtkiSize - 1);
  vec3 further;
  vec3 furtherFacet;
  return vtkiFetchNeighbor(ahead == at ? beside : ahead, further, furtherFacet) &&
    vtkiIsFlat(facet, furtherFacet, further - position);
}

// Returns the pixel that shows a place near the receiver; for places just beyond the image a pixel
// of its border. offset: from the receiver.
ivec2 vtkiPixelOf(vtkiReceiver receiver, vec3 offset)
{
  vec2 center = vec2(vtkiCreasePixel()) + 0.5f;
  vec3 ndc = vec3(2.0f * center / vec2(vtkiSize) - 1.0f, 1.0f);
  vec2 aside = offset.xy + offset.z * (vtkiRayDirection * ndc).xy;
  float depth = receiver.depth - offset.z;
  vec2 halfSize = vec2(vtkiRayOrigin[0].x + depth * vtkiRayDirection[0].x,
    vtkiRayOrigin[1].y + depth * vtkiRayDirection[1].y);
  vec2 place = center + 0.5f * vec2(vtkiSize) * aside / halfSize;
  vec2 inside = clamp(place, vec2(0.5f), vec2(vtkiSize) - 0.5f);
  vec2 beyond = abs(place - inside);
  return max(beyond.x, beyond.y) > float(VTKI_CREASE_FAR) ? ivec2(-1) : ivec2(inside);
}

// Returns true if a surface rises over the receiver's plane at one of eight pixels at a distance:
// elsewhere there is no crease. In software only loops save the look-ups of pixels without a
// crease.
bool vtkiSurfaceRises(ivec2 pixel, vtkiReceiver receiver, bool lit, float width, int distance)
{
  bool rises = false;
  for (int i = 0; i < (lit ? 8 : 0); ++i)
  {
    vec3 position;
    vec3 facet;
    bool there = vtkiFetchNeighbor(vtkiPixelBeside(pixel, i, distance), position, facet);
    float height = dot(receiver.facetVC, position - receiver.positionVC);
    rises = rises || (there && height > VTKI_CREASE_RISE * width * float(distance));
  }
  return rises;
}

struct vtkiOther
{
  vec3 normal; // zero if there is none
  vec3 offset; // from the receiver to a position on the surface
};

// Finds the nearest flat surface that meets the receiver's own in a crease, at eight pixels in each
// of some rings, and the nearest facet in the first ring that meets the receiver's facet in a fold:
// farther facets are no neighbours, and light would enter closed bodies beside them.
vtkiOther vtkiFindOtherSurface(ivec2 pixel, vtkiReceiver receiver, int rings, int far, out vtkiOther fold)
{
  float nearest = 16.0f * VTKI_CREASE_REACH * VTKI_CREASE_REACH;
  float nearestFold = nearest;
  vtkiOther other = vtkiOther(vec3(0.0f), vec3(0.0f));
  fold = other;
  for (int i = 0; i < rings * 8; ++i)
  {
    int distance = min(VTKI_CREASE_NEAR << (2 * (i >> 3)), far);
    ivec2 at = vtkiPixelBeside(pixel, i & 7, distance);
    ivec2 way = at - pixel;
    vec3 position;
    vec3 facet;
    bool there = vtkiFetchNeighbor(at, position, facet);
    vec3 apart = position - receiver.positionVC;
    float apart2 = dot(apart, apart);
    bool folds = there && i < 8 && apart2 < nearestFold &&
      vtkiMeetsInCrease(receiver.facetVC, facet, apart, VTKI_FOLD_COSINE);
    nearestFold = folds ? apart2 : nearestFold;
    fold.offset = folds ? apart : fold.offset;
    fold.normal = folds ? facet : fold.normal;
    bool meets = there && apart2 < nearest &&
      vtkiMeetsInCrease(receiver.facetVC, facet, apart, VTKI_CREASE_COSINE);
    for (int k = 0; k < (meets ? 1 : 0); ++k)
    {
      meets = vtkiIsFlatAround(at, way, position, facet) &&
        vtkiIsFlatAround(pixel, -way, receiver.positionVC, receiver.facetVC);
    }
    nearest = meets ? apart2 : nearest;
    other.offset = meets ? apart : other.offset;
    other.normal = meets ? facet : other.normal;
  }
  return other;
}

// Returns how far the other surface, or one that stands on it, goes on before the receiver and to
// both sides, or 0 if it ends at once.
float vtkiFindExtent(vtkiReceiver receiver, vec3 normal, vec3 offset)
{
  vec3 outwards = normalize(receiver.facetVC - dot(receiver.facetVC, normal) * normal);
  vec3 along = cross(normal, outwards);
  float extent = VTKI_CREASE_REACH;
  bool present = false;
  bool found = normal != vec3(0.0f);
  for (int halving = 0; halving < VTKI_CREASE_HALVINGS && found && !present; ++halving)
  {
    bool whole = true;
    for (int side = -1; side < 2; ++side)
    {
      vec3 place = dot(offset, normal) * normal +
        extent * ((side == 0 ? 1.0f : 0.25f) * outwards + float(side) * along);
      vec3 seen;
      vec3 seenFacet;
      bool there = vtkiFetchNeighbor(vtkiPixelOf(receiver, place), seen, seenFacet);
      seen -= receiver.positionVC;
      whole = whole && there && (side != 0 || dot(receiver.facetVC, seen) > 0.1f * extent) &&
        dot(normal, seen - offset) > -VTKI_CREASE_ROUNDING - VTKI_CREASE_FLAT_HEIGHT * extent;
    }
    present = whole;
    extent = present ? extent : 0.5f * extent;
  }
  return present ? extent : 0.0f;
}

void main()
{
  ivec2 pixel = vtkiCreasePixel();
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  float width = vtkiSampleDistance(receiver.depth);
  int far = clamp(int(0.5f * VTKI_CREASE_REACH / width), VTKI_CREASE_FAR, VTKI_CREASE_FARTHEST);
  int rings = 2 + int(far > 4 * VTKI_CREASE_NEAR) + int(far > 16 * VTKI_CREASE_NEAR);
  bool rises = vtkiSurfaceRises(pixel, receiver, lit, width, far);
  vtkiOther fold;
  vtkiOther other = vtkiFindOtherSurface(pixel, receiver, rises ? rings : 0, far, fold);
  float extent = vtkiFindExtent(receiver, other.normal, other.offset);
  vec3 normal = extent > 0.0f ? other.normal : fold.normal;
  vec3 offset = extent > 0.0f ? other.offset : fold.offset;
  // The plane goes with the normal as packed.
  float code = vtkiPackNormal(mat3(vtkiViewToScene) * normal, VTKI_SURFACE_LINEAR);
  vec3 position = (vtkiViewToScene * vec4(receiver.positionVC + offset, 1.0f)).xyz;
  float plane = dot(vtkiOctahedralDecode(vtkiUnpackCode(code)), position);
  gl_FragData[0] = normal != vec3(0.0f) ? vec4(code, plane, extent * extent, 1.0f) : vec4(0.0f);
}
