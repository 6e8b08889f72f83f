// Bounds of a specular sender's lobe: an ellipsoid around the iso-surface of its kernel.
#ifndef vtkIndirectLibLobeSplat
#define vtkIndirectLibLobeSplat
#include "vtkIndirectLibPortable.glsl"
#include "vtkIndirectLibSenderLobe.glsl"
#include "vtkIndirectLibSplat.glsl"

/* Largest distance of a receiver from a light, in scene units: the scene is one across. */
const float VTKI_LOBE_SPLAT_FARTHEST = 1.01f;

/* Light cut off from lobes in receivers' own lobes has no far field: there the threshold is at most
 * this one, which cuts off next to nothing. */
const float VTKI_LOBE_SPLAT_GLOSSY = 3.0e-4f;

/* Greatest ratio of a widened lobe's axial brightness to 2 F / (pi A), over twice the share of the
 * lobe above the surface: the maximum of (u + 1) / (u + 4 / (pi u)) for exponents u >= 1, near
 * three. */
const float VTKI_LOBE_SPLAT_PEAK = 1.17f;

/* exp(x) - 1, x >= 0, precise for small x. */
float vtkiExponentialRest(float x)
{
  return x < 0.02f ? x * (1.0f + 0.5f * x * (1.0f + x * (1.0f / 3.0f + x / 12.0f))) : exp(x) - 1.0f;
}

/* Returns the centre along the axis, half length and half width of an ellipsoid around the part of
 * the iso-surface r(a) = size cos(a)^(n/2) within VTKI_LOBE_SPLAT_FARTHEST = D. If the surface
 * still widens at that distance, the ellipsoid's middle is put there; if it is wider than long, the
 * ellipsoid is a ball about the light. Equation (7) of the paper, with z = x size, is h(z)^2 = z^2
 * ((size / z)^(4 / (n + 2)) - 1), for n >= 2 at most the ellipsoid's h(D)^2 (2 - z / D) z / D. */
vec3 vtkiLobeEllipsoid(float exponent, float size)
{
  vec2 widest = size * vtkiSplatWidest(exponent);
  float farthest = VTKI_LOBE_SPLAT_FARTHEST;
  float grows = 4.0f / (exponent + 2.0f) * log(max(size / farthest, 1.0f));
  float width2 = vtkiExponentialRest(min(grows, 2.0f));
  bool ball = width2 >= 1.0f;
  vec3 cut = vec3(ball ? 0.0f : farthest, farthest, ball ? farthest : farthest * sqrt(width2));
  vec3 whole = vec3(widest.x, max(widest.x, size - widest.x), widest.y);
  return exponent >= 2.0f && widest.x > farthest ? cut : whole;
}

/* Returns the ellipsoid outside of which the lobe's intensity over the squared distance is below the
 * lowest that counts; across is negative if that holds everywhere. cosine is that of the lobe's
 * direction on the surface; flux is the lobe's, over the lowest intensity over a squared distance
 * that counts. The ellipsoid has two parts. Beyond the distance a within which the lobe is widened
 * (vtkiLobeReach) the iso-surface is that of Dachsbacher and Stamminger 2006 (appendix) for I0 =
 * flux / N. Within a the exponent is 4 d^2 / A, and cos(a)^P' <= exp(-P' sin(a)^2 / 2) = exp(-2 h^2
 * / A) at a distance h from the axis, for any d: a beam of radius sqrt(A / 2 log(peak)), where peak
 * is the level along the axis. For a mirror, a ball of radius a would cover the whole scene. */
vtkiSplat vtkiMakeLobeSplat(
  vec3 position, vec3 direction, float cosine, float exponent, float area, float flux)
{
  float size = sqrt(flux / vtkiLobeIntegral(exponent, cosine));
  vec3 ellipsoid = vtkiLobeEllipsoid(exponent, size);
  // The widest lobe has the least share above the surface.
  float peak =
    VTKI_LOBE_SPLAT_PEAK * 2.0f * flux / (VTKI_PI * area * vtkiShareAbove(0.0f, max(cosine, 0.0f)));
  float reach = min(vtkiLobeReach(exponent, area), VTKI_LOBE_SPLAT_FARTHEST);
  float beam = min(sqrt(0.5f * area * log(max(peak, 1.0f))), reach);
  // Covers both ends of the beam: with its radius a share t of the half width, sqrt(1 - t^2) of the
  // half length extends to them.
  float across = max(ellipsoid.z, 1.41421357f * beam);
  float t = across > 0.0f ? beam / across : 0.0f;
  float ends = max(ellipsoid.x, reach - ellipsoid.x) / sqrt(1.0f - t * t);
  vtkiSplat splat;
  splat.center = position + ellipsoid.x * direction;
  splat.along = VTKI_SPLAT_MARGIN * (beam > 0.0f ? max(ellipsoid.y, ends) : ellipsoid.y);
  splat.axis = direction;
  splat.across = peak > 1.0f && area > 0.0f ? VTKI_SPLAT_MARGIN * across : -1.0f;
  return splat;
}
#endif
