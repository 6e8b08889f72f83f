//VTK::System::Dec
//VTK::Output::Dec
// Adds the irradiance from a further batch of lights.
uniform sampler2D vtkiBatch;

void main()
{
  gl_FragData[0] = texelFetch(vtkiBatch, ivec2(gl_FragCoord.xy), 0);
}
