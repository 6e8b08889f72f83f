//VTK::System::Dec
// A point as large as a cell for each cell of pixels that is more than one surface. Each of these pixels
// finds its own way to its irradiance; points keep the work away from all others.
#include "vtkIndirectStep.glsl"
#include "vtkIndirectLibInterpolation.glsl"

uniform sampler2D vtkiCoarse;
uniform ivec2 vtkiCoarseSize;

void main()
{
  // As floats, which hold all numbers of cells: integers are divided one by one in software.
  float row = floor((float(gl_VertexID) + 0.5f) / float(vtkiCoarseSize.x));
  vec2 cell = vec2(float(gl_VertexID) - row * float(vtkiCoarseSize.x), row);
  vec2 at = (cell + 0.5f) / vec2(vtkiCoarseSize);
  float state = textureLod(vtkiCoarse, at, 0.0f).a;
  bool mixed = state == VTKI_CELL_MIXED || state == VTKI_CELL_MIXED_UNLIT;
  // The viewport is as large as all cells, of which the last may reach over the image.
  vec2 place = 2.0f * at - 1.0f;
  gl_Position = mixed ? vec4(place, 0.0f, 1.0f) : vec4(2.0f, 2.0f, 2.0f, 1.0f);
}
