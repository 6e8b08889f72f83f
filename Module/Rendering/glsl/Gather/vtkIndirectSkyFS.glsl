//VTK::System::Dec
//VTK::Output::Dec
// Irradiance that comes directly from the sky: the sum over its directions of those that the receiver
// sees, each by a parallel depth map of its own.
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
#endif

void main()
{
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(ivec2(gl_FragCoord.xy), receiver);
  vec3 position = receiver.position;
  vec3 normal = receiver.normal;
  vec3 sum = vec3(0.0f);
  int count = lit ? vtkiSkyCount : 0;
  for (int i = 0; i < count; ++i)
  {
    vec4 down = vtkiSkyDepth[i];
    vec4 shape = vtkiSkyShape[i];
    vec4 light = vtkiSkyLight[i];
    float cosine = -dot(normal, down.xyz) * shape.z;
#ifdef VTKI_VISIBILITY
    vec4 right = vtkiSkyRight[i];
    vec4 up = vtkiSkyUp[i];
    vec2 place = vec2(dot(right.xyz, position) + right.w, dot(up.xyz, position) + up.w);
    float depth = dot(down.xyz, position) + down.w;
    vec2 slope = vec2(dot(normal, right.xyz) * shape.x, dot(normal, up.xyz) * shape.y);
    float texels = vtkiTileShape.y;
    vec2 texel = floor((0.5f + 0.5f * place) * texels);
    // Nothing casts beyond the tile's border.
    bool inside = texel == clamp(texel, vec2(0.0f), vec2(texels - 1.0f));
    texel = clamp(texel, vec2(0.0f), vec2(texels - 1.0f));
    vec2 toCentre = (2.0f * texel + 1.0f) / texels - 1.0f - place;
    // A look-up at a texel's centre is exact, and in software faster than a fetch.
    vec2 at = (vec2(light.w, shape.w) * texels + texel + 0.5f) / (vtkiTileShape.x * texels);
    float stored = textureLod(vtkiDepthTiles, at, 0.0f).r;
    bool seen =
      !inside || stored >= vtkiParallelTileDepth(depth, cosine, slope, toCentre, texels, shape);
    cosine = seen ? cosine : 0.0f;
#endif
    sum += max(cosine, 0.0f) * light.rgb;
  }
  gl_FragData[0] = vec4(sum, 1.0f);
}
