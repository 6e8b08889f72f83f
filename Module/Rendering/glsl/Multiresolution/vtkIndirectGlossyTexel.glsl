// The receiver at a texel of a level, or with VTKI_PIXELS at a pixel.
#include "vtkIndirectGlossyNeighbors.glsl"
#include "vtkIndirectLibGlossy.glsl"

#ifdef VTKI_PIXELS
uniform sampler2D vtkiSurface;
uniform sampler2D vtkiSpecular;
#else
uniform sampler2D vtkiLevelSurface;
uniform sampler2D vtkiLevelLobe;
#endif
uniform ivec2 vtkiLevelSize;
uniform float vtkiEdge; // pixels along a texel's edge

struct vtkiGlossyReceiver
{
  vec3 position; // view coordinates
  vec3 normal;
  float depth;
  float power;
  float state; // specular pixels are whole
};

vtkiGlossyReceiver vtkiFetchGlossyReceiver(ivec2 texel)
{
  ivec2 inside = clamp(texel, ivec2(0), vtkiLevelSize - 1);
  vtkiGlossyReceiver receiver;
#ifdef VTKI_PIXELS
  vec4 surface = texelFetch(vtkiSurface, inside, 0);
  vec4 specular = texelFetch(vtkiSpecular, inside, 0);
  vec2 center = 2.0f * (vec2(inside) + 0.5f) / vec2(vtkiSize) - 1.0f;
  bool present = vtkiSurfaceIsLit(surface) && specular.a >= 0.0f && max(max(specular.r, specular.g), specular.b) > 0.0f;
  receiver.depth = vtkiSurfaceDepth(surface);
  receiver.normal = vtkiSurfaceNormal(surface);
  receiver.power = specular.a;
  receiver.state = present ? VTKI_GLOSSY_WHOLE : VTKI_GLOSSY_NONE;
#else
  vec4 surface = texelFetch(vtkiLevelSurface, inside, 0);
  vec2 center = vtkiSubsplatCenter(vec2(inside), vtkiEdge, vec2(vtkiSize));
  vec2 lobe = texelFetch(vtkiLevelLobe, inside, 0).xy;
  receiver.depth = surface.z;
  receiver.normal = vtkiOctahedralDecode(surface.xy);
  receiver.power = lobe.x;
  receiver.state = lobe.y;
#endif
  receiver.position = vtkiReconstruct(center, receiver.depth, vtkiRayOrigin, vtkiRayDirection);
  receiver.state = texel == inside ? receiver.state : VTKI_GLOSSY_NONE;
  return receiver;
}
