//VTK::System::Dec
//VTK::Output::Dec
// The far field at every vtkiStep-th pixel.
#include "vtkIndirectReceiverGrid.glsl"
#include "vtkIndirectFarField.glsl"

void main()
{
  ivec2 pixel = vtkiSamplePixel(ivec2(gl_FragCoord.xy));
  vtkiReceiver receiver;
  vtkiFarField sum = vtkiFarField(vec3(0.0f), 0.0f, vec3(0.0f));
  if (vtkiFetchReceiver(pixel, receiver))
  {
    sum = vtkiSumFarField(receiver.position, receiver.normal, receiver.facet, pixel, vtkiLightRows.x * VTKI_ROW_LENGTH,
      min(vtkiLightRows.y * VTKI_ROW_LENGTH, vtkiLightCount));
  }
  gl_FragData[0] = vec4(sum.irradiance, sum.all);
  gl_FragData[1] = vec4(sum.vector, 0.0f);
}
