//VTK::System::Dec
//VTK::Output::Dec
// Builds a level of nodes from the level below: each quadrant is the sum of a node's quadrants.
#include "vtkIndirectLibPortable.glsl"

uniform sampler2D vtkiLit;
#ifdef VTKI_FLUX
uniform sampler2D vtkiFlux;
#endif
uniform int vtkiBelow; // begin of the level below
uniform int vtkiBegin; // begin of this level

float vtkiNode(sampler2D nodes, ivec2 at)
{
  return dot(texelFetch(nodes, at, 0), vec4(1.0f));
}

vec4 vtkiSum(sampler2D nodes, ivec2 at)
{
  return vec4(vtkiNode(nodes, at), vtkiNode(nodes, at + ivec2(1, 0)), vtkiNode(nodes, at + ivec2(0, 1)),
    vtkiNode(nodes, at + ivec2(1, 1)));
}

void main()
{
  ivec2 at = 2 * (ivec2(gl_FragCoord.xy) - ivec2(vtkiBegin, 0)) + ivec2(vtkiBelow, 0);
  gl_FragData[0] = vtkiSum(vtkiLit, at);
#ifdef VTKI_FLUX
  gl_FragData[1] = vtkiSum(vtkiFlux, at);
#endif
}
