// Where the lobe of a specular sender counts: an ellipsoid about the iso-surface of its kernel.
#ifndef vtkIndirectLibLobeSplat
#define vtkIndirectLibLobeSplat
#include "vtkIndirectLibPortable.glsl"
#include "vtkIndirectLibSenderLobe.glsl"
#include "vtkIndirectLibSplat.glsl"

/* No receiver is farther from a light than this, in scene units: the scene is one across. */
const float VTKI_LOBE_SPLAT_FARTHEST = 1.01f;

/* What is cut off of lobes in receivers' own lobes is not given back: there they count from a threshold on that cuts
 * off next to nothing, this one at most. */
const float VTKI_LOBE_SPLAT_GLOSSY = 3.0e-4f;

/* How much brighter than 2 F / (pi A), over twice the share of the lobe above the surface, a
 * widened lobe is along its axis at most: of (u + 1) / (u + 4 / (pi u)) for exponents u >= 1, which
 * is largest near three. */
const float VTKI_LOBE_SPLAT_PEAK = 1.17f;

/* The lobe's intensity over the squared distance, as vtkiSenderLobeStrength has both, times its
 * flux over the lowest that counts: what vtkiSplatShare takes. */
float vtkiLobeLevel(
  vec3 toSender, vec3 normalS, vec3 direction, float exponent, float area, float flux)
{
  return flux * length(toSender) *
    vtkiSenderLobeStrength(toSender, normalS, direction, exponent, area);
}

/* exp(x) - 1, x >= 0, without loss of digits for small x. */
float vtkiExponentialRest(float x)
{
  return x < 0.02f ? x * (1.0f + 0.5f * x * (1.0f + x * (1.0f / 3.0f + x / 12.0f))) : exp(x) - 1.0f;
}

/* Centre along the axis, half length and half width of an ellipsoid about what of the iso-surface
 * r(a) = size cos(a)^(n/2) is no farther than VTKI_LOBE_SPLAT_FARTHEST = D. Where the surface is
 * still becoming wider that far along the axis the ellipsoid's middle is put there, or where it is
 * wider than long a ball about the light. Equation (7) of the paper, with z = x size, is
 * h(z)^2 = z^2 ((size / z)^(4 / (n + 2)) - 1), for n >= 2 no more than the ellipsoid's
 * h(D)^2 (2 - z / D) z / D. */
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

/* The ellipsoid outside of which vtkiLobeLevel is below one; across is below zero where it is so
 * everywhere. cosine: of the direction on the surface; flux: the lobe's, over the lowest intensity
 * over a squared distance that counts. Two parts. Beyond the distance a within which the lobe is
 * widened (vtkiLobeReach) its iso-surface is that of Dachsbacher and Stamminger 2006 (appendix) for
 * I0 = flux / N. Within it the exponent is 4 d^2 / A, and cos(a)^P' <= exp(-P' sin(a)^2 / 2) =
 * exp(-2 h^2 / A) at a distance h from the axis, whatever d is: a beam, of radius sqrt(A / 2
 * log(peak)), peak the level along the axis. A ball of radius a would hold all of the scene for a
 * mirror. */
vtkiSplat vtkiMakeLobeSplat(
  vec3 position, vec3 direction, float cosine, float exponent, float area, float flux)
{
  float size = sqrt(flux / vtkiLobeIntegral(exponent, cosine));
  vec3 ellipsoid = vtkiLobeEllipsoid(exponent, size);
  // The share above the surface is least for the widest lobe.
  float peak =
    VTKI_LOBE_SPLAT_PEAK * 2.0f * flux / (VTKI_PI * area * vtkiShareAbove(0.0f, max(cosine, 0.0f)));
  float reach = min(vtkiLobeReach(exponent, area), VTKI_LOBE_SPLAT_FARTHEST);
  float beam = min(sqrt(0.5f * area * log(max(peak, 1.0f))), reach);
  // Both ends of the beam: with its radius a share t of the half width, sqrt(1 - t^2) of the half
  // length reaches there.
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
