// Irradiance from one virtual light.
#ifndef vtkIndirectLibVirtualLight
#define vtkIndirectLibVirtualLight
#include "vtkIndirectLibPortable.glsl"

/* Weight w such that a virtual light of reflected density times area BA adds BA * w to a receiver's
 * irradiance (VTK units: radiance physical, irradiance physical / pi).
 *   w = cosS cosR / (pi r^2 + A),  the form factor of a disk of area A seen at distance r, over A
 * (Wallace, Elmquist, Haines 1989, "A ray tracing algorithm for progressive radiosity").
 * toSender: sender minus receiver, scene units; normals unit; area > 0 in scene units squared.
 * Bounded by 1/A with no clamp. Bias <= 0 where r^2 < A. No visibility. */
float vtkiVirtualLightWeight(vec3 toSender, vec3 normalS, vec3 normalR, float area)
{
  float r2 = dot(toSender, toSender);
  float projectedS = max(-dot(normalS, toSender), 0.0f);
  float projectedR = max(dot(normalR, toSender), 0.0f);
  float denominator = r2 * (VTKI_PI * r2 + area);
  // The denominator is zero only if sender and receiver coincide, where neither sees the other.
  return denominator > 0.0f ? projectedS * projectedR / denominator : 0.0f;
}

/* vtkiVirtualLightWeight without the receiver's cosine: times max(dot(normalR, toSender), 0) it is
 * that weight, and times toSender it is the light's share of the vector irradiance. The projection
 * of the vector irradiance on any normal that sees the same lights is its irradiance. */
float vtkiVirtualLightStrength(vec3 toSender, vec3 normalS, float area)
{
  float r2 = dot(toSender, toSender);
  float projectedS = max(-dot(normalS, toSender), 0.0f);
  float denominator = r2 * (VTKI_PI * r2 + area);
  return denominator > 0.0f ? projectedS / denominator : 0.0f;
}

/* Returns the square of the half width over which cosines spread for normals with this mean: three
 * times their variance along one direction, which is half of one minus the mean's squared length; a
 * difference within rounding counts as zero. */
float vtkiSpreadOfNormals(vec3 mean)
{
  return 1.5f * max(1.0f - dot(mean, mean) - 1.0e-4f, 0.0f);
}

/* The mean of max(cosine, 0) over cosines evenly spread about one of them. Lengths may replace
 * cosines. */
float vtkiMeanOfSpread(float projected, float halfWidth)
{
  float within = max(halfWidth - abs(projected), 0.0f);
  return max(projected, 0.0f) + within * within / (4.0f * max(halfWidth, 1.0e-30f));
}

/* The mean of max(dot(normal, -toSender), 0) over normals with the mean normalS: exact if all are
 * alike, and if cosines are evenly spread, as on a bent patch. Zero behind all of these. toSender
 * as above, r2 its square. */
float vtkiMeanProjection(vec3 toSender, vec3 normalS, float r2)
{
  return vtkiMeanOfSpread(-dot(normalS, toSender), sqrt(vtkiSpreadOfNormals(normalS) * r2));
}

/* Share of the spread that counts for a receiver: zero if it faces the sender, since a receiver
 * behind the sender's mean plane that faces it is the other side of the same sheet. */
float vtkiShareOfSpread(vec3 normalS, vec3 normalR)
{
  return min(max(1.0f + 2.0f * dot(normalS, normalR), 0.0f), 1.0f);
}

/* Strength of a light that represents surfaces with the mean normal normalS: their mean cosine over
 * `spread`, the area over which the light spreads at the receiver. r2: square of toSender. */
float vtkiMeanStrengthOver(vec3 toSender, vec3 normalS, vec3 normalR, float r2, float spread)
{
  float halfWidth = vtkiShareOfSpread(normalS, normalR) * sqrt(vtkiSpreadOfNormals(normalS) * r2);
  float denominator = r2 * spread;
  return denominator > 0.0f ? vtkiMeanOfSpread(-dot(normalS, toSender), halfWidth) / denominator : 0.0f;
}

/* vtkiVirtualLightStrength of a light that represents surfaces with the mean normal normalS. */
float vtkiMeanLightStrength(vec3 toSender, vec3 normalS, vec3 normalR, float area)
{
  float r2 = dot(toSender, toSender);
  return vtkiMeanStrengthOver(toSender, normalS, normalR, r2, VTKI_PI * r2 + area);
}

/* vtkiMeanLightStrength of a point in place of a disk: cosS / (pi r^2) over r (Nichols and Wyman
 * 2009, equation 1). Bias >= 0 where r^2 < A. Nearer than sqrt(A / (1024 pi)) the distance counts as
 * that, so that images remain finite. */
float vtkiPointLightStrength(vec3 toSender, vec3 normalS, vec3 normalR, float area)
{
  float r2 = dot(toSender, toSender);
  float spread = max(VTKI_PI * r2, area * (1.0f / 1024.0f));
  return vtkiMeanStrengthOver(toSender, normalS, normalR, r2, spread);
}

/* This is the bound of the factor by which a patch's light rises near its plane. Receivers that
 * face a flat patch get at most 9.8. */
