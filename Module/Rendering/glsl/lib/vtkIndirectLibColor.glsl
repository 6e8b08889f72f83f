// VTK's PBR writes colours encoded with gamma 2.2; Phong writes them linear.
#ifndef vtkIndirectLibColor
#define vtkIndirectLibColor
#include "vtkIndirectLibPortable.glsl"

const float VTKI_GAMMA = 2.2f;

vec3 vtkiDecodeGamma(vec3 c)
{
  return vec3(pow(max(c.x, 0.0f), VTKI_GAMMA), pow(max(c.y, 0.0f), VTKI_GAMMA),
    pow(max(c.z, 0.0f), VTKI_GAMMA));
}

vec3 vtkiEncodeGamma(vec3 c)
{
  float e = 1.0f / VTKI_GAMMA;
  return vec3(pow(max(c.x, 0.0f), e), pow(max(c.y, 0.0f), e), pow(max(c.z, 0.0f), e));
}
#endif
