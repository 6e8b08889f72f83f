// Tests the visibility of a sender from a receiver: with VTKI_DEPTH_TILES by the sender's own depth
// map; otherwise with VTKI_VOXEL_SEGMENTS by the distance field of the scene's voxels, and with
// VTKI_SPHERE_SEGMENTS by spheres, which the voxels do not contain.
#ifdef VTKI_DEPTH_TILES
#include "vtkIndirectDepthTiles.glsl"
#include "vtkIndirectCrease.glsl"

// The receiver's crease. A receiver that is not at a pixel has none.
vtkiCrease vtkiReceiverCrease = vtkiCrease(vec3(0.0f), 0.0f, 0.0f);

// The receiver's data, beside its position, for look-ups: the normal of its facet, which the maps
// hold.
vec3 vtkiOpenPlace(vec3 position, vec3 normal, vec3 facet)
{
  return facet;
}

// Returns the same for a receiver at a pixel, whose crease hides lights.
vec3 vtkiOpenPlace(vec3 position, vec3 normal, vec3 facet, ivec2 pixel)
{
  vtkiReceiverCrease = vtkiFetchCrease(pixel);
  return facet;
}

#ifdef VTKI_SHARED_TILES
#include "vtkIndirectLibTable.glsl"

// This is the owner of the tile that each light looks up: position and tile in the upper half, axis
// in the lower half.
uniform sampler2D vtkiTileOwners;
#endif

// The tile for a light: its own, or a neighbour's if tiles are shared. light: its number.
vtkiTile vtkiFetchTile(int light, vec3 place, vec3 axis)
{
#ifdef VTKI_SHARED_TILES
  ivec2 at = vtkiTableTexel(light);
  vec4 owner = texelFetch(vtkiTileOwners, at, 0);
  int rows = textureSize(vtkiTileOwners, 0).y / 2;
  return vtkiMakeTile(
    int(owner.w + 0.5f), owner.xyz, texelFetch(vtkiTileOwners, at + ivec2(0, rows), 0).xyz);
#else
#ifdef VTKI_DIVIDED
  axis = normalize(axis);
#endif
  return vtkiMakeTile(light, place, axis);
#endif
}

// Directions have no tile and are not tested. facet: see vtkiOpenPlace.
bool vtkiIsSenderVisible(
  int light, vec3 facet, vec3 position, vec3 normal, vec4 sender, vec3 senderNormal, bool test)
{
  return sender.w < 0.0f ||
    (vtkiIsSeenInTile(vtkiFetchTile(light, sender.xyz, senderNormal), position, facet) &&
      !vtkiHidesInCrease(vtkiReceiverCrease, position, sender.xyz - position));
}
#else
#ifdef VTKI_SPHERE_SEGMENTS
#include "vtkIndirectSphereSegments.glsl"
#endif

#ifdef VTKI_VOXEL_SEGMENTS
#include "vtkIndirectLibDistanceField.glsl"

uniform usampler3D vtkiDistanceField;  // voxels to the nearest occupied one
uniform vec4 vtkiDistanceFieldOrigin;  // scene units; voxels per scene unit
uniform vec3 vtkiDistanceFieldSize;    // voxels

// One step of a walk. clear: no occupied voxel so far; more: the walk goes on.
void vtkiStepOn(inout vtkiLeap leap, inout bool clear, inout bool more)
{
  ivec3 at = clamp(leap.voxel, ivec3(0), ivec3(vtkiDistanceFieldSize) - 1);
  int freeVoxels = int(texelFetch(vtkiDistanceField, at, 0).r);
  bool blocked = freeVoxels == 0 && at == leap.voxel;
  clear = clear && !(more && blocked);
  bool on = vtkiLeapOn(leap, max(freeVoxels, 1));
  more = more && !blocked && on && leap.voxel != leap.last;
}

// Returns true if the segment meets no occupied voxel besides those of its ends. With test false no
// voxel is looked up, which a branch around the call would not save.
bool vtkiIsClear(vec3 start, vec3 end, bool test)
{
  vtkiLeap leap = vtkiBeginLeap(start, end);
  bool clear = true;
  bool on = vtkiLeapOn(leap, 1);
  bool more = test && on && leap.voxel != leap.last;
  // Four steps at a time: llvmpipe ends all loops of a shader after 65535 rounds in total.
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
  ivec3 at = clamp(voxel, ivec3(0), ivec3(vtkiDistanceFieldSize) - 1);
  return texelFetch(vtkiDistanceField, at, 0).r > 0u || at != voxel;
}

