// This text is added to the fragment shader of every surface mapper. One text serves light maps and
// the eye's view, so that a frame that draws both rebuilds no shader source.
#include "vtkIndirectLibSurface.glsl"
#include "vtkIndirectLibAlbedo.glsl"
#include "vtkIndirectLibLightMap.glsl"
#include "vtkIndirectLibShadow.glsl"

uniform int vtkiStage;          // 0: from the eye, 1: from a light
uniform int vtkiAlbedoInAlpha;  // 1: albedo takes the place of alpha, which is one on surfaces
uniform int vtkiNumber;         // of the prop's faces, or of its lines and points; negative: catches light
uniform float vtkiSceneScale;   // scene units per world unit
uniform vec3 vtkiDepthRange;    // near, far [scene units], 1 for parallel projection
uniform vec4 vtkiPixelRays;     // of gl_FragCoord: times xy plus zw; see vtkiDepthOnRay
uniform vec3 vtkiRaysMeet;      // where all rays of a perspective meet [scene units]

#ifdef VTKI_SHADOWS
uniform float vtkiMagnitude; // size of the numbers whose differences are positions [scene units]
uniform sampler2DArray vtkiShadowMaps; // depths, then slopes, of a texel and of the next in the row
#endif

// Shape of the light map that is drawn.
uniform vec3 vtkiMapLight; // 1 if positional, texel size in tangents or scene units, 1 if the prop sends

// This is the least squared sine of the angle between a facet and its shading normal; rounding
// error of positions, and of their differences between pixels, as a share of the distance. Under a
// narrow angle of view a pixel measures hardly more than that error, and its derivatives do not
// tell the facet.
const float VTKI_FACET_SINE2 = 1.0e-5f;
const float VTKI_FACET_ROUNDING = 1.0e-6f;
// A shading normal lies along the facet if the cosine of the angle between it and the facet's normal
// is below this number, far above rounding.
const float VTKI_FACET_ALONG = 1.0e-3f;

// These are the pixels that a position may lie beside its ray: corners are rounded by half of 1/16
// at most, which is the coarsest that OpenGL allows. Lines and points lie farther.
const float VTKI_MOST_BESIDE = 0.03125f;

// The way from the middle of a pixel's facet to the pixel [scene units], in view coordinates; see
// vtkiLeaveFacets.
vec3 vtkiFacetWay = vec3(0.0f);

// The shading normal is the facet's own at the facet's middle and turns from there: its tilt over
// its turn is the distance from the middle. The turn is the root of the sum of both squared
// curvatures over two, that of a sphere. Inside a hollow no pixel has a way. dx, dy: change of the
// position over a pixel; facet: their cross product.
vec3 vtkiFindFacetWay(vec3 dx, vec3 dy, vec3 facet, vec3 normal)
{
  vec3 turnX = dFdx(normal);
  vec3 turnY = dFdy(normal);
  float turn2 = dot(turnX, turnX) * dot(dy, dy) + dot(turnY, turnY) * dot(dx, dx) -
    2.0f * dot(turnX, turnY) * dot(dx, dy); // times length2
  float length2 = dot(facet, facet);
  float upright = dot(normal, facet);
  vec3 tilt = normal * length2 - facet * upright; // times length2
  float scale = upright * upright * turn2;
  // The divergence of normals is positive on convex surfaces.
  float divergence = dot(facet, cross(turnX, dy) + cross(dx, turnY));
  return scale > 0.0f && divergence > 0.0f ? tilt * inversesqrt(0.5f * scale) : vec3(0.0f);
}

// Returns the unit normal of the facet at a position, on the side of its shading normal; the
// shading normal itself where the two differ by less than the derivatives of the position can
// resolve. Sets vtkiFacetWay, too.
vec3 vtkiFacetNormal(vec3 position, vec3 normal)
{
  vec3 dx = dFdx(position);
  vec3 dy = dFdy(position);
  vec3 facet = cross(dx, dy);
  vec3 across = cross(facet, normal);
  float length2 = dot(facet, facet);
  vtkiFacetWay = vtkiFindFacetWay(dx, dy, facet, normal);
  float rounding = VTKI_FACET_ROUNDING * VTKI_FACET_ROUNDING * dot(position, position);
  bool other =
    dot(across, across) > max(VTKI_FACET_SINE2 * length2, rounding * (dot(dx, dx) + dot(dy, dy)));
  // The derivatives' product is on the side that is seen. The facet's normal stays there if the
  // shading normal lies along the facet: rounding would decide at each pixel anew.
  float scale = inversesqrt(length2);
  bool behind = dot(facet, normal) * scale < -VTKI_FACET_ALONG;
  return other ? facet * (behind ? -scale : scale) : normal;
}

