//VTK::System::Dec
//VTK::Output::Dec
// Writes zero to all channels of the geometry buffer. Software clears float textures pixel by
// pixel, which takes longer than drawing over them.
void main()
{
  gl_FragData[0] = vec4(0.0f);
  gl_FragData[1] = vec4(0.0f);
  gl_FragData[2] = vec4(0.0f);
  gl_FragData[3] = vec4(0.0f);
}
