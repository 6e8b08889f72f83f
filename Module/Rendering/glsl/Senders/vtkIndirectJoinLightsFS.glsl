//VTK::System::Dec
//VTK::Output::Dec
// Appends a sampler's lights, or with VTKI_LOBES their lobes, to those of the samplers before it.
#include "vtkIndirectLibTable.glsl"

#ifdef VTKI_LOBES
uniform sampler2D vtkiLobeDirection;
uniform sampler2D vtkiLobeDensity;
#else
uniform sampler2D vtkiLightPosition;
uniform sampler2D vtkiLightNormal;
uniform sampler2D vtkiLightDensity;
#endif
uniform int vtkiFirst; // place of the sampler's first light
uniform int vtkiCount;

void main()
{
  int light = vtkiTableEntry(ivec2(gl_FragCoord.xy)) - vtkiFirst;
  if (light < 0 || light >= vtkiCount)
  {
    discard;
  }
  ivec2 at = vtkiTableTexel(light);
#ifdef VTKI_LOBES
  gl_FragData[0] = texelFetch(vtkiLobeDirection, at, 0);
  gl_FragData[1] = texelFetch(vtkiLobeDensity, at, 0);
#else
  gl_FragData[0] = texelFetch(vtkiLightPosition, at, 0);
  gl_FragData[1] = texelFetch(vtkiLightNormal, at, 0);
  gl_FragData[2] = texelFetch(vtkiLightDensity, at, 0);
#endif
}
