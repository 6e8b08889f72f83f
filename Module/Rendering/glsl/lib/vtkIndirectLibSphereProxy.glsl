// Sums over spheres in spherical harmonics of order 4: their occlusion and their light.
// "Image-Based Proxy Accumulation for Real-Time Soft Global Illumination", Sloan, Govindaraju,
// Nowrouzezahrai, Snyder 2007; numbers by Testing/Reference/fit_sphere_proxies.py.
#ifndef vtkIndirectLibSphereProxy
#define vtkIndirectLibSphereProxy
#include "vtkIndirectLibHarmonicProduct.glsl"
#include "vtkIndirectLibPortable.glsl"
#include "vtkIndirectLibProxyOperator.glsl"

/* This is the constant function Y00, of unit norm over the sphere. */
const float VTKI_HARMONICS_Y00 = 0.28209479f;
/* f without its constant is halved until its length is at most this. */
const float VTKI_HARMONICS_HALVING = 0.25f;
/* f without its constant is shortened to this length first, a little more than that of a sphere
 * that fills a hemisphere: further spheres at the same place hide nothing more. */
const float VTKI_HARMONICS_LONGEST = 12.0f;

/* Returns all 16 functions at a unit direction. */
vtkiHarmonics4 vtkiHarmonics4At(vec3 d)
{
  vtkiHarmonics4 y;
  float z2 = d.z * d.z;
  float xy = d.x * d.y;
  float difference = d.x * d.x - d.y * d.y;
  y.A = vec4(0.28209479f, 0.48860251f * d.y, 0.48860251f * d.z, 0.48860251f * d.x);
  y.B = vec4(1.09254843f * xy, 1.09254843f * d.y * d.z, 0.31539157f * (3.0f * z2 - 1.0f), 1.09254843f * d.x * d.z);
  y.C = vec4(0.54627422f * difference, 0.59004359f * d.y * (3.0f * d.x * d.x - d.y * d.y), 2.89061144f * xy * d.z,
    0.45704580f * d.y * (5.0f * z2 - 1.0f));
  y.D = vec4(0.37317633f * d.z * (5.0f * z2 - 3.0f), 0.45704580f * d.x * (5.0f * z2 - 1.0f),
    1.44530572f * d.z * difference, 0.59004359f * d.x * (d.x * d.x - 3.0f * d.y * d.y));
  return y;
}

float vtkiHarmonicsDot(vtkiHarmonics4 f, vtkiHarmonics4 g)
{
  return dot(f.A, g.A) + dot(f.B, g.B) + dot(f.C, g.C) + dot(f.D, g.D);
}

/* Returns f + s g. */
vtkiHarmonics4 vtkiHarmonicsAdd(vtkiHarmonics4 f, float s, vtkiHarmonics4 g)
{
  vtkiHarmonics4 h;
  h.A = f.A + s * g.A;
  h.B = f.B + s * g.B;
  h.C = f.C + s * g.C;
  h.D = f.D + s * g.D;
  return h;
}

/* Turns a function around +z, given by its four coefficients, to a unit direction (Eq 8): band l of
 * the functions there times sqrt(4 pi / (2 l + 1)). */
vtkiHarmonics4 vtkiZonalTo(vec4 zonal, vec3 d)
{
  vtkiHarmonics4 y = vtkiHarmonics4At(d);
  vec4 s = zonal * vec4(3.54490770f, 2.04665341f, 1.58533092f, 1.33984918f);
  y.A = vec4(y.A.x * s.x, y.A.y * s.y, y.A.z * s.y, y.A.w * s.y);
  y.B = y.B * s.z;
  y.C = vec4(y.C.x * s.z, y.C.y * s.w, y.C.z * s.w, y.C.w * s.w);
  y.D = y.D * s.w;
  return y;
}

/* Returns the clamped cosine about a unit normal, over pi: its product with the light's
 * coefficients is irradiance in VTK's unit. Its band 3 is zero. */
vtkiHarmonics4 vtkiClampedCosine(vec3 n)
{
  return vtkiZonalTo(vec4(0.28209479f, 0.32573501f, 0.15769578f, 0.0f), n);
}

/* e^f, cut to order 4: e^(f0 Y00) (a + b g + g^2 / 2) squared p times, g the rest of f halved p
 * times. Turns the sum of logarithms into visibility. After Ren, Wang, Snyder, Zhou, Liu, Sun, Hua,
 * Guo, Shum 2006, "Real-time soft shadows in dynamic scenes using spherical harmonic
 * exponentiation". */
