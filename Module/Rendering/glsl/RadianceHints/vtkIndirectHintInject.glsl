// Light of the maps' senders at a hint.
#include "vtkIndirectHintField.glsl"
#include "vtkIndirectHintPlaces.glsl"
#include "vtkIndirectHintOutput.glsl"
#include "vtkIndirectHintDepth.glsl"
#ifdef VTKI_HINT_OCCUPANCY
#include "vtkIndirectLibSurface.glsl"

uniform sampler2D vtkiRays; // four surfaces a texel, -1 for a ray that meets none
uniform sampler2D vtkiSurfelPosition;
uniform sampler2D vtkiSurfelNormal;
uniform int vtkiRayEdge;
uniform int vtkiRayRowLength;

// 1 if a sender is on or in front of the surface that the ray in its direction meets. Compared with
// the surface's plane, not its distance: a bin of directions spans many distances on a wall seen
// from the side.
float vtkiSeen(int hint, vec3 sender, vec3 direction)
{
  vec2 uv = 0.5f * vtkiOctahedralEncode(direction) + 0.5f;
  ivec2 bin = ivec2(min(uv * float(vtkiRayEdge), vec2(float(vtkiRayEdge) - 0.5f)));
  int ray = hint * vtkiRayEdge * vtkiRayEdge + bin.x + vtkiRayEdge * bin.y;
  int texel = ray / 4;
  vec4 four = texelFetch(vtkiRays, ivec2(texel % vtkiRayRowLength, texel / vtkiRayRowLength), 0);
  int surfel = int(four[ray & 3]);
  ivec2 at = vtkiTableTexel(max(surfel, 0));
  // The last component is the depth behind its mean plane at which a sender may lie on the surface.
  vec4 surface = texelFetch(vtkiSurfelPosition, at, 0);
  float height = dot(sender - surface.xyz, texelFetch(vtkiSurfelNormal, at, 0).xyz);
  return surfel < 0 || height > -surface.w ? 1.0f : 0.0f;
}
#endif

uniform float vtkiRange;     // scene units; scale of stored distances
uniform float vtkiSoftening; // least area of a sender as a share of the cell's face

// This is the hint of a fragment.
struct vtkiHintPlace
{
  int hint;
  vec3 position;
  vec3 cell;  // size of its cell
  float face; // mean area of the cell's faces
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
  float front; // solid angle of senders that face the hint; back: of the others
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

// Light from a direction; light: radiance times solid angle. The part that the hint does not see
// counts as a sender that faces away.
void vtkiAddDirection(
  inout vtkiHintSums sums, int hint, vec3 position, vec3 direction, float solidAngle, vec3 light)
{
  float share = 1.0f;
#ifdef VTKI_HINT_OCCUPANCY
  // The sender lies beyond all of the scene.
  share = vtkiSeen(hint, position + 4.0f * direction, direction);
#endif
  sums.front += solidAngle * share;
  sums.back += solidAngle * (1.0f - share);
  vtkiAddLight(sums.field, light * share, direction);
}

void vtkiEndHint(vtkiHintSums sums)
{
  float turned = sums.front + sums.back;
  // Inside closed surfaces all senders face the hint; outside, or in a solid, as many face away.
  float facing = turned > 0.0f ? clamp((sums.front - sums.back) / turned, 0.0f, 1.0f) : 0.0f;
  vtkiWriteField(sums.field,
    vec4(min(sums.nearest, vtkiRange) / vtkiRange, min(sums.farthest, vtkiRange) / vtkiRange, facing,
      0.0f));
}
