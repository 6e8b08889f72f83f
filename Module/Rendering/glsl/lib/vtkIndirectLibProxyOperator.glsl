// Light that a sphere reflects, over its solid angle, for a light along +z: the operator of
// "Image-Based Proxy Accumulation for Real-Time Soft Global Illumination", Sloan, Govindaraju,
// Nowrouzezahrai, Snyder 2007, Eq 16. Written by Testing/Reference/fit_sphere_proxies.py; not to be edited.
#ifndef vtkIndirectLibProxyOperator
#define vtkIndirectLibProxyOperator
#include "vtkIndirectLibPortable.glsl"

/* Means over the visible disk of a function of the direction times one of the sphere's normal there, of the
 * same m; by bands of direction and normal. m = 0: 00, 01, 02, 10; 11, 12, 20, 21; 22; m = 1, or -1: 11, 12, 21;
 * 22; m = 2, or -2: 22. */
struct vtkiProxyOperator
{
  vec4 A;
  vec4 B;
  vec4 C;
  vec4 D;
};

/* By the sine of half the angle, from 0 to 1. */
vtkiProxyOperator vtkiExactOperator(float sine)
{
  float s2 = sine * sine;
  float s3 = s2 * sine;
  float c = sqrt(max(1.0f - s2, 0.0f));
  float sc = sine * c;
  float s2c = s2 * c;
  vtkiProxyOperator m;
  m.A = vec4(0.0795775f, -0.1137522f, 0.1741226f, 0.0689161f);
  m.A += sine * vec4(0.0000000f, -0.0528553f, 0.0160682f, 0.0000000f);
  m.A += s2 * vec4(0.0000000f, 0.0393495f, -0.0344019f, 0.0000000f);
  m.A += s3 * vec4(0.0000000f, -0.0105517f, 0.0221025f, 0.0000000f);
  m.A += c * vec4(0.0000000f, 0.0218612f, -0.1296321f, 0.0689161f);
  m.A += sc * vec4(0.0000000f, -0.0159561f, 0.1260946f, 0.0000000f);
  m.A += s2c * vec4(0.0000000f, -0.0063577f, 0.0045544f, 0.0000000f);
  m.B = vec4(-0.0805848f, 0.0145823f, 0.0889703f, -0.0724094f);
  m.B += sine * vec4(-0.0785378f, 0.1997618f, 0.0000000f, -0.0688231f);
  m.B += s2 * vec4(0.0322972f, 0.0446348f, -0.0889703f, 0.0440428f);
  m.B += s3 * vec4(0.0074352f, -0.1048127f, 0.0000000f, 0.0971796f);
  m.B += c * vec4(-0.0785681f, 0.0624638f, 0.0889703f, -0.1330575f);
  m.B += sc * vec4(-0.0409005f, 0.0469520f, 0.0000000f, -0.0853249f);
  m.B += s2c * vec4(0.0006376f, 0.0431629f, 0.0000000f, 0.0644837f);
  m.C = vec4(-0.5574259f, 0.1324626f, -0.2809349f, 0.0262620f);
  m.C += sine * vec4(0.8080992f, -0.0880221f, 0.2252331f, 0.0738530f);
  m.C += s2 * vec4(0.3730140f, -0.0898058f, 0.0963688f, -0.0508281f);
  m.C += s3 * vec4(-0.6240227f, 0.0450387f, -0.0399460f, -0.0492955f);
  m.C += c * vec4(0.6569343f, -0.1324470f, 0.2809014f, -0.0262609f);
  m.C += sc * vec4(-0.4910293f, 0.1471680f, -0.2952617f, 0.0595620f);
  m.C += s2c * vec4(0.0396021f, -0.0039153f, -0.0096300f, -0.0331258f);
  m.D = vec4(0.2446797f, -0.1246387f, 0.0000000f, 0.0000000f);
  m.D += sine * vec4(-0.4300567f, 0.1286949f, 0.0000000f, 0.0000000f);
  m.D += s2 * vec4(-0.1973927f, 0.1081471f, 0.0000000f, 0.0000000f);
  m.D += s3 * vec4(0.3830667f, -0.1122409f, 0.0000000f, 0.0000000f);
  m.D += c * vec4(-0.2447120f, 0.1246428f, 0.0000000f, 0.0000000f);
  m.D += sc * vec4(0.2720113f, -0.1288309f, 0.0000000f, 0.0000000f);
  m.D += s2c * vec4(-0.0331908f, 0.0049030f, 0.0000000f, 0.0000000f);
  return m;
}
#endif
