// Reads and writes the fields of the hints.
#include "vtkIndirectHintField.glsl"
#include "vtkIndirectHintPlaces.glsl"

uniform sampler2D vtkiField0;
uniform sampler2D vtkiField1;
uniform sampler2D vtkiField2;
#if VTKI_HINT_LAYOUT == 2
uniform sampler2D vtkiField3;
uniform sampler2D vtkiField4;
uniform sampler2D vtkiField5;
uniform sampler2D vtkiField6;
#endif
uniform sampler2D vtkiHintDistance; // nearest and farthest sender over vtkiRange, faces turned here

void vtkiAddHint(inout vtkiField f, int hint, float weight)
{
  ivec2 at = vtkiHintTexel(hint);
  f.c[0] += weight * texelFetch(vtkiField0, at, 0);
  f.c[1] += weight * texelFetch(vtkiField1, at, 0);
  f.c[2] += weight * texelFetch(vtkiField2, at, 0);
#if VTKI_HINT_LAYOUT == 2
  f.c[3] += weight * texelFetch(vtkiField3, at, 0);
  f.c[4] += weight * texelFetch(vtkiField4, at, 0);
  f.c[5] += weight * texelFetch(vtkiField5, at, 0);
  f.c[6] += weight * texelFetch(vtkiField6, at, 0);
#endif
}
