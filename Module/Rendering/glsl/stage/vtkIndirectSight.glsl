// Whether a receiver sees a sender, from the clearance of the scene's voxels.
#include "vtkIndirectLibClearance.glsl"

uniform usampler3D vtkiClearance;  // voxels to the nearest occupied one
uniform vec4 vtkiClearanceOrigin;  // scene units; voxels per scene unit
uniform vec3 vtkiClearanceSize;    // voxels

// A step of a walk: whether all is clear so far, and whether there is more.
void vtkiStepOn(inout vtkiLeap leap, inout bool clear, inout bool more)
{
  ivec3 at = clamp(leap.voxel, ivec3(0), ivec3(vtkiClearanceSize) - 1);
  int clearance = int(texelFetch(vtkiClearance, at, 0).r);
  bool blocked = clearance == 0 && at == leap.voxel;
  clear = clear && !(more && blocked);
  bool on = vtkiLeapOn(leap, max(clearance, 1));
  more = more && !blocked && on && leap.voxel != leap.last;
}

// Whether the segment meets no occupied voxel besides those of its ends. With test false nothing is
// looked up, which a branch around this would not save.
bool vtkiIsClear(vec3 start, vec3 end, bool test)
{
  vtkiLeap leap = vtkiBeginLeap(start, end);
  bool clear = true;
  bool on = vtkiLeapOn(leap, 1);
  bool more = test && on && leap.voxel != leap.last;
  // Four at a time: llvmpipe ends all loops of a shader after 65535 rounds together.
  while (more)
  {
    vtkiStepOn(leap, clear, more);
    vtkiStepOn(leap, clear, more);
    vtkiStepOn(leap, clear, more);
    vtkiStepOn(leap, clear, more);
  }
  return clear;
}

bool vtkiIsEmpty(vec3 place)
{
  ivec3 voxel = ivec3(floor(place));
  ivec3 at = clamp(voxel, ivec3(0), ivec3(vtkiClearanceSize) - 1);
  return texelFetch(vtkiClearance, at, 0).r > 0u || at != voxel;
}

// In voxels, a place near a surface that none of its own voxels blocks, nor, if there is such a place,
// another's.
vec3 vtkiOpenPlace(vec3 position, vec3 normal)
{
  vec3 voxels = (position - vtkiClearanceOrigin.xyz) * vtkiClearanceOrigin.w;
  vec3 place = voxels + vtkiClearHeight(normal) * normal;
  vec3 open = place;
  bool empty = vtkiIsEmpty(place);
  for (int i = 0; i < VTKI_ASIDE && !empty; ++i)
  {
    vec3 aside = place + vtkiAside(i, normal);
    empty = vtkiIsEmpty(aside);
    open = empty ? aside : open;
  }
  return open;
}

// Whether nothing stands between two surfaces, whose own voxels do not count. start: the receiver's
// open place.
bool vtkiSees(vec3 start, vec3 position, vec3 normal, vec3 sender, vec3 senderNormal, bool test)
{
  vec3 receiver = (position - vtkiClearanceOrigin.xyz) * vtkiClearanceOrigin.w;
  vec3 light = (sender - vtkiClearanceOrigin.xyz) * vtkiClearanceOrigin.w;
  vec3 end = vtkiClearOf(
    vtkiOpenPlace(sender, senderNormal), senderNormal, receiver, normal, vtkiClearHeight(normal));
  return vtkiIsClear(
    vtkiClearOf(start, normal, light, senderNormal, vtkiClearHeight(senderNormal)), end, test);
}
