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

/* What normals of this mean add to a squared cosine's place below: 2 / pi times the variance along one direction,
 * which is half of what a mean of length less than one leaves; of that, what rounding leaves is nothing. */
float vtkiSpreadOfNormals(vec3 mean)
{
  return max(1.0f - dot(mean, mean) - 1.0e-4f, 0.0f) / VTKI_PI;
}

/* The mean of max(dot(normal, -toSender), 0) over normals whose mean is normalS: exact where all are alike, and where
 * cosines are normally distributed about zero; in between it is too large, by a tenth of their spread at most.
 * toSender as above, r2 its square. */
float vtkiMeanProjection(vec3 toSender, vec3 normalS, float r2)
{
  float projected = -dot(normalS, toSender);
  return 0.5f * (projected + sqrt(projected * projected + vtkiSpreadOfNormals(normalS) * r2));
}

/* vtkiVirtualLightStrength and vtkiVirtualLightWeight of a light that stands for surfaces whose mean normal is
 * normalS. */
float vtkiMeanLightStrength(vec3 toSender, vec3 normalS, float area)
{
  float r2 = dot(toSender, toSender);
  float denominator = r2 * (VTKI_PI * r2 + area);
  return denominator > 0.0f ? vtkiMeanProjection(toSender, normalS, r2) / denominator : 0.0f;
}

float vtkiMeanLightWeight(vec3 toSender, vec3 normalS, vec3 normalR, float area)
{
  return max(dot(normalR, toSender), 0.0f) * vtkiMeanLightStrength(toSender, normalS, area);
}

/* Weight w such that light from a direction, of radiance times solid angle LO, adds LO * w to a
 * receiver's irradiance (VTK units: physical over pi). toLight, normalR: unit. */
float vtkiDirectionWeight(vec3 toLight, vec3 normalR)
{
  return max(dot(normalR, toLight), 0.0f) / VTKI_PI;
}
#endif
