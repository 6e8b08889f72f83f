//VTK::System::Dec
// Draws a point the size of a cell for each cell of pixels with more than one surface, whose pixels
// each need their own irradiance; other pixels cost nothing.
#include "vtkIndirectReceiverGrid.glsl"

uniform sampler2D vtkiCoarse;

void main()
{
  // Floats represent all cell numbers exactly; software divides integers one by one.
  float row = floor((float(gl_VertexID) + 0.5f) / float(vtkiCoarseSize.x));
  vec2 cell = vec2(float(gl_VertexID) - row * float(vtkiCoarseSize.x), row);
  vec2 at = (cell + 0.5f) / vec2(vtkiCoarseSize);
  float state = textureLod(vtkiCoarse, at, 0.0f).a;
  bool mixed = state == VTKI_CELL_MIXED || state == VTKI_CELL_MIXED_UNLIT;
  // The viewport is the size of all cells, which may extend beyond the image.
  vec2 place = 2.0f * at - 1.0f;
  gl_Position = mixed ? vec4(place, 0.0f, 1.0f) : vec4(2.0f, 2.0f, 2.0f, 1.0f);
}
