// The ellipsoids of vtkIndirectSplatTableFS.glsl.
#include "vtkIndirectLibSplat.glsl"
#include "vtkIndirectLibTable.glsl"

uniform sampler2D vtkiSplatCenter; // centre, half length
uniform sampler2D vtkiSplatAxis;   // axis, half width; negative: no splat
#ifdef VTKI_SPLAT_LOBES
uniform sampler2D vtkiLobeSplatCenter; // the same for lobes
uniform sampler2D vtkiLobeSplatAxis;
#endif

vtkiSplat vtkiSplatOf(vec4 center, vec4 axis)
{
  vtkiSplat splat;
  splat.center = center.xyz;
  splat.along = center.w;
  splat.axis = axis.xyz;
  splat.across = axis.w;
  return splat;
}

vtkiSplat vtkiFetchSplat(int light)
{
  ivec2 at = vtkiTableTexel(light);
  return vtkiSplatOf(texelFetch(vtkiSplatCenter, at, 0), texelFetch(vtkiSplatAxis, at, 0));
}

#ifdef VTKI_SPLAT_LOBES
vtkiSplat vtkiFetchLobeSplat(int light)
{
  ivec2 at = vtkiTableTexel(light);
  return vtkiSplatOf(texelFetch(vtkiLobeSplatCenter, at, 0), texelFetch(vtkiLobeSplatAxis, at, 0));
}
#endif
