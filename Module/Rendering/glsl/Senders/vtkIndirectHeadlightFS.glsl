//VTK::System::Dec
//VTK::Output::Dec
// Virtual lights of a headlight, read from the geometry buffer, which serves as its map.
#include "vtkIndirectLibSurface.glsl"
#include "vtkIndirectAlbedo.glsl"
#include "vtkIndirectLibLightMap.glsl"

uniform sampler2D vtkiPattern;
uniform sampler2D vtkiSurface;
uniform ivec2 vtkiSize;
uniform mat3 vtkiRayOrigin;
uniform mat3 vtkiRayDirection;
uniform mat4 vtkiViewToScene;
uniform vec3 vtkiLightColor;  // colour times intensity
uniform vec3 vtkiToLight;     // view coordinates, unit
uniform int vtkiParallel;

void main()
{
  vec4 sampled = texelFetch(vtkiPattern, ivec2(gl_FragCoord.xy), 0);
  vec2 size = vec2(vtkiSize);
  ivec2 texel = ivec2(min(sampled.xy * size, size - 1.0f));
  vec4 surface = texelFetch(vtkiSurface, texel, 0);
  vec3 position = vec3(0.0f);
  vec3 normal = vec3(0.0f, 0.0f, 1.0f);
  vec3 densityArea = vec3(0.0f);
  float area = 1.0f;
  if (sampled.w > 0.0f && vtkiSurfaceIsLit(surface))
  {
    vec2 ndc = 2.0f * (vec2(texel) + 0.5f) / size - 1.0f;
    vec3 p = vtkiReconstruct(ndc, vtkiSurfaceDepth(surface), vtkiRayOrigin, vtkiRayDirection);
    // The facet sends, and the shading normal lights it.
    normal = vtkiSurfaceFacet(surface);
    // Edge vectors of the pixel on the plane at this depth: its area there, whatever the projection.
    vec3 dx = (vtkiRayOrigin[0] + vtkiSurfaceDepth(surface) * vtkiRayDirection[0]) * (2.0f / size.x);
    vec3 dy = (vtkiRayOrigin[1] + vtkiSurfaceDepth(surface) * vtkiRayDirection[1]) * (2.0f / size.y);
    float pixelArea = length(cross(dx, dy));
    // In stereo the eye is beside the origin.
    vec3 toEye = vtkiParallel != 0 ? vec3(0.0f, 0.0f, 1.0f) : normalize(vtkiRayOrigin[2] - p);
    // pixelArea is perpendicular to the axis: seen from the eye it covers area * toEye.z / (n.v).
    float cosEye = max(dot(normal, toEye), sqrt(pixelArea));
    float covered = pixelArea * toEye.z / cosEye * sampled.w;
    float encoded = vtkiSurfaceKind(surface) == VTKI_SURFACE_ENCODED ? 1.0f / VTKI_PI : 1.0f;
    position = (vtkiViewToScene * vec4(p, 1.0f)).xyz;
    densityArea = vtkiFetchAlbedo(texel) * vtkiLightColor *
      (max(dot(vtkiSurfaceNormal(surface), vtkiToLight), 0.0f) * covered * encoded);
    area = covered;
    normal = mat3(vtkiViewToScene) * normal;
  }
  gl_FragData[0] = vec4(position, area);
  gl_FragData[1] = vec4(normal, 0.0f);
  gl_FragData[2] = vec4(densityArea, 0.0f);
}
