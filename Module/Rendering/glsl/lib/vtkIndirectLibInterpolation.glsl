// Tests that a coarse sample represents a pixel.
#ifndef vtkIndirectLibInterpolation
#define vtkIndirectLibInterpolation
#include "vtkIndirectLibPortable.glsl"

// Limits for interpolating a coarse sample: least cosine of the normals, and largest distance from
// each other's tangent plane, over the distance between samples on a surface that faces the eye.
const float VTKI_INTERPOLATION_COSINE = 0.9f;
const float VTKI_INTERPOLATION_DISTANCE = 0.5f;

/* True when a sample lies on the pixel's surface: normals agree and each lies near the other's
 * tangent plane. offset: sample minus pixel position; footprint: distance between samples there. */
bool vtkiSameSurface(
  vec3 offset, vec3 normal, vec3 sampleNormal, float minimumCosine, float planeTolerance)
{
  return dot(normal, sampleNormal) >= minimumCosine &&
    max(abs(dot(normal, offset)), abs(dot(sampleNormal, offset))) <= planeTolerance;
}

/* True only if vtkiSameSurface holds between any two of several positions, from their largest
 * deviations from one of them: height over its plane, length of a normal's difference to its
 * normal, distance from it. For smooth, strongly curved surfaces it may be false although the
 * condition holds. Normals differ by 2 turn at most, and chords of length c have the cosine 1 - c^2
 * / 2. Along the one normal two positions are 2 height apart, along another turn times their
 * distance more. */
bool vtkiOneSurface(
  float height, float turn, float radius, float minimumCosine, float planeTolerance)
{
  return 1.0f - 2.0f * turn * turn >= minimumCosine &&
    2.0f * height + 2.0f * turn * radius <= planeTolerance;
}

/* Largest difference between unit vectors over the sum of the absolute differences of their
 * octahedral coordinates: on the octahedron points move by at most sqrt(2) times that sum, at a
 * distance of 1 / sqrt(3) or more from the centre. */
const float VTKI_TURN_PER_CODE = 2.4494897f;

// Content of a cell of pixels between four samples. Values for cells with a lit sample are
// positive.
const float VTKI_CELL_WHOLE = 2.0f;       // one lit surface, which has the four samples
const float VTKI_CELL_MIXED = 1.0f;       // other content; the cell's own sample is lit
const float VTKI_CELL_MIXED_UNLIT = 0.0f; // other content; the cell's own sample is unlit
const float VTKI_CELL_EMPTY = -1.0f;      // no lit surface
#endif
