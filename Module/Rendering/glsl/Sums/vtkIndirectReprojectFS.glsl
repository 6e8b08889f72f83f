//VTK::System::Dec
//VTK::Output::Dec
// Irradiance of the last frame at the places that the eye sees again: a bilinear mean of those pixels
// that lie on the place's surface. Where the eye sees a few more pixels of a surface, such as beside
// an outline, the mean of pixels around the place. With VTKI_REPROJECT_RADIUS alpha is a radius, that
// of the heaviest pixel, negative: see vtkIndirectSkyReprojection.
#include "vtkIndirectLibSurface.glsl"
#include "vtkIndirectLibReprojection.glsl"

uniform ivec2 vtkiSize;
uniform mat3 vtkiRayOrigin;
uniform mat3 vtkiRayDirection;
uniform sampler2D vtkiSurface;
uniform ivec2 vtkiRowsAnew; // first row, and row after the last one, that are summed anew

// The last frame's.
uniform sampler2D vtkiSurfaceBefore;
uniform sampler2D vtkiIrradianceBefore;
uniform mat3 vtkiRayOriginBefore;
uniform mat3 vtkiRayDirectionBefore;
uniform mat4 vtkiViewToBefore;     // to view coordinates
uniform mat4 vtkiViewToClipBefore; // to clip coordinates

// Limits for pixels of one surface: distance from the tangent plane in widths of a pixel, and
// difference of octahedral coordinates.
const float vtkiSamePlaneBefore = 1.0f;
const float vtkiSameNormalBefore = 0.2f;
// Least sum of the bilinear weights.
const float vtkiEnoughBefore = 0.2f;
// Distance, in pixels, of the eight pixels around a place whose own pixels do not show its surface.
const float vtkiAroundBefore = 1.0f;

// The receiver in the last frame's view coordinates.
struct vtkiReceiverBefore
{
  vec3 alongOrigin; // its facet in the ray's origin and direction
  vec3 alongDirection;
  float offset;    // of its plane
  float tolerance; // distance from the plane
  vec2 code;       // octahedral normal
};

struct vtkiSumBefore
{
  vec3 irradiance;
  float weights;
  float heaviest; // greatest weight, and the radius there
  float radius;
};

void vtkiAddBefore(
  inout vtkiSumBefore sum, vtkiReceiverBefore receiver, ivec2 texel, float weight)
{
  ivec2 inside = clamp(texel, ivec2(0), vtkiSize - 1);
  vec4 other = texelFetch(vtkiSurfaceBefore, inside, 0);
  vec3 ray = vec3(2.0f * (vec2(texel) + 0.5f) / vec2(vtkiSize) - 1.0f, 1.0f);
  float away = dot(receiver.alongOrigin, ray) +
    vtkiSurfaceDepth(other) * dot(receiver.alongDirection, ray) - receiver.offset;
  vec2 turn = vtkiSurfaceCode(other) - receiver.code;
  bool same = texel == inside && vtkiSurfaceIsLit(other) && abs(away) <= receiver.tolerance &&
    dot(turn, turn) <= vtkiSameNormalBefore * vtkiSameNormalBefore;
  vec4 before = texelFetch(vtkiIrradianceBefore, inside, 0);
  float counted = same ? weight : 0.0f;
  sum.irradiance += counted * before.rgb;
  sum.weights += counted;
  sum.radius = counted > sum.heaviest ? abs(before.a) : sum.radius;
  sum.heaviest = max(sum.heaviest, counted);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 surface = texelFetch(vtkiSurface, pixel, 0);
  bool lit = vtkiSurfaceIsLit(surface);
  vec2 ndc = 2.0f * (vec2(pixel) + 0.5f) / vec2(vtkiSize) - 1.0f;
  vec4 place =
    vec4(vtkiReconstruct(ndc, vtkiSurfaceDepth(surface), vtkiRayOrigin, vtkiRayDirection), 1.0f);
  vec3 position = (vtkiViewToBefore * place).xyz;
  vec4 clip = vtkiViewToClipBefore * place;
  bool wanted = lit && clip.w > 0.0f && (pixel.y < vtkiRowsAnew.x || pixel.y >= vtkiRowsAnew.y);
  vec2 at = (0.5f * clip.xy / (wanted ? clip.w : 1.0f) + 0.5f) * vec2(vtkiSize) - 0.5f;
  ivec2 corner = ivec2(floor(at));
  vec2 blend = at - floor(at);
  vec3 facet = mat3(vtkiViewToBefore) * vtkiSurfaceFacet(surface);
  vtkiReceiverBefore receiver;
  receiver.alongOrigin = facet * vtkiRayOriginBefore;
  receiver.alongDirection = facet * vtkiRayDirectionBefore;
  receiver.offset = dot(facet, position);
  receiver.tolerance = vtkiSamePlaneBefore * (2.0f / float(vtkiSize.x)) *
    length(vtkiRayOriginBefore[0] - position.z * vtkiRayDirectionBefore[0]);
  receiver.code = vtkiOctahedralEncode(mat3(vtkiViewToBefore) * vtkiSurfaceNormal(surface));
  vtkiSumBefore sum = vtkiSumBefore(vec3(0.0f), 0.0f, 0.0f, 0.0f);
  // In software loops save time where branches do not.
  for (int i = 0; i < (wanted ? 4 : 0); ++i)
  {
    float weight = ((i & 1) == 1 ? blend.x : 1.0f - blend.x) * (i > 1 ? blend.y : 1.0f - blend.y);
    vtkiAddBefore(sum, receiver, corner + ivec2(i & 1, i >> 1), weight);
  }
  for (int i = 0; i < (wanted && sum.weights < vtkiEnoughBefore ? 8 : 0); ++i)
  {
    int turn = i < 4 ? i : i + 1;
    vec2 way = vtkiAroundBefore * vec2(ivec2(turn % 3, turn / 3) - 1);
    vtkiAddBefore(sum, receiver, ivec2(floor(at + way + 0.5f)), 1.0f);
  }
  bool found = sum.weights >= vtkiEnoughBefore;
#ifdef VTKI_REPROJECT_RADIUS
  float alpha = -sum.radius;
#else
  float alpha = 1.0f;
#endif
  gl_FragData[0] = found ? vec4(sum.irradiance / max(sum.weights, vtkiEnoughBefore), alpha)
                         : vec4(0.0f, 0.0f, 0.0f, lit ? VTKI_REPROJECTED_NONE : 0.0f);
  gl_FragDepth = found || !lit ? 0.0f : 1.0f;
}
