//VTK::System::Dec
//VTK::Output::Dec
// Adds the light of an area light's points at a pixel, once of visible points and once of all, to
// the sums of other rounds and lights.
#define VTKI_VISIBILITY
#include "vtkIndirectAreaLamps.glsl"

uniform int vtkiAreaPoints; // points in use

void main()
{
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(ivec2(gl_FragCoord.xy), receiver);
  vec3 seen = vec3(0.0f);
  vec3 all = vec3(0.0f);
  vtkiAddShares(0, lit ? vtkiAreaPoints : 0, receiver, seen, all);
  gl_FragData[0] = vec4(seen, 0.0f);
  gl_FragData[1] = vec4(all, 0.0f);
}
