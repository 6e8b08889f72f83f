//VTK::System::Dec
//VTK::Output::Dec
// The number of splats at each pixel, white for 256.
uniform sampler2D vtkiIrradiance;

void main()
{
  float splats = texelFetch(vtkiIrradiance, ivec2(gl_FragCoord.xy), 0).a;
  gl_FragData[0] = vec4(vec3(splats / 256.0f), 1.0f);
}
