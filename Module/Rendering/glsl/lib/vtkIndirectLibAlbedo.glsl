// Diffuse reflectance packed into the bits of one float.
#ifndef vtkIndirectLibAlbedo
#define vtkIndirectLibAlbedo
#include "vtkIndirectLibPortable.glsl"

/* albedo: clamped to 0 to 1, the physical range. Ten bits a channel store its square root, whose
 * steps are about even to the eye: the error is at most 1 / (1023 sqrt(albedo)) of the albedo, 0.14
 * % of 0.5. The thirty bits avoid exponents that make no number, or one so small that it may be
 * flushed to zero. */
float vtkiPackAlbedo(vec3 albedo)
{
  uint r = uint(1023.0f * sqrt(min(max(albedo.x, 0.0f), 1.0f)) + 0.5f);
  uint g = uint(1023.0f * sqrt(min(max(albedo.y, 0.0f), 1.0f)) + 0.5f);
  uint b = uint(1023.0f * sqrt(min(max(albedo.z, 0.0f), 1.0f)) + 0.5f);
  // The last bit goes to the sign, above the two bits of the exponent that are fixed at 01.
  return uintBitsToFloat(r | (g << 10u) | ((b & 511u) << 20u) | (1u << 29u) | ((b & 512u) << 22u));
}

/* Returns the inverse of vtkiPackAlbedo; 0 for a cleared texel. */
vec3 vtkiUnpackAlbedo(float code)
{
  uint bits = floatBitsToUint(code);
  vec3 root = vec3(float(bits & 1023u), float((bits >> 10u) & 1023u),
                float(((bits >> 20u) & 511u) | ((bits >> 22u) & 512u))) *
    (1.0f / 1023.0f);
  return root * root;
}
#endif
