//VTK::System::Dec
//VTK::Output::Dec
// The irradiance from a further batch of lights, to be added.
uniform sampler2D vtkiBatch;

void main()
{
  gl_FragData[0] = texelFetch(vtkiBatch, ivec2(gl_FragCoord.xy), 0);
}
