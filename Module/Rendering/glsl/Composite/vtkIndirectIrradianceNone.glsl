// Returns the irradiance of a frame without an estimate: zero.
vec3 vtkiFetchIrradiance(vec2 position)
{
  return vec3(0.0f);
}
