// Concave creases of flat surfaces. A depth map passes a surface that stands before a receiver by
// less than the map's bias for the receiver's own surface, so that light reaches a wall's foot from
// beyond the floor. Where the image shows the other surface, its plane hides what lies behind it.
#ifndef vtkIndirectLibCrease
#define vtkIndirectLibCrease
#include "vtkIndirectLibPortable.glsl"

// This is the greatest cosine between the normals of surfaces that meet in a crease.
const float VTKI_CREASE_COSINE = 0.75f;
// This is the greatest cosine between the normals of facets that meet in a fold. A map's bias covers
// folds of less than 16 degrees, see VTKI_TILE_ROUGHNESS.
const float VTKI_FOLD_COSINE = 0.97f;
// This is the greatest extent of the other surface that counts, in scene units: two texels of the
// sky's maps, beyond which the maps show the other surface.
const float VTKI_CREASE_REACH = 0.02f;
// A receiver may lie behind the other plane by this, in scene units: rounding.
const float VTKI_CREASE_ROUNDING = 1.0e-4f;
// A plane hides positions that lie behind it by more than this, in scene units: virtual lights on
// the plane are not hidden.
const float VTKI_CREASE_MARGIN = 1.0e-3f;
// Facets are one flat surface above this cosine, and within this share of their distance.
const float VTKI_CREASE_FLAT_COSINE = 0.999f;
const float VTKI_CREASE_FLAT_HEIGHT = 0.02f;

/* This is the other surface at a receiver: its normal, the product of the normal and a position on
 * the surface, and the distance from the receiver up to which the surface goes on, squared: zero
 * where the surface hides nothing. All are zero where no crease is near. */
struct vtkiCrease
{
  vec3 normal;
  float plane;
  float extent2;
};

/* Returns true if two surfaces meet in a concave crease: each lies before the other's plane.
 * offset: from the receiver to the other position; cosine: the greatest between the normals. */
bool vtkiMeetsInCrease(vec3 facet, vec3 other, vec3 offset, float cosine)
{
  return dot(facet, other) < cosine && dot(facet, offset) > 0.0f &&
    dot(other, offset) < VTKI_CREASE_ROUNDING;
}

/* Returns true if two positions lie on one flat surface. */
bool vtkiIsFlat(vec3 facet, vec3 other, vec3 offset)
{
  float height = dot(facet, offset);
  return dot(facet, other) > VTKI_CREASE_FLAT_COSINE &&
    height * height < VTKI_CREASE_FLAT_HEIGHT * VTKI_CREASE_FLAT_HEIGHT * dot(offset, offset);
}

/* Returns true if the other surface of a crease hides a position from the receiver: the segment
 * crosses the surface's plane near the receiver. to: from the receiver to what may be hidden. Needs
 * no division. */
bool vtkiHidesInCrease(vtkiCrease crease, vec3 position, vec3 to)
{
  float height = dot(crease.normal, position) - crease.plane;
  float descent = -dot(crease.normal, to);
  return descent > height + VTKI_CREASE_MARGIN &&
    height * height * dot(to, to) < crease.extent2 * descent * descent;
}
#endif