#ifdef VTKI_SHADOWS
// Facets approximate curved surfaces: if facets meet at less than 18 degrees, a concave neighbour
// rises over the receiver's plane by less than this share of a texel within the filter's radius.
const float VTKI_SURFACE_ROUGHNESS = 0.5f;
// Below this distance between caster and receiver, in texel widths along depth, planes decide the
// shadow: a steep plane crosses a flatter one within the texels around the receiver.
const float VTKI_SHADOW_CONTACT = 16.0f;
// Rounding error of positions, here and in the map, relative to the numbers they are computed from.
const float VTKI_POSITION_ROUNDING = 4.8e-7f;

// Moves a position towards a light at the origin, or along z, past neighbouring facets of the same
// surface. It moves where the facet faces away from the light and the shading normal does not: the
// curved surface that the facets approximate is lit there, and neighbouring facets lie in front of
// the facet. A neighbour as large as the facet hides the pixel by at most three times the pixel's
// distance from the facet's middle. p, facet: in the light's frame.
//   Another body within this distance hides nothing from such pixels either: too bright.
vec3 vtkiLeaveFacets(mat3x4 viewToLight, bool parallel, vec3 p, vec3 facet)
{
  vec3 way = vec4(vtkiFacetWay / vtkiSceneScale, 0.0f) * viewToLight;
  float most = parallel ? 1.0f : 0.5f * length(p);
  vec3 toLight = parallel ? vec3(0.0f, 0.0f, 1.0f) : p * (-0.5f / max(most, 1.0e-15f));
  float distance = dot(facet, toLight) < 0.0f ? 3.0f * dot(way, toLight) : 0.0f;
  return p + toLight * clamp(distance, 0.0f, most);
}

