// What a specular sender gives: a lobe about the direction in which it reflects or refracts a light.
#ifndef vtkIndirectLibSenderLobe
#define vtkIndirectLibSenderLobe
#include "vtkIndirectLibPortable.glsl"

// Beyond this exponent a lobe is narrower than floats tell directions apart.
const float VTKI_LOBE_EXPONENT_MAX = 1.0e6f;

/* log(1 - s) for s in [0,1], without loss of digits for small s. */
float vtkiLogOfRest(float s)
{
  return s < 0.02f ? -s * (1.0f + s * (0.5f + s * (1.0f / 3.0f + 0.25f * s)))
                   : log(max(1.0f - s, 1.0e-30f));
}

/* cos^exponent, of an angle in [0, pi / 2] by its squared sine. The sine keeps its digits where cosines are all but one:
 * a cosine's rounding would be a tenth of a lobe of exponent 1e6. */
float vtkiLobePower(float sine2, float exponent)
{
  return exp(0.5f * exponent * vtkiLogOfRest(min(sine2, 1.0f)));
}

/* The share of a lobe cos^exponent above a plane that its axis stands over by an angle e in [0, pi / 2], of which `sine`
 * is the sine: the integral of cos^exponent from -e to pi / 2 over that from -pi / 2 to pi / 2, which is Student's
 * distribution for exponent + 1 degrees of freedom at sqrt(exponent + 1) tan(e).
 * By a normal distribution (Wallace 1959, "Bounds on normal approximations to Student's and the chi-square
 * distributions"; Page 1977, "Approximations to the cumulative normal function"): off by 0.9 % at exponent 0, by 0.3 %
 * at 1, from 10 on by 0.04 %. */
float vtkiShareAbove(float exponent, float sine)
{
  float freedom = exponent + 1.0f;
  float z2 = -freedom * vtkiLogOfRest(min(sine * sine, 1.0f));
  float z = (8.0f * freedom + 1.0f) / (8.0f * freedom + 3.0f) * sqrt(max(z2, 0.0f));
  return 1.0f / (1.0f + exp(-min(z * (1.5976f + 0.07056f * z * z), 80.0f)));
}

/* N, the integral of max(r.w, 0)^exponent over the directions w above a surface, on which the lobe's axis r has this
 * cosine, in [0,1]. Off as vtkiShareAbove. */
float vtkiLobeIntegral(float exponent, float cosine)
{
  return 2.0f * VTKI_PI / (exponent + 1.0f) * vtkiShareAbove(exponent, max(cosine, 0.0f));
}

/* The integral over the same directions of max(r.w, 0)^exponent (n.w): what a surface that shows VTK's specular term of
 * coefficient one to every eye sends, over its area and the light's strength. Not proportional to the cosine: near
 * grazing light VTK's term gives back more than falls onto the surface.
 * In two factors: along the plane of n and r the lobe is cos^exponent, across it cos^(exponent + 2). Off by 0.2 %. */
float vtkiPhongFlux(float exponent, float cosine)
{
  float sine = min(max(cosine, 0.0f), 1.0f);
  // The integral of cos^m from -pi / 2 to pi / 2 for m = exponent + 2, by Wallis' bounds: off by 1e-4.
  float m = exponent + 2.0f;
  float across = sqrt(2.0f * VTKI_PI / (m + 0.5f + 1.0f / (8.0f * m + 5.5f)));
  return sine * 2.0f * VTKI_PI / m * vtkiShareAbove(exponent + 1.0f, sine) +
    across * vtkiLobePower(sine * sine, m) / (exponent + 1.0f);
}

/* The exponent of the lobe about the mirror direction that is about as wide as VTK's PBR has it for this roughness, whose
 * square is the alpha of the distribution of half vectors: 2 / alpha^2 - 2 of half vectors (Walter, Marschner, Li,
 * Torrance 2007, "Microfacet models for refraction through rough surfaces", section 5.2), a quarter of it of directions,
 * which turn by twice the half vector's angle (Fisher, Woo 1994, "R.E versus N.H specular highlights"). */
float vtkiExponentOfRoughness(float roughness)
{
  float alpha = roughness * roughness;
  float alpha2 = max(alpha * alpha, 1.0e-12f);
  return min(max(0.5f * (1.0f / alpha2 - 1.0f), 0.0f), VTKI_LOBE_EXPONENT_MAX);
}

