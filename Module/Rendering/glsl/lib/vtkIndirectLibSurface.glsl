// One pixel of surface: linear depth; in the bits of one float the unit shading normal and the kind
// of shading; and in those of another the unit normal of its facet, the drawn plane. The two
// normals differ where normals are interpolated over few triangles: the shading normal gives
// cosines, and the facet decides what lies before, behind, beside or on the surface. Images without
// a third channel lack the facet.
#ifndef vtkIndirectLibSurface
#define vtkIndirectLibSurface
#include "vtkIndirectLibPortable.glsl"

// These are the kinds of surface. A cleared texel is VTKI_SURFACE_NONE.
const float VTKI_SURFACE_NONE = 0.0f;
const float VTKI_SURFACE_LINEAR = 1.0f;  // lit; the pixel holds linear colour
const float VTKI_SURFACE_ENCODED = 2.0f; // lit by VTK's PBR; the pixel is encoded with gamma 2.2
// drawn without lighting; has its prop's number in place of a normal
const float VTKI_SURFACE_UNLIT = 3.0f;

// The depth buffer holds floats just below one; interpolation loses about four of their steps.
const float VTKI_DEPTH_ROUNDING = 2.4e-7f;

float vtkiSignNotZero(float v)
{
  return v >= 0.0f ? 1.0f : -1.0f;
}

/* Maps a unit vector to the octahedral square [-1,1]^2. Meyer, Suessmuth, Sussner, Stamminger,
 * Greiner 2010, "On floating-point normal vectors". */
vec2 vtkiOctahedralEncode(vec3 n)
{
  float norm1 = abs(n.x) + abs(n.y) + abs(n.z);
  // A zero vector has no direction; it is encoded as +z.
  float scale = norm1 > 0.0f ? 1.0f / norm1 : 0.0f;
  vec2 p = vec2(n.x * scale, n.y * scale);
  if (n.z < 0.0f)
  {
    p = vec2((1.0f - abs(p.y)) * vtkiSignNotZero(p.x), (1.0f - abs(p.x)) * vtkiSignNotZero(p.y));
  }
  return p;
}

/* Returns the inverse of vtkiOctahedralEncode; the result is a unit vector for every input in
 * [-1,1]^2. */
vec3 vtkiOctahedralDecode(vec2 p)
{
  vec3 n = vec3(p.x, p.y, 1.0f - abs(p.x) - abs(p.y));
  float fold = max(-n.z, 0.0f);
  n.x -= vtkiSignNotZero(n.x) * fold;
  n.y -= vtkiSignNotZero(n.y) * fold;
  return normalize(n);
}

/* These are the steps from 0 to 1 of an octahedral coordinate. Zero and both ends are steps, so
 * that normals along the axes are exact. */
const float VTKI_CODE_STEPS_X = 16127.0f;
const float VTKI_CODE_STEPS_Y = 16383.0f;

/* Packs a unit normal and a kind into the bits of a float, from the highest: two of kind, 15 of x,
 * 15 of y. x begins at 256, which avoids the least exponent, whose floats may be flushed to zero,
 * and the largest, which makes no numbers. */
float vtkiPackNormal(vec3 normal, float kind)
{
  vec2 p = vtkiOctahedralEncode(normal);
  uint x = uint(VTKI_CODE_STEPS_X * p.x + (VTKI_CODE_STEPS_X + 256.5f));
  uint y = uint(VTKI_CODE_STEPS_Y * p.y + (VTKI_CODE_STEPS_Y + 0.5f));
  return uintBitsToFloat((uint(kind) << 30u) | (x << 15u) | y);
}

/* normal, facet: unit; depth along the view axis, scene units (diagonal = 1); kind: one above, not
 * VTKI_SURFACE_NONE. Alpha is 1 because VTK blends opaque geometry: any other value would mix
 * with the surface behind. */
vec4 vtkiPackSurface(vec3 normal, vec3 facet, float depth, float kind)
{
  return vec4(depth, vtkiPackNormal(normal, kind), vtkiPackNormal(facet, VTKI_SURFACE_LINEAR), 1.0f);
}

/* Marks a packed surface as one that catches light: it shows the background, as bright as the
 * surface is compared with one that is alone. The facet's bits of kind hold the mark. */
vec4 vtkiMarkCatcher(vec4 surface)
{
  uint facet = floatBitsToUint(surface.z) & 0x3fffffffu;
  return vec4(surface.x, surface.y, uintBitsToFloat((uint(VTKI_SURFACE_ENCODED) << 30u) | facet), surface.w);
}

/* Returns true for a lit surface with that mark. */
bool vtkiSurfaceCatches(vec4 surface)
{
  return (floatBitsToUint(surface.z) >> 30u) == uint(VTKI_SURFACE_ENCODED);
}

/* Packs an unlit surface. number: of its prop; stored in the bits of y in place of a normal,
 * beginning with that of one towards the eye. Numbers repeat after 32768 props. */
vec4 vtkiPackUnlit(float depth, int number)
{
  uint x = uint(VTKI_CODE_STEPS_X + 256.5f);
  uint y = (uint(VTKI_CODE_STEPS_Y + 0.5f) + uint(number)) & 32767u;
  return vec4(depth, uintBitsToFloat((uint(VTKI_SURFACE_UNLIT) << 30u) | (x << 15u) | y), 0.0f, 1.0f);
}

float vtkiSurfaceDepth(vec4 surface)
{
  return surface.x;
}

float vtkiSurfaceKind(vec4 surface)
{
  return float(floatBitsToUint(surface.y) >> 30u);
}

/* Returns the octahedral coordinates of a packed normal, each off by half a step at most. */
vec2 vtkiUnpackCode(float bits)
{
  uint code = floatBitsToUint(bits);
  return vec2((float((code >> 15u) & 32767u) - 256.0f) * (1.0f / VTKI_CODE_STEPS_X) - 1.0f,
    float(code & 32767u) * (1.0f / VTKI_CODE_STEPS_Y) - 1.0f);
}

vec2 vtkiSurfaceCode(vec4 surface)
{
  return vtkiUnpackCode(surface.y);
}

vec3 vtkiSurfaceNormal(vec4 surface)
{
  return vtkiOctahedralDecode(vtkiSurfaceCode(surface));
}

vec3 vtkiSurfaceFacet(vec4 surface)
{
  return vtkiOctahedralDecode(vtkiUnpackCode(surface.z));
}

/* Ranges of the float for each kind: 2 and above, -2 to 0, below -2. */
bool vtkiSurfaceIsLit(vec4 surface)
{
  return surface.y > -2.0f && surface.y != 0.0f;
}

/* Returns the position at linear depth on the ray through ndc in [-1,1]^2: origin and direction are
 * affine in ndc, for perspective (origin 0) and parallel (direction constant) projections alike. */
vec3 vtkiReconstruct(vec2 ndc, float depth, mat3 rayOrigin, mat3 rayDirection)
{
  vec3 h = vec3(ndc.x, ndc.y, 1.0f);
  return rayOrigin * h + depth * (rayDirection * h);
}
#endif
