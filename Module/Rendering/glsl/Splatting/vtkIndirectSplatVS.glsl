//VTK::System::Dec
// A splat for each virtual light, an instance, or with VTKI_SPLAT_LOBES for its lobe: the far side
// of its ellipsoid, or a rectangle around it at the ellipsoid's greatest depth. Only surfaces in
// front of that depth pass the depth test.
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
// corner of the polyhedron about the unit ball, or of the rectangle from -1 to 1
in vec3 vtkiCorner;
uniform int vtkiFirstLight;
uniform mat4 vtkiSceneToClip;
uniform float vtkiDepthMargin; // rounding of depths in normalized device coordinates
flat out int vtkiSplatNumber;
flat out vec4 vtkiSplatPosition;
flat out vec4 vtkiSplatNormal;
// density, and the lowest intensity over a squared distance that counts
flat out vec4 vtkiSplatDensity;

vec4 vtkiClipRow(int i)
{
  return vec4(vtkiSceneToClip[0][i], vtkiSceneToClip[1][i], vtkiSceneToClip[2][i], vtkiSceneToClip[3][i]);
}

// Corner of the rectangle around the ellipsoid; of the whole view if the ellipsoid extends to the
// eye's plane.
vec4 vtkiRectangleCorner(vtkiSplat splat)
{
  vec4 rowW = vtkiClipRow(3);
  vec2 x;
  vec2 y;
  vec2 z;
  int where = vtkiSplatRange(splat, vtkiClipRow(0), rowW, x);
  vtkiSplatRange(splat, vtkiClipRow(1), rowW, y);
  vtkiSplatRange(splat, vtkiClipRow(2), rowW, z);
  const float margin = 1.0e-4f;
  vec4 corner = vec4(vtkiCorner.x < 0.0f ? x.x - margin : x.y + margin,
    vtkiCorner.y < 0.0f ? y.x - margin : y.y + margin, z.y, 1.0f);
  // The background has depth one.
  corner = where == 0 ? vec4(vtkiCorner.xy, 1.0f, 1.0f) : corner;
  corner.z = min(corner.z, 1.0f);
  return where < 0 ? vec4(2.0f, 2.0f, 2.0f, 1.0f) : corner;
}

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
#ifdef VTKI_SPLAT_RECTANGLES
  vec4 corner = vtkiRectangleCorner(splat);
#else
  vec4 corner = vtkiSceneToClip * vec4(vtkiSplatPoint(splat, vtkiCorner), 1.0f);
#endif
  corner.z += vtkiDepthMargin * corner.w;
  gl_Position = splat.across > 0.0f ? corner : vec4(2.0f, 2.0f, 2.0f, 1.0f);
}
