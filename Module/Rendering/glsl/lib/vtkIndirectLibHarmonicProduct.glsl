// The product of two functions in spherical harmonics of order 4, cut to that order. Written by
// Testing/Reference/fit_sphere_proxies.py; not to be edited.
#ifndef vtkIndirectLibHarmonicProduct
#define vtkIndirectLibHarmonicProduct
#include "vtkIndirectLibPortable.glsl"

/* Coefficients by l (l + 1) + m, four in each. */
struct vtkiHarmonics4
{
  vec4 A;
  vec4 B;
  vec4 C;
  vec4 D;
};

vtkiHarmonics4 vtkiHarmonicProduct(vtkiHarmonics4 f, vtkiHarmonics4 g)
{
  vtkiHarmonics4 h;
  h.A.x = 0.28209479f * (f.A.x * g.A.x) + 0.28209479f * (f.A.y * g.A.y)
    + 0.28209479f * (f.A.z * g.A.z) + 0.28209479f * (f.A.w * g.A.w) + 0.28209479f * (f.B.x * g.B.x)
    + 0.28209479f * (f.B.y * g.B.y) + 0.28209479f * (f.B.z * g.B.z) + 0.28209479f * (f.B.w * g.B.w)
    + 0.28209479f * (f.C.x * g.C.x) + 0.28209479f * (f.C.y * g.C.y) + 0.28209479f * (f.C.z * g.C.z)
    + 0.28209479f * (f.C.w * g.C.w) + 0.28209479f * (f.D.x * g.D.x) + 0.28209479f * (f.D.y * g.D.y)
    + 0.28209479f * (f.D.z * g.D.z) + 0.28209479f * (f.D.w * g.D.w);
  h.A.y = 0.28209479f * (f.A.x * g.A.y + f.A.y * g.A.x)
    - 0.12615663f * (f.A.y * g.B.z + f.B.z * g.A.y) - 0.21850969f * (f.A.y * g.C.x + f.C.x * g.A.y)
    + 0.21850969f * (f.A.z * g.B.y + f.B.y * g.A.z) + 0.21850969f * (f.A.w * g.B.x + f.B.x * g.A.w)
    - 0.05839917f * (f.B.x * g.D.y + f.D.y * g.B.x) - 0.22617901f * (f.B.x * g.D.w + f.D.w * g.B.x)
    - 0.14304817f * (f.B.y * g.D.x + f.D.x * g.B.y) - 0.18467439f * (f.B.y * g.D.z + f.D.z * g.B.y)
    + 0.20230066f * (f.B.z * g.C.w + f.C.w * g.B.z) + 0.18467439f * (f.B.w * g.C.z + f.C.z * g.B.w)
    + 0.22617901f * (f.C.x * g.C.y + f.C.y * g.C.x) + 0.05839917f * (f.C.x * g.C.w + f.C.w * g.C.x);
  h.A.z = 0.28209479f * (f.A.x * g.A.z + f.A.z * g.A.x)
    + 0.21850969f * (f.A.y * g.B.y + f.B.y * g.A.y) + 0.25231325f * (f.A.z * g.B.z + f.B.z * g.A.z)
    + 0.21850969f * (f.A.w * g.B.w + f.B.w * g.A.w) + 0.18467439f * (f.B.x * g.C.z + f.C.z * g.B.x)
    + 0.23359668f * (f.B.y * g.C.w + f.C.w * g.B.y) + 0.24776670f * (f.B.z * g.D.x + f.D.x * g.B.z)
    + 0.23359668f * (f.B.w * g.D.y + f.D.y * g.B.w) + 0.18467439f * (f.C.x * g.D.z + f.D.z * g.C.x);
  h.A.w = 0.28209479f * (f.A.x * g.A.w + f.A.w * g.A.x)
    + 0.21850969f * (f.A.y * g.B.x + f.B.x * g.A.y) + 0.21850969f * (f.A.z * g.B.w + f.B.w * g.A.z)
    - 0.12615663f * (f.A.w * g.B.z + f.B.z * g.A.w) + 0.21850969f * (f.A.w * g.C.x + f.C.x * g.A.w)
    + 0.22617901f * (f.B.x * g.C.y + f.C.y * g.B.x) - 0.05839917f * (f.B.x * g.C.w + f.C.w * g.B.x)
    + 0.18467439f * (f.B.y * g.C.z + f.C.z * g.B.y) + 0.20230066f * (f.B.z * g.D.y + f.D.y * g.B.z)
    - 0.14304817f * (f.B.w * g.D.x + f.D.x * g.B.w) + 0.18467439f * (f.B.w * g.D.z + f.D.z * g.B.w)
    - 0.05839917f * (f.C.x * g.D.y + f.D.y * g.C.x) + 0.22617901f * (f.C.x * g.D.w + f.D.w * g.C.x);
  h.B.x = 0.28209479f * (f.A.x * g.B.x + f.B.x * g.A.x)
    + 0.21850969f * (f.A.y * g.A.w + f.A.w * g.A.y) - 0.05839917f * (f.A.y * g.D.y + f.D.y * g.A.y)
    - 0.22617901f * (f.A.y * g.D.w + f.D.w * g.A.y) + 0.18467439f * (f.A.z * g.C.z + f.C.z * g.A.z)
    + 0.22617901f * (f.A.w * g.C.y + f.C.y * g.A.w) - 0.05839917f * (f.A.w * g.C.w + f.C.w * g.A.w)
    - 0.18022375f * (f.B.x * g.B.z + f.B.z * g.B.x) + 0.15607835f * (f.B.y * g.B.w + f.B.w * g.B.y)
    - 0.09403160f * (f.C.y * g.D.y + f.D.y * g.C.y) - 0.18806319f * (f.C.z * g.D.x + f.D.x * g.C.z)
    + 0.14567312f * (f.C.w * g.D.y + f.D.y * g.C.w) + 0.09403160f * (f.C.w * g.D.w + f.D.w * g.C.w);
  h.B.y = 0.28209479f * (f.A.x * g.B.y + f.B.y * g.A.x)
    + 0.21850969f * (f.A.y * g.A.z + f.A.z * g.A.y) - 0.14304817f * (f.A.y * g.D.x + f.D.x * g.A.y)
    - 0.18467439f * (f.A.y * g.D.z + f.D.z * g.A.y) + 0.23359668f * (f.A.z * g.C.w + f.C.w * g.A.z)
    + 0.18467439f * (f.A.w * g.C.z + f.C.z * g.A.w) + 0.15607835f * (f.B.x * g.B.w + f.B.w * g.B.x)
    + 0.09011188f * (f.B.y * g.B.z + f.B.z * g.B.y) - 0.15607835f * (f.B.y * g.C.x + f.C.x * g.B.y)
    + 0.14867701f * (f.C.y * g.D.z + f.D.z * g.C.y) + 0.11516472f * (f.C.z * g.D.y + f.D.y * g.C.z)
    - 0.14867701f * (f.C.z * g.D.w + f.D.w * g.C.z) + 0.05947080f * (f.C.w * g.D.x + f.D.x * g.C.w)
    - 0.11516472f * (f.C.w * g.D.z + f.D.z * g.C.w);
  h.B.z = 0.28209479f * (f.A.x * g.B.z + f.B.z * g.A.x) - 0.12615663f * (f.A.y * g.A.y)
    + 0.20230066f * (f.A.y * g.C.w + f.C.w * g.A.y) + 0.25231325f * (f.A.z * g.A.z)
    + 0.24776670f * (f.A.z * g.D.x + f.D.x * g.A.z) - 0.12615663f * (f.A.w * g.A.w)
    + 0.20230066f * (f.A.w * g.D.y + f.D.y * g.A.w) - 0.18022375f * (f.B.x * g.B.x)
    + 0.09011188f * (f.B.y * g.B.y) + 0.18022375f * (f.B.z * g.B.z) + 0.09011188f * (f.B.w * g.B.w)
    - 0.18022375f * (f.C.x * g.C.x) - 0.21026104f * (f.C.y * g.C.y) + 0.12615663f * (f.C.w * g.C.w)
    + 0.16820883f * (f.D.x * g.D.x) + 0.12615663f * (f.D.y * g.D.y) - 0.21026104f * (f.D.w * g.D.w);
  h.B.w = 0.28209479f * (f.A.x * g.B.w + f.B.w * g.A.x)
    + 0.18467439f * (f.A.y * g.C.z + f.C.z * g.A.y) + 0.21850969f * (f.A.z * g.A.w + f.A.w * g.A.z)
    + 0.23359668f * (f.A.z * g.D.y + f.D.y * g.A.z) - 0.14304817f * (f.A.w * g.D.x + f.D.x * g.A.w)
    + 0.18467439f * (f.A.w * g.D.z + f.D.z * g.A.w) + 0.15607835f * (f.B.x * g.B.y + f.B.y * g.B.x)
    + 0.09011188f * (f.B.z * g.B.w + f.B.w * g.B.z) + 0.15607835f * (f.B.w * g.C.x + f.C.x * g.B.w)
    + 0.14867701f * (f.C.y * g.C.z + f.C.z * g.C.y) + 0.11516472f * (f.C.z * g.C.w + f.C.w * g.C.z)
    + 0.05947080f * (f.D.x * g.D.y + f.D.y * g.D.x) + 0.11516472f * (f.D.y * g.D.z + f.D.z * g.D.y)
    + 0.14867701f * (f.D.z * g.D.w + f.D.w * g.D.z);
  h.C.x = 0.28209479f * (f.A.x * g.C.x + f.C.x * g.A.x) - 0.21850969f * (f.A.y * g.A.y)
    + 0.22617901f * (f.A.y * g.C.y + f.C.y * g.A.y) + 0.05839917f * (f.A.y * g.C.w + f.C.w * g.A.y)
    + 0.18467439f * (f.A.z * g.D.z + f.D.z * g.A.z) + 0.21850969f * (f.A.w * g.A.w)
    - 0.05839917f * (f.A.w * g.D.y + f.D.y * g.A.w) + 0.22617901f * (f.A.w * g.D.w + f.D.w * g.A.w)
    - 0.15607835f * (f.B.y * g.B.y) - 0.18022375f * (f.B.z * g.C.x + f.C.x * g.B.z)
    + 0.15607835f * (f.B.w * g.B.w) - 0.09403160f * (f.C.y * g.C.w + f.C.w * g.C.y)
    - 0.14567312f * (f.C.w * g.C.w) - 0.18806319f * (f.D.x * g.D.z + f.D.z * g.D.x)
    + 0.14567312f * (f.D.y * g.D.y) - 0.09403160f * (f.D.y * g.D.w + f.D.w * g.D.y);
  h.C.y = 0.28209479f * (f.A.x * g.C.y + f.C.y * g.A.x)
    + 0.22617901f * (f.A.y * g.C.x + f.C.x * g.A.y) + 0.22617901f * (f.A.w * g.B.x + f.B.x * g.A.w)
    - 0.09403160f * (f.B.x * g.D.y + f.D.y * g.B.x) + 0.14867701f * (f.B.y * g.D.z + f.D.z * g.B.y)
    - 0.21026104f * (f.B.z * g.C.y + f.C.y * g.B.z) + 0.14867701f * (f.B.w * g.C.z + f.C.z * g.B.w)
    - 0.09403160f * (f.C.x * g.C.w + f.C.w * g.C.x);
  h.C.z = 0.28209479f * (f.A.x * g.C.z + f.C.z * g.A.x)
    + 0.18467439f * (f.A.y * g.B.w + f.B.w * g.A.y) + 0.18467439f * (f.A.z * g.B.x + f.B.x * g.A.z)
    + 0.18467439f * (f.A.w * g.B.y + f.B.y * g.A.w) - 0.18806319f * (f.B.x * g.D.x + f.D.x * g.B.x)
    + 0.11516472f * (f.B.y * g.D.y + f.D.y * g.B.y) - 0.14867701f * (f.B.y * g.D.w + f.D.w * g.B.y)
    + 0.14867701f * (f.B.w * g.C.y + f.C.y * g.B.w) + 0.11516472f * (f.B.w * g.C.w + f.C.w * g.B.w);
  h.C.w = 0.28209479f * (f.A.x * g.C.w + f.C.w * g.A.x)
    + 0.20230066f * (f.A.y * g.B.z + f.B.z * g.A.y) + 0.05839917f * (f.A.y * g.C.x + f.C.x * g.A.y)
    + 0.23359668f * (f.A.z * g.B.y + f.B.y * g.A.z) - 0.05839917f * (f.A.w * g.B.x + f.B.x * g.A.w)
    + 0.14567312f * (f.B.x * g.D.y + f.D.y * g.B.x) + 0.09403160f * (f.B.x * g.D.w + f.D.w * g.B.x)
    + 0.05947080f * (f.B.y * g.D.x + f.D.x * g.B.y) - 0.11516472f * (f.B.y * g.D.z + f.D.z * g.B.y)
    + 0.12615663f * (f.B.z * g.C.w + f.C.w * g.B.z) + 0.11516472f * (f.B.w * g.C.z + f.C.z * g.B.w)
    - 0.09403160f * (f.C.x * g.C.y + f.C.y * g.C.x) - 0.14567312f * (f.C.x * g.C.w + f.C.w * g.C.x);
  h.D.x = 0.28209479f * (f.A.x * g.D.x + f.D.x * g.A.x)
    - 0.14304817f * (f.A.y * g.B.y + f.B.y * g.A.y) + 0.24776670f * (f.A.z * g.B.z + f.B.z * g.A.z)
    - 0.14304817f * (f.A.w * g.B.w + f.B.w * g.A.w) - 0.18806319f * (f.B.x * g.C.z + f.C.z * g.B.x)
    + 0.05947080f * (f.B.y * g.C.w + f.C.w * g.B.y) + 0.16820883f * (f.B.z * g.D.x + f.D.x * g.B.z)
    + 0.05947080f * (f.B.w * g.D.y + f.D.y * g.B.w) - 0.18806319f * (f.C.x * g.D.z + f.D.z * g.C.x);
  h.D.y = 0.28209479f * (f.A.x * g.D.y + f.D.y * g.A.x)
    - 0.05839917f * (f.A.y * g.B.x + f.B.x * g.A.y) + 0.23359668f * (f.A.z * g.B.w + f.B.w * g.A.z)
    + 0.20230066f * (f.A.w * g.B.z + f.B.z * g.A.w) - 0.05839917f * (f.A.w * g.C.x + f.C.x * g.A.w)
    - 0.09403160f * (f.B.x * g.C.y + f.C.y * g.B.x) + 0.14567312f * (f.B.x * g.C.w + f.C.w * g.B.x)
    + 0.11516472f * (f.B.y * g.C.z + f.C.z * g.B.y) + 0.12615663f * (f.B.z * g.D.y + f.D.y * g.B.z)
    + 0.05947080f * (f.B.w * g.D.x + f.D.x * g.B.w) + 0.11516472f * (f.B.w * g.D.z + f.D.z * g.B.w)
    + 0.14567312f * (f.C.x * g.D.y + f.D.y * g.C.x) - 0.09403160f * (f.C.x * g.D.w + f.D.w * g.C.x);
  h.D.z = 0.28209479f * (f.A.x * g.D.z + f.D.z * g.A.x)
    - 0.18467439f * (f.A.y * g.B.y + f.B.y * g.A.y) + 0.18467439f * (f.A.z * g.C.x + f.C.x * g.A.z)
    + 0.18467439f * (f.A.w * g.B.w + f.B.w * g.A.w) + 0.14867701f * (f.B.y * g.C.y + f.C.y * g.B.y)
    - 0.11516472f * (f.B.y * g.C.w + f.C.w * g.B.y) + 0.11516472f * (f.B.w * g.D.y + f.D.y * g.B.w)
    + 0.14867701f * (f.B.w * g.D.w + f.D.w * g.B.w) - 0.18806319f * (f.C.x * g.D.x + f.D.x * g.C.x);
  h.D.w = 0.28209479f * (f.A.x * g.D.w + f.D.w * g.A.x)
    - 0.22617901f * (f.A.y * g.B.x + f.B.x * g.A.y) + 0.22617901f * (f.A.w * g.C.x + f.C.x * g.A.w)
    + 0.09403160f * (f.B.x * g.C.w + f.C.w * g.B.x) - 0.14867701f * (f.B.y * g.C.z + f.C.z * g.B.y)
    - 0.21026104f * (f.B.z * g.D.w + f.D.w * g.B.z) + 0.14867701f * (f.B.w * g.D.z + f.D.z * g.B.w)
    - 0.09403160f * (f.C.x * g.D.y + f.D.y * g.C.x);
  return h;
}
#endif
