//VTK::System::Dec
//VTK::Output::Dec
// Packs the depths of four neighbouring texels of a tile into one texel, so that a filtered look-up
// takes one fetch; see vtkIndirectPenumbra.glsl. A tile's last row and column are their own
// neighbours.
uniform sampler2D vtkiDepthTiles;
uniform vec3 vtkiTileShape; // columns and rows of tiles in the atlas, texels along an edge of a tile

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  int texels = int(vtkiTileShape.z + 0.5f);
  ivec2 next = min(at + 1, (at / texels + 1) * texels - 1);
  gl_FragData[0] = vec4(texelFetch(vtkiDepthTiles, at, 0).r,
    texelFetch(vtkiDepthTiles, ivec2(next.x, at.y), 0).r,
    texelFetch(vtkiDepthTiles, ivec2(at.x, next.y), 0).r, texelFetch(vtkiDepthTiles, next, 0).r);
}
