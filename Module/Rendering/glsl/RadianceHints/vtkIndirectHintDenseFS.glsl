//VTK::System::Dec
//VTK::Output::Dec
// First bounce at a hint: the sum over all senders of a list.
#include "vtkIndirectHintInject.glsl"

uniform sampler2D vtkiLightPosition; // position, area
uniform sampler2D vtkiLightNormal;
uniform sampler2D vtkiLightDensity;
uniform int vtkiLightCount;

void main()
{
  vtkiHintPlace place = vtkiFetchHintPlace();
  vtkiHintSums sums = vtkiBeginHint();
  int count = place.used ? vtkiLightCount : 0;
  for (int i = 0; i < count; ++i)
  {
    ivec2 from = vtkiTableTexel(i);
    vec4 sender = texelFetch(vtkiLightPosition, from, 0);
    vec3 densityArea = texelFetch(vtkiLightDensity, from, 0).rgb;
    bool sends = max(max(densityArea.r, densityArea.g), densityArea.b) > 0.0f;
#ifdef VTKI_DIRECTIONS
    if (sends && sender.w < 0.0f)
    {
      vtkiAddDirection(sums, place.hint, place.position, sender.xyz, -sender.w, densityArea);
      sends = false;
    }
#endif
    if (sends)
    {
      vtkiAddSender(sums, place.hint, place.position, sender.xyz, texelFetch(vtkiLightNormal, from, 0).xyz, sender.w,
        densityArea, max(sender.w, vtkiSoftening * place.face) / 6.2831853f);
    }
  }
  vtkiEndHint(sums);
}
