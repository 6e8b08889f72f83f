// Occlusion between two points by the eye's depth buffer (section 8 of the paper). Not physical: a
// point hidden from the eye need not be hidden from a sender.
#include "vtkIndirectLibSurface.glsl"

uniform int vtkiDepthSamples; // 0: off
uniform float vtkiDepthFactor;
uniform sampler2D vtkiSurface;
uniform mat4 vtkiSceneToView; // scaled view coordinates
uniform mat4 vtkiSceneToClip;

float vtkiDepthShare(vec3 a, vec3 b, bool needed)
{
  float share = 1.0f;
  int count = needed ? vtkiDepthSamples : 0;
  for (int i = 0; i < count; ++i)
  {
    vec4 p = vec4(mix(a, b, (float(i) + 0.5f) / float(count)), 1.0f);
    vec4 clip = vtkiSceneToClip * p;
    vec2 at = 0.5f * clip.xy / clip.w + 0.5f;
    if (clip.w > 0.0f && min(at.x, at.y) >= 0.0f && max(at.x, at.y) < 1.0f)
    {
      float depth = vtkiSurfaceDepth(
        texelFetch(vtkiSurface, ivec2(at * vec2(textureSize(vtkiSurface, 0))), 0));
      share *= depth > 0.0f && -(vtkiSceneToView * p).z > depth ? vtkiDepthFactor : 1.0f;
    }
  }
  return share;
}
