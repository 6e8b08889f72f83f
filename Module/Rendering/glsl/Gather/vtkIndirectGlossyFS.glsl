//VTK::System::Dec
//VTK::Output::Dec
// Indirect light in the specular lobe, at every specular pixel. VTKI_GATHER names the file that
// sums over the senders, as for irradiance but with the lobe's weight.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectLibGlossy.glsl"

uniform sampler2D vtkiSpecular;
uniform float vtkiStorageScale;

#include "vtkIndirectGlossyWeight.glsl"
#include VTKI_GATHER

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 specular = texelFetch(vtkiSpecular, pixel, 0);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  vtkiReceiverMirror =
    mat3(vtkiViewToScene) * vtkiMirror(receiver.positionVC, receiver.normalVC);
  vtkiReceiverPower = specular.a;
  vec3 sum = vec3(0.0f);
  // Negative powers are roughnesses of VTK's PBR; only area lights support these.
  if (lit && specular.a >= 0.0f && max(max(specular.r, specular.g), specular.b) > 0.0f)
  {
    sum = vtkiGather(receiver.position, receiver.normal, receiver.facet, pixel);
  }
  gl_FragData[0] = vec4(sum * vtkiStorageScale, 1.0f);
}
