// Where there is no estimate.
vec3 vtkiFetchIrradiance(vec2 position)
{
  return vec3(0.0f);
}
