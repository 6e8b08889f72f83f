// Light that senders of the maps bring to a hint.
#include "vtkIndirectHintField.glsl"
#include "vtkIndirectHintPlaces.glsl"
#include "vtkIndirectHintOutput.glsl"
#include "vtkIndirectHintDepth.glsl"
#ifdef VTKI_HINT_OCCUPANCY
#include "vtkIndirectOccupancy.glsl"
#endif

uniform float vtkiRange;     // scene units that distances are stored in
uniform float vtkiSoftening; // least area of a sender as a share of the cell's face

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

// position: of the hint, or near it. softening: see vtkiPatchSolidAngle.
void vtkiAddSender(inout vtkiHintSums sums, vec3 position, vec3 sender, vec3 normal, float area,
  vec3 densityArea, float softening)
{
  vec3 toSender = sender - position;
  float r = length(toSender);
  float angle = vtkiPatchSolidAngle(toSender, normal, softening);
  float mirrored = vtkiPatchSolidAngle(toSender, -normal, softening);
  sums.nearest = min(sums.nearest, r);
  sums.farthest = max(sums.farthest, r);
  sums.front += area * angle;
  sums.back += area * mirrored;
  vec3 light = densityArea * angle;
  bool lit = max(max(light.r, light.g), light.b) > 0.0f && r > 0.0f;
  float share = 1.0f;
#ifdef VTKI_HINT_OCCUPANCY
  // To a voxel and a half in front of the sender, whose own voxels do not hide it.
  share = vtkiIsFree(vtkiToVoxels(position), vtkiToVoxels(sender) + 1.5f * normal, lit) ? 1.0f : 0.0f;
#endif
  share *= vtkiDepthShare(position, sender, lit);
  if (lit)
  {
    vtkiAddLight(sums.field, light * share, toSender / r);
  }
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
