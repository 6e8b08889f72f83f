//VTK::System::Dec
// Transforms positions for depth maps. Points of coarse levels move away from the emitter along
// their normals, so that a level does not hide the mesh that it replaces.
in vec4 vertexMC;
in vec3 insetMC;
uniform mat4 vtkiToClip;
uniform vec4 vtkiEmitter; // place of the emitter and 1, or the direction to it and 0

void main()
{
  vec3 toEmitter = vtkiEmitter.xyz - vtkiEmitter.w * vertexMC.xyz;
  vec3 inset = dot(insetMC, toEmitter) > 0.0 ? insetMC : -insetMC;
  gl_Position = vtkiToClip * vec4(vertexMC.xyz - inset, 1.0);
}
