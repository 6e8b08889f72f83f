// Irradiance of an estimator that has a value for every pixel.
uniform sampler2D vtkiIrradiance;

// position: centre of a pixel, in pixels of the view.
vec3 vtkiFetchIrradiance(vec2 position)
{
  return textureLod(vtkiIrradiance, position / vec2(vtkiSize), 0.0f).rgb;
}
