// Irradiance at a surface from the surrounding hints. VTKI_HINT_OCCUPANCY: hints that the surface
// does not see have no weight.
#include "vtkIndirectHintTexture.glsl"
#ifdef VTKI_HINT_OCCUPANCY
#include "vtkIndirectLibPlane.glsl"
#include "vtkIndirectOccupancy.glsl"
// This is one texel a voxel: for a free voxel the surrounding hints visible from it, one channel a
// grid; for an occupied voxel the plane of its surface.
uniform sampler3D vtkiMasks;

const int VTKI_ASIDE_STEPS = 2; // steps out of the voxels of two walls that meet

// The first free voxel before a surface (voxel coordinates), along its normal, or aside if an
// adjacent wall fills the voxels there. If there is none, the last one tried.
void vtkiFindOpen(vec3 place, vec3 normal, out vec3 open, out vec3 aside)
{
  bool found = false;
  open = place;
  aside = vec3(0.0f);
  // The loop's condition comes last, see vtkiHintIrradiance.
  int tried = 0;
  do
  {
    vec3 before = place + (1.0f + 0.5f * float(tried)) * normal;
    open = before;
    found = !vtkiIsOccupied(ivec3(floor(open)));
    bool more = !found;
    for (int k = 0; k < VTKI_ASIDE_STEPS && more; ++k)
    {
      ivec3 voxel = clamp(ivec3(floor(open)), ivec3(0), ivec3(vtkiOccupancySize) - 1);
      ivec2 bytes = ivec2(textureLod(vtkiMasks, (vec3(voxel) + 0.5f) / vtkiOccupancySize, 0.0f).rg * 255.0f + 0.5f);
      vec4 plane = vtkiUnpackPlane(bytes.x | (bytes.y << 8));
      more = plane.xyz != vec3(0.0f);
      open = more ? vtkiLeavePlane(open, plane) : open;
      found = more && !vtkiIsOccupied(ivec3(floor(open)));
      more = more && !found;
    }
    aside = open - before;
    ++tried;
  } while (!found && tried < 6);
}
#endif

// Settings as literals, so that no code is evaluated for those that are off. These are the
// defaults.
#ifndef VTKI_LOOKUPS
#define VTKI_LOOKUPS 1         // 1, or 4: one above and three at 80 degrees (Eq. 7)
#define VTKI_LOOKUP_ROTATION 0 // 1: the three turn from pixel to pixel
#define VTKI_LOBES 1
#define VTKI_FACING 1 // 1: hints behind senders weigh less
#endif

const int VTKI_MARCH = 24; // steps of a look-up through the voxels

// Adds the hints around a place in front of a surface. seen: only hints that the surface sees;
// otherwise hints in front of its plane, so that a surface at the grid's border, which faces
// outwards, gets no light of hints behind it.
void vtkiAddLookup(inout vtkiField sum, inout float total, int grid, vec3 at, float weight,
  vec3 position, vec3 normal, bool seen)
{
  vtkiGrid g = vtkiGetGrid(grid);
  int mask = 255;
  vec3 inGrid = (at - g.lower) / g.cell - 0.5f;
  vec3 base = floor(inGrid);
#ifdef VTKI_HINT_OCCUPANCY
  ivec3 voxel = clamp(ivec3(floor(vtkiToVoxels(at))), ivec3(0), ivec3(vtkiOccupancySize) - 1);
  // The mask belongs to the voxel's centre, and so do the hints that it names.
  vec3 centre = (vec3(voxel) + 0.5f) / vtkiOccupancyOrigin.w + vtkiOccupancyOrigin.xyz;
  base = floor((centre - g.lower) / g.cell - 0.5f);
  vec2 masks = textureLod(vtkiMasks, (vec3(voxel) + 0.5f) / vtkiOccupancySize, 0.0f).rg;
  // An occupied voxel has a plane in place of the mask. At the volume's border it stands for a free
  // place beyond.
  int sees = vtkiIsOccupied(voxel) ? 0 : int((grid == 0 ? masks.x : masks.y) * 255.0f + 0.5f);
  mask = seen ? sees : 255;
#endif
  vec3 blend = clamp(inGrid - base, 0.0f, 1.0f);
  for (int corner = 0; corner < 8; ++corner)
  {
    ivec3 shift = ivec3(corner & 1, (corner >> 1) & 1, corner >> 2);
    ivec3 hintAt = clamp(ivec3(base) + shift, ivec3(0), g.size - 1);
    int hint = g.first + hintAt.x + g.size.x * (hintAt.y + g.size.y * hintAt.z);
    vec3 w3 = mix(1.0f - blend, blend, vec3(shift));
    // Above zero, so that a single visible hint counts wherever it lies.
    float w = weight * max(w3.x * w3.y * w3.z, 1.0e-4f) * float((mask >> corner) & 1);
#ifdef VTKI_HINT_OCCUPANCY
    vec3 toHint = g.lower + (vec3(hintAt) + 0.5f) * g.cell - position;
    w *= seen || dot(toHint, normal) > 0.0f ? 1.0f : 0.0f;
#else
    if (VTKI_FACING != 0)
    {
      w *= texelFetch(vtkiHintDistance, vtkiHintTexel(hint), 0).z;
    }
#endif
    vtkiAddHint(sum, hint, w);
    total += w;
  }
}

