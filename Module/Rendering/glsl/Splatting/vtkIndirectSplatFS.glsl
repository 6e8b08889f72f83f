//VTK::System::Dec
//VTK::Output::Dec
// What one virtual light gives a pixel under its splat, to be added; the fourth component counts splats.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectSplatLight.glsl"

flat in int vtkiSplatNumber;
flat in vec4 vtkiSplatPosition;
flat in vec4 vtkiSplatNormal;
flat in vec4 vtkiSplatDensity;

void main()
{
  vtkiReceiver receiver;
  vec3 irradiance = vec3(0.0f);
  if (vtkiFetchReceiver(ivec2(gl_FragCoord.xy), receiver))
  {
    vec3 open = vtkiSplatOpenPlace(receiver.position, receiver.normal);
    irradiance = vtkiSplatSender(receiver.position, receiver.normal, open, vtkiSplatNumber, vtkiSplatPosition,
      vtkiSplatNormal, vtkiSplatDensity.rgb, vtkiSplatDensity.a);
  }
  gl_FragData[0] = vec4(irradiance, 1.0f);
}
