//VTK::System::Dec
//VTK::Output::Dec
// At every VTKI_AREA_STEP-th pixel: irradiance of area lights without occlusion; distance of the
// nearest lamp; the surface's plane; a bit for each lamp that sends light to the surface's side of
// it.
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
