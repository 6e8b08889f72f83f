//VTK::System::Dec
// A corner of a visible area light, by its number.
uniform vec4 vtkiLampCorner[4]; // clip coordinates
uniform vec4 vtkiLampDepth;     // along the view axis, scene units

out vec2 vtkiLampPlace; // in [0,1] along the edges
out float vtkiLampLinearDepth;

void main()
{
  vtkiLampPlace = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vtkiLampLinearDepth = vtkiLampDepth[gl_VertexID];
  gl_Position = vtkiLampCorner[gl_VertexID];
}
