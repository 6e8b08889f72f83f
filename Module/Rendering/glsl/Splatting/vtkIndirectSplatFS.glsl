//VTK::System::Dec
//VTK::Output::Dec
// Adds the irradiance of one virtual light, or with VTKI_SPLAT_LOBES of its lobe, to a pixel under
// its splat; the fourth component counts splats.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectSplatLobe.glsl"

flat in int vtkiSplatNumber;
flat in vec4 vtkiSplatPosition;
flat in vec4 vtkiSplatNormal;
flat in vec4 vtkiSplatDensity;
#ifdef VTKI_SPLAT_LOBES
flat in vec4 vtkiSplatDirection;
#endif

void main()
{
  vtkiReceiver receiver;
  vec3 irradiance = vec3(0.0f);
  if (vtkiFetchReceiver(ivec2(gl_FragCoord.xy), receiver))
  {
    vec3 open = vtkiSplatOpenPlace(receiver.position, receiver.normal, receiver.facet, ivec2(gl_FragCoord.xy));
#ifdef VTKI_SPLAT_LOBES
    irradiance = vtkiSplatLobe(receiver.position, receiver.normal, open, vtkiSplatNumber, vtkiSplatPosition,
      vtkiSplatNormal.xyz, vtkiSplatDirection, vtkiSplatDensity.rgb, vtkiSplatDensity.a);
#else
    irradiance = vtkiSplatSender(receiver.position, receiver.normal, open, vtkiSplatNumber, vtkiSplatPosition,
      vtkiSplatNormal, vtkiSplatDensity.rgb, vtkiSplatDensity.a);
#endif
  }
  gl_FragData[0] = vec4(irradiance, 1.0f);
}
