// Mean of an image over a rectangle as a receiver sees it. The descent of the image's pyramid ends
// where the texels below differ too little from their mean to matter.
#include "vtkIndirectLibAreaLight.glsl"

// This is the radiance, and three times the variance of the texels below, summed over the colours:
// at least the variance of the sum of the colours. The lamps' pyramids lie above each other.
uniform sampler2D vtkiAreaPyramid;
uniform float vtkiAreaTolerance;

// Levels lie beside each other, the finest one alone on the left. image: first row, level of the
// single texel.
vec4 vtkiFetchAreaTexel(ivec2 image, int level, ivec2 texel)
{
  int edge = 1 << image.y;
  ivec2 first = level == 0 ? ivec2(0) : ivec2(edge, edge - (edge >> (level - 1)));
  return texelFetch(vtkiAreaPyramid, ivec2(0, image.x) + first + texel, 0);
}

// whole: form factor of the whole rectangle, or 0 if no value is wanted. The pieces' errors have
// practically independent signs: the square of each may take the share of the squared tolerance
// that the piece has of the whole.
vec3 vtkiMeanOfImage(ivec2 image, vec3 corner, vec3 edge1, vec3 edge2, vec3 normal, float whole)
{
  int top = image.y;
  vec4 mean = vtkiFetchAreaTexel(image, top, ivec2(0));
  float goal = vtkiAreaTolerance * (mean.r + mean.g + mean.b);
  goal *= goal * whole;
  vec3 span = cross(edge1, edge2);
  float area = length(span);
  float plane = abs(dot(span, corner)) / max(area, 1.0e-30f);
  vec3 heights = vec3(dot(normal, edge1), dot(normal, edge2), dot(normal, corner));
  float reach = 0.5f * (abs(heights.x) + abs(heights.y));
  vec2 length2 = vec2(dot(edge1, edge1), dot(edge2, edge2));
  float far2 = VTKI_PIECE_FAR * VTKI_PIECE_FAR * max(length2.x, length2.y);
  int level = whole > 0.0f ? top : top + 1;
  ivec2 texel = ivec2(0);
  vec4 sum = vec4(0.0f);
  // Bound of the time: after this many rounds, the remaining pieces count with their mean.
  for (int round = 0; round < 4096 && level <= top; ++round)
  {
    float width = 1.0f / float(1 << (top - level));
    float width2 = width * width;
    vec2 at = (vec2(texel) + 0.5f) * width;
    vec3 middle = corner + at.x * edge1 + at.y * edge2;
    float square = max(dot(middle, middle), 1.0e-30f);
    float height = heights.z + at.x * heights.x + at.y * heights.y;
    float up = width * reach;
    vtkiPiece piece = vtkiPiece(square, max(max(height, up), 1.0e-30f), width * heights.xy,
      width * vec2(dot(middle, edge1), dot(middle, edge2)), width2 * length2);
    bool near = square < far2 * width2;
    float factor = width2 * area * plane * vtkiMeanHeight(height, up) * vtkiPieceMean(piece) /
      (VTKI_PI * square * square);
    vec4 radiance = vtkiFetchAreaTexel(image, level, texel);
    bool below = height + up <= 0.0f;
    bool taken = level == 0 || below || radiance.a == 0.0f || round > 3072 ||
      (!near && radiance.a * vtkiPieceVariance(piece) * factor <= goal);
    // A loop of one round, which software skips where it is not needed. Compilers cannot know that
    // it has only one.
    for (int n = near && taken && !below ? 1 : 0; n > 0; n -= top)
    {
      factor = vtkiRectangleFormFactor(middle - (0.5f * width) * (edge1 + edge2), width * edge1,
        width * edge2, normal);
    }
    sum += taken ? factor * vec4(radiance.rgb, 1.0f) : vec4(0.0f);
    if (!taken)
    {
      --level;
      texel *= 2;
    }
    else
    {
      while ((texel.x & texel.y & 1) == 1 && level < top)
      {
        texel >>= 1;
        ++level;
      }
      bool last = level >= top;
      level += last ? 1 : 0;
      texel += (texel.x & 1) == 0 ? ivec2(1, 0) : ivec2(-1, 1);
    }
  }
  return sum.a > 0.0f ? sum.rgb / sum.a : mean.rgb;
}
