// A light's map: the texel for a point, and the surface and reflected light of a texel. Lengths are
// scene units (diagonal = 1).
#ifndef vtkIndirectLibLightMap
#define vtkIndirectLibLightMap
#include "vtkIndirectLibPortable.glsl"

// Projections of a map.
const int VTKI_MAP_PARALLEL = 0; // directional light
const int VTKI_MAP_SINGLE = 1;   // one perspective face: about a spot's axis, or aimed at the scene
const int VTKI_MAP_FACES = 2;    // point or wide spot: perspective faces of a cube

/* Returns the face of the cube that sees a point given in the light's frame (-z is forward): 0
 * forward, 1 +x, 2 -x, 3 +y, 4 -y, 5 backward, which wide spots lack. */
int vtkiFaceOf(vec3 p)
{
  vec3 a = vec3(abs(p.x), abs(p.y), abs(p.z));
  if (a.z >= a.x && a.z >= a.y)
  {
    return p.z <= 0.0f ? 0 : 5;
  }
  if (a.x >= a.y)
  {
    return p.x >= 0.0f ? 1 : 2;
  }
  return p.y >= 0.0f ? 3 : 4;
}

/* Returns a point of the light's frame in a face's view coordinates: x right, y up, looking along
 * -z. */
vec3 vtkiToFace(vec3 p, int face)
{
  if (face == 1)
  {
    return vec3(p.z, p.y, -p.x);
  }
  if (face == 2)
  {
    return vec3(-p.z, p.y, p.x);
  }
  if (face == 3)
  {
    return vec3(p.x, p.z, -p.y);
  }
  if (face == 4)
  {
    return vec3(p.x, -p.z, p.y);
  }
  if (face == 5)
  {
    return vec3(-p.x, p.y, -p.z);
  }
  return p;
}

/* Solid angle of a texel of a perspective map [sr]: centre at tangents t, edge length texelSize in
 * tangents. dw = dA cos^3 on the plane at distance one. */
float vtkiTexelSolidAngle(vec2 t, float texelSize)
{
  float distance2 = 1.0f + t.x * t.x + t.y * t.y;
  return texelSize * texelSize / (distance2 * sqrt(distance2));
}

/* att(d) d^2 for VTK's attenuation 1 / (c + l d + q d^2), in one fraction so that neither factor
 * overflows on its own; the limit is returned at d = 0. */
float vtkiAttenuationTimesDistance2(vec3 attenuation, float d)
{
  float denominator = attenuation.x + d * (attenuation.y + d * attenuation.z);
  if (denominator > 0.0f)
  {
    return d * d / denominator;
  }
  // Here d is 0, or there is no falloff at all, where VTK divides by zero.
  return attenuation.x <= 0.0f && attenuation.y <= 0.0f && attenuation.z > 0.0f
    ? 1.0f / attenuation.z
    : 0.0f;
}

/* Returns VTK's spot factor: hard edge at the cone's half angle, cos^exponent inside. cosCone < -1:
 * none. */
float vtkiConeFactor(float cosAxis, float cosCone, float exponent)
{
  if (cosCone < -1.0f)
  {
    return 1.0f;
  }
  if (cosAxis < cosCone)
  {
    return 0.0f;
  }
  return exponent == 0.0f ? 1.0f : pow(max(cosAxis, 0.0f), exponent);
}

/* Factor between albedo and reflected density at a texel of a map: (n_s.l) / (n_g.l), n_s the shading
 * and n_g the geometric normal. A texel covers footprint / (n_g.l) of surface and VTK lights it with
 * n_s.l, so for equal normals the cosine cancels. cosGeometricMin keeps the covered surface no deeper
 * than the scene. */
float vtkiCosineRatio(float cosShading, float cosGeometric, float cosGeometricMin)
{
  return max(cosShading, 0.0f) / max(cosGeometric, cosGeometricMin);
}
#endif
