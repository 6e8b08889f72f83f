// The picture before antialiasing, and its colour as shown: with VTKI_FLOATS values may lie below
// black and above white.
#include "vtkIndirectLibAntialiasing.glsl"

uniform sampler2D vtkiPicture;

vec4 vtkiToShown(vec4 color)
{
#ifdef VTKI_FLOATS
  return clamp(color, 0.0f, 1.0f);
#else
  return color;
#endif
}

vec4 vtkiShown(vec2 place)
{
  return vtkiToShown(textureLod(vtkiPicture, place, 0.0f));
}
