// Sample patterns.
#ifndef vtkIndirectLibSampling
#define vtkIndirectLibSampling
#include "vtkIndirectLibPortable.glsl"

/* Sample i of n in the disk around a map coordinate: offset in units of the disk's radius, radius
 * xi uniform and therefore dense in the middle; weight = xi * 2 pi / n is the Jacobian of that
 * choice (unit disk area). Dachsbacher and Stamminger 2005, "Reflective shadow maps", section 4. */
vec3 vtkiDiskSample(int i, int n)
{
  float xi1 = (float(i) + 0.5f) / float(n);
  // Golden-ratio rotation: neighbours in radius are far apart in angle.
  float angle = 2.0f * VTKI_PI * fract(float(i) * 0.61803398875f);
  return vec3(xi1 * cos(angle), xi1 * sin(angle), xi1 * 2.0f * VTKI_PI / float(n));
}
#endif
