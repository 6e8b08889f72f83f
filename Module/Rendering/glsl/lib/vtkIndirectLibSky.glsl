// Light of the sky where nothing hides it, by the direction of the normal. Of a sum of clamped cosines
// max(n . f, 0) one half is n . F / 2, of the sum of all f, and the other one of |n . f| / 2, the same for n and -n
// and smooth: that half is a texture over the square of the octahedron, whose outermost texels lie on its border.
#ifndef vtkIndirectLibSky
#define vtkIndirectLibSky
#include "vtkIndirectLibSurface.glsl"

// Along an edge; an odd number, so that the folds of the octahedron lie on texels.
const int VTKI_OPEN_SKY_TEXELS = 49;

/* The normal that a texel holds the irradiance of. */
vec3 vtkiOpenSkyNormal(vec2 texel)
{
  float scale = 2.0f / float(VTKI_OPEN_SKY_TEXELS - 1);
  return vtkiOctahedralDecode(vec2(scale * texel.x - 1.0f, scale * texel.y - 1.0f));
}

/* Where a filtered look-up finds the irradiance of a unit normal, in [0,1]^2. */
vec2 vtkiOpenSkyPlace(vec3 normal)
{
  vec2 p = vtkiOctahedralEncode(normal);
  float n = float(VTKI_OPEN_SKY_TEXELS);
  float scale = 0.5f * (n - 1.0f) / n;
  return vec2(scale * p.x + 0.5f, scale * p.y + 0.5f);
}

/* A sum over some of the sky's directions, as what it stands for: seen: those that nothing hides, summed:
 * all of them that were asked, open: irradiance if nothing hid any of the sky; the latter two as sums over the
 * colours. What is seen of an open sky is all of it, whichever directions were asked; what is hidden
 * behind all of them is dark. */
vec3 vtkiSkyIrradiance(vec3 seen, float summed, float open)
{
  return summed > 0.0f ? open * (seen / summed) : vec3(0.0f);
}
#endif
