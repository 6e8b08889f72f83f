//VTK::System::Dec
//VTK::Output::Dec
// Irradiance from the hints at every vtkiStep-th pixel, with VTKI_KEEP mixed with that of the last
// frame, and the state of the pixel's cell.
#include "vtkIndirectHintCell.glsl"
#include "vtkIndirectHintLookup.glsl"

#ifdef VTKI_KEEP
uniform float vtkiKeep; // share of the last frame
uniform sampler2D vtkiLast;
#endif

void main()
{
  ivec2 coarse = ivec2(gl_FragCoord.xy);
  ivec2 pixel = vtkiSamplePixel(coarse);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  vec3 e = max(vtkiHintIrradiance(receiver.position, receiver.normal, coarse, lit), vec3(0.0f));
#ifdef VTKI_KEEP
  vec4 last = texelFetch(vtkiLast, coarse, 0);
  e = last.a > 0.5f ? mix(e, last.rgb, vtkiKeep) : e;
#endif
  gl_FragData[0] = vec4(lit ? e : vec3(0.0f),
    vtkiCellState(coarse * vtkiStep, receiver, lit));
}
