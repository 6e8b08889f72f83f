//VTK::System::Dec
//VTK::Output::Dec
// Adds one light's share to a subsplat; see vtkIndirectSubsplatPointVS.glsl.
flat in vec3 vtkiPointIrradiance;
flat in vec3 vtkiPointVector;

void main()
{
  // What the texel is, in alpha, has been written before.
  gl_FragData[0] = vec4(vtkiPointIrradiance, 0.0f);
#ifndef VTKI_PIXELS
  gl_FragData[1] = vec4(vtkiPointVector, 0.0f);
#endif
}