// Returns a light's visibility from a position that the eye sees. viewToLight: its columns are the
// rows of the matrix from view coordinates to the light's frame in scene units; map: first layer
// (-1: none), projection, half width, texels; depthRange: near, far, shadow strength, number of
// layers; window: middle, half width (-1: none) and layer of a finer image of a part of the map, in
// tangents or scene units; projection: of the light's map, VTKI_MAP_FACES where only the map knows whether it has
// several faces. The projection is a literal, so that the compiler drops code for other kinds of
// light.
float vtkiVisibility(mat3x4 viewToLight, vec4 map, vec4 depthRange, vec4 window, int projection,
  vec3 positionVC, vec3 normalVC, vec3 facetNormalVC)
{
  if (vtkiStage != 0 || map.x < 0.0f)
  {
    return 1.0f;
  }
  float scale = 1.0f / vtkiSceneScale;
  vec3 p = vec4(positionVC, 1.0f) * viewToLight;
  vec3 n = vec4(normalVC * scale, 0.0f) * viewToLight;
  vec3 facet = vec4(facetNormalVC * scale, 0.0f) * viewToLight;
  bool parallel = projection == VTKI_MAP_PARALLEL;
  p = vtkiLeaveFacets(viewToLight, parallel, p, facet);
  int face = 0;
  if (projection == VTKI_MAP_FACES && int(map.y + 0.5f) == VTKI_MAP_FACES)
  {
    face = vtkiFaceOf(p);
    if (float(face) >= depthRange.w)
    {
      return 1.0f;
    }
    p = vtkiToFace(p, face);
    n = vtkiToFace(n, face);
    facet = vtkiToFace(facet, face);
  }
  float depth = -p.z;
  if (!parallel && !(depth > 0.0f))
  {
    return 1.0f;
  }
  vec2 there = p.xy / (parallel ? 1.0f : depth);
  vec2 ndc = there / map.z;
  // Where two faces meet, a GPU's division may put a position beyond either.
  if (max(abs(ndc.x), abs(ndc.y)) > 1.00001f)
  {
    return 1.0f;
  }
  vec2 inWindow = (there - window.xy) / window.z;
  bool windowed = window.z > 0.0f && max(abs(inWindow.x), abs(inWindow.y)) < 1.0f - 2.0f / map.w;
  ndc = windowed ? inWindow : ndc;
  float halfWidth = windowed ? window.z : map.z;
  // The map has drawn the facet. Where the facet faces away from the light and the interpolated
  // normal does not, only that normal tells how the curved surface runs.
  float texel = 2.0f * halfWidth / map.w;
  vtkiShadowPlane plane;
  plane.turned = !((parallel ? facet.z : -dot(facet, p)) > 0.0f);
  plane.facet = vtkiPlaneDepthGradient(
    p, plane.turned ? -facet : facet, texel, depthRange.x, depthRange.y, parallel).xy;
  vec2 gradient = plane.facet;
  if (plane.turned)
  {
    gradient = vtkiPlaneDepthGradient(p, n, texel, depthRange.x, depthRange.y, parallel).xy;
  }
  plane.reference = vtkiDepthToBuffer(depth, depthRange.x, depthRange.y, parallel);
  plane.gradient = gradient;
  float slope = vtkiDepthToBufferSlope(depth, depthRange.x, depthRange.y, parallel);
  float rounding = VTKI_DEPTH_ROUNDING +
    VTKI_POSITION_ROUNDING * (vtkiMagnitude + length(p)) * slope;
  float length1 = texel * (parallel ? 1.0f : depth) * slope; // depth over a texel's width
  plane.perTexel = 1.0f / length1;
  plane.rounding = rounding;
  plane.bias = rounding + VTKI_SURFACE_ROUGHNESS * length1;
  // The four texels around the receiver; beyond the centres of the map's outermost texels these
  // count alone.
  vec2 at = (0.5f * ndc + 0.5f) * map.w - 0.5f;
  vec2 first = clamp(floor(at), vec2(0.0f), vec2(max(map.w - 2.0f, 0.0f)));
  vec2 fraction = clamp(at - first, vec2(0.0f), vec2(1.0f));
  float layer = windowed ? window.w : map.x + float(face);
  // A look-up at a texel's centre is exact, and in software faster than a fetch.
  vec2 place = (first + 0.5f) / map.w;
  vec4 row = textureLod(vtkiShadowMaps, vec3(place, layer), 0.0f);
  vec4 next = textureLod(vtkiShadowMaps, vec3(place.x, place.y + 1.0f / map.w, layer), 0.0f);
  vec4 depths = vec4(row.xy, next.xy);
  vec4 slopes = vec4(row.zw, next.zw);
  vec4 planes = plane.reference + gradient.x * (first.x - at.x + vec4(0.0f, 1.0f, 0.0f, 1.0f)) +
    gradient.y * (first.y - at.y + vec4(0.0f, 0.0f, 1.0f, 1.0f));
  // A surface that meets the receiver's plane at the receiver rises less than the bias over it.
  bool ended = any(lessThan(depths, planes - rounding)) &&
    any(greaterThan(depths, planes + vtkiMostBehind(plane)));
  bool asked = plane.turned || ended || any(lessThan(depths, min(planes - plane.bias, vec4(1.0f))));
  bool deep = all(
    lessThan(depths, min(planes, vec4(plane.reference)) - VTKI_SHADOW_CONTACT * length1));
  // If texels differ, and at contact, their planes decide. A loop, not a branch: OpenGL on the
  // processor takes both sides of a branch, and at least one step of a loop.
  vtkiShadowVotes votes = vtkiBeginShadow();
  float end = depthRange.y / (depthRange.y - depthRange.x);
  int count = asked && !deep ? 4 : 0;
  for (int i = 0; i < count; ++i)
  {
    vec2 neighbor = vtkiShadowNeighbor(i);
    // Inverse depth falls where depth grows: this is depth times the stored slope, in units of
    // depth.
    float scale = texel * (parallel ? slope : depths.x - end);
    vtkiVoteOnShadow(plane, first + neighbor - at, depths.x, scale * vtkiUnpackSlope(slopes.x),
      vtkiShadowWeight(neighbor, fraction), i, votes);
    depths = depths.yzwx; // the next texel comes first
    slopes = slopes.yzwx;
  }
  float counted = 0.0f;
  for (int i = 0; i < 4; ++i)
  {
    vec2 neighbor = vtkiShadowNeighbor(i);
    counted += vtkiCountsForShadow(plane, first + neighbor - at, depths[i], i, votes)
      ? vtkiShadowWeight(neighbor, fraction)
      : 0.0f;
  }
  float seen = !asked ? 1.0f : (deep ? 0.0f : vtkiShareOfShadow(counted, votes));
  return mix(1.0f, seen, depthRange.z);
}
#endif

