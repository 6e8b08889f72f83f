//VTK::System::Dec
//VTK::Output::Dec
// Irradiance of earlier frames at the places that the eye sees again: a bilinear mean of those
// pixels that lie on the place's surface. Where the eye sees a few more pixels of a surface, such as
// beside an outline, the mean of pixels around the place. Such a mean passes on three times at most:
// otherwise an outline that moves would draw one irradiance along. With VTKI_REPROJECT_RADIUS alpha
// is a radius, that of the heaviest pixel, negative, see vtkIndirectSkyReprojection, and cannot tell
// how often a mean was passed on: pixels around a place do not count.
#include "vtkIndirectLibSurface.glsl"
#include "vtkIndirectLibReprojection.glsl"

uniform ivec2 vtkiSize;
uniform mat3 vtkiRayOrigin;
uniform mat3 vtkiRayDirection;
uniform sampler2D vtkiSurface;
uniform ivec2 vtkiRowsAnew; // first row, and row after the last one, that are summed anew

// The last frame's, and those of the key picture, an earlier frame.
uniform sampler2D vtkiSurfaceBefore;
uniform sampler2D vtkiIrradianceBefore;
uniform mat3 vtkiRayOriginBefore;
uniform mat3 vtkiRayDirectionBefore;
uniform mat4 vtkiViewToBefore;     // to view coordinates
uniform mat4 vtkiViewToClipBefore; // to clip coordinates
#ifdef VTKI_REPROJECT_KEY
uniform sampler2D vtkiSurfaceOfKey;
uniform sampler2D vtkiIrradianceOfKey;
uniform mat3 vtkiRayOriginOfKey;
uniform mat3 vtkiRayDirectionOfKey;
uniform mat4 vtkiViewToKey;
uniform mat4 vtkiViewToClipOfKey;
#endif

// Limits for pixels of one surface: distance from the tangent plane in widths of a pixel, and
// difference of octahedral coordinates.
const float vtkiSamePlaneBefore = 1.0f;
const float vtkiSameNormalBefore = 0.2f;
// Least sum of the bilinear weights.
const float vtkiEnoughBefore = 0.2f;
// Pixels around a place whose own pixels do not show its surface: rings of eight pixels, at a
// distance of 1 and 2 pixels. The second has wider limits.
const int vtkiRingsBefore = 2;
const float vtkiWidenPlaneBefore = 3.0f;

// The receiver in an earlier frame's view coordinates.
struct vtkiReceiverBefore
{
  vec2 at;          // its place in the picture, in pixels
  vec3 alongOrigin; // its facet in the ray's origin and direction
  vec3 alongDirection;
  float offset;    // of its plane
  float tolerance; // distance from the plane
  vec2 code;       // octahedral normal
  bool ahead;      // of that frame's eye
  float least;     // alpha of pixels that count
};

struct vtkiSumBefore
{
  vec3 irradiance;
  float weights;
  float heaviest; // greatest weight, and the alpha there
  float alpha;
};

vtkiReceiverBefore vtkiFindBefore(vec4 place, vec3 normal, vec3 facet, mat4 toView, mat4 toClip,
  mat3 rayOrigin, mat3 rayDirection)
{
  vtkiReceiverBefore receiver;
  vec3 position = (toView * place).xyz;
  vec4 clip = toClip * place;
  receiver.ahead = clip.w > 0.0f;
  receiver.at =
    (0.5f * clip.xy / (receiver.ahead ? clip.w : 1.0f) + 0.5f) * vec2(vtkiSize) - 0.5f;
  facet = mat3(toView) * facet;
  receiver.alongOrigin = facet * rayOrigin;
  receiver.alongDirection = facet * rayDirection;
  receiver.offset = dot(facet, position);
  receiver.tolerance = vtkiSamePlaneBefore * (2.0f / float(vtkiSize.x)) *
    length(rayOrigin[0] - position.z * rayDirection[0]);
  receiver.code = vtkiOctahedralEncode(mat3(toView) * normal);
  receiver.least = -1.0e30f;
  return receiver;
}

