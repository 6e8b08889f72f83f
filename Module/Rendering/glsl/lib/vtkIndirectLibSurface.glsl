// One pixel of surface in one RGBA texel: unit normal, linear depth and how the pixel was shaded.
#ifndef vtkIndirectLibSurface
#define vtkIndirectLibSurface
#include "vtkIndirectLibPortable.glsl"

// Kinds of surface. A cleared texel is VTKI_SURFACE_NONE.
const float VTKI_SURFACE_NONE = 0.0f;
const float VTKI_SURFACE_LINEAR = 1.0f;  // lit; the pixel holds linear colour
const float VTKI_SURFACE_ENCODED = 2.0f; // lit by VTK's PBR; the pixel is encoded with gamma 2.2
const float VTKI_SURFACE_UNLIT = 3.0f;   // drawn without lighting; has no normal

float vtkiSignNotZero(float v)
{
  return v >= 0.0f ? 1.0f : -1.0f;
}

/* Unit vector to the octahedral square [-1,1]^2.
 * Meyer, Suessmuth, Sussner, Stamminger, Greiner 2010, "On floating-point normal vectors". */
vec2 vtkiOctahedralEncode(vec3 n)
{
  float norm1 = abs(n.x) + abs(n.y) + abs(n.z);
  // A zero vector has no direction; it encodes as +z.
  float scale = norm1 > 0.0f ? 1.0f / norm1 : 0.0f;
  vec2 p = vec2(n.x * scale, n.y * scale);
  if (n.z < 0.0f)
  {
    p = vec2((1.0f - abs(p.y)) * vtkiSignNotZero(p.x), (1.0f - abs(p.x)) * vtkiSignNotZero(p.y));
  }
  return p;
}

/* Inverse of vtkiOctahedralEncode; the result is a unit vector for every input in [-1,1]^2. */
vec3 vtkiOctahedralDecode(vec2 p)
{
  vec3 n = vec3(p.x, p.y, 1.0f - abs(p.x) - abs(p.y));
  float fold = max(-n.z, 0.0f);
  n.x -= vtkiSignNotZero(n.x) * fold;
  n.y -= vtkiSignNotZero(n.y) * fold;
  return normalize(n);
}

/* normal unit; depth along the view axis, scene units (diagonal = 1); kind one of the above.
 * Alpha is 1 because VTK blends opaque geometry: any other value would mix with what lies behind. What
 * the eye sees is not blended and has the albedo there, see vtkIndirectLibAlbedo.glsl.
 * The kind rides on the first coordinate in steps of four, clear of its range [-1,1]. */
vec4 vtkiPackSurface(vec3 normal, float depth, float kind)
{
  vec2 p = vtkiOctahedralEncode(normal);
  return vec4(p.x + 4.0f * kind, p.y, depth, 1.0f);
}

float vtkiSurfaceKind(vec4 surface)
{
  return floor((surface.x + 2.0f) * 0.25f);
}

/* Octahedral coordinates of the normal. */
vec2 vtkiSurfaceCode(vec4 surface)
{
  return vec2(surface.x - 4.0f * vtkiSurfaceKind(surface), surface.y);
}

vec3 vtkiSurfaceNormal(vec4 surface)
{
  return vtkiOctahedralDecode(vtkiSurfaceCode(surface));
}

bool vtkiSurfaceIsLit(vec4 surface)
{
  float kind = vtkiSurfaceKind(surface);
  return kind > 0.5f && kind < 2.5f;
}

/* Position at linear depth on the ray through ndc in [-1,1]^2: origin and direction are affine in
 * ndc, for perspective (origin 0) and parallel (direction constant) projections alike. */
vec3 vtkiReconstruct(vec2 ndc, float depth, mat3 rayOrigin, mat3 rayDirection)
{
  vec3 h = vec3(ndc.x, ndc.y, 1.0f);
  return rayOrigin * h + depth * (rayDirection * h);
}
#endif