// Slope of a surface in a light's map: change of depth (parallel), or of inverse depth times depth
// (perspective), over one texel's width. Both are affine on a plane, so two derivatives give the
// facet's normal. Cosines are computed when the map is sampled, for far fewer texels than are drawn
// here.
vec2 vtkiDepthSlope(float depth)
{
  // mix() would lose precision: far from the light, a sum with the depth cancels its inverse.
  bool positional = vtkiMapLight.x > 0.5f;
  float s = positional ? 1.0f / depth : depth;
  return vec2(dFdx(s), dFdy(s)) * ((positional ? depth : 1.0f) / vtkiMapLight.y);
}

// Returns the normal of the sphere that VTK draws around a place, and the pixel's place on it, in
// view coordinates. VTK draws spheres as if their centres were straight ahead, with `normal`. Beside
// the sphere's edge the pixel has the edge's place. radius: of the sphere, over depth in a
// perspective.
vec3 vtkiFindSurface(vec3 middle, vec3 normal, float radius, bool parallel, out vec3 place)
{
  float r = radius * (parallel ? 1.0f : -middle.z);
  vec3 way = normalize(vec3(middle.xy + r * normal.xy, middle.z));
  vec3 beside = middle - dot(middle, way) * way; // from the pixel's ray to the centre
  vec3 found = normalize(-beside - sqrt(max(r * r - dot(beside, beside), 0.0f)) * way);
  found = parallel ? normal : found;
  place = middle + r * found;
  return found;
}

// vtkiDepthSlope of the plane through a position, in view coordinates, with this normal.
vec2 vtkiNormalSlope(vec3 normal, vec3 place)
{
  // A surface seen edge-on covers no pixel: bound the divisor.
  const float least = 1.0e-4f;
  bool positional = vtkiMapLight.x > 0.5f;
  float across = positional ? dot(normal, place) / min(place.z, -1.0e-30f) : normal.z;
  return normal.xy * ((positional ? -1.0f : 1.0f) / (across < 0.0f ? min(across, -least) : max(across, least)));
}

// Returns the depth of the plane of a triangle where the ray through the middle of the pixel meets
// it. A GPU rounds a triangle's corners to fractions of a pixel (GL_SUBPIXEL_BITS, mostly 1/256)
// before it interpolates, so that a position lies on the plane beside the ray. position: in view
// coordinates [scene units]. Rays are tangents of a perspective, or places of a parallel
// projection.
float vtkiDepthOnRay(vec3 position)
{
  bool parallel = vtkiDepthRange.z > 0.5f;
  float depth = -position.z;
  float along = parallel ? 1.0f : depth + vtkiRaysMeet.z;
  vec2 ray = gl_FragCoord.xy * vtkiPixelRays.xy + vtkiPixelRays.zw;
  vec2 beside = (ray - (position.xy - vtkiRaysMeet.xy) / along) / vtkiPixelRays.xy;
  // Affine on the plane: the depth of a parallel projection, the inverse depth of a perspective.
  float s = parallel ? depth : 1.0f / along;
  float change = dot(vec2(dFdx(s), dFdy(s)), clamp(beside, -VTKI_MOST_BESIDE, VTKI_MOST_BESIDE));
  // Derivatives on triangles seen from their edge may be anything, infinite and no number, too.
  change = abs(change) < (parallel ? 1.0f : 0.125f * s) ? change : 0.0f;
  return parallel ? depth + change : depth - along * change / (s + change);
}

float vtkiLinearDepth()
{
  return vtkiDepthRange.z > 0.5f ? mix(vtkiDepthRange.x, vtkiDepthRange.y, gl_FragCoord.z)
                                 : vtkiSceneScale / gl_FragCoord.w;
}
