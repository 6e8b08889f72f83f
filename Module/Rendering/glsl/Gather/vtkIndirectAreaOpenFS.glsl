//VTK::System::Dec
//VTK::Output::Dec
// Irradiance from area lights if nothing hid them, at every VTKI_AREA_STEP-th pixel; distance of the nearest lamp;
// the surface there; and which lamps send light to its side of them.
#include "vtkIndirectAreaLamps.glsl"

void main()
{
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(min(ivec2(gl_FragCoord.xy) * VTKI_AREA_STEP, vtkiSize - 1), receiver);
  float front;
  gl_FragData[0] = vtkiFindOpen(receiver, lit, front);
  gl_FragData[1] =
    lit ? vec4(receiver.facetVC, dot(receiver.facetVC, receiver.positionVC)) : vec4(0.0f);
  gl_FragData[2] = vec4(front);
}
