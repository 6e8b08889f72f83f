// The light that comes to coarse receivers: planes of nine coefficients above each other, those of what proxies send
// to the right of those of the sky.
uniform ivec2 vtkiCoarseSize;

ivec2 vtkiPlaneTexel(ivec2 receiver, int column, int coefficient)
{
  return receiver + ivec2(column, coefficient) * vtkiCoarseSize;
}