vtkiHarmonics4 vtkiHarmonicsExp(vtkiHarmonics4 f)
{
  vtkiHarmonics4 g = f;
  g.A.x = 0.0f;
  float size = sqrt(max(vtkiHarmonicsDot(g, g), 0.0f));
  float constant = f.A.x * VTKI_HARMONICS_Y00;
  float scale = 1.0f;
  if (size > VTKI_HARMONICS_LONGEST)
  {
    scale = VTKI_HARMONICS_LONGEST / size;
    constant *= scale;
    size = VTKI_HARMONICS_LONGEST;
  }
  int halvings = 0;
  for (int i = 0; i < 8; ++i)
  {
    if (size > VTKI_HARMONICS_HALVING)
    {
      size *= 0.5f;
      scale *= 0.5f;
      ++halvings;
    }
  }
  vtkiHarmonics4 zero;
  zero.A = vec4(0.0f);
  zero.B = vec4(0.0f);
  zero.C = vec4(0.0f);
  zero.D = vec4(0.0f);
  g = vtkiHarmonicsAdd(zero, scale, g);
  vtkiHarmonics4 e = vtkiHarmonicsAdd(zero, 1.0f + 0.03528f * size * size, g);
  e = vtkiHarmonicsAdd(e, 0.5f, vtkiHarmonicProduct(g, g));
  e.A.x += (1.0f + 7.05e-5f * size * size) / VTKI_HARMONICS_Y00;
  for (int i = 0; i < halvings; ++i)
  {
    e = vtkiHarmonicProduct(e, e);
  }
  // For much longer f, ringing lobes grow as well; visibility is at most one.
  float whole = exp(min(constant, 0.0f));
  float seen = whole * e.A.x * VTKI_HARMONICS_Y00;
  return vtkiHarmonicsAdd(zero, seen > 1.0f ? whole / seen : whole, e);
}

/* Returns the row of the table for a sphere of that sine, from 0 to 1: rows go with the solid
 * angle, which is the leading term of the logarithm. */
float vtkiProxyRow(float sine)
{
  return 1.0f - sqrt(max(1.0f - sine * sine, 0.0f));
}

/* Multiplication by a light, for the nine functions of a clamped cosine (Eq 10). */
struct vtkiLightMatrix
{
  vtkiHarmonics4 Columns[9];
};

vtkiLightMatrix vtkiMakeLightMatrix(vtkiHarmonics4 light)
{
  vtkiLightMatrix m;
  for (int i = 0; i < 9; ++i)
  {
    vtkiHarmonics4 one;
    one.A = vec4(i == 0 ? 1.0f : 0.0f, i == 1 ? 1.0f : 0.0f, i == 2 ? 1.0f : 0.0f, i == 3 ? 1.0f : 0.0f);
    one.B = vec4(i == 4 ? 1.0f : 0.0f, i == 5 ? 1.0f : 0.0f, i == 6 ? 1.0f : 0.0f, i == 7 ? 1.0f : 0.0f);
    one.C = vec4(i == 8 ? 1.0f : 0.0f, 0.0f, 0.0f, 0.0f);
    one.D = vec4(0.0f);
    m.Columns[i] = vtkiHarmonicProduct(light, one);
  }
  return m;
}

/* Returns C(n): light times clamped cosine over pi. Its dot product with visibility is irradiance
 * (VTK units: without occlusion a constant radiance L gives L). */
vtkiHarmonics4 vtkiLitCosine(vtkiLightMatrix m, vec3 n)
{
  vtkiHarmonics4 h = vtkiClampedCosine(n);
  vtkiHarmonics4 c = vtkiHarmonicsAdd(m.Columns[0], h.A.x - 1.0f, m.Columns[0]);
  c = vtkiHarmonicsAdd(c, h.A.y, m.Columns[1]);
  c = vtkiHarmonicsAdd(c, h.A.z, m.Columns[2]);
  c = vtkiHarmonicsAdd(c, h.A.w, m.Columns[3]);
  c = vtkiHarmonicsAdd(c, h.B.x, m.Columns[4]);
  c = vtkiHarmonicsAdd(c, h.B.y, m.Columns[5]);
  c = vtkiHarmonicsAdd(c, h.B.z, m.Columns[6]);
  c = vtkiHarmonicsAdd(c, h.B.w, m.Columns[7]);
  return vtkiHarmonicsAdd(c, h.C.x, m.Columns[8]);
}

/* Returns the gradient of irradiance by the normal, taken as any vector, for light in its first
 * nine coefficients. Irradiance of a nearby normal is that here plus the gradient's product with
 * their difference. */
