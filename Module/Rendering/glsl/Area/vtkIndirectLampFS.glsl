//VTK::System::Dec
//VTK::Output::Dec
// Draws a visible area light: its radiance, as an unlit surface. VTKI_LAMP_IMAGE: the radiance is
// an image. VTKI_ENCODED: the frame has pixels of VTK's PBR, which are encoded, so the lamp's are
// too. VTKI_ALBEDO_IN_ALPHA: see vtkIndirectAlbedo.glsl.
#include "vtkIndirectLibAlbedo.glsl"
#include "vtkIndirectLibColor.glsl"
#include "vtkIndirectLibSurface.glsl"

uniform vec3 vtkiLampNormal; // view
#ifdef VTKI_LAMP_IMAGE
uniform sampler2D vtkiLampImage;
#else
uniform vec3 vtkiLampRadiance;
#endif

in vec2 vtkiLampPlace;
in float vtkiLampLinearDepth;

void main()
{
#ifdef VTKI_LAMP_IMAGE
  vec3 radiance = texture(vtkiLampImage, vtkiLampPlace).rgb;
#else
  vec3 radiance = vtkiLampRadiance;
#endif
#ifdef VTKI_ENCODED
  radiance = vtkiEncodeGamma(radiance);
#endif
  float black = vtkiPackAlbedo(vec3(0.0f));
#ifdef VTKI_ALBEDO_IN_ALPHA
  gl_FragData[0] = vec4(radiance, black);
#else
  gl_FragData[0] = vec4(radiance, 1.0f);
#endif
  gl_FragData[1] = vtkiPackSurface(vtkiLampNormal, vtkiLampNormal, vtkiLampLinearDepth, VTKI_SURFACE_UNLIT);
  gl_FragData[2] = vec4(black, 0.0f, 0.0f, 1.0f);
  gl_FragData[3] = vec4(0.0f);
}
