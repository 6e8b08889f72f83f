// Samples at every few pixels of an image: a pixel's place between four of them, and the tests that
// a sample represents the pixel.
#ifndef vtkIndirectLibReceiverGrid
#define vtkIndirectLibReceiverGrid
#include "vtkIndirectLibPortable.glsl"

/* A cell of pixels between four samples, and the place of a pixel in the cell. */
struct vtkiGridCell
{
  ivec2 corner; // the first sample
  vec2 blend;   // 0 at the first sample, 1 at the sample across
};

/* Returns the cell that holds a pixel. step: pixels between samples; last: pixel at the image's
 * upper right corner. The last samples lie on the border and may be closer together. */
vtkiGridCell vtkiFindCell(ivec2 pixel, int step, ivec2 last)
{
  vtkiGridCell cell;
  cell.corner = pixel / step;
  ivec2 first = cell.corner * step;
  ivec2 width = max(min(first + step, last) - first, ivec2(1));
  cell.blend = vec2(pixel - first) / vec2(width);
  return cell;
}

/* Returns the bilinear weight of sample i of four: the first, the next along x, along y, and
 * across. */
float vtkiCellWeight(vtkiGridCell cell, int i)
{
  return ((i & 1) == 1 ? cell.blend.x : 1.0f - cell.blend.x) *
    (i > 1 ? cell.blend.y : 1.0f - cell.blend.y);
}

// Limits for interpolating a coarse sample: least cosine of the normals, and largest distance from
// each other's tangent plane, over the distance between samples on a surface that faces the eye.
const float VTKI_INTERPOLATION_COSINE = 0.9f;
const float VTKI_INTERPOLATION_DISTANCE = 0.5f;

/* Returns true when two normals agree and a position lies near the second's tangent plane. offset:
 * from one position to the other. */
bool vtkiLiesOnPlane(
  vec3 offset, vec3 normal, vec3 planeNormal, float minimumCosine, float planeTolerance)
{
  return dot(normal, planeNormal) >= minimumCosine &&
    abs(dot(planeNormal, offset)) <= planeTolerance;
}

/* Returns true when a sample lies on the pixel's surface: normals agree and each lies near the
 * other's tangent plane. offset: sample minus pixel position; footprint: distance between samples
 * there. */
bool vtkiSameSurface(
  vec3 offset, vec3 normal, vec3 sampleNormal, float minimumCosine, float planeTolerance)
{
  return dot(normal, sampleNormal) >= minimumCosine &&
    max(abs(dot(normal, offset)), abs(dot(sampleNormal, offset))) <= planeTolerance;
}

/* Agreement between 0 and 1 for light that varies little with the normal: power 8 of the normals'
 * cosine; one half where a position is half of `distance`, that of samples, off the other plane. */
float vtkiAgreement(vec3 offset, vec3 normal, vec3 sampleNormal, float distance)
{
  float away = max(abs(dot(offset, normal)), abs(dot(offset, sampleNormal))) /
    max(VTKI_INTERPOLATION_DISTANCE * distance, 1.0e-30f);
  float away2 = away * away;
  float c = max(dot(normal, sampleNormal), 0.0f);
  float c2 = c * c;
  float c4 = c2 * c2;
  return c4 * c4 / (1.0f + away2 * away2);
}

/* Returns true only if vtkiSameSurface holds between any two of several positions, from their
 * largest deviations from one of them: height over its plane, length of a normal's difference to
 * its normal, distance from it. For smooth, strongly curved surfaces it may be false although the
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
