//VTK::System::Dec
//VTK::Output::Dec
// Marks tiles of vtkiTile x vtkiTile pixels, 32 at most, that have a pixel with an edge on a side.
uniform usampler2D vtkiEdges;
uniform int vtkiRows;
uniform int vtkiTile;

void main()
{
  ivec2 first = ivec2(gl_FragCoord.xy) * vtkiTile;
  uint bits = vtkiTile == 32 ? 0xffffffffu : (1u << uint(vtkiTile)) - 1u;
  // Tiles divide words evenly; the last tile may extend beyond the picture.
  ivec2 end = min(first + vtkiTile, ivec2(textureSize(vtkiEdges, 0).y - vtkiRows, vtkiRows) - 1);
  uint any = 0u;
  for (int y = first.y; y <= end.y; ++y)
  {
    any |= (texelFetch(vtkiEdges, ivec2((first.x >> 5) + 1, y), 0).r >> uint(first.x & 31)) & bits;
  }
  for (int x = first.x; x <= end.x; ++x)
  {
    any |= (texelFetch(vtkiEdges, ivec2((first.y >> 5) + 1, vtkiRows + x), 0).r >> uint(first.y & 31)) & bits;
  }
  gl_FragData[0] = vec4(any != 0u ? 1.0f : 0.0f);
}
