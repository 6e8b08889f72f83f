//VTK::System::Dec
// A point as large as a cell for each cell of pixels that is more than one surface. Each of these pixels
// finds its own way to its irradiance; points keep the work away from all others.
#include "vtkIndirectStep.glsl"
#include "vtkIndirectLibInterpolation.glsl"

uniform sampler2D vtkiCoarse;
uniform ivec2 vtkiCoarseSize;

void main()
{
  ivec2 cell = ivec2(gl_VertexID % vtkiCoarseSize.x, gl_VertexID / vtkiCoarseSize.x);
  float state = texelFetch(vtkiCoarse, cell, 0).a;
  bool mixed = state == VTKI_CELL_MIXED || state == VTKI_CELL_MIXED_UNLIT;
  // The viewport is as large as all cells, of which the last may reach over the image.
  vec2 place = 2.0f * (vec2(cell) + 0.5f) / vec2(vtkiCoarseSize) - 1.0f;
  gl_Position = mixed ? vec4(place, 0.0f, 1.0f) : vec4(2.0f, 2.0f, 2.0f, 1.0f);
}