vec3 vtkiIrradianceGradient(vtkiHarmonics4 light, vec3 n)
{
  float k = 0.27313711f;
  return vec3(0.32573501f * light.A.w + k * (light.B.x * n.y + light.B.w * n.z + light.C.x * n.x),
    0.32573501f * light.A.y + k * (light.B.x * n.x + light.B.y * n.z - light.C.x * n.y),
    0.32573501f * light.A.z + k * (light.B.y * n.y + light.B.w * n.x) + 0.47308736f * light.B.z * n.z);
}

/* Returns the irradiance from a disk of radiance 1, by the cosine between its middle and the
 * normal: of order 3. */
float vtkiDiskIrradiance(float sine, float cosine)
{
  float s2 = sine * sine;
  float c = sqrt(max(1.0f - s2, 0.0f));
  return max(0.5f * s2 / (1.0f + c) + 0.5f * s2 * cosine + 0.15625f * c * s2 * (3.0f * cosine * cosine - 1.0f), 0.0f);
}

/* Returns the sine of half the angle under which a sphere counts for a receiver of unit normal n;
 * toCenter from the receiver. Seen from outside it is r / d, also if the sphere crosses the
 * receiver's plane. Spheres that contain the receiver are mostly those of its own surface; farther
 * outside the sine blends into r / d, so that it is continuous. A drawn sphere (`drawn`) is the
 * receiver's own if its centre is straight below, to 18 degrees: normals and positions are those of
 * its facets or of an intersecting neighbour's, and the farther the centre is aside, the more of
 * the sphere is above the plane. Spheres that represent a surface may lie on either side of it. A
 * sphere with its centre below the plane is shrunk until it ends at the plane; one with its centre
 * above hides more the higher that is, all of its side from a quarter of the radius on, and the
 * blend extends as far outside. Too bright within that distance beside a body half sunk into the
 * ground. */
float vtkiProxySine(vec3 toCenter, float radius, vec3 n, bool drawn)
{
  float d = length(toCenter);
  if (!(radius > 0.0f))
  {
    return 0.0f;
  }
  float seen = d > radius ? radius / d : 1.0f;
  float outside = min(max((drawn ? 100.0f : 4.0f) * (d / radius - 1.0f), 0.0f), 1.0f);
  outside = outside * outside * (3.0f - 2.0f * outside);
  float height = dot(toCenter, n);
  float own = height < 0.0f ? min(-height / d, seen) : seen * min(4.0f * height / radius, 1.0f);
  if (drawn)
  {
    float aside = min(max(5.0f * (height / max(d, 1.0e-30f) + 0.95f), 0.0f), 1.0f);
    own = seen * aside * aside * (3.0f - 2.0f * aside);
  }
  return own + (seen - own) * outside;
}

/* 1 for a receiver inside of a sphere, or on its surface with its normal n, unit, towards the
 * sphere's centre; 0 for one that faces out of the sphere, and from half of the radius outside on:
 * a body's corners stand out of its spheres. Only an eye inside of a body sees such receivers: those
 * that an eye outside sees there face a body that stands beside them. */
float vtkiProxyInside(vec3 toCenter, float radius, vec3 n)
{
  float outside = length(toCenter) - radius;
  float into = min(max((dot(toCenter, n) - min(outside, 0.0f)) / (0.3f * radius) - 0.7f, 0.0f), 1.0f);
  return into * min(max(1.0f - outside / (0.5f * radius), 0.0f), 1.0f);
}

/* Returns the weight of a sphere by its height over the receiver's plane, from the cosine of its
 * middle and its own sine: zero for one wholly below, such as the receiver's own sphere, which
 * touches the plane. In order 4 such a sphere would ring into the upper half, as dark as 0.05 of
 * the sky, most of all where the ground fills the lower half as well. */
