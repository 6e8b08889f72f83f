// Specular reflection of a virtual light by a receiver with VTK's Phong model.
#ifndef vtkIndirectLibGlossy
#define vtkIndirectLibGlossy
#include "vtkIndirectLibPortable.glsl"
#include "vtkIndirectLibVirtualLight.glsl"

/* Returns the direction from a surface to the eye (the origin of view coordinates), mirrored at the
 * normal: R.V is the cosine between this and the direction to the light. Unit. VTK's Phong model
 * takes the same direction to the eye for parallel projections. */
vec3 vtkiMirror(vec3 positionVC, vec3 normalVC)
{
  float r2 = dot(positionVC, positionVC);
  vec3 toEye = r2 > 0.0f ? -positionVC * (1.0f / sqrt(r2)) : vec3(0.0f, 0.0f, 1.0f);
  return 2.0f * dot(normalVC, toEye) * normalVC - toEye;
}

/* Returns true if all lobes cos^power, or narrower ones, about mirror directions within a cone
 * leave less than 2e-7 of a sender, seen from anywhere within `radius` of a position. toSender:
 * from that position; axis: of the cone, unit; cosine: least cosine of the cone's directions to the
 * axis. cos(a)^power <= exp(-power a^2 / 2), here 1.2e-7. Angles have a margin for rounding. */
bool vtkiIsBesideMirrors(vec3 toSender, float radius, vec3 axis, float cosine, float power)
{
  float r = length(toSender);
  float shift = r > radius ? asin(radius / r) : VTKI_PI;
  float along = r > 0.0f ? dot(axis, toSender) / r : 1.0f;
  float angle = acos(min(max(along, -1.0f), 1.0f));
  float lobe = sqrt(32.0f / max(power, 1.0e-6f));
  return angle > acos(min(max(cosine, -1.0f), 1.0f)) + shift + lobe + 1.0e-3f;
}

/* Weight w such that a virtual light of reflected density times area BA adds specular colour times
 * BA w to a receiver's colour (VTK units). The light's strength corresponds to VTK's lightColor:
 * irradiance without the receiver's cosine. The lobe is VTK's, cos^power about the mirror direction
 * for lights above the horizon, without a cosine at the receiver (Phong 1975, "Illumination for
 * computer generated pictures"):
 *   w = cosS / (pi r^2 + A) * max(R.V, 0)^power.
 * toSender: sender minus receiver, scene units; normalR and mirror unit, normalS unit or a mean
 * (vtkiMeanProjection); area > 0. The size of the disk against the lobe is ignored: an error of
 * either sign at a pixel. No visibility. */
float vtkiGlossyWeight(
  vec3 toSender, vec3 normalS, vec3 normalR, vec3 mirror, float power, float area)
{
  float r2 = dot(toSender, toSender);
  float r = sqrt(r2);
  float mirrored = r > 0.0f ? min(dot(mirror, toSender) / r, 1.0f) : 0.0f;
  bool sees = mirrored > 0.0f && dot(normalR, toSender) > 0.0f;
  float lobe = sees ? pow(mirrored, power) : 0.0f;
  return vtkiMeanLightStrength(toSender, normalS, normalR, area) * r * lobe;
}

/* Position of a light against the horizon of a patch of surface: 1 above all of it, -1 below, where
 * it has no lobe, 0 where the horizon crosses the patch, at which VTK's lobe steps to zero. radius:
 * of the patch about the receiver; turn: largest angle between its normals and the receiver's. */
float vtkiGlossyHorizon(vec3 toSender, vec3 normalR, float radius, float turn)
{
  float height = dot(normalR, toSender);
  float reach = radius + turn * (sqrt(dot(toSender, toSender)) + radius);
  return height > reach ? 1.0f : (height < -reach ? -1.0f : 0.0f);
}

/* Returns the error at a patch of surface, for the same BA, if a light is left out there
 * (interpolated false) or interpolated between samples at such patches (interpolated true). radius,
 * turn: as above; toEye: distance of the eye. The mirror direction turns by twice the normal's turn
 * and by the angle of the patch seen from the eye, the direction to the light by the angle of the
 * patch seen from the light. Interpolation uses samples twice as far: the light is evaluated over
 * twice the patch. A light left out costs at most the largest weight there. Interpolation's error
 * is an eighth of the second derivative: that of a lobe cos^m is at most m max(1, m theta^2) times
 * the lobe, theta its angle, and strength falls with the square of the distance, whose relative
 * second derivative is 6. */
float vtkiGlossyVariation(vec3 toSender, vec3 normalS, vec3 mirror, float power, float area,
  float radius, float turn, float toEye, bool interpolated)
{
  float r = sqrt(dot(toSender, toSender));
  // The arc of a sine x is at most half pi x.
  float seen = (r > radius ? radius / r : 1.0f) + (toEye > radius ? radius / toEye : 1.0f);
  float shift = min(0.5f * VTKI_PI * seen + 2.0f * turn, VTKI_PI);
  float twice = r > 2.0f * radius ? min(2.0f * shift, VTKI_PI) : VTKI_PI;
  float mirrored = r > 0.0f ? min(max(dot(mirror, toSender) / r, -1.0f), 1.0f) : 1.0f;
  float nearest = mirrored >= cos(twice)
    ? 1.0f
    : mirrored * cos(twice) + sqrt(max(1.0f - mirrored * mirrored, 0.0f)) * sin(twice);
  float lobe = nearest > 0.0f ? pow(min(nearest, 1.0f), power) : 0.0f;
  float closest = max(r - 2.0f * radius, 0.0f);
  float facing = vtkiMeanProjection(toSender, normalS, r * r) + 2.0f * radius;
  float cosine = facing < closest ? facing / closest : 1.0f;
  float strength = cosine / (VTKI_PI * closest * closest + area);
  float curvature = power * max(power * (1.0f - nearest * nearest), 1.0f) + 6.0f;
  // The distance between samples is the patch's width: twice the shift.
  return strength * lobe * (interpolated ? min(0.5f * shift * shift * curvature, 1.0f) : 1.0f);
}
#endif
