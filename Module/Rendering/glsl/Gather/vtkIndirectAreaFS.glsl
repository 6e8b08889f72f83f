//VTK::System::Dec
//VTK::Output::Dec
// Irradiance of an area light of one radiance in closed form, without occlusion.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectLibAreaLight.glsl"

uniform vec3 vtkiAreaCorner; // scene units
uniform vec3 vtkiAreaEdge1;
uniform vec3 vtkiAreaEdge2;
uniform vec3 vtkiAreaNormal; // the side that sends light
uniform bool vtkiAreaTwoSided;
uniform vec3 vtkiAreaRadiance;

void main()
{
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(ivec2(gl_FragCoord.xy), receiver);
  vec3 corner = vtkiAreaCorner - receiver.position;
  bool front = dot(vtkiAreaNormal, corner) < 0.0f;
  lit = lit && (front || vtkiAreaTwoSided);
  if (!lit)
  {
    discard;
  }
  float whole = vtkiRectangleFormFactor(corner, vtkiAreaEdge1, vtkiAreaEdge2, receiver.normal);
  gl_FragData[0] = vec4(whole * vtkiAreaRadiance, 1.0f);
}