const float VTKI_PATCH_RISE = 16.0f;

/* This is the sine of the angle between a receiver's normal and its facet's, where facets meet at 8
 * degrees. A larger one would cost light between planes that face each other at less than a patch's
 * width. */
const float VTKI_PATCH_FACET = 0.07f;

/* A light that represents a patch of a surface, for receivers that may be near to it. */
struct vtkiPatchLight
{
  vec3 toPlace;   // towards the origin of its light, of any length
  float strength; // weight over the product of toPlace and the receiver's normal, above its horizon
};

/* The patch's mean of the weight of its points, up to the second order in its width over the
 * distance, for any receiver that sees all of it; on the axis it is that of a disk of the same
 * variance, at any distance. toSender: to its middle; normalS: its mean normal; area: of a square,
 * so that A / 12 is the variance along either side; softening: the square of the depth of contact
 * softening.
 *   With h the height of the receiver over the patch, x the offset along it, b^2 = h^2 + s^2 / (s +
 * h^2) and R^2 = x^2 + b^2, a point's light along and towards the plane, h x / (pi R^4) and h^2 /
 * (pi R^4), becomes
 *   (h R^2 + 4 b^2 (b - h)) x / (pi R^6)  and  (h^2 R^2 + 2 b^2 (b^2 - h^2)) / (pi R^6).
 * For a plane, or half a plane at a crease, the sum does not depend on b (the integrals are 1 and
 * 1/2), so that patches add up to these down to contact, where points would leave dots and a dark
 * line. From farther than b the light is that of points, but for (b / R)^3: beside a wall its plane
 * is dark. b - h is of fourth order.
 *   The mean over the patch adds variance / 2 times the Laplacian along it: with 4 variance / R^2 =
 * v and t = v b^2 / R^2 times 1 + v along it, 1 + 2 v towards it, and 1 - 3 t both. 1 / ((1 + t) (1
 * + 2 t)) is positive and the same in the first order.
 *   Behind the patch the light is zero: to avoid a step, it is softened from a tenth of b on for
 * receivers that face the patch, which may be the other side of a thin sheet, and from a thousandth
 * on for others, which may lie in the plane. Receivers across the plane get all of it down to the
 * plane and none from a thousandth of b behind: rounding places a pixel on a crease there. Where
 * normals differ, receivers that do not face the patch get light behind it, too. A patch whose
 * middle lies behind the receiver gives nothing, and one just before it at most VTKI_PATCH_RISE
 * times the light that its height over the receiver alone would give: the back of a bowl is before
 * its mean plane. For receivers that face the patch this is the height over their facet, which may
 * face the other way: too dark by the square of VTKI_PATCH_FACET between two planes. */
vtkiPatchLight vtkiFindPatchLight(vec3 toSender, vec3 normalS, vec3 normalR, float area, float softening)
{
  float r2 = dot(toSender, toSender);
  float across = vtkiShareOfSpread(normalS, normalR);
  float towards = -dot(normalS, toSender);
  float height = vtkiMeanOfSpread(towards, across * sqrt(vtkiSpreadOfNormals(normalS) * r2));
  float height2 = height * height;
  float added2 = softening * softening / max(softening + height2, 1.0e-30f);
  float softened2 = height2 + added2;
  float b = sqrt(softened2);
  float behind = b * min(max(1.0f - 2.0f * dot(normalS, normalR), 0.0f), 1.0f);
  float depth = min(b - height, 10.0f * height + across * max(1000.0f * towards + behind, 0.0f));
  float over = 1.0f / max(r2 + added2, 1.0e-18f);
  float v = area / 3.0f * over;
  float t = v * over * softened2;
  float core = 2.0f * softened2 * over * depth * dot(normalS, normalS);
  float along = height + 2.0f * core;
  vtkiPatchLight light;
  light.toPlace = along * (1.0f + v) * toSender - (v * along * height + (1.0f + 2.0f * v) * core * depth) * normalS;
  light.strength = over * over / (VTKI_PI * (1.0f + t) * (1.0f + 2.0f * t));
  float given = dot(normalR, light.toPlace);
  float lift = dot(normalR, toSender) - VTKI_PATCH_FACET * (1.0f - across) * sqrt(r2);
  float most = VTKI_PATCH_RISE * along * max(lift, 0.0f);
  light.strength *= given > most ? most / given : 1.0f;
  return light;
}

/* The weight of a patch light, as vtkiVirtualLightWeight. */
float vtkiPatchLightWeight(vec3 toSender, vec3 normalS, vec3 normalR, float area, float softening)
{
  vtkiPatchLight light = vtkiFindPatchLight(toSender, normalS, normalR, area, softening);
  return max(dot(normalR, light.toPlace), 0.0f) * light.strength;
}

/* Returns the weight w such that light from a direction, of radiance times solid angle LO, adds LO
 * * w to a receiver's irradiance (VTK units: physical over pi). toLight, normalR: unit. */
float vtkiDirectionWeight(vec3 toLight, vec3 normalR)
{
  return max(dot(normalR, toLight), 0.0f) / VTKI_PI;
}
#endif
