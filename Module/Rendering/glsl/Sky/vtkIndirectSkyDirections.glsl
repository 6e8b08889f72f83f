// Directions of the sky in a uniform block, and a receiver's irradiance from one direction.
// VTKI_SKY_BLOCK: directions in the block, at most 146: 16384 bytes, which every OpenGL has.
// VTKI_VISIBILITY: tests occlusion; VTKI_FILTERED: filters the shadow edges, which are visible if
// few strong directions make the sky; VTKI_SKY_NEAR: directions have second tiles, of the nearer
// part of the picture.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectLibDepthTile.glsl"
#include "vtkIndirectCrease.glsl"

layout(std140) uniform vtkiSkyBlock
{
  vec4 vtkiSkyRight[VTKI_SKY_BLOCK]; // rows of the matrix from scene to texels of the tile
  vec4 vtkiSkyUp[VTKI_SKY_BLOCK];
  vec4 vtkiSkyDepth[VTKI_SKY_BLOCK]; // row to the depth buffer's value, [0,1], less the bias
  // irradiance facing it, times the range of depth; sum over colours
  vec4 vtkiSkyLight[VTKI_SKY_BLOCK];
  vec4 vtkiSkyPlace[VTKI_SKY_BLOCK]; // first texel of the tile; a texel's width over the range, squared
  // from texels of the tile to those of the second tile: scale and offset
  vec4 vtkiSkyNearer[VTKI_SKY_BLOCK];
  // first texel of the second tile; its depths less the first one's; ratio of the texels' widths
  vec4 vtkiSkyNearerPlace[VTKI_SKY_BLOCK];
};

struct vtkiSkyDirection
{
  vec4 right;
  vec4 up;
  vec4 down;
  vec4 light;
  vec4 place;
  float halfTexel; // over the range of depth, squared; infinite for receivers that cast no shadow
  float nearness;  // sum of the light over the range of depth
  float least;     // half a texel over the range of depth
  float perRange2; // one over the range of depth, squared
#ifdef VTKI_SKY_NEAR
  vec4 near;
  vec4 nearPlace;
#endif
};

#ifdef VTKI_VISIBILITY
uniform int vtkiReceiversCast; // see vtkIndirectDepthTiles.glsl
#else
const int vtkiReceiversCast = 1;
#endif

vtkiSkyDirection vtkiFetchSkyDirection(int i)
{
  float perRange = length(vtkiSkyDepth[i].xyz);
  float least = 0.5f * sqrt(max(vtkiSkyPlace[i].z, vtkiSkyPlace[i].w));
  return vtkiSkyDirection(
    vtkiSkyRight[i], vtkiSkyUp[i], vtkiSkyDepth[i], vtkiSkyLight[i], vtkiSkyPlace[i],
    vtkiReceiversCast != 0 ? perRange * least : 1.0e30f, perRange * vtkiSkyLight[i].w, least, perRange * perRange
#ifdef VTKI_SKY_NEAR
    , vtkiSkyNearer[i], vtkiSkyNearerPlace[i]
#endif
    );
}

#ifdef VTKI_VISIBILITY
uniform sampler2D vtkiDepthTiles;
uniform vec3 vtkiTileShape; // columns and rows of tiles in the atlas, texels along an edge of a tile

// Answer of one texel of a direction's tile, see vtkiLookUpParallelTile: 1 if the sky is visible
// over it, and 1 if it answers. first: the tile's first texel; at: the receiver's place, centre: the
// texel's, in the tile; slope: of the receiver's plane; over: depth of what the texel shows before the
// receiver.
vec2 vtkiLookUpSky(vec2 first, vec2 at, vec2 centre, float depth, float facing, vec2 slope, float bend,
  out float over)
{
  // A look-up at a texel's centre is exact, and in software faster than a fetch.
  float stored = textureLod(vtkiDepthTiles,
    (first + centre) * (1.0f / (vtkiTileShape.xy * vtkiTileShape.z)), 0.0f).r;
  over = depth - stored;
  // There are no casters beyond the tile's border.
  vec2 beyond = abs(centre - 0.5f * vtkiTileShape.z);
  return vtkiLookUpParallelTile(
    max(beyond.x, beyond.y) > 0.5f * vtkiTileShape.z, stored, depth, facing, slope, centre - at, bend);
}

