//VTK::System::Dec
//VTK::Output::Dec
// Zero in all of the geometry buffer's channels. Software clears textures of floats pixel by pixel, which
// takes longer than to draw over them.
void main()
{
  gl_FragData[0] = vec4(0.0f);
  gl_FragData[1] = vec4(0.0f);
  gl_FragData[2] = vec4(0.0f);
  gl_FragData[3] = vec4(0.0f);
}
