//VTK::System::Dec
//VTK::Output::Dec
// Luminance of the irradiance at one pixel in each texel of the coarsest level, to see how the
// lighting varies before the image is cut up; and of the difference between the sums over lights of
// even and of odd number, which tells how much the choice of lights matters.
#include "vtkIndirectSubsplatTexel.glsl"

uniform sampler2D vtkiSurface;

float vtkiLuminanceOf(
  vec3 position, vec3 normal, vec3 open, vec4 sender, vec3 senderNormal, vec3 density)
{
  vec3 irradiance = vec3(0.0f);
  vec3 unused = vec3(0.0f);
  vtkiAddLight(position, normal, open, sender, senderNormal, density, irradiance, unused);
  return vtkiLuminance(irradiance);
}

void main()
{
  vec2 center = vtkiSubsplatCenter(floor(gl_FragCoord.xy), vtkiEdge, vec2(vtkiSize));
  vec4 surface = textureLod(vtkiSurface, 0.5f * center + 0.5f, 0.0f);
  vec3 position = vtkiReconstruct(center, surface.z, vtkiRayOrigin, vtkiRayDirection);
  position = (vtkiViewToScene * vec4(position, 1.0f)).xyz;
  vec3 normal = mat3(vtkiViewToScene) * vtkiSurfaceNormal(surface);
  bool lit = vtkiSurfaceIsLit(surface);
  vec3 open = vtkiOpenPlace(position, normal);
  float sum = 0.0f;
  float difference = 0.0f;
  float sign = 1.0f;
  int count = lit ? vtkiBlockCount : 0;
  for (int i = 0; i < count; ++i)
  {
    float luminance = vtkiLuminanceOf(position, normal, open, vtkiBlockPosition[i],
      vtkiBlockNormal[i].xyz, vtkiBlockDensity[i].rgb);
    sum += luminance;
    difference += sign * luminance;
    sign = -sign;
  }
  count = lit ? vtkiLightCount : 0;
  for (int i = vtkiBlockCount; i < count; ++i)
  {
    vec4 sender;
    vec3 senderNormal;
    vec3 density;
    vtkiFetchLight(i, sender, senderNormal, density);
    float luminance = vtkiLuminanceOf(position, normal, open, sender, senderNormal, density);
    sum += luminance;
    difference += sign * luminance;
    sign = -sign;
  }
  gl_FragData[0] = vec4(sum * vtkiStorageScale, difference * vtkiStorageScale, 0.0f, lit ? 1.0f : 0.0f);
}
