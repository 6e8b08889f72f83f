// Whether a sender is visible from a receiver: with VTKI_DEPTH_TILES by the sender's own depth map; else, with
// VTKI_VOXEL_SEGMENTS, by the distance field of the scene's voxels and, with VTKI_SPHERE_SEGMENTS, by spheres, which
// voxels do not hold.
#ifdef VTKI_DEPTH_TILES
#include "vtkIndirectDepthTiles.glsl"

// What look-ups ask of a receiver beside its place: the normal of its facet, which is what maps hold.
vec3 vtkiOpenPlace(vec3 position, vec3 normal, vec3 facet)
{
  return facet;
}

#ifdef VTKI_SHARED_TILES
#include "vtkIndirectLibTable.glsl"

// Whose tile each light looks up: place and tile in the upper half, axis in the lower one.
uniform sampler2D vtkiTileOwners;
#endif

// Whose map tells what a light sees: its own, or, where tiles are shared, a neighbour's. light: its number.
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

// A direction has no tile. facet: see vtkiOpenPlace.
bool vtkiIsSenderVisible(
  int light, vec3 facet, vec3 position, vec3 normal, vec4 sender, vec3 senderNormal, bool test)
{
  return vtkiIsSeenInTile(vtkiFetchTile(light, sender.xyz, senderNormal), position, facet) ||
    sender.w < 0.0f;
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

// A step of a walk: whether all is clear so far, and whether there is more.
void vtkiStepOn(inout vtkiLeap leap, inout bool clear, inout bool more)
{
  ivec3 at = clamp(leap.voxel, ivec3(0), ivec3(vtkiDistanceFieldSize) - 1);
  int freeVoxels = int(texelFetch(vtkiDistanceField, at, 0).r);
  bool blocked = freeVoxels == 0 && at == leap.voxel;
  clear = clear && !(more && blocked);
  bool on = vtkiLeapOn(leap, max(freeVoxels, 1));
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
  ivec3 at = clamp(voxel, ivec3(0), ivec3(vtkiDistanceFieldSize) - 1);
  return texelFetch(vtkiDistanceField, at, 0).r > 0u || at != voxel;
}

// In voxels, a place near a surface that none of its own voxels blocks, nor, if there is such a place,
// another's.
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

// Whether no voxels stand between two surfaces, whose own ones do not count. start: the receiver's
// open place.
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

// Where a way in a direction has left the voxels.
vec3 vtkiLeaveVoxels(vec3 position, vec3 direction)
{
  vec3 lower = vtkiDistanceFieldOrigin.xyz;
  vec3 upper = lower + vtkiDistanceFieldSize / vtkiDistanceFieldOrigin.w;
  vec3 way = mix(lower, upper, greaterThan(direction, vec3(0.0f))) - position;
  // Twice the diagonal of the scene where a direction is along the others' plane.
  vec3 far = vec3(2.0f);
  vec3 exits = mix(far, way / direction, greaterThan(abs(direction), vec3(1.0e-6f)));
  float leave = clamp(min(exits.x, min(exits.y, exits.z)), 0.0f, 2.0f);
  // Two voxels further on nothing is.
  return position + (leave + 2.0f / vtkiDistanceFieldOrigin.w) * direction;
}
#else
// Spheres need no place but the surface's own.
vec3 vtkiOpenPlace(vec3 position, vec3 normal)
{
  return position;
}
#endif

vec3 vtkiOpenPlace(vec3 position, vec3 normal, vec3 facet)
{
  return vtkiOpenPlace(position, normal);
}

// Whether nothing stands between two surfaces. start: the receiver's open place; voxelEnd, sphereEnd: the sender's
// place, as voxels and spheres are asked.
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

// The same of a virtual light: a place, or with VTKI_DIRECTIONS a direction, which is seen where
// nothing stands on the way out of the scene.
bool vtkiIsSenderVisible(
  int light, vec3 start, vec3 position, vec3 normal, vec4 sender, vec3 senderNormal, bool test)
{
  vec3 voxelEnd = sender.xyz;
  vec3 sphereEnd = sender.xyz;
#ifdef VTKI_DIRECTIONS
  if (sender.w < 0.0f)
  {
    // Twice the diagonal of the scene.
    sphereEnd = position + 2.0f * sender.xyz;
#ifdef VTKI_VOXEL_SEGMENTS
    voxelEnd = vtkiLeaveVoxels(position, sender.xyz);
#endif
  }
#endif
  return vtkiIsVisibleFrom(start, position, normal, voxelEnd, sphereEnd, senderNormal, test);
}
#endif
