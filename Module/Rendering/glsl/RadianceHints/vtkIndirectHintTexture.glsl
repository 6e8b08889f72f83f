// Reads the fields of the hints.
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
// nearest and farthest sender over vtkiRange, share of surfaces facing the hint
uniform sampler2D vtkiHintDistance;

void vtkiAddHint(inout vtkiField f, int hint, float weight)
{
  // A look-up at a texel's centre is exact, and in software an eighth faster than a fetch.
  vec2 at = (vec2(vtkiHintTexel(hint)) + 0.5f) / vec2(textureSize(vtkiField0, 0));
  f.c[0] += weight * textureLod(vtkiField0, at, 0.0f);
  f.c[1] += weight * textureLod(vtkiField1, at, 0.0f);
  f.c[2] += weight * textureLod(vtkiField2, at, 0.0f);
#if VTKI_HINT_LAYOUT == 2
  f.c[3] += weight * textureLod(vtkiField3, at, 0.0f);
  f.c[4] += weight * textureLod(vtkiField4, at, 0.0f);
  f.c[5] += weight * textureLod(vtkiField5, at, 0.0f);
  f.c[6] += weight * textureLod(vtkiField6, at, 0.0f);
#endif
}
