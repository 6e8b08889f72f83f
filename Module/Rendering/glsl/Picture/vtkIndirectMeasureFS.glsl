//VTK::System::Dec
//VTK::Output::Dec
// Measures blocks of pixels for vtkIndirectLightBalance, a block a fragment, every second pixel of
// every second row. First output: sums over pixels that VTK does not draw black, of the mean of
// red, green and blue, of VTK's shading, of its part by lamps and of the preset's own light. Second
// output: the greatest strengths of the own light with which no
// channel exceeds MOST, or VTK's value if that is more, where none and where all of the lamps'
// light is replaced.
#include "vtkIndirectAddedLight.glsl"
#include "vtkIndirectAlbedo.glsl"
#include "vtkIndirectBalance.glsl"

// Pixels between those that are measured may be brighter.
const float MOST = 0.99f;

uniform int vtkiBlock; // pixels along an edge of a block
uniform float vtkiUnbounded;

float findMean(vec3 color)
{
  return dot(color, vec3(1.0f / 3.0f));
}

float findLeast(vec3 color)
{
  return min(color.r, min(color.g, color.b));
}

void main()
{
  ivec2 first = vtkiBlock * ivec2(gl_FragCoord.xy);
  ivec2 end = min(first + vtkiBlock, vtkiSize);
  vec3 sums = vec3(0.0f);
  vec2 room = vec2(vtkiUnbounded);
  for (int y = first.y; y < end.y; y += 2)
  {
    for (int x = first.x; x < end.x; x += 2)
    {
      ivec2 pixel = ivec2(x, y);
      vec4 surface = texelFetch(vtkiSurface, pixel, 0);
      vec3 albedo = vtkiFetchAlbedo(pixel);
      if (!vtkiSurfaceIsLit(surface) || vtkiSurfaceCatches(surface) || albedo == vec3(0.0f))
      {
        continue;
      }
      vec3 direct = vtkiDecodeShading(surface, texelFetch(vtkiLit, pixel, 0).rgb);
      vec2 position = vec2(pixel) + 0.5f;
      vec3 sky = vec3(0.0f);
      vec3 area = vec3(0.0f);
      vec3 bounce = vec3(0.0f);
      vtkiAddIrradiance(position, surface, sky, area, bounce);
      vec3 own = albedo * (sky + area + bounce);
      vtkiAddRadiance(position, 1.0f, own);
      vec3 lamps = vtkiFindLampLight(surface, albedo, direct);
      float mean = findMean(min(direct, vec3(1.0f)));
      sums += mean > 0.0f ? vec3(mean, findMean(lamps), findMean(own)) : vec3(0.0f);
      // A pixel that VTK clips becomes no brighter.
      vec3 left = max(MOST - direct, vec3(0.0f));
      vec3 reflected = max(own, vec3(1.0e-6f));
      room = min(room, vec2(findLeast(left / reflected), findLeast((left + lamps) / reflected)));
    }
  }
  gl_FragData[0] = vec4(sums, 0.0f);
  gl_FragData[1] = vec4(room, 0.0f, 0.0f);
}
