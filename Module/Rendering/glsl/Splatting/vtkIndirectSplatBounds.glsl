// The ellipsoids of vtkIndirectSplatTableFS.glsl.
#include "vtkIndirectLibSplat.glsl"
#include "vtkIndirectLibTable.glsl"

uniform sampler2D vtkiSplatCenter; // centre, half length
uniform sampler2D vtkiSplatAxis;   // axis, half width; below zero: no splat

vtkiSplat vtkiFetchSplat(int light)
{
  ivec2 at = vtkiTableTexel(light);
  vec4 center = texelFetch(vtkiSplatCenter, at, 0);
  vec4 axis = texelFetch(vtkiSplatAxis, at, 0);
  vtkiSplat splat;
  splat.center = center.xyz;
  splat.along = center.w;
  splat.axis = axis.xyz;
  splat.across = axis.w;
  return splat;
}
