// Joins up to four surfaces into the texel of the level above.
#include "vtkIndirectSubsplat.glsl"
#ifdef VTKI_LIST_SPLIT
#include "vtkIndirectSubsplatStorage.glsl"
#endif

uniform float vtkiPlaneThreshold;  // fraction of the texel's width
uniform float vtkiNormalThreshold; // length of the difference of unit normals
uniform float vtkiDepthThreshold;  // scene units
#ifdef VTKI_VARIATION
uniform sampler2D vtkiVariation;      // error of interpolation on the coarsest level; nearest light
uniform sampler2D vtkiProbeSender;    // position of the nearest light in view coordinates, and area
uniform float vtkiVariationThreshold; // limit of that error on this level
uniform float vtkiLightingThreshold;  // relative error of interpolation
#endif
uniform sampler2D vtkiSurface;      // of pixels
uniform bool vtkiSplits;           // this level may be split
uniform bool vtkiLast;             // this level is always split
uniform float vtkiEdge;            // pixels along the edge of a written texel

struct vtkiJoin
{
  vec3 position[4]; // view coordinates
  vec3 normal[4];
#ifdef VTKI_DEPTH_RANGE
  vec4 minimum[4]; // least components of the normal, and least depth; maximum: the largest
  vec4 maximum[4];
#else
  float deviation[4]; // farthest from the tangent plane, over the child's width
  float spread[4];    // largest difference to the normal
#endif
  bool present[4];
  bool split; // the children require it to be split
#ifdef VTKI_REPROJECTED
  bool needed; // a pixel of the texel or beside it has no irradiance of the last frame
#endif
};

// Returns the number of the pixel at which a texel is evaluated (vtkiSubsplatPixel): the lit one nearest
// to the middle where the texel holds several surfaces or its middle shows none, since the plane there
// goes on beyond the end of the surface; otherwise 0. Pixels farther than `farthest` do not count: a
// thing before others keeps its sample, the others have samples around.
int vtkiFindPixel(ivec2 texel, bool mixed, float farthest)
{
  vec2 middle = vtkiPixelInTexel(texel, vtkiEdge, 0);
  bool whole = !mixed && vtkiSurfaceIsLit(textureLod(vtkiSurface, middle / vec2(vtkiSize), 0.0f));
  int count = whole ? 0 : VTKI_SUBSPLAT_PIXELS * VTKI_SUBSPLAT_PIXELS;
  float least = 1.0e30f;
  int nearest = 0;
  for (int i = 1; i <= count; ++i)
  {
    vec2 at = vtkiPixelInTexel(texel, vtkiEdge, i);
    vec2 apart = at - middle;
    vec4 surface = textureLod(vtkiSurface, at / vec2(vtkiSize), 0.0f);
    bool nearer = dot(apart, apart) < least && vtkiSurfaceIsLit(surface) &&
      vtkiSurfaceDepth(surface) <= farthest;
    least = nearer ? dot(apart, apart) : least;
    nearest = nearer ? i : nearest;
  }
  return nearest;
}

// Returns a spread with the sign that tells whether the texel is needed. Zero gets a sign, too.
float vtkiCodeSpread(float spread, bool needed)
{
  return needed ? spread : -spread - 1.0e-4f;
}

