// Bounds the bounced light: together with direct light it cannot exceed all the light in the scene.
// Errors of the bounce are largest in crevices, where this bound applies.
uniform vec3 vtkiGreatest;

vec3 vtkiBoundBounce(vec3 bounce, vec3 direct)
{
  return min(bounce, max(vtkiGreatest - direct, vec3(0.0f)));
}
