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
  // Zero only where sender and receiver coincide; neither sees the other there.
  return denominator > 0.0f ? projectedS * projectedR / denominator : 0.0f;
}

/* The same without the receiver's cosine: times max(dot(normalR, toSender), 0) it is the weight
 * above, and times toSender it is the light's share of the vector irradiance, of which the
 * irradiance of any normal that sees the same lights is the projection. */
float vtkiVirtualLightStrength(vec3 toSender, vec3 normalS, float area)
{
  float r2 = dot(toSender, toSender);
  float projectedS = max(-dot(normalS, toSender), 0.0f);
  float denominator = r2 * (VTKI_PI * r2 + area);
  return denominator > 0.0f ? projectedS / denominator : 0.0f;
}

/* Square of the half width over which cosines spread where normals have this mean: three times their variance along one
 * direction, which is half of what a mean of length less than one leaves; of that, what rounding leaves is nothing. */
float vtkiSpreadOfNormals(vec3 mean)
{
  return 1.5f * max(1.0f - dot(mean, mean) - 1.0e-4f, 0.0f);
}

/* The mean of max(cosine, 0) over cosines that are evenly spread about one of them. Lengths may stand for cosines. */
float vtkiMeanOfSpread(float projected, float halfWidth)
{
  float within = max(halfWidth - abs(projected), 0.0f);
  return max(projected, 0.0f) + within * within / (4.0f * max(halfWidth, 1.0e-30f));
}

/* The mean of max(dot(normal, -toSender), 0) over normals whose mean is normalS: exact where all are alike, and where
 * cosines are evenly spread, as on a bent patch. Behind all of these nothing arrives. toSender as above, r2 its
 * square. */
float vtkiMeanProjection(vec3 toSender, vec3 normalS, float r2)
{
  return vtkiMeanOfSpread(-dot(normalS, toSender), sqrt(vtkiSpreadOfNormals(normalS) * r2));
}

/* How much of the spread counts to a receiver: none where that faces the sender, since one that a surface is seen by
 * behind its mean plane and faces it is the other side of the same sheet. */
float vtkiShareOfSpread(vec3 normalS, vec3 normalR)
{
  return min(max(1.0f + 2.0f * dot(normalS, normalR), 0.0f), 1.0f);
}

/* vtkiVirtualLightStrength of a light that stands for surfaces whose mean normal is normalS. */
float vtkiMeanLightStrength(vec3 toSender, vec3 normalS, vec3 normalR, float area)
{
  float r2 = dot(toSender, toSender);
  float halfWidth = vtkiShareOfSpread(normalS, normalR) * sqrt(vtkiSpreadOfNormals(normalS) * r2);
  float denominator = r2 * (VTKI_PI * r2 + area);
  return denominator > 0.0f ? vtkiMeanOfSpread(-dot(normalS, toSender), halfWidth) / denominator : 0.0f;
}

/* What faces a flat patch gets 9.8 times at most. */
const float VTKI_PATCH_RISE = 16.0f;

/* Sine of the angle between a receiver's normal and its facet's, where facets meet at 8 degrees. With more, planes that
 * face each other nearer than patches are wide would lose light. */
const float VTKI_PATCH_FACET = 0.07f;

/* A light that stands for a patch of a surface, to receivers that may be near to it. */
struct vtkiPatchLight
{
  vec3 toPlace;   // towards where its light comes from, of any length
  float strength; // times the product of this and the receiver's normal, above its horizon: the weight
};

/* The patch's mean of the weight of its points, up to the second order in its width over the distance, for any receiver
 * that sees all of it; on the axis it is that of a disk of the same variance, at any distance. toSender: to its middle;
 * normalS: its mean normal; area: of a square, so that A / 12 is the variance along either side; bluntArea: the square
 * of the depth by which it is blunt at contact.
 *   With h the height of the receiver over the patch, x the way along it, b^2 = h^2 + s^2 / (s + h^2) and
 * R^2 = x^2 + b^2, what a point gives along and towards the plane, h x / (pi R^4) and h^2 / (pi R^4), becomes
 *   (h R^2 + 4 b^2 (b - h)) x / (pi R^6)  and  (h^2 R^2 + 2 b^2 (b^2 - h^2)) / (pi R^6).
 * Of a plane, or of half of one at a crease, as much arrives whatever b (the integrals are 1 and 1/2), so that patches
 * add up to these down to contact, where points would leave dots and a dark line. From farther than b comes what points
 * give, but for (b / R)^3: beside a wall its plane is dark. b - h is of fourth order.
 *   The mean over the patch adds variance / 2 times the Laplacian along it: with 4 variance / R^2 = v and
 * t = v b^2 / R^2 times 1 + v along it, 1 + 2 v towards it, and 1 - 3 t both. 1 / ((1 + t) (1 + 2 t)) is positive and
 * the same in the first order.
 *   Nothing arrives behind the patch: so that this is no step, it is blunt from a tenth of b on. Receivers that do not
 * face it, as pixels on a crease, see it so from a thousandth on; those that do may be the other side of a thin sheet.
 * Where normals differ receivers that do not face it get light behind it, too. A patch whose middle lies behind the
 * receiver gives nothing, and one just before it no more than VTKI_PATCH_RISE times what its height over the receiver
 * alone would: the back of a bowl is before its mean plane. To receivers that face it this is the height over their
 * facet, which may look the other way than they do: too dark by the square of VTKI_PATCH_FACET between two planes. */
vtkiPatchLight vtkiFindPatchLight(vec3 toSender, vec3 normalS, vec3 normalR, float area, float bluntArea)
{
  float r2 = dot(toSender, toSender);
  float across = vtkiShareOfSpread(normalS, normalR);
  float towards = -dot(normalS, toSender);
  float height = vtkiMeanOfSpread(towards, across * sqrt(vtkiSpreadOfNormals(normalS) * r2));
  float height2 = height * height;
  float added2 = bluntArea * bluntArea / max(bluntArea + height2, 1.0e-30f);
  float blunt2 = height2 + added2;
  float depth = min(sqrt(blunt2) - height, 10.0f * height + across * (1000.0f * max(towards, 0.0f)));
  float over = 1.0f / max(r2 + added2, 1.0e-18f);
  float v = area / 3.0f * over;
  float t = v * over * blunt2;
  float core = 2.0f * blunt2 * over * depth * dot(normalS, normalS);
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

/* The weight, as vtkiVirtualLightWeight. */
float vtkiPatchLightWeight(vec3 toSender, vec3 normalS, vec3 normalR, float area, float bluntArea)
{
  vtkiPatchLight light = vtkiFindPatchLight(toSender, normalS, normalR, area, bluntArea);
  return max(dot(normalR, light.toPlace), 0.0f) * light.strength;
}

/* Weight w such that light from a direction, of radiance times solid angle LO, adds LO * w to a
 * receiver's irradiance (VTK units: physical over pi). toLight, normalR: unit. */
float vtkiDirectionWeight(vec3 toLight, vec3 normalR)
{
  return max(dot(normalR, toLight), 0.0f) / VTKI_PI;
}
#endif
