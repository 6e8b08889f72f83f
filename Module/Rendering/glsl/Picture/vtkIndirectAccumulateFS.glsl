//VTK::System::Dec
//VTK::Output::Dec
// Light of a batch of virtual lights, or of several; see vtkIndirectAccumulation.
uniform sampler2D vtkiLight;
uniform float vtkiScale; // from the image's unit to the result's

void main()
{
  gl_FragData[0] = vec4(vtkiScale * texelFetch(vtkiLight, ivec2(gl_FragCoord.xy), 0).rgb, 1.0f);
}