// Returns a position near a surface, in voxels, that none of the surface's own voxels blocks and,
// if possible, none of another surface's.
vec3 vtkiOpenPlace(vec3 position, vec3 normal)
{
  vec3 voxels = (position - vtkiDistanceFieldOrigin.xyz) * vtkiDistanceFieldOrigin.w;
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

// Returns true if no voxels stand between two surfaces, apart from their own voxels. start: the
// receiver's open place.
bool vtkiIsFreeOfVoxels(
  vec3 start, vec3 position, vec3 normal, vec3 sender, vec3 senderNormal, bool test)
{
  vec3 receiver = (position - vtkiDistanceFieldOrigin.xyz) * vtkiDistanceFieldOrigin.w;
  vec3 light = (sender - vtkiDistanceFieldOrigin.xyz) * vtkiDistanceFieldOrigin.w;
  vec3 end = vtkiClearOf(
    vtkiOpenPlace(sender, senderNormal), senderNormal, receiver, normal, vtkiClearHeight(normal));
  return vtkiIsClear(
    vtkiClearOf(start, normal, light, senderNormal, vtkiClearHeight(senderNormal)), end, test);
}

// Returns the position where a ray has left the voxels.
vec3 vtkiLeaveVoxels(vec3 position, vec3 direction)
{
  vec3 lower = vtkiDistanceFieldOrigin.xyz;
  vec3 upper = lower + vtkiDistanceFieldSize / vtkiDistanceFieldOrigin.w;
  vec3 way = mix(lower, upper, greaterThan(direction, vec3(0.0f))) - position;
  // An axis that the direction does not move along gets twice the scene's diagonal.
  vec3 far = vec3(2.0f);
  vec3 exits = mix(far, way / direction, greaterThan(abs(direction), vec3(1.0e-6f)));
  float leave = clamp(min(exits.x, min(exits.y, exits.z)), 0.0f, 2.0f);
  // Two voxels further on, the ray is outside the scene.
  return position + (leave + 2.0f / vtkiDistanceFieldOrigin.w) * direction;
}
#else
// Sphere tests start at the surface's own position.
vec3 vtkiOpenPlace(vec3 position, vec3 normal)
{
  return position;
}
#endif

vec3 vtkiOpenPlace(vec3 position, vec3 normal, vec3 facet)
{
  return vtkiOpenPlace(position, normal);
}

vec3 vtkiOpenPlace(vec3 position, vec3 normal, vec3 facet, ivec2 pixel)
{
  return vtkiOpenPlace(position, normal);
}

// Returns true if no occluder stands between two surfaces. start: the receiver's open place;
// voxelEnd, sphereEnd: the sender's position for the tests of voxels and spheres.
bool vtkiIsVisibleFrom(vec3 start, vec3 position, vec3 normal, vec3 voxelEnd, vec3 sphereEnd, vec3 senderNormal,
  bool test)
{
  bool visible = true;
#ifdef VTKI_SPHERE_SEGMENTS
  visible = vtkiIsFreeOfSpheres(position, sphereEnd, test);
#endif
#ifdef VTKI_VOXEL_SEGMENTS
  visible = vtkiIsFreeOfVoxels(start, position, normal, voxelEnd, senderNormal, test && visible) && visible;
#endif
  return visible;
}

bool vtkiIsVisible(vec3 start, vec3 position, vec3 normal, vec3 sender, vec3 senderNormal, bool test)
{
  return vtkiIsVisibleFrom(start, position, normal, sender, sender, senderNormal, test);
}

// vtkiIsVisibleFrom for a virtual light: a position, or with VTKI_DIRECTIONS a direction, which is
// visible if the ray leaves the scene unoccluded.
bool vtkiIsSenderVisible(
  int light, vec3 start, vec3 position, vec3 normal, vec4 sender, vec3 senderNormal, bool test)
{
  vec3 voxelEnd = sender.xyz;
  vec3 sphereEnd = sender.xyz;
#ifdef VTKI_DIRECTIONS
  if (sender.w < 0.0f)
  {
    // A distance of twice the scene's diagonal.
    sphereEnd = position + 2.0f * sender.xyz;
#ifdef VTKI_VOXEL_SEGMENTS
    voxelEnd = vtkiLeaveVoxels(position, sender.xyz);
#endif
  }
#endif
  return vtkiIsVisibleFrom(start, position, normal, voxelEnd, sphereEnd, senderNormal, test);
}
#endif
