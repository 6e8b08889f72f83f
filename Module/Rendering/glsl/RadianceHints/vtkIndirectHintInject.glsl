// Light that senders of the maps bring to a hint.
#include "vtkIndirectHintField.glsl"
#include "vtkIndirectHintPlaces.glsl"
#include "vtkIndirectHintOutput.glsl"
#include "vtkIndirectHintDepth.glsl"
#ifdef VTKI_HINT_OCCUPANCY
#include "vtkIndirectLibSurface.glsl"

uniform sampler2D vtkiRays; // four surfaces a texel, -1 where a ray meets none
uniform sampler2D vtkiSurfelPosition;
uniform sampler2D vtkiSurfelNormal;
uniform int vtkiRayEdge;
uniform int vtkiRayRowLength;

// Whether a sender is in front of the surface that the ray of its direction meets, or on it. The
// plane of that surface, not its distance: a bin of directions spans many distances on a wall that is
// seen from the side.
float vtkiSeen(int hint, vec3 sender, vec3 direction)
{
  vec2 uv = 0.5f * vtkiOctahedralEncode(direction) + 0.5f;
  ivec2 bin = ivec2(min(uv * float(vtkiRayEdge), vec2(float(vtkiRayEdge) - 0.5f)));
  int ray = hint * vtkiRayEdge * vtkiRayEdge + bin.x + vtkiRayEdge * bin.y;
  int texel = ray / 4;
  vec4 four = texelFetch(vtkiRays, ivec2(texel % vtkiRayRowLength, texel / vtkiRayRowLength), 0);
  int surfel = int(four[ray & 3]);
  ivec2 at = vtkiTableTexel(max(surfel, 0));
  // The last number: how far behind its mean plane a sender may lie on the surface.
  vec4 surface = texelFetch(vtkiSurfelPosition, at, 0);
  float height = dot(sender - surface.xyz, texelFetch(vtkiSurfelNormal, at, 0).xyz);
  return surfel < 0 || height > -surface.w ? 1.0f : 0.0f;
}
#endif

uniform float vtkiRange;     // scene units that distances are stored in
uniform float vtkiSoftening; // least area of a sender as a share of the cell's face

// The hint that a fragment is for.
struct vtkiHintPlace
{
  int hint;
  vec3 position;
  vec3 cell;  // its size
  float face; // mean area of a face of it
  bool used;
};

vtkiHintPlace vtkiFetchHintPlace()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  int hint = vtkiTableEntry(at);
  vec4 place = texelFetch(vtkiHints, at, 0);
  vec3 cell = vtkiGetGrid(vtkiGridOf(hint)).cell;
  return vtkiHintPlace(hint, place.xyz, cell, pow(cell.x * cell.y * cell.z, 2.0f / 3.0f),
    hint < vtkiHintCount && place.w > 0.0f);
}

struct vtkiHintSums
{
  vtkiField field;
  float nearest;
  float farthest;
  float front; // solid angle of senders that face the hint, and that do not
  float back;
};

vtkiHintSums vtkiBeginHint()
{
  return vtkiHintSums(vtkiZeroField(), 1.0e30f, 0.0f, 0.0f, 0.0f);
}

// position: of the hint, or near it. softening: see vtkiPatchOffset.
void vtkiAddSender(inout vtkiHintSums sums, int hint, vec3 position, vec3 sender, vec3 normal, float area,
  vec3 densityArea, float softening)
{
  vec3 toSender = sender - position;
  float r = length(toSender);
  vec3 offset = vtkiPatchOffset(toSender, normal, softening);
  float angle = vtkiPatchSolidAngle(offset, normal);
  float mirrored = vtkiPatchSolidAngle(vtkiPatchOffset(toSender, -normal, softening), -normal);
  sums.nearest = min(sums.nearest, r);
  sums.farthest = max(sums.farthest, r);
  sums.front += area * angle;
  sums.back += area * mirrored;
  vec3 light = densityArea * angle;
  bool lit = max(max(light.r, light.g), light.b) > 0.0f && r > 0.0f;
  float share = 1.0f;
#ifdef VTKI_HINT_OCCUPANCY
  share = vtkiSeen(hint, sender, r > 0.0f ? toSender / r : normal);
#endif
  share *= vtkiDepthShare(position, sender, lit);
  if (lit)
  {
    vtkiAddLight(sums.field, light * share, normalize(offset));
  }
}

// Light from a direction; light: radiance times solid angle. What the hint does not see of it counts
// like a sender that is turned away.
void vtkiAddDirection(
  inout vtkiHintSums sums, int hint, vec3 position, vec3 direction, float solidAngle, vec3 light)
{
  float share = 1.0f;
#ifdef VTKI_HINT_OCCUPANCY
  // From farther away than anything in the scene.
  share = vtkiSeen(hint, position + 4.0f * direction, direction);
#endif
  sums.front += solidAngle * share;
  sums.back += solidAngle * (1.0f - share);
  vtkiAddLight(sums.field, light * share, direction);
}

void vtkiEndHint(vtkiHintSums sums)
{
  float turned = sums.front + sums.back;
  // Inside of closed surfaces all senders face the hint; outside, or in a solid, as many do not.
  float facing = turned > 0.0f ? clamp((sums.front - sums.back) / turned, 0.0f, 1.0f) : 0.0f;
  vtkiWriteField(sums.field,
    vec4(min(sums.nearest, vtkiRange) / vtkiRange, min(sums.farthest, vtkiRange) / vtkiRange, facing,
      0.0f));
}
