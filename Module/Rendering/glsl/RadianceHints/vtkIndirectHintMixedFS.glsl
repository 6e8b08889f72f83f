//VTK::System::Dec
//VTK::Output::Dec
// Joint bilateral interpolation of the coarse samples that lie on a pixel's surface. If there is
// none, the pixel is discarded together with its depth, by which a second draw finds it.
#include "vtkIndirectCoarse.glsl"

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  vec3 sum;
  float weights;
  int agreeing;
  vtkiInterpolateCoarse(pixel, receiver, sum, weights, agreeing);
  if (lit && weights < 0.05f)
  {
    discard;
  }
  gl_FragData[0] = vec4(lit ? sum / weights : vec3(0.0f), 1.0f);
}
