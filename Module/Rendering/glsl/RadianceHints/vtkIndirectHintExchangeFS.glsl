//VTK::System::Dec
//VTK::Output::Dec
// A further bounce at a hint as in the paper: the light of other hints within a range, weighted by
// their nearness to surfaces (Eq. 9) and by the probability of free sight (Eq. 11). Eq. 8 with its
// weights normalized once:
//   c_lm += 4 pi sum_j V_j w_j albedo_j E_j Y_lm(d_j) / sum_j V_j w_j,  w_j = 1 - nearest_j
// E_j: irradiance at hint j on a surface that faces this hint.
#include "vtkIndirectHintTexture.glsl"
#include "vtkIndirectHintOutput.glsl"
#ifdef VTKI_HINT_OCCUPANCY
#include "vtkIndirectOccupancy.glsl"
#endif

uniform sampler2D vtkiHintAlbedo;
uniform vec4 vtkiMeanAlbedo; // 1 in the last component: for all surfaces
uniform int vtkiSampleCount;
uniform float vtkiRange;
uniform int vtkiLobes;

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  int hint = vtkiTableEntry(at);
  vec4 place = texelFetch(vtkiHints, at, 0);
  vec2 own = texelFetch(vtkiHintDistance, at, 0).xy;
  vtkiGrid grid = vtkiGetGrid(vtkiGridOf(hint));
  int first = grid.first;
  ivec3 size = grid.size;
  vec3 reach = vtkiRange / grid.cell;
  int inGrid = hint - first;
  vec3 middle = vec3(inGrid % size.x, inGrid / size.x % size.y, inGrid / (size.x * size.y));
  vtkiField sum = vtkiZeroField();
  float weights = 0.0f;
  int found = 0;
  bool used = hint < vtkiHintCount && place.w > 0.0f;
  // Samples outside the range or the grid are repeated, with up to eight tries for each.
  int tries = used ? 8 * vtkiSampleCount : 0;
  for (int i = 0; i < tries && found < vtkiSampleCount; ++i)
  {
    vec3 lower = max(middle - reach, vec3(-0.5f));
    vec3 upper = min(middle + reach, vec3(size) - 0.5f);
    ivec3 other = ivec3(mix(lower, upper, vtkiSpread(i, uint(hint))) + 0.5f);
    other = clamp(other, ivec3(0), size - 1);
    int j = first + other.x + size.x * (other.y + size.y * other.z);
    vec4 there = texelFetch(vtkiHints, vtkiHintTexel(j), 0);
    vec3 toward = there.xyz - place.xyz;
    float r = length(toward);
    if (r > 0.0f && r <= vtkiRange && there.w > 0.0f)
    {
      vec4 distances = texelFetch(vtkiHintDistance, vtkiHintTexel(j), 0);
      float least = own.x + distances.x;
      float most = own.y + distances.y;
      float visible = most > least
        ? 1.0f - clamp((r / vtkiRange - least) / (most - least), 0.0f, 1.0f)
        : 1.0f;
#ifdef VTKI_HINT_OCCUPANCY
      visible =
        vtkiIsFree(vtkiToVoxels(place.xyz), vtkiToVoxels(there.xyz), true) ? 1.0f : 0.0f;
#endif
      float weight = visible * (1.0f - distances.x);
      vec3 direction = toward / r;
      vtkiField light = vtkiZeroField();
      vtkiAddHint(light, j, 1.0f);
      vec3 e = max(vtkiFieldIrradiance(light, -direction, vtkiLobes != 0), vec3(0.0f));
      vec3 albedo = vtkiMeanAlbedo.w > 0.0f
        ? vtkiMeanAlbedo.rgb
        : texelFetch(vtkiHintAlbedo, vtkiHintTexel(j), 0).rgb;
      vtkiAddLight(sum, weight * albedo * e, direction);
      weights += weight;
      ++found;
    }
  }
  for (int i = 0; i < VTKI_HINT_TEXTURES; ++i)
  {
    sum.c[i] *= weights > 0.0f ? 12.5663706f / weights : 0.0f;
  }
  vtkiWriteField(sum, vec4(0.0f));
}
