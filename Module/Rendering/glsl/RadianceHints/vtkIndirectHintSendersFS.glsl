//VTK::System::Dec
//VTK::Output::Dec
// A coarser level of the maps: a block of texels makes one sender. Its light and area are the
// block's sums. Its normal is that of the texel nearest to the light-weighted mean position; its
// position is that mean if it lies on this texel's plane, otherwise the texel's, so that the sender
// of a block over an edge lies on a surface.
#include "vtkIndirectMapTexel.glsl"

uniform int vtkiBlocks; // blocks along a map's edge
uniform int vtkiReads;  // texels along a block's edge, at most
uniform int vtkiLightCount;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int index = vtkiTableEntry(pixel);
  int layer = index / (vtkiBlocks * vtkiBlocks);
  int block = index - layer * vtkiBlocks * vtkiBlocks;
  vec3 mean = vec3(0.0f);
  vec3 densityArea = vec3(0.0f);
  float area = 0.0f;
  float weights = 0.0f;
  // The senders' positions must not depend on the light's strength, not even by rounding, because
  // tests of visibility would change with it. So the light's colour, in steps, weights the
  // reflectance.
  vec3 power = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_LIGHT, min(layer, 1 << 20)), 0).rgb;
  float most = max(power.r, max(power.g, power.b));
  vec3 hue = most > 0.0f
    ? max(floor(power / most * 1024.0f + 0.5f), ceil(min(power / most, 1.0f))) / 1024.0f
    : vec3(0.0f);
  int texels = int(texelFetch(vtkiMapTable, ivec2(VTKI_MAP_SHAPE, min(layer, 1 << 20)), 0).z);
  // Blocks are of whole texels, each in one block only: overlapping blocks would count some texels
  // twice and others never, and a row of doubled texels at a surface's edge is far more light than
  // the mean allows for.
  ivec2 column = ivec2(block % vtkiBlocks, block / vtkiBlocks);
  ivec2 first = column * texels / vtkiBlocks;
  ivec2 width = (column + 1) * texels / vtkiBlocks - first;
  ivec2 reads = index < vtkiLightCount ? min(width, ivec2(vtkiReads)) : ivec2(0);
  int count = reads.x * reads.y;
  vec2 between = vec2(width) / vec2(max(reads, ivec2(1)));
  float share = between.x * between.y;
  for (int i = 0; i < count; ++i)
  {
    vec2 at = (vec2(i % reads.x, i / reads.x) + 0.5f) * between;
    vtkiVirtualLight light;
    if (vtkiVirtualLightFromTexel(layer, first + ivec2(at), light))
    {
      float weight = dot(light.reflected, hue);
      mean += weight * light.position;
      densityArea += light.densityArea;
      // Unlit texels of the block send no light and do not enlarge the sender.
      area += weight > 0.0f ? light.area : 0.0f;
      weights += weight;
    }
  }
  mean *= weights > 0.0f ? 1.0f / weights : 0.0f;
  float nearest = 1.0e30f;
  vec3 position = vec3(0.0f);
  vec3 normal = vec3(0.0f, 0.0f, 1.0f);
  int again = weights > 0.0f ? count : 0;
  for (int i = 0; i < again; ++i)
  {
    vec2 at = (vec2(i % reads.x, i / reads.x) + 0.5f) * between;
    vtkiVirtualLight light;
    if (vtkiVirtualLightFromTexel(layer, first + ivec2(at), light) &&
      dot(light.reflected, hue) > 0.0f)
    {
      vec3 offset = light.position - mean;
      float distance2 = dot(offset, offset);
      // In a regular block several texels are equally near: takes the first of them, however the
      // mean is rounded.
      bool nearer = distance2 < 0.99f * nearest;
      position = nearer ? light.position : position;
      normal = nearer ? light.normal : normal;
      nearest = nearer ? distance2 : nearest;
    }
  }
  vec3 shift = mean - position;
  float height = dot(shift, normal);
  if (height * height < 0.01f * area * share)
  {
    position += shift - height * normal;
  }
  gl_FragData[0] = vec4(position, max(area * share, 1.0e-20f));
  gl_FragData[1] = vec4(normal, 0.0f);
  gl_FragData[2] = vec4(densityArea * share, 0.0f);
}
