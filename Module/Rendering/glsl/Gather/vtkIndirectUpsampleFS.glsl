//VTK::System::Dec
//VTK::Output::Dec
// Irradiance at every pixel: interpolated from the coarse samples if at least three of the four
// neighbours lie on the same surface, otherwise gathered anew (Dachsbacher and Stamminger 2005,
// 5.2).
#include "vtkIndirectCoarse.glsl"
#include VTKI_GATHER

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  if (!vtkiFetchReceiver(pixel, receiver))
  {
    gl_FragData[0] = vec4(0.0f, 0.0f, 0.0f, 1.0f);
    return;
  }
  vec3 sum;
  float weights;
  int agreeing;
  vtkiInterpolateCoarse(pixel, receiver, sum, weights, agreeing);
  // Three of four agreeing samples have more than zero weight, except exactly on a sample.
  if (agreeing >= 3 && weights > 0.0f)
  {
    gl_FragData[0] = vec4(sum / weights, 1.0f);
  }
  else
  {
    gl_FragData[0] = vec4(vtkiGather(receiver.position, receiver.normal, receiver.facet, pixel), 1.0f);
  }
}
