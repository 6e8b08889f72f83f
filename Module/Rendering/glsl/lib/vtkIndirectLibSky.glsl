// Unoccluded light of the sky by the direction of the normal. A sum of clamped cosines max(n . f,
// 0) has two halves: n . F / 2, F the sum of all f, and that of |n . f| / 2, which is the same for
// n and -n and smooth. The second half is a texture over the square of the octahedron, whose
// outermost texels lie on its border.
#ifndef vtkIndirectLibSky
#define vtkIndirectLibSky
#include "vtkIndirectLibSurface.glsl"

// These are the texels along an edge; an odd number, so that the folds of the octahedron lie on
// texels.
const int VTKI_OPEN_SKY_TEXELS = 49;

/* Returns the normal whose irradiance a texel holds. */
vec3 vtkiOpenSkyNormal(vec2 texel)
{
  float scale = 2.0f / float(VTKI_OPEN_SKY_TEXELS - 1);
  return vtkiOctahedralDecode(vec2(scale * texel.x - 1.0f, scale * texel.y - 1.0f));
}

/* Returns the texture coordinates of a unit normal's irradiance, in [0,1]^2. */
vec2 vtkiOpenSkyPlace(vec3 normal)
{
  vec2 p = vtkiOctahedralEncode(normal);
  float n = float(VTKI_OPEN_SKY_TEXELS);
  float scale = 0.5f * (n - 1.0f) / n;
  return vec2(scale * p.x + 0.5f, scale * p.y + 0.5f);
}

/* Irradiance estimated from a sum over some of the sky's directions. seen: the sum of the visible
 * ones; summed: of all that were tested; open: irradiance of the whole sky without occlusion; the
 * latter two as sums over the colours. An unoccluded sky is complete, whichever directions were
 * tested; a receiver that sees none of them is dark. */
vec3 vtkiSkyIrradiance(vec3 seen, float summed, float open)
{
  return summed > 0.0f ? open * (seen / summed) : vec3(0.0f);
}
#endif
