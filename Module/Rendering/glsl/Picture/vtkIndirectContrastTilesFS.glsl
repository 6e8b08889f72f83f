//VTK::System::Dec
//VTK::Output::Dec
// Marks tiles of vtkiTile x vtkiTile pixels that have a contrast.
uniform sampler2D vtkiContrasts;
uniform ivec2 vtkiSize;
uniform int vtkiTile;

void main()
{
  vec2 texel = 1.0f / vec2(vtkiSize);
  vec2 first = floor(gl_FragCoord.xy) * float(vtkiTile) + 0.5f;
  vec2 any = vec2(0.0f);
  // Tiles at the picture's border may extend beyond it and read its last pixels again.
  for (int y = 0; y < vtkiTile; ++y)
  {
    for (int x = 0; x < vtkiTile; ++x)
    {
      any = max(any, textureLod(vtkiContrasts, (first + vec2(float(x), float(y))) * texel, 0.0f).rg);
    }
  }
  gl_FragData[0] = vec4(max(any.x, any.y) > 0.0f ? 1.0f : 0.0f);
}
