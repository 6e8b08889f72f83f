//VTK::System::Dec
// Draws a point the size of a tile for each tile that has an edge, so that other pixels cost
// nothing.
uniform sampler2D vtkiTiles;
uniform ivec2 vtkiTileCount;
uniform ivec2 vtkiSize;
uniform ivec2 vtkiOrigin;
uniform int vtkiRows;
uniform ivec2 vtkiEdgeSize;
flat out vec2 vtkiTexel;
flat out vec2 vtkiEdgeTexel;
flat out ivec3 vtkiPlaces; // the viewport's origin, and the first line of columns

void main()
{
  // Floats represent all tile numbers exactly; software divides integers one by one.
  float row = floor((float(gl_VertexID) + 0.5f) / float(vtkiTileCount.x));
  vec2 tile = vec2(float(gl_VertexID) - row * float(vtkiTileCount.x), row);
  vec2 at = (tile + 0.5f) / vec2(vtkiTileCount);
  bool hasEdges = textureLod(vtkiTiles, at, 0.0f).r > 0.0f;
  vtkiTexel = 1.0f / vec2(vtkiSize);
  vtkiEdgeTexel = 1.0f / vec2(vtkiEdgeSize);
  vtkiPlaces = ivec3(vtkiOrigin, vtkiRows);
  // The viewport is the size of all tiles, which may extend beyond the picture.
  gl_Position = hasEdges ? vec4(2.0f * at - 1.0f, 0.0f, 1.0f) : vec4(2.0f, 2.0f, 2.0f, 1.0f);
}