/* a, the distance from a light of this area within which its lobe is widened: where the lobe has become about half as
 * wide as the light itself. */
float vtkiLobeReach(float exponent, float area)
{
  return 0.5f * sqrt(exponent * area);
}

/* P', the exponent at a distance from a light whose surface has this area: the lobe is nowhere narrower than about half
 * the light's own width, or lights would show one by one. Dachsbacher and Stamminger 2006 (section 3.3) lower the
 * exponent with the distance over a length; with its square the lobe's footprint is what stays the same. */
float vtkiLobeExponent(float exponent, float distance, float area)
{
  float reach = vtkiLobeReach(exponent, area);
  float nearness = reach > distance ? distance / reach : 1.0f;
  return exponent * nearness * nearness;
}

/* What the size of a light adds to the squared distance in the denominator: A / pi for diffuse light, as of the disk of
 * vtkiVirtualLightWeight, and less for a lobe, whose light does not spread over the hemisphere before it arrives; that
 * it is bounded is the widened exponent's matter. With A / pi a caustic close to its mirror lost a tenth of its flux. */
float vtkiLobeSize(float exponent, float area)
{
  return area / (VTKI_PI * max(exponent, 1.0f));
}

/* Intensity of a lobe of flux one towards a receiver, over r^2 + vtkiLobeSize and the distance: times the receiver's projection
 * max(dot(normalR, toSender), 0) and the lobe's flux it is its irradiance (VTK units, both physical over pi), and times
 * toSender its share of the vector irradiance. Dachsbacher and Stamminger 2006, eq. 3, with the lobe clamped to the
 * sender's hemisphere and normalised over it:
 *   I(w) = max(r.w, 0)^P' / N(P', n.r),   E = flux I(w) cosR / (r^2 + A / (pi max(P', 1))).
 * toSender: sender minus receiver, scene units; normalS: unit, or a mean; direction: unit; exponent >= 0; area > 0.
 * Bounded without a clamp: the exponent is zero at the light. No visibility. The form factor's cosine at the sender is
 * the lobe's own matter, so a wide lobe is brighter along the surface than VTK's specular term shows it there, and
 * darker away from it, for the same flux. */
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

/* The same with the receiver's cosine: irradiance over flux. */
float vtkiSenderLobeWeight(
  vec3 toSender, vec3 normalS, vec3 normalR, vec3 direction, float exponent, float area)
{
  return max(dot(normalR, toSender), 0.0f) *
    vtkiSenderLobeStrength(toSender, normalS, direction, exponent, area);
}

/* Whether less than 1e-6 of a lobe is left at a receiver, which most receivers are beside and need no more. The exponent
 * is 4 r^2 / area near the light (vtkiLobeExponent). */
bool vtkiIsBesideLobe(vec3 toSender, vec3 direction, float exponent, float area)
{
  float r2 = dot(toSender, toSender);
  float along = -dot(toSender, direction);
  return along <= 0.0f || min(exponent, 4.0f * r2 / area) * (r2 - along * along) > 28.0f * r2;
}

/* What interpolation over a patch of surface of this radius about a receiver may change of vtkiSenderLobeStrength times
 * the distance, at most: an eighth of the second derivative over the patch's width, which of a lobe cos^m is at most
 * m max(1, m sin^2) times the lobe at the nearest angle, and of 1 / r^2 six over r^2; never more than the whole. */
float vtkiSenderLobeVariation(
  vec3 toSender, vec3 normalS, vec3 direction, float exponent, float area, float radius)
{
  float r = sqrt(dot(toSender, toSender));
  float shift = r > radius ? 0.5f * VTKI_PI * radius / r : VTKI_PI;
  float twice = min(2.0f * shift, VTKI_PI);
  float cosine = r > 0.0f ? min(max(-dot(direction, toSender) / r, -1.0f), 1.0f) : 1.0f;
  float sine = sqrt(max(1.0f - cosine * cosine, 0.0f));
  bool inside = cosine >= cos(twice);
  // Sine and cosine of the angle that is left when the patch has come as near to the axis as it can.
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

/* The direction in which a surface of this unit normal mirrors light; toLight: unit. */
vec3 vtkiMirroredLight(vec3 toLight, vec3 normal)
{
  return 2.0f * dot(normal, toLight) * normal - toLight;
}
#endif