// Returns the share of the finer grid at a point: whole inside, fading over its outermost two
// cells, except at faces that both grids share.
float vtkiFineShare(vec3 position)
{
  vec3 inGrid = (position - vtkiGridLower1.xyz) / vtkiGridCell1.xyz;
  vec3 low = (vtkiGridLower1.xyz - vtkiGridLower0.xyz) / vtkiGridCell1.xyz;
  vec3 high =
    low + vtkiGridSize1.xyz - vtkiGridSize0.xyz * vtkiGridCell0.xyz / vtkiGridCell1.xyz;
  vec3 inside = min(inGrid + 2.0f * vec3(lessThan(abs(low), vec3(0.5f))),
    vtkiGridSize1.xyz - inGrid + 2.0f * vec3(lessThan(abs(high), vec3(0.5f))));
  return clamp(0.5f * min(min(inside.x, inside.y), inside.z), 0.0f, 1.0f);
}

vec3 vtkiHintIrradiance(vec3 position, vec3 normal, ivec2 pixel, bool needed)
{
  vtkiField sum = vtkiZeroField();
  float total = 0.0f;
  // Any two directions that make a frame with the normal.
  vec3 helper = abs(normal.x) < 0.5f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
  vec3 tangent = normalize(cross(helper, normal));
  vec3 bitangent = cross(normal, tangent);
  float turn = VTKI_LOOKUP_ROTATION != 0
    ? 6.2831853f * vtkiSpread(0, uint(pixel.x * 4099 + pixel.y)).x
    : 0.0f;
#ifdef VTKI_HINT_OCCUPANCY
  vec3 open;
  vec3 aside;
  vtkiFindOpen(vtkiToVoxels(position), normal, open, aside);
#endif
  float fine = VTKI_GRIDS > 1 ? vtkiFineShare(position) : 0.0f;
  // First with the visible hints; if there is none, once more with those in front. Conditions come
  // last: a loop ends when they hold for all fragments shaded together, and a loop that begins with its
  // condition runs one more round, which costs as much as the others.
  int attempt = 0;
  bool again = false;
  do
  {
    int lookups = needed && !(total > 0.0f) ? VTKI_LOOKUPS * VTKI_GRIDS : 0;
    int i = 0;
    do
    {
      int grid = VTKI_GRIDS > 1 ? i / VTKI_LOOKUPS : 0;
      int lookup = i - grid * VTKI_LOOKUPS;
      float weight = grid == 1 ? fine : 1.0f - fine;
      vtkiGrid g = vtkiGetGrid(grid);
      float diagonal = g.diagonal;
      vec3 cell = g.cell;
      // Half a cell along the normal; or the paper's hemisphere, a cell's diagonal in radius, half
      // a diagonal above the surface.
      vec3 offset = 0.5f * dot(abs(normal), cell) * normal;
      if (VTKI_LOOKUPS > 1)
      {
        float angle = turn + 2.0943951f * float(lookup);
        offset = lookup == 0
          ? 1.5f * diagonal * normal
          : diagonal * ((0.5f + 0.17364818f) * normal +
              0.98480775f * (cos(angle) * tangent + sin(angle) * bitangent));
      }
      vec3 at = position + offset;
#ifdef VTKI_HINT_OCCUPANCY
      // Moves along the offset while the voxels are free.
      vec3 way = vtkiToVoxels(at) + aside - open;
      int steps = min(int(ceil(1.2f * length(way))), VTKI_MARCH);
      float reached = 0.0f;
      for (int s = 1; s <= steps; ++s)
      {
        float t = float(s) / float(steps);
        if (vtkiIsOccupied(ivec3(floor(open + t * way))))
        {
          break;
        }
        reached = t;
      }
      at = (open + reached * way) / vtkiOccupancyOrigin.w + vtkiOccupancyOrigin.xyz;
#endif
      if (weight > 0.0f && i < lookups)
      {
        vtkiAddLookup(sum, total, grid, at, weight, position, normal, attempt == 0);
      }
      ++i;
    } while (VTKI_LOOKUPS * VTKI_GRIDS > 1 && i < lookups);
    ++attempt;
    again = needed && !(total > 0.0f) && attempt < 2;
  } while (again);
  for (int i = 0; i < VTKI_HINT_TEXTURES; ++i)
  {
    sum.c[i] *= total > 0.0f ? 1.0f / total : 0.0f;
  }
  return vtkiFieldIrradiance(sum, normal, VTKI_LOBES != 0);
}