// Answer in a crease. The other surface hides what lies behind its plane, and nothing before the plane:
// a texel whose centre lies beyond the crease shows the other surface, which may rise over the receiver.
// offset: from the receiver to the texel's centre; perTexel: from the axes' products with a normal to
// a slope; over: see vtkiLookUpSky.
vec2 vtkiAnswerInCrease(vec2 answer, vtkiSkyDirection sky, vec3 position, vtkiCrease crease, vec2 offset,
  vec2 perTexel, float over)
{
  float facing = -dot(crease.normal, sky.down.xyz);
  vec2 slope = vec2(dot(crease.normal, sky.right.xyz), dot(crease.normal, sky.up.xyz)) * perTexel;
  float height = (dot(crease.normal, position) - crease.plane) * sky.perRange2;
  bool shows = facing > 0.0f && -over * facing >= height + dot(slope, offset);
  vec2 other = vec2(shows ? 1.0f : answer.x, shows ? 1.0f : answer.y);
  return vtkiHidesInCrease(crease, position, -sky.down.xyz) ? vec2(0.0f, 1.0f) : other;
}
#endif

// Irradiance, and in the fourth component its unoccluded sum over the colours. facet: the normal of
// the receiver's plane. Directions below that plane and above the shading normal's horizon take no
// part: the curved surface that facets approximate does not hide them. Nor do directions whose tile
// does not answer: the others represent them. nearness: what is hidden of the sum over the colours,
// over the distance of what hides it, is added.
vec4 vtkiFromSky(vtkiSkyDirection sky, vec3 position, vec3 normal, vec3 facet, vtkiCrease crease,
  inout float nearness)
{
  float facing = max(-dot(normal, sky.down.xyz), 0.0f);
#ifndef VTKI_FILTERED
  facing = dot(facet, sky.down.xyz) < 0.0f ? facing : 0.0f;
#endif
  vec2 answer = vec2(1.0f);
#ifdef VTKI_VISIBILITY
  vec2 at = vec2(
    dot(sky.right.xyz, position) + sky.right.w, dot(sky.up.xyz, position) + sky.up.w);
  float depth = dot(sky.down.xyz, position) + sky.down.w;
  vec2 perTexel = sky.place.zw;
  vec2 tile = sky.place.xy;
  float halfTexel = sky.halfTexel;
  float least = sky.least;
#ifdef VTKI_SKY_NEAR
  vec2 nearAt = at * sky.near.xy + sky.near.zw;
  bool near = min(nearAt.x, nearAt.y) > 1.0f && max(nearAt.x, nearAt.y) < vtkiTileShape.z - 1.0f;
  at = near ? nearAt : at;
  depth += near ? sky.nearPlace.z : 0.0f;
  perTexel /= near ? sky.near.xy : vec2(1.0f);
  tile = near ? sky.nearPlace.xy : tile;
  halfTexel *= near ? sky.nearPlace.w : 1.0f;
  least *= near ? sky.nearPlace.w : 1.0f;
#endif
  vec2 slope = vec2(dot(facet, sky.right.xyz), dot(facet, sky.up.xyz)) * perTexel;
  float open = max(-dot(facet, sky.down.xyz), 0.0f);
  float over;
#ifdef VTKI_FILTERED
  // Blend of the four nearest texels, which widens the shadow's edge to a texel.
  vec2 first = floor(at - 0.5f) + 0.5f;
  vec2 blend = at - first;
  vec2 lower = mix(vtkiLookUpSky(tile, at, first, depth, open, slope, halfTexel, over),
    vtkiLookUpSky(tile, at, first + vec2(1.0f, 0.0f), depth, open, slope, halfTexel, over), blend.x);
  vec2 upper = mix(vtkiLookUpSky(tile, at, first + vec2(0.0f, 1.0f), depth, open, slope, halfTexel, over),
    vtkiLookUpSky(tile, at, first + 1.0f, depth, open, slope, halfTexel, over), blend.x);
  answer = mix(lower, upper, blend.y);
  answer.x /= max(answer.y, 1.0e-6f);
  answer.x = vtkiHidesInCrease(crease, position, -sky.down.xyz) ? 0.0f : answer.x;
#else
  vec2 centre = floor(at) + 0.5f;
  answer = vtkiLookUpSky(tile, at, centre, depth, open, slope, halfTexel, over);
  answer = vtkiAnswerInCrease(answer, sky, position, crease, centre - at, perTexel, over);
  nearness += facing * (answer.y - answer.x) * sky.nearness / max(over, least);
#endif
#endif
  return facing * vec4(answer.x * sky.light.rgb, answer.y * sky.light.w);
}
