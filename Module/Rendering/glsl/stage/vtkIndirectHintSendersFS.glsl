//VTK::System::Dec
//VTK::Output::Dec
// A coarser level of the maps: a block of texels as one sender. Light and area are the block's own
// sums. Its normal is that of the texel nearest to the mean place of its light; its place is that mean
// where it lies on this texel's plane, otherwise the texel's own, so that a block over an edge does
// not hang in the air.
#include "vtkIndirectMapTexel.glsl"

uniform int vtkiBlocks; // along a map's edge
uniform int vtkiReads;  // along a block's edge, at most
uniform int vtkiRowLength;
uniform int vtkiLightCount;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int index = pixel.x + vtkiRowLength * pixel.y;
  int layer = index / (vtkiBlocks * vtkiBlocks);
  int block = index - layer * vtkiBlocks * vtkiBlocks;
  vec3 mean = vec3(0.0f);
  vec3 densityArea = vec3(0.0f);
  float area = 0.0f;
  float weights = 0.0f;
  // Where senders are does not depend on the light's strength, not even by rounding: decisions on what
  // hides them would fall otherwise. So its colour, in steps, weighs what is reflected.
  vec3 power = texelFetch(vtkiMapTable, ivec2(4, min(layer, 1 << 20)), 0).rgb;
  float most = max(power.r, max(power.g, power.b));
  vec3 hue = most > 0.0f
    ? max(floor(power / most * 1024.0f + 0.5f), ceil(min(power / most, 1.0f))) / 1024.0f
    : vec3(0.0f);
  float texels = texelFetch(vtkiMapTable, ivec2(3, min(layer, 1 << 20)), 0).z;
  float width = texels / float(vtkiBlocks);
  int reads = index < vtkiLightCount ? min(vtkiReads, max(int(width), 1)) : 0;
  vec2 first = vec2(block % vtkiBlocks, block / vtkiBlocks) * width;
  float share = width * width / float(max(reads * reads, 1));
  for (int i = 0; i < reads * reads; ++i)
  {
    vec2 at = first + (vec2(i % reads, i / reads) + 0.5f) * (width / float(reads));
    vtkiVirtualLight light;
    if (vtkiVirtualLightFromTexel(layer, ivec2(min(at, vec2(texels - 1.0f))), light))
    {
      float weight = dot(light.reflected, hue);
      mean += weight * light.position;
      densityArea += light.densityArea;
      // Unlit surface in the block sends nothing and makes the sender no larger.
      area += weight > 0.0f ? light.area : 0.0f;
      weights += weight;
    }
  }
  mean *= weights > 0.0f ? 1.0f / weights : 0.0f;
  float nearest = 1.0e30f;
  vec3 position = vec3(0.0f);
  vec3 normal = vec3(0.0f, 0.0f, 1.0f);
  int again = weights > 0.0f ? reads * reads : 0;
  for (int i = 0; i < again; ++i)
  {
    vec2 at = first + (vec2(i % reads, i / reads) + 0.5f) * (width / float(reads));
    vtkiVirtualLight light;
    if (vtkiVirtualLightFromTexel(layer, ivec2(min(at, vec2(texels - 1.0f))), light) &&
      dot(light.reflected, hue) > 0.0f)
    {
      vec3 offset = light.position - mean;
      float distance2 = dot(offset, offset);
      // In a regular block several are as near: the first of them, however the mean is rounded.
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