float vtkiProxyAbove(float cosine, float sine)
{
  float t = min(max(10.0f * (cosine / max(sine, 1.0e-30f) + 1.0f), 0.0f), 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

/* Returns the mean over the visible disk of band l at the sphere's normals, l = 0, 1, 2 (D0 to D2).
 */
vec3 vtkiProxyAverage(float sine)
{
  return vec3(0.28209479f, (0.08434643f * sine - 0.25075079f) * sine - 0.32493353f,
    ((-0.22261791f * sine + 0.22540738f) * sine + 0.47386883f) * sine + 0.15950106f);
}

/* Mean radiance of a sphere of albedo 1 in a unit direction d from the receiver, under light
 * without occlusion (Eq 15); `light` of one colour, its first nine coefficients. */
float vtkiProxyRadiance(vtkiHarmonics4 light, vec3 d, float sine)
{
  vec3 mean = vtkiProxyAverage(sine);
  // The clamped cosine over pi has 1, 2/3, 1/4 in these bands.
  vtkiHarmonics4 y = vtkiZonalTo(vec4(mean.x, mean.y * (2.0f / 3.0f), mean.z * 0.25f, 0.0f), d);
  return vtkiHarmonicsDot(y, light);
}

/* Returns the radiance at the sphere's middle (Eq 13): an error of 7 to 8 % where the mean has 0.3
 * %. */
float vtkiProxyRadianceAtMiddle(vtkiHarmonics4 light, vec3 d)
{
  return vtkiHarmonicsDot(vtkiClampedCosine(-d), light);
}

/* Returns half the gradient of band 2 of a function in the direction of a vector: its product with
 * the vector is the function. */
vec3 vtkiBandTwo(vtkiHarmonics4 f, vec3 v)
{
  float k = 0.54627422f;
  float z = 0.31539157f * f.B.z;
  return vec3(k * (f.B.x * v.y + f.B.w * v.z + f.C.x * v.x) - z * v.x,
    k * (f.B.x * v.x + f.B.y * v.z - f.C.x * v.y) - z * v.y, k * (f.B.y * v.y + f.B.w * v.x) + 2.0f * z * v.z);
}

/* Returns the irradiance at a unit normal n, in VTK's unit and over the sphere's solid angle, from
 * a sphere of albedo 1 in a unit direction d, each point as bright as its own normal makes it,
 * under light without occlusion (Eq 17); `light` of one colour, its first nine coefficients.
 * Instead of rotating light and result, both are decomposed along d and u, the part of n across d:
 * n is the cosine's only direction. */
float vtkiProxyExactIrradiance(vtkiProxyOperator m, vtkiHarmonics4 light, vec3 d, vec3 n)
{
  float c = dot(n, d);
  vec3 u = n - c * d;
  float s2 = dot(u, u);
  // Bands of the clamped cosine over pi about n, and of its convolution with the light, 1, 2/3 and
  // 1/4 of it.
  vec3 v = 0.32573501f * vec3(light.A.w, light.A.y, light.A.z);
  vec3 qd = vtkiBandTwo(light, d);
  vec3 qu = vtkiBandTwo(light, u);
  float dqd = dot(d, qd);
  vec3 to = vec3(0.28209479f, 0.32573501f * c, 0.07884789f * (3.0f * c * c - 1.0f));
  vec3 from = vec3(light.A.x, dot(v, d) / 0.48860251f, dqd * 0.39633273f);
  float sum = to.x * (m.A.x * from.x + m.A.y * from.y + m.A.z * from.z) +
    to.y * (m.A.w * from.x + m.B.x * from.y + m.B.y * from.z) +
    to.z * (m.B.z * from.x + m.B.w * from.y + m.C.x * from.z);
  // Terms of m = 1, both without the length of u.
  vec2 to1 = vec2(0.32573501f, 0.27313711f * c);
  vec2 from1 = vec2(dot(v, u) / 0.48860251f, 0.25f * dot(d, qu) / 0.54627422f);
  sum += to1.x * (m.C.y * from1.x + m.C.z * from1.y) + to1.y * (m.C.w * from1.x + m.D.x * from1.y);
  // Terms of m = 2, without its square.
  sum += 0.13656855f * m.D.y * 0.25f * (2.0f * dot(u, qu) + s2 * dqd) / 1.09254843f;
  return max(sum, 0.0f);
}

/* Occlusion by all spheres together over the sum of their solid angles (Eq 12): the factor of their
 * summed light. `seen` is the exponential, `solidAngle` the sum. */
float vtkiProxyOverlap(vtkiHarmonics4 seen, float solidAngle)
{
  float hidden = 4.0f * VTKI_PI * (1.0f - seen.A.x * VTKI_HARMONICS_Y00);
  return solidAngle > 0.0f ? min(max(hidden / solidAngle, 0.0f), 1.0f) : 0.0f;
}

/* Returns the occlusion of a uniform sky of radiance 1 by the spheres at a normal, over their
 * irradiance if all of them had radiance 1, each with its weight as a sender: the factor of their
 * summed light. So the occluders together send the weighted mean of their light in proportion to
 * the sky they hide. Solid angles would combine both sides of the receiver, which are crowded
 * behind a receiver on a body and sparse in front of it. */
float vtkiProxyMean(vtkiHarmonics4 seen, vec3 normal, float given)
{
  float hidden = 1.0f - vtkiHarmonicsDot(seen, vtkiClampedCosine(normal));
  return max(hidden, 0.0f) / max(given, 1.0e-6f);
}
#endif
