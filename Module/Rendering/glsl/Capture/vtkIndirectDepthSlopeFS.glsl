//VTK::System::Dec
//VTK::Output::Dec
// Draws depth, which OpenGL writes, and its slope over a texel's width in a parallel map; see
// vtkiDepthSlope.
uniform vec2 vtkiSlopeScale; // depth of the view over a texel's width

void main()
{
  gl_FragData[0] =
    vec4(vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z)) * vtkiSlopeScale, 0.0f, 1.0f);
}
