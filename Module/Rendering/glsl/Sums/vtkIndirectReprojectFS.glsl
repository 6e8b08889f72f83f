//VTK::System::Dec
//VTK::Output::Dec
// Irradiance of the last frame at the places that the eye sees again: a bilinear mean of those pixels
// that lie on the place's surface. With VTKI_REPROJECT_RADIUS alpha is a radius, that of the
// heaviest pixel, negative: see vtkIndirectSkyReprojection.
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
  vec3 alongOrigin = facet * vtkiRayOriginBefore;
  vec3 alongDirection = facet * vtkiRayDirectionBefore;
  float offset = dot(facet, position);
  float tolerance = vtkiSamePlaneBefore * (2.0f / float(vtkiSize.x)) *
    length(vtkiRayOriginBefore[0] - position.z * vtkiRayDirectionBefore[0]);
  vec2 code = vtkiOctahedralEncode(mat3(vtkiViewToBefore) * vtkiSurfaceNormal(surface));
  vec3 irradiance = vec3(0.0f);
  float weights = 0.0f;
#ifdef VTKI_REPROJECT_RADIUS
  float heaviest = 0.0f;
  float radius = 0.0f;
#endif
  // In software loops save time where branches do not.
  for (int i = 0; i < (wanted ? 4 : 0); ++i)
  {
    ivec2 texel = corner + ivec2(i & 1, i >> 1);
    ivec2 inside = clamp(texel, ivec2(0), vtkiSize - 1);
    vec4 other = texelFetch(vtkiSurfaceBefore, inside, 0);
    vec3 ray = vec3(2.0f * (vec2(texel) + 0.5f) / vec2(vtkiSize) - 1.0f, 1.0f);
    float away = dot(alongOrigin, ray) + vtkiSurfaceDepth(other) * dot(alongDirection, ray) - offset;
    vec2 turn = vtkiSurfaceCode(other) - code;
    bool same = texel == inside && vtkiSurfaceIsLit(other) && abs(away) <= tolerance &&
      dot(turn, turn) <= vtkiSameNormalBefore * vtkiSameNormalBefore;
    float weight = ((i & 1) == 1 ? blend.x : 1.0f - blend.x) * (i > 1 ? blend.y : 1.0f - blend.y);
    weight = same ? weight : 0.0f;
    vec4 before = texelFetch(vtkiIrradianceBefore, inside, 0);
    irradiance += weight * before.rgb;
#ifdef VTKI_REPROJECT_RADIUS
    radius = weight > heaviest ? abs(before.a) : radius;
    heaviest = max(heaviest, weight);
#endif
    weights += weight;
  }
  bool found = weights >= vtkiEnoughBefore;
#ifdef VTKI_REPROJECT_RADIUS
  float alpha = -radius;
#else
  float alpha = 1.0f;
#endif
  gl_FragData[0] = found ? vec4(irradiance / max(weights, vtkiEnoughBefore), alpha)
                         : vec4(0.0f, 0.0f, 0.0f, lit ? VTKI_REPROJECTED_NONE : 0.0f);
  gl_FragDepth = found || !lit ? 0.0f : 1.0f;
}
