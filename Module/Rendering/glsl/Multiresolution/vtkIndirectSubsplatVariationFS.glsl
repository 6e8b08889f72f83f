//VTK::System::Dec
//VTK::Output::Dec
// Relative error of linear interpolation between probes: compares each probe with the mean of its
// two neighbours on the same surface. On a grid of half the width the error is a quarter. Also the
// probe's nearest light, whose curvature between probes exceeds what the probes can show.
#include "vtkIndirectSubsplatPlane.glsl"

uniform sampler2D vtkiSurface;
uniform sampler2D vtkiProbe;
uniform sampler2D vtkiProbeDensity;
uniform ivec2 vtkiLevelSize;
uniform float vtkiEdge;

void main()
{
  vec2 texel = floor(gl_FragCoord.xy);
  vec2 center = vtkiSubsplatCenter(texel, vtkiEdge, vec2(vtkiSize));
  vec4 surface = textureLod(vtkiSurface, 0.5f * center + 0.5f, 0.0f);
  vec3 normal = vtkiSurfaceNormal(surface);
  vtkiTangentPlane plane =
    vtkiMakeTangentPlane(vtkiReconstruct(center, vtkiSurfaceDepth(surface), vtkiRayOrigin, vtkiRayDirection),
      normal, vtkiSurfaceCode(surface), vtkiSurfaceDepth(surface), vtkiEdge);
  float own = textureLod(vtkiProbe, gl_FragCoord.xy / vec2(vtkiLevelSize), 0.0f).r;
  vec3 nearest = textureLod(vtkiProbeDensity, gl_FragCoord.xy / vec2(vtkiLevelSize), 0.0f).xyz;
  float greatest = own;
  float error = 0.0f;
  for (int axis = 0; axis < 2; ++axis)
  {
    float second = 0.0f;
    for (int side = -1; side <= 1; side += 2)
    {
      vec2 at = texel + float(side) * (axis == 0 ? vec2(1.0f, 0.0f) : vec2(0.0f, 1.0f));
      vec2 inside = clamp(at, vec2(0.0f), vec2(vtkiLevelSize - 1));
      vec2 otherCenter = vtkiSubsplatCenter(inside, vtkiEdge, vec2(vtkiSize));
      vec4 other = textureLod(vtkiSurface, 0.5f * otherCenter + 0.5f, 0.0f);
      bool lit = vtkiSurfaceIsLit(other);
      float there = textureLod(vtkiProbe, (inside + 0.5f) / vec2(vtkiLevelSize), 0.0f).r;
      bool same = vtkiSurfaceIsLit(surface) && lit && at == inside &&
        vtkiIsOnPlane(plane, otherCenter,
          vec4(vtkiSurfaceCode(other), vtkiSurfaceDepth(other), 0.0f));
      greatest = max(greatest, there);
      second += same ? there - own : 0.0f;
    }
    // Interpolation's error midway is an eighth of the second difference. At an end of the surface
    // only the first difference is known; light from a surface that meets it there falls as one
    // over the distance, whose second difference is as large.
    error = max(error, 0.125f * abs(second));
  }
  gl_FragData[0] = vec4(greatest > 0.0f ? error / greatest : 0.0f, nearest);
}
