// Light of a specular sender: a lobe about the direction of reflection or refraction.
#ifndef vtkIndirectLibSenderLobe
#define vtkIndirectLibSenderLobe
#include "vtkIndirectLibPortable.glsl"

// A larger exponent would make a lobe narrower than the precision of float directions.
const float VTKI_LOBE_EXPONENT_MAX = 1.0e6f;

/* log(1 - s) for s in [0,1], precise for small s. */
float vtkiLogOfRest(float s)
{
  return s < 0.02f ? -s * (1.0f + s * (0.5f + s * (1.0f / 3.0f + 0.25f * s)))
                   : log(max(1.0f - s, 1.0e-30f));
}

/* cos^exponent, of an angle in [0, pi / 2] by its squared sine. The sine is precise where cosines
 * are almost one: a cosine's rounding would be a tenth of a lobe of exponent 1e6. */
float vtkiLobePower(float sine2, float exponent)
{
  return exp(0.5f * exponent * vtkiLogOfRest(min(sine2, 1.0f)));
}

/* Returns the share of a lobe cos^exponent above a plane, over which its axis is raised by an angle
 * e in [0, pi / 2] with this sine: the integral of cos^exponent from -e to pi / 2 over that from
 * -pi / 2 to pi / 2, which is Student's distribution for exponent + 1 degrees of freedom at
 * sqrt(exponent + 1) tan(e). Approximated by a normal distribution (Wallace 1959, "Bounds on normal
 * approximations to Student's and the chi-square distributions"; Page 1977, "Approximations to the
 * cumulative normal function"), with an error of 0.9 % at exponent 0, 0.3 % at 1, 0.04 % from 10
 * on. */
float vtkiShareAbove(float exponent, float sine)
{
  float freedom = exponent + 1.0f;
  float z2 = -freedom * vtkiLogOfRest(min(sine * sine, 1.0f));
  float z = (8.0f * freedom + 1.0f) / (8.0f * freedom + 3.0f) * sqrt(max(z2, 0.0f));
  return 1.0f / (1.0f + exp(-min(z * (1.5976f + 0.07056f * z * z), 80.0f)));
}

/* Returns N, the integral of max(r.w, 0)^exponent over the directions w above a surface, on which
 * the lobe's axis r has this cosine, in [0,1]. Errors as vtkiShareAbove. */
float vtkiLobeIntegral(float exponent, float cosine)
{
  return 2.0f * VTKI_PI / (exponent + 1.0f) * vtkiShareAbove(exponent, max(cosine, 0.0f));
}

/* Returns the integral over the same directions of max(r.w, 0)^exponent (n.w): flux of a surface
 * that shows VTK's specular term of coefficient one to every eye, over its area and the light's
 * strength. Not proportional to the cosine: near grazing light VTK's term returns more than falls
 * onto the surface. In two factors: along the plane of n and r the lobe is cos^exponent, across it
 * cos^(exponent + 2). Error 0.2 %. */
float vtkiPhongFlux(float exponent, float cosine)
{
  float sine = min(max(cosine, 0.0f), 1.0f);
  // The integral of cos^m from -pi / 2 to pi / 2 for m = exponent + 2, by Wallis' bounds: error
  // 1e-4.
  float m = exponent + 2.0f;
  float across = sqrt(2.0f * VTKI_PI / (m + 0.5f + 1.0f / (8.0f * m + 5.5f)));
  return sine * 2.0f * VTKI_PI / m * vtkiShareAbove(exponent + 1.0f, sine) +
    across * vtkiLobePower(sine * sine, m) / (exponent + 1.0f);
}

/* Returns the exponent of the lobe about the mirror direction of about the width of VTK's PBR at
 * this roughness, whose square is the alpha of the distribution of half vectors: 2 / alpha^2 - 2
 * for half vectors (Walter, Marschner, Li, Torrance 2007, "Microfacet models for refraction through
 * rough surfaces", section 5.2), a quarter of that for directions, which turn by twice the half
 * vector's angle (Fisher, Woo 1994, "R.E versus N.H specular highlights"). */
float vtkiExponentOfRoughness(float roughness)
{
  float alpha = roughness * roughness;
  float alpha2 = max(alpha * alpha, 1.0e-12f);
  return min(max(0.5f * (1.0f / alpha2 - 1.0f), 0.0f), VTKI_LOBE_EXPONENT_MAX);
}

/* a, the distance from a light of this area within which its lobe is widened: at a the lobe is
 * about half as wide as the light. */
float vtkiLobeReach(float exponent, float area)
{
  return 0.5f * sqrt(exponent * area);
}

/* P', the exponent at a distance from a light with this surface area: the lobe is at least about
 * half as wide as the light, because otherwise single lights would be visible. Dachsbacher and
 * Stamminger 2006 (section 3.3) lower the exponent with the distance over a length; with its square
 * the lobe's footprint stays the same. */
float vtkiLobeExponent(float exponent, float distance, float area)
{
  float reach = vtkiLobeReach(exponent, area);
  float nearness = reach > distance ? distance / reach : 1.0f;
  return exponent * nearness * nearness;
}

/* Returns the area term added to the squared distance in the denominator: A / pi for diffuse light,
 * as of the disk of vtkiVirtualLightWeight, and less for a lobe, which does not spread over the
 * hemisphere on its way; the widened exponent bounds it. With A / pi a caustic close to its mirror
 * would lose a tenth of its flux. */
