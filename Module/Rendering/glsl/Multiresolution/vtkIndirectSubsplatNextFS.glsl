//VTK::System::Dec
//VTK::Output::Dec
// Makes the next level of the pyramid from the level below.
#include "vtkIndirectSubsplatJoin.glsl"

uniform sampler2D vtkiFinerSurface;
#ifdef VTKI_DEPTH_RANGE
uniform sampler2D vtkiFinerMinimum;
uniform sampler2D vtkiFinerMaximum;
#else
uniform sampler2D vtkiFinerDeviation;
#endif
uniform ivec2 vtkiFinerSize;

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vtkiJoin children;
  children.split = false;
#ifdef VTKI_REPROJECTED
  children.needed = false;
#endif
  for (int i = 0; i < 4; ++i)
  {
    ivec2 at = 2 * texel + ivec2(i & 1, i >> 1);
    ivec2 inside = min(at, vtkiFinerSize - 1);
    vec4 surface = textureLod(vtkiFinerSurface, (vec2(at) + 0.5f) / vec2(vtkiFinerSize), 0.0f);
    vec2 center = vtkiSubsplatCenter(vec2(at), 0.5f * vtkiEdge, vec2(vtkiSize));
    children.position[i] = vtkiReconstruct(center, surface.z, vtkiRayOrigin, vtkiRayDirection);
    children.normal[i] = vtkiOctahedralDecode(surface.xy);
#ifdef VTKI_DEPTH_RANGE
    children.minimum[i] = texelFetch(vtkiFinerMinimum, inside, 0);
    children.maximum[i] = texelFetch(vtkiFinerMaximum, inside, 0);
#else
    vec2 deviation = texelFetch(vtkiFinerDeviation, inside, 0).xy;
    children.deviation[i] = deviation.x;
    children.spread[i] = abs(deviation.y);
#ifdef VTKI_REPROJECTED
    children.needed = children.needed || deviation.y >= 0.0f;
#endif
#endif
    children.present[i] = surface.w != VTKI_SUBSPLAT_EMPTY && at == inside;
    children.split = children.split || (vtkiSubsplatIsSplit(surface.w) && at == inside);
  }
  // Neighbouring leaves may differ by one level: a texel is split if the ring of finer texels
  // around its children holds a split one. At the image's border the clamped texture returns one of
  // the children.
#ifdef VTKI_BALANCE
  for (int i = 0; i < 16; ++i)
  {
    vec2 at = vec2(2 * texel + ivec2(i & 3, i >> 2)) - 0.5f;
    children.split = children.split ||
      vtkiSubsplatIsSplit(textureLod(vtkiFinerSurface, at / vec2(vtkiFinerSize), 0.0f).w);
  }
#endif
#ifdef VTKI_REPROJECTED
  for (int i = 0; i < (vtkiSplits ? 0 : 16); ++i)
  {
    ivec2 at = clamp(2 * texel + ivec2((i & 3) - 1, (i >> 2) - 1), ivec2(0), vtkiFinerSize - 1);
    children.needed = children.needed || texelFetch(vtkiFinerDeviation, at, 0).y >= 0.0f;
  }
#endif
  vtkiWriteJoin(children, texel);
}
