// This text is added to the fragment shader of surface mappers where a light has a size: the
// light's visibility is the mean over points of it, each with its own depth map.
#include "vtkIndirectLibDepthTile.glsl"
#include "vtkIndirectLibPenumbra.glsl"

// These are the depths of a texel, of the next texel in the row, and of the two in the next row.
uniform sampler2D vtkiPenumbraTiles;

// These are the texels by which a GPU moves a triangle when it rounds the corners; see
// vtkiDepthOnRay. These maps hold the depths that OpenGL writes.
const float VTKI_TILE_SHIFT = 1.0f / 512.0f;

// Visibility of a receiver from one point of the light (x), and its weight: 1, or 0 where the point
// does not count (y). The receiver's position, normals and place in the map's image, [-1,1], are in
// the map's view coordinates. tile: the map's number; map, depthRange, size: see vtkiPenumbra;
// rounding: of positions.
vec2 vtkiSeeLightPoint(float tile, vec4 map, vec4 depthRange, vec4 size, bool parallel, vec3 p, vec3 n,
  vec3 facet, vec2 place, float depth, float rounding)
{
  float inside = max(abs(place.x), abs(place.y)) <= 1.0f && depth > 0.0f ? 1.0f : 0.0f;
  float texel = 2.0f * map.z / map.w;
  vec3 gradient = vtkiPlaneDepthGradient(p, facet, texel, depthRange.x, depthRange.y, parallel);
  if (gradient.z == 0.0f)
  {
    gradient = vtkiPlaneDepthGradient(p, n, texel, depthRange.x, depthRange.y, parallel);
  }
  // A point below the receiver's horizon does not count: VTK's cosine is that of the light's
  // centre, whatever part of the light lies below.
  float counts = gradient.z * max(inside, size.y);
  // Half of a texel's diagonal on each side allows for facets that approximate curved surfaces.
  float offset = 2.0f * VTKI_TILE_ROUGHNESS * texel * (parallel ? 1.0f : depth) + rounding;
  float compared = vtkiDepthToBuffer(depth, depthRange.x, depthRange.y, parallel) -
    VTKI_DEPTH_ROUNDING - VTKI_TILE_SHIFT * (abs(gradient.x) + abs(gradient.y)) -
    offset * vtkiDepthToBufferSlope(depth, depthRange.x, depthRange.y, parallel);
  vec2 at = (0.5f * place + 0.5f) * map.w - 0.5f;
  vec2 first = clamp(floor(at), vec2(0.0f), vec2(map.w - 2.0f));
  vec2 fraction = clamp(at - first, vec2(0.0f), vec2(1.0f));
  float row = floor((tile + 0.5f) / size.z);
  vec2 corner = vec2(tile - row * size.z, row) * map.w;
  vec4 stored =
    textureLod(vtkiPenumbraTiles, (corner + first + 0.5f) / (size.zw * map.w), 0.0f);
  // Each texel is compared with the depth of the receiver's plane at that texel; see
  // vtkiVisibility.
  vec2 toFirst = first - at;
  float plane = dot(gradient.xy, toFirst);
  vec4 planes = min(
    plane + vec4(0.0f, gradient.x, gradient.y, gradient.x + gradient.y), vec4(0.0f));
  vec4 lit = vec4(greaterThanEqual(stored, min(compared + planes, vec4(1.0f))));
  vec2 rows = mix(lit.xz, lit.yw, fraction.x);
  float seen = inside > 0.0f ? mix(rows.x, rows.y, fraction.y) : 1.0f;
  return counts * vec2(seen, 1.0f);
}

// Returns a light's visibility from a position that the eye sees, as vtkiVisibility. map: first
// tile (-1: none), projection, half width, texels; depthRange: near, far, shadow strength, tiles of
// a point; size: radius in scene units or sine of the angular radius, 1 if nothing casts beyond the
// maps, columns and rows of tiles in the texture.
float vtkiPenumbra(mat3x4 viewToLight, vec4 map, vec4 depthRange, vec4 size, int projection,
  vec3 positionVC, vec3 normalVC, vec3 facetNormalVC)
{
  // A loop of count rounds replaces a branch: OpenGL on the processor takes both sides of a
  // branch and unrolls a loop of known length, so pixels of maps would pay for all points.
  int count = vtkiStage != 0 || map.x < 0.0f ? 0 : VTKI_LIGHT_PAIRS;
  float scale = 1.0f / vtkiSceneScale;
  vec3 p = vec4(positionVC, 1.0f) * viewToLight;
  vec3 n = vec4(normalVC * scale, 0.0f) * viewToLight;
  vec3 facet = vec4(facetNormalVC * scale, 0.0f) * viewToLight;
  float rounding = VTKI_POSITION_ROUNDING * (vtkiMagnitude + length(p));
  bool parallel = projection == VTKI_MAP_PARALLEL;
  p = vtkiLeaveFacets(viewToLight, parallel, p, facet);
  bool cube = projection == VTKI_MAP_FACES && int(map.y + 0.5f) == VTKI_MAP_FACES;
  vec2 sum = vec2(0.0f);
  vtkiLightPairs pairs = vtkiBeginLightPairs();
  for (int i = 0; i < count; ++i)
  {
    vec3 point = vtkiNextLightPoint(pairs, i);
    for (int opposite = 0; opposite < 2; ++opposite)
    {
      float tile = map.x + float(2 * i + opposite) * depthRange.w;
      vec3 x;
      vec3 y;
      vec3 z;
      vtkiLightPointAxes((parallel ? size.x : VTKI_LIGHT_SHIFT) * point.xy, x, y, z);
      mat3 axes = mat3(x, y, z);
      if (parallel)
      {
        vec3 q = p * axes;
        sum += vtkiSeeLightPoint(tile, map, depthRange, size, true, q, n * axes, facet * axes,
          q.xy / map.z - VTKI_LIGHT_SHIFT * point.xy, 0.5f * depthRange.y - q.z, rounding);
      }
      else
      {
        vec3 q = (p - size.x * point) * axes;
        int face = cube ? vtkiFaceOf(q) : 0;
        q = vtkiToFace(q, face);
        // A wide spot light has no map of its backward face.
        float there = float(face) < depthRange.w ? 1.0f : 0.0f;
        float depth = -q.z;
        vec2 place = q.xy / (max(depth, depthRange.x) * map.z);
        sum += there *
          vtkiSeeLightPoint(tile + float(face), map, depthRange, size, false, q,
            vtkiToFace(n * axes, face), vtkiToFace(facet * axes, face), place, depth, rounding);
      }
      point = -point;
    }
  }
  float lit = sum.y > 0.0f ? sum.x / sum.y : 1.0f;
  return mix(1.0f, lit, depthRange.z);
}
