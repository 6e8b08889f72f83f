//VTK::System::Dec
// A rectangle about the region in which an entry of the tree of spheres counts; each entry is an
// instance.
#include "vtkIndirectLibSplat.glsl"
#include "vtkIndirectLibProxyRegion.glsl"
#include "vtkIndirectLibTable.glsl"

in vec3 vtkiCorner; // corner of the square from -1 to 1
uniform sampler2D vtkiProxyCenter; // see vtkIndirectProxySum.glsl
uniform sampler2D vtkiProxyRegion;
uniform int vtkiFirstProxy;
uniform mat4 vtkiSceneToClip;
uniform vec2 vtkiProxyMargin; // two coarse pixels
flat out int vtkiProxyNumber;

vec4 vtkiClipRow(int i)
{
  return vec4(vtkiSceneToClip[0][i], vtkiSceneToClip[1][i], vtkiSceneToClip[2][i], vtkiSceneToClip[3][i]);
}

void main()
{
  vtkiProxyNumber = vtkiFirstProxy + gl_InstanceID;
  ivec2 at = vtkiTableTexel(vtkiProxyNumber);
  vtkiRegion whole = vtkiUnpackRegion(texelFetch(vtkiProxyRegion, at, 0));
  vec2 corner = vtkiCorner.xy;
  // An entry that counts in the whole scene covers the view.
  if (whole.Outer < 1.0e3f)
  {
    vtkiSplat region;
    region.center = texelFetch(vtkiProxyCenter, at, 0).xyz + whole.ToOuter;
    region.along = whole.Outer;
    region.axis = vec3(0.0f, 0.0f, 1.0f);
    region.across = whole.Outer;
    vec2 x;
    vec2 y;
    int where = vtkiSplatRange(region, vtkiClipRow(0), vtkiClipRow(3), x);
    vtkiSplatRange(region, vtkiClipRow(1), vtkiClipRow(3), y);
    // The margin covers receivers anywhere in the pixels that they represent.
    vec2 low = where == 0 ? vec2(-1.0f) : vec2(x.x, y.x) - vtkiProxyMargin;
    vec2 high = where == 0 ? vec2(1.0f) : vec2(x.y, y.y) + vtkiProxyMargin;
    corner = where < 0 ? vec2(2.0f) : mix(low, high, 0.5f * vtkiCorner.xy + 0.5f);
  }
  gl_Position = vec4(corner, 0.0f, 1.0f);
}
