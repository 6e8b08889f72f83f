// Tests a cell of vtkiStep by vtkiStep pixels for being one surface.
#include "vtkIndirectReceiverGrid.glsl"

struct vtkiCell
{
  vtkiReceiver corner; // at the cell's own sample
  vec4 code;           // its normal and its facet's, as stored
  bool whole;          // all lit
  bool empty;          // none lit
  float height;        // largest distance of the other pixels from its plane
  float turn;
  float radius2;
  float nearest; // depth
};

void vtkiAddToCell(inout vtkiCell cell, ivec2 pixel)
{
  vec2 place = (vec2(min(pixel, vtkiSize - 1)) + 0.5f) / vec2(vtkiSize);
  vec4 surface = textureLod(vtkiSurface, place, 0.0f);
  bool lit = vtkiSurfaceIsLit(surface);
  cell.whole = cell.whole && lit;
  cell.empty = cell.empty && !lit;
  vec3 offset =
    vtkiReconstruct(2.0f * place - 1.0f, vtkiSurfaceDepth(surface), vtkiRayOrigin, vtkiRayDirection) -
    cell.corner.positionVC;
  cell.height = max(cell.height, abs(dot(cell.corner.facetVC, offset)));
  vec4 difference = abs(vec4(vtkiSurfaceCode(surface), vtkiUnpackCode(surface.z)) - cell.code);
  cell.turn = max(cell.turn, max(difference.x + difference.y, difference.z + difference.w));
  cell.radius2 = max(cell.radius2, dot(offset, offset));
  cell.nearest = min(cell.nearest, vtkiSurfaceDepth(surface));
}

// first: the cell's lower left pixel, where its sample is, with the surface there. Each pixel of
// the cell and the samples at its other three corners are read once.
float vtkiCellState(ivec2 first, vtkiReceiver corner, bool lit)
{
  // The last samples may be closer together.
  ivec2 last = first + vtkiStep;
  bool complete = all(lessThan(last, vtkiSize));
  vec4 code = vec4(vtkiOctahedralEncode(corner.normalVC), vtkiOctahedralEncode(corner.facetVC));
  vtkiCell cell = vtkiCell(corner, code, lit && complete, !lit, 0.0f, 0.0f, 0.0f, corner.depth);
  // Conditions come last; see vtkIndirectHintLookup.glsl.
  int y = 0;
  do
  {
    int x = 0;
    do
    {
      vtkiAddToCell(cell, first + ivec2(x, y));
      ++x;
    } while (x < vtkiStep);
    ++y;
  } while (y < vtkiStep);
  vtkiAddToCell(cell, ivec2(last.x, first.y));
  vtkiAddToCell(cell, ivec2(first.x, last.y));
  vtkiAddToCell(cell, last);
  bool whole = cell.whole &&
    vtkiOneSurface(cell.height, VTKI_TURN_PER_CODE * cell.turn, sqrt(cell.radius2),
      VTKI_INTERPOLATION_COSINE, VTKI_INTERPOLATION_DISTANCE * vtkiSampleDistance(cell.nearest));
  float mixed = lit ? VTKI_CELL_MIXED : VTKI_CELL_MIXED_UNLIT;
  return whole ? VTKI_CELL_WHOLE : (cell.empty ? VTKI_CELL_EMPTY : mixed);
}
