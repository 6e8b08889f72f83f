//VTK::System::Dec
//VTK::Output::Dec
// What splats leave, at every pixel, to be added: interpolated from those of the four samples around that lie on
// the pixel's surface, and summed anew where none does.
#include "vtkIndirectCoarse.glsl"
#include "vtkIndirectFarField.glsl"

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  vec3 left = vec3(0.0f);
  if (vtkiFetchReceiver(pixel, receiver))
  {
    vec3 sum;
    float weights;
    int agreeing;
    vtkiInterpolateCoarse(pixel, receiver, sum, weights, agreeing);
    if (weights > VTKI_SPLAT_LEAST_WEIGHT)
    {
      left = sum / weights;
    }
#ifndef VTKI_SPLAT_MANY
    else
    {
      left = vtkiSumFarField(receiver.position, receiver.normal, 0, vtkiLightCount).rgb;
    }
#endif
  }
  gl_FragData[0] = vec4(left, 0.0f);
}
