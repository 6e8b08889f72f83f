// What surfaces reflect, beside what comes directly: together no more than there can be. Errors of the first are largest
// in crevices, where all that surfaces can do is to reflect all of the light that there is.
uniform vec3 vtkiGreatest;

vec3 vtkiBoundBounce(vec3 bounce, vec3 direct)
{
  return min(bounce, max(vtkiGreatest - direct, vec3(0.0f)));
}
