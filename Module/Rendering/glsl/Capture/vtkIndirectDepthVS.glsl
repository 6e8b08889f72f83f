//VTK::System::Dec
// Transforms positions for depth maps.
in vec4 vertexMC;
uniform mat4 vtkiToClip;

void main()
{
  gl_Position = vtkiToClip * vertexMC;
}