void vtkiAddBefore(inout vtkiSumBefore sum, sampler2D surfaces, sampler2D irradiances,
  vtkiReceiverBefore receiver, ivec2 texel, float weight)
{
  ivec2 inside = clamp(texel, ivec2(0), vtkiSize - 1);
  vec4 other = texelFetch(surfaces, inside, 0);
  vec3 ray = vec3(2.0f * (vec2(texel) + 0.5f) / vec2(vtkiSize) - 1.0f, 1.0f);
  float away = dot(receiver.alongOrigin, ray) +
    vtkiSurfaceDepth(other) * dot(receiver.alongDirection, ray) - receiver.offset;
  vec2 turn = vtkiSurfaceCode(other) - receiver.code;
  bool same = texel == inside && vtkiSurfaceIsLit(other) && abs(away) <= receiver.tolerance &&
    dot(turn, turn) <= vtkiSameNormalBefore * vtkiSameNormalBefore;
  vec4 before = texelFetch(irradiances, inside, 0);
  float counted = same && before.a >= receiver.least ? weight : 0.0f;
  sum.irradiance += counted * before.rgb;
  sum.weights += counted;
  sum.alpha = counted > sum.heaviest ? abs(before.a) : sum.alpha;
  sum.heaviest = max(sum.heaviest, counted);
}

// Adds the four pixels at the receiver's place. In software loops save time where branches do not.
void vtkiAddBilinear(inout vtkiSumBefore sum, sampler2D surfaces, sampler2D irradiances,
  vtkiReceiverBefore receiver, bool wanted)
{
  ivec2 corner = ivec2(floor(receiver.at));
  vec2 blend = receiver.at - floor(receiver.at);
  for (int i = 0; i < (wanted && receiver.ahead ? 4 : 0); ++i)
  {
    float weight = ((i & 1) == 1 ? blend.x : 1.0f - blend.x) * (i > 1 ? blend.y : 1.0f - blend.y);
    vtkiAddBefore(sum, surfaces, irradiances, receiver, corner + ivec2(i & 1, i >> 1), weight);
  }
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(vtkiSurface, pixel, 0);
  bool lit = vtkiSurfaceIsLit(surface);
  vec2 ndc = 2.0f * (vec2(pixel) + 0.5f) / vec2(vtkiSize) - 1.0f;
  vec4 place =
    vec4(vtkiReconstruct(ndc, vtkiSurfaceDepth(surface), vtkiRayOrigin, vtkiRayDirection), 1.0f);
  vec3 normal = vtkiSurfaceNormal(surface);
  vec3 facet = vtkiSurfaceFacet(surface);
  bool wanted = lit && (pixel.y < vtkiRowsAnew.x || pixel.y >= vtkiRowsAnew.y);
  vtkiSumBefore sum = vtkiSumBefore(vec3(0.0f), 0.0f, 0.0f, 0.0f);
#ifdef VTKI_REPROJECT_KEY
  vtkiReceiverBefore inKey = vtkiFindBefore(place, normal, facet, vtkiViewToKey,
    vtkiViewToClipOfKey, vtkiRayOriginOfKey, vtkiRayDirectionOfKey);
  vtkiAddBilinear(sum, vtkiSurfaceOfKey, vtkiIrradianceOfKey, inKey, wanted);
  wanted = wanted && sum.weights < vtkiEnoughBefore;
#endif
  vtkiReceiverBefore receiver = vtkiFindBefore(place, normal, facet, vtkiViewToBefore,
    vtkiViewToClipBefore, vtkiRayOriginBefore, vtkiRayDirectionBefore);
  vtkiAddBilinear(sum, vtkiSurfaceBefore, vtkiIrradianceBefore, receiver, wanted);
#ifdef VTKI_REPROJECT_RADIUS
  float alpha = -sum.alpha;
#else
  wanted = wanted && receiver.ahead;
  receiver.least = 2.0f * VTKI_REPROJECTED_STEP;
  float around = 1.0f;
  for (int ring = 0; ring < vtkiRingsBefore && wanted && sum.weights < vtkiEnoughBefore; ++ring)
  {
    for (int i = 0; i < 8; ++i)
    {
      int turn = i < 4 ? i : i + 1;
      vec2 way = around * vec2(ivec2(turn % 3, turn / 3) - 1);
      vtkiAddBefore(sum, vtkiSurfaceBefore, vtkiIrradianceBefore, receiver,
        ivec2(floor(receiver.at + way + 0.5f)), 1.0f);
    }
    around *= 2.0f;
    receiver.tolerance *= vtkiWidenPlaneBefore;
  }
  float alpha = sum.alpha - (around > 1.0f ? VTKI_REPROJECTED_STEP : 0.0f);
#endif
  bool found = sum.weights >= vtkiEnoughBefore;
  gl_FragData[0] = found ? vec4(sum.irradiance / max(sum.weights, vtkiEnoughBefore), alpha)
                         : vec4(0.0f, 0.0f, 0.0f, lit ? VTKI_REPROJECTED_NONE : 0.0f);
  gl_FragDepth = found || !lit ? 0.0f : 1.0f;
}
