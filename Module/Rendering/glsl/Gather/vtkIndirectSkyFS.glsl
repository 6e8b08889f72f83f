//VTK::System::Dec
//VTK::Output::Dec
// Irradiance that comes directly from the sky: the sum over its directions of those that the receiver
// sees, each by a parallel depth map of its own. VTKI_FILTERED: of few strong directions, whose shadows
// have edges that are seen.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectLibDepthTile.glsl"

// Directions in a block: 16000 of the 16384 bytes that every OpenGL has.
const int VTKI_SKY_BLOCK = 200;
layout(std140) uniform vtkiSkyBlock
{
  vec4 vtkiSkyRight[VTKI_SKY_BLOCK]; // rows of the matrix from scene to the tile's image, [-1,1]
  vec4 vtkiSkyUp[VTKI_SKY_BLOCK];
  vec4 vtkiSkyDepth[VTKI_SKY_BLOCK]; // and to what the depth buffer holds, [0,1]
  vec4 vtkiSkyLight[VTKI_SKY_BLOCK]; // radiance times solid angle over pi, column of the tile
  vec4 vtkiSkyShape[VTKI_SKY_BLOCK]; // half widths squared, range of depth, row of the tile
};
uniform int vtkiSkyCount;
#ifdef VTKI_VISIBILITY
uniform sampler2D vtkiDepthTiles;
uniform vec2 vtkiTileShape; // tiles along an edge of the atlas, texels along an edge of a tile

struct vtkiSkyPlace
{
  vec2 place; // in the tile's image, [-1,1]
  float depth;
  vec2 slope; // of the receiver's plane, see vtkiParallelTileDepth
};

vtkiSkyPlace vtkiFindSkyPlace(int i, vec3 position, vec3 normal)
{
  vec4 right = vtkiSkyRight[i];
  vec4 up = vtkiSkyUp[i];
  vec4 down = vtkiSkyDepth[i];
  vec4 shape = vtkiSkyShape[i];
  return vtkiSkyPlace(
    vec2(dot(right.xyz, position) + right.w, dot(up.xyz, position) + up.w),
    dot(down.xyz, position) + down.w,
    vec2(dot(normal, right.xyz) * shape.x, dot(normal, up.xyz) * shape.y));
}

// Whether the sky is seen over one texel of a direction's tile.
bool vtkiIsSkySeen(int i, vtkiSkyPlace at, vec2 texel, float cosine)
{
  vec4 shape = vtkiSkyShape[i];
  float texels = vtkiTileShape.y;
  // Nothing casts beyond the tile's border.
  vec2 held = clamp(texel, vec2(0.0f), vec2(texels - 1.0f));
  vec2 toCentre = (2.0f * held + 1.0f) / texels - 1.0f - at.place;
  // A look-up at a texel's centre is exact, and in software faster than a fetch.
  vec2 corner = vec2(vtkiSkyLight[i].w, shape.w) * texels;
  float stored =
    textureLod(vtkiDepthTiles, (corner + held + 0.5f) / (vtkiTileShape.x * texels), 0.0f).r;
  return texel != held ||
    stored >= vtkiParallelTileDepth(at.depth, cosine, at.slope, toCentre, texels, shape);
}
#endif

void main()
{
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(ivec2(gl_FragCoord.xy), receiver);
  vec3 sum = vec3(0.0f);
  int count = lit ? vtkiSkyCount : 0;
  for (int i = 0; i < count; ++i)
  {
    float cosine = -dot(receiver.normal, vtkiSkyDepth[i].xyz) * vtkiSkyShape[i].z;
    float seen = 1.0f;
#ifdef VTKI_VISIBILITY
    vtkiSkyPlace at = vtkiFindSkyPlace(i, receiver.position, receiver.normal);
    vec2 texel = (0.5f + 0.5f * at.place) * vtkiTileShape.y;
#ifdef VTKI_FILTERED
    // The four nearest texels, so that the edge of a shadow is as wide as one of them.
    vec2 first = floor(texel - 0.5f);
    vec2 blend = texel - 0.5f - first;
    vec4 four = vec4(vtkiIsSkySeen(i, at, first, cosine),
      vtkiIsSkySeen(i, at, first + vec2(1.0f, 0.0f), cosine),
      vtkiIsSkySeen(i, at, first + vec2(0.0f, 1.0f), cosine),
      vtkiIsSkySeen(i, at, first + 1.0f, cosine));
    vec2 rows = mix(four.xz, four.yw, blend.x);
    seen = mix(rows.x, rows.y, blend.y);
#else
    seen = vtkiIsSkySeen(i, at, floor(texel), cosine) ? 1.0f : 0.0f;
#endif
#endif
    sum += max(cosine, 0.0f) * seen * vtkiSkyLight[i].rgb;
  }
  gl_FragData[0] = vec4(sum, 1.0f);
}
