// The radiance field at a hint: spherical harmonics of the incoming radiance.
// VTKI_HINT_LAYOUT, the storage of colours:
//   0  order 2, red, green, blue: 12 numbers
//   1  order 3 of the luma, order 1 of the chroma: 11 numbers
//   2  order 3, red, green, blue: 27 numbers
#include "vtkIndirectLibHarmonics.glsl"

#ifndef VTKI_HINT_LAYOUT
#define VTKI_HINT_LAYOUT 0
#endif
#if VTKI_HINT_LAYOUT == 2
#define VTKI_HINT_TEXTURES 7
#else
#define VTKI_HINT_TEXTURES 3
#endif

struct vtkiField
{
  vec4 c[VTKI_HINT_TEXTURES];
};

vtkiField vtkiZeroField()
{
  vtkiField f;
  for (int i = 0; i < VTKI_HINT_TEXTURES; ++i)
  {
    f.c[i] = vec4(0.0f);
  }
  return f;
}

// light: radiance times solid angle, from a unit direction.
void vtkiAddLight(inout vtkiField f, vec3 light, vec3 direction)
{
  vec4 low = vtkiHarmonicsLow(direction);
#if VTKI_HINT_LAYOUT == 1
  float luma = dot(light, vec3(0.25f, 0.5f, 0.25f));
  f.c[0] += luma * low;
  f.c[1] += luma * vtkiHarmonicsHigh(direction);
  f.c[2] += vec4(luma * vtkiHarmonicsLast(direction), light.r - light.b,
    light.g - 0.5f * (light.r + light.b), 0.0f);
#else
  f.c[0] += light.r * low;
  f.c[1] += light.g * low;
  f.c[2] += light.b * low;
#endif
#if VTKI_HINT_LAYOUT == 2
  vec4 high = vtkiHarmonicsHigh(direction);
  f.c[3] += light.r * high;
  f.c[4] += light.g * high;
  f.c[5] += light.b * high;
  f.c[6] += vec4(light * vtkiHarmonicsLast(direction), 0.0f);
#endif
}

// Returns the irradiance on a surface of this normal. lobes: without ringing, otherwise linear in
// the field.
vec3 vtkiFieldIrradiance(vtkiField f, vec3 normal, bool lobes)
{
#if VTKI_HINT_LAYOUT == 1
  float luma = vtkiIrradianceLow(f.c[0], normal) + vtkiIrradianceHigh(f.c[1], f.c[2].x, normal);
  if (lobes)
  {
    luma = max(luma, 0.0f);
  }
  // The chroma has no direction of its own and follows the luma. total: of all light around.
  float total = f.c[0].x / 0.28209479f;
  vec2 chroma = total > 0.0f ? f.c[2].yz / total : vec2(0.0f);
  // light = luma (1, 1, 1) + the two differences' contribution
  return luma * vec3(1.0f + 0.5f * (chroma.x - chroma.y), 1.0f + 0.5f * chroma.y,
    1.0f - 0.5f * (chroma.x + chroma.y));
#else
  vec3 e = vec3(0.0f);
#if VTKI_HINT_LAYOUT == 0
  if (lobes)
  {
    return vec3(vtkiIrradianceLobe(f.c[0], normal), vtkiIrradianceLobe(f.c[1], normal),
      vtkiIrradianceLobe(f.c[2], normal));
  }
#endif
  e = vec3(vtkiIrradianceLow(f.c[0], normal), vtkiIrradianceLow(f.c[1], normal),
    vtkiIrradianceLow(f.c[2], normal));
#if VTKI_HINT_LAYOUT == 2
  e += vec3(vtkiIrradianceHigh(f.c[3], f.c[6].x, normal),
    vtkiIrradianceHigh(f.c[4], f.c[6].y, normal), vtkiIrradianceHigh(f.c[5], f.c[6].z, normal));
#endif
  return lobes ? max(e, vec3(0.0f)) : e;
#endif
}