float vtkiLobeSize(float exponent, float area)
{
  return area / (VTKI_PI * max(exponent, 1.0f));
}

/* Intensity of a lobe of flux one towards a receiver, over r^2 + vtkiLobeSize and the distance:
 * times the receiver's projection max(dot(normalR, toSender), 0) and the lobe's flux it is its
 * irradiance (VTK units, both physical over pi), and times toSender its share of the vector
 * irradiance. Dachsbacher and Stamminger 2006, eq. 3, with the lobe clamped to the sender's
 * hemisphere and normalised over it:
 *   I(w) = max(r.w, 0)^P' / N(P', n.r),   E = flux I(w) cosR / (r^2 + A / (pi max(P', 1))).
 * toSender: sender minus receiver, scene units; normalS: unit, or a mean; direction: unit; exponent
 * >= 0; area > 0. Bounded without a clamp: the exponent is zero at the light. No visibility. The
 * lobe contains the form factor's cosine at the sender, so for the same flux a wide lobe is
 * brighter along the surface than VTK's specular term, and darker away from it. */
float vtkiSenderLobeStrength(
  vec3 toSender, vec3 normalS, vec3 direction, float exponent, float area)
{
  float r2 = dot(toSender, toSender);
  float r = sqrt(r2);
  vec3 w = toSender * (-1.0f / max(r, 1.0e-30f));
  vec3 aside = cross(direction, w);
  bool leaves = dot(normalS, w) > 0.0f && dot(direction, w) > 0.0f;
  float length2 = dot(normalS, normalS);
  float cosine = dot(normalS, direction) * (length2 > 0.0f ? 1.0f / sqrt(length2) : 0.0f);
  float widened = vtkiLobeExponent(exponent, r, area);
  float intensity = vtkiLobePower(dot(aside, aside), widened) / vtkiLobeIntegral(widened, cosine);
  return leaves && r > 0.0f ? intensity / (r * (r2 + vtkiLobeSize(widened, area))) : 0.0f;
}

/* vtkiSenderLobeStrength with the receiver's cosine: irradiance over flux. */
float vtkiSenderLobeWeight(
  vec3 toSender, vec3 normalS, vec3 normalR, vec3 direction, float exponent, float area)
{
  return max(dot(normalR, toSender), 0.0f) *
    vtkiSenderLobeStrength(toSender, normalS, direction, exponent, area);
}

/* Returns true if less than 1e-6 of a lobe is left at a receiver, as at most receivers, which then
 * need no evaluation. The exponent is 4 r^2 / area near the light (vtkiLobeExponent). */
bool vtkiIsBesideLobe(vec3 toSender, vec3 direction, float exponent, float area)
{
  float r2 = dot(toSender, toSender);
  float along = -dot(toSender, direction);
  return along <= 0.0f || min(exponent, 4.0f * r2 / area) * (r2 - along * along) > 28.0f * r2;
}

/* Returns the bound of the error of vtkiSenderLobeStrength times the distance when interpolated
 * over a patch of this radius about a receiver: an eighth of the second derivative over the patch's
 * width, which for a lobe cos^m is at most m max(1, m sin^2) times the lobe at the nearest angle,
 * and for 1 / r^2 six over r^2; at most the whole. */
float vtkiSenderLobeVariation(
  vec3 toSender, vec3 normalS, vec3 direction, float exponent, float area, float radius)
{
  float r = sqrt(dot(toSender, toSender));
  float shift = r > radius ? 0.5f * VTKI_PI * radius / r : VTKI_PI;
  float twice = min(2.0f * shift, VTKI_PI);
  float cosine = r > 0.0f ? min(max(-dot(direction, toSender) / r, -1.0f), 1.0f) : 1.0f;
  float sine = sqrt(max(1.0f - cosine * cosine, 0.0f));
  bool inside = cosine >= cos(twice);
  // Sine and cosine of the smallest angle between the patch and the axis.
  float nearestSine = inside ? 0.0f : sine * cos(twice) - cosine * sin(twice);
  float nearestCosine = inside ? 1.0f : cosine * cos(twice) + sine * sin(twice);
  float closest = max(r - 2.0f * radius, 0.0f);
  float widened = vtkiLobeExponent(exponent, closest, area);
  float steepest = vtkiLobeExponent(exponent, r + 2.0f * radius, area);
  float lobe = nearestCosine > 0.0f ? vtkiLobePower(nearestSine * nearestSine, widened) : 0.0f;
  float length2 = dot(normalS, normalS);
  float upright = dot(normalS, direction) * (length2 > 0.0f ? 1.0f / sqrt(length2) : 0.0f);
  float strength = lobe / (vtkiLobeIntegral(steepest, upright) * (closest * closest + vtkiLobeSize(steepest, area)));
  float curvature = steepest * max(steepest * nearestSine * nearestSine, 1.0f) + 6.0f;
  return strength * min(0.5f * shift * shift * curvature, 1.0f);
}

/* Returns the direction in which a surface of this unit normal mirrors light; toLight: unit. */
vec3 vtkiMirroredLight(vec3 toLight, vec3 normal)
{
  return 2.0f * dot(normal, toLight) * normal - toLight;
}
#endif
