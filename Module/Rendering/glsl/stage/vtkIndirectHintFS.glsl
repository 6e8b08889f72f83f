//VTK::System::Dec
//VTK::Output::Dec
// Irradiance from the hints at every vtkiStep-th pixel, mixed with that of the last frame, and what the
// cell of pixels beyond it holds.
#include "vtkIndirectHintCell.glsl"
#include "vtkIndirectHintLookup.glsl"

uniform float vtkiKeep; // share of the last frame
uniform sampler2D vtkiLast;

void main()
{
  ivec2 coarse = ivec2(gl_FragCoord.xy);
  ivec2 pixel = min(coarse * vtkiStep, vtkiSize - 1);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  vec3 e = max(vtkiHintIrradiance(receiver.position, receiver.normal, coarse, lit), vec3(0.0f));
  vec4 last = texelFetch(vtkiLast, coarse, 0);
  float keep = last.a > 0.5f ? vtkiKeep : 0.0f;
  gl_FragData[0] = vec4(lit ? (keep > 0.0f ? mix(e, last.rgb, keep) : e) : vec3(0.0f),
    vtkiCellState(coarse * vtkiStep, receiver, lit));
}