// Writes the texel: octahedral normal, depth, state; deviation, spread and need, or the ranges.
void vtkiWriteJoin(vtkiJoin children, ivec2 texel)
{
#ifdef VTKI_REPROJECTED
  bool needed = children.needed;
#else
  bool needed = true;
#endif
  vec3 normal = vec3(0.0f);
  vec3 position = vec3(0.0f);
  float count = 0.0f;
  float nearest = 0.0f;
  float farthest = 0.0f;
  int first = 0;
  for (int i = 0; i < 4; ++i)
  {
    if (children.present[i])
    {
      float depth = -children.position[i].z;
      first = count == 0.0f || depth < nearest ? i : first;
      nearest = count == 0.0f ? depth : min(nearest, depth);
      farthest = count == 0.0f ? depth : max(farthest, depth);
      normal += children.normal[i];
      position += children.position[i];
      count += 1.0f;
    }
  }
  if (count == 0.0f)
  {
    gl_FragData[0] = vec4(0.0f, 0.0f, 0.0f, VTKI_SUBSPLAT_EMPTY);
    gl_FragData[1] = vec4(0.0f, vtkiCodeSpread(0.0f, needed), 0.0f, 0.0f);
#ifdef VTKI_DEPTH_RANGE
    gl_FragData[2] = vec4(0.0f);
#endif
    return;
  }
  position /= count;
  float norm = length(normal);
  // Opposite normals cancel: the texel is split, whatever its normal.
  normal = norm > 0.0f ? normal / norm : children.normal[first];

  float width = vtkiPixelWidth(0.5f * (nearest + farthest)) * vtkiEdge;
#ifdef VTKI_DEPTH_RANGE
  // Section 3.2 of the paper: splits if the depth or a component of the normal differs by too much.
  vec4 minimum = vec4(0.0f);
  vec4 maximum = vec4(0.0f);
  bool begun = false;
  for (int i = 0; i < 4; ++i)
  {
    if (children.present[i])
    {
      minimum = begun ? min(minimum, children.minimum[i]) : children.minimum[i];
      maximum = begun ? max(maximum, children.maximum[i]) : children.maximum[i];
      begun = true;
    }
  }
  vec4 range = maximum - minimum;
  bool mixed = range.w > vtkiDepthThreshold || max(max(range.x, range.y), range.z) > vtkiNormalThreshold;
  bool everywhere = vtkiLast || vtkiDepthThreshold <= 0.0f || vtkiNormalThreshold <= 0.0f;
  gl_FragData[1] = minimum;
  gl_FragData[2] = maximum;
#else
  float deviation = 0.0f;
  float spread = 0.0f;
  for (int i = 0; i < 4; ++i)
  {
    if (children.present[i])
    {
      // The child's own deviation is in units of its width, which is half of this texel's.
      deviation = max(deviation,
        abs(dot(normal, children.position[i] - position)) / width + 0.5f * children.deviation[i]);
      spread = max(spread, length(children.normal[i] - normal) + children.spread[i]);
    }
  }
  bool mixed = deviation > vtkiPlaneThreshold || spread > vtkiNormalThreshold;
  bool everywhere = vtkiLast || vtkiPlaneThreshold <= 0.0f || vtkiNormalThreshold <= 0.0f;
  gl_FragData[1] = vec4(min(deviation, 60000.0f), vtkiCodeSpread(spread, needed), 0.0f, 0.0f);
#endif
  vec2 center = vtkiSubsplatCenter(vec2(texel), vtkiEdge, vec2(vtkiSize));
  vec3 origin = vtkiRayOrigin * vec3(center, 1.0f);
  vec3 direction = vtkiRayDirection * vec3(center, 1.0f);
  bool forced = false;
#ifdef VTKI_VARIATION
  vec4 variation = textureLod(vtkiVariation, 0.5f * center + 0.5f, 0.0f);
  vec4 sender = textureLod(vtkiProbeSender, 0.5f * center + 0.5f, 0.0f);
  float curvature =
    vtkiVirtualLightCurvature(sender.xyz - position, variation.yzw, normal, sender.w);
  // On a surface seen at a grazing angle, a pixel spans a longer stretch.
  float cosine = dot(normal, direction);
  forced = variation.x > vtkiVariationThreshold ||
    0.125f * curvature * width * width * dot(direction, direction) >
      vtkiLightingThreshold * cosine * cosine;
#endif
  float depth;
  int number = vtkiFindPixel(texel, mixed, nearest + width);
  if (mixed)
  {
    // No plane fits a mixture of surfaces: the sample lies at the pixel, which the eye sees. The plane
    // of another pixel may continue behind a surface in front, where no light comes.
    vec2 place = vtkiPixelInTexel(texel, vtkiEdge, number) / vec2(vtkiSize);
    vec4 surface = textureLod(vtkiSurface, place, 0.0f);
    bool lit = number > 0;
    normal = lit ? vtkiSurfaceNormal(surface) : children.normal[first];
    position = lit ? vtkiReconstruct(2.0f * place - 1.0f, vtkiSurfaceDepth(surface), vtkiRayOrigin,
                       vtkiRayDirection)
                   : children.position[first];
    depth = vtkiPlaneDepth(
      normal, position, origin, direction, -position.z - width, -position.z + width);
  }
  else
  {
    // If some pixels are background, the centre may lie beyond the depths of the others and must
    // still lie on the plane: light from the other side illuminates points behind it. (Depths of a
    // parallel projection may be negative.)
    float lower = min(0.5f * nearest, 2.0f * nearest);
    float upper = max(0.5f * farthest, 2.0f * farthest);
    depth = vtkiPlaneDepth(normal, position, origin, direction, lower, upper);
    // The mean of positions on a curved surface lies behind it, too: place the sample before all
    // children, and before their tangent planes at the sample's ray.
    vec3 middle = origin + depth * direction;
    float before = dot(normal, children.position[first] - middle);
    for (int i = 0; i < 4; ++i)
    {
      if (children.present[i])
      {
        vec3 way = children.position[i] - middle;
        float tangent = dot(children.normal[i], way) / max(dot(children.normal[i], normal), 0.5f);
        before = max(before, max(dot(normal, way), tangent));
      }
    }
    depth = vtkiPlaneDepth(normal, middle + before * normal, origin, direction, lower, upper);
  }
  float state = VTKI_SUBSPLAT_WHOLE;
  if (mixed || everywhere || forced || children.split)
  {
    state = vtkiSplits ? (mixed || everywhere ? VTKI_SUBSPLAT_SPLIT : VTKI_SUBSPLAT_PARTED)
                       : (mixed ? VTKI_SUBSPLAT_MIXED : VTKI_SUBSPLAT_WHOLE);
#ifdef VTKI_LIST_SPLIT
    if (vtkiSplits && needed)
    {
      vtkiAppend(texel);
    }
#endif
  }
  gl_FragData[0] = vec4(
    vtkiOctahedralEncode(normal), depth, state + float(number) / VTKI_SUBSPLAT_FRACTION);
}
