//VTK::System::Dec
// A splat, an instance a virtual light, or with VTKI_SPLAT_LOBES its lobe: the far side of a polyhedron about its
// ellipsoid. Pixels pass the depth test where a surface lies in front of that.
#include "vtkIndirectSplatLow.glsl"
#include "vtkIndirectSplatBounds.glsl"

uniform sampler2D vtkiLightPosition; // see vtkIndirectGatherVirtualLights.glsl
uniform sampler2D vtkiLightNormal;
#ifdef VTKI_SPLAT_LOBES
uniform sampler2D vtkiLobeDirection;
uniform sampler2D vtkiLobeDensity;
flat out vec4 vtkiSplatDirection; // direction and exponent
#else
uniform sampler2D vtkiLightDensity;
#endif
// corner of the polyhedron about the unit ball
in vec3 vtkiCorner;
uniform int vtkiFirstLight;
uniform mat4 vtkiSceneToClip;
uniform float vtkiDepthMargin; // rounding of depths in normalized device coordinates
flat out int vtkiSplatNumber;
flat out vec4 vtkiSplatPosition;
flat out vec4 vtkiSplatNormal;
// density, and the lowest intensity over a squared distance that counts
flat out vec4 vtkiSplatDensity;

void main()
{
  int light = vtkiFirstLight + gl_InstanceID;
  ivec2 at = vtkiTableTexel(light);
  vtkiSplatNumber = light;
  vtkiSplatPosition = texelFetch(vtkiLightPosition, at, 0);
  vtkiSplatNormal = texelFetch(vtkiLightNormal, at, 0);
#ifdef VTKI_SPLAT_LOBES
  vtkiSplatDirection = texelFetch(vtkiLobeDirection, at, 0);
  vtkiSplatDensity = vec4(texelFetch(vtkiLobeDensity, at, 0).rgb, vtkiSplatLow());
  vtkiSplat splat = vtkiFetchLobeSplat(light);
#else
  vtkiSplatDensity = vec4(texelFetch(vtkiLightDensity, at, 0).rgb, vtkiSplatLow());
  vtkiSplat splat = vtkiFetchSplat(light);
#endif
  vec4 corner = vtkiSceneToClip * vec4(vtkiSplatPoint(splat, vtkiCorner), 1.0f);
  corner.z += vtkiDepthMargin * corner.w;
  gl_Position = splat.across > 0.0f ? corner : vec4(2.0f, 2.0f, 2.0f, 1.0f);
}
