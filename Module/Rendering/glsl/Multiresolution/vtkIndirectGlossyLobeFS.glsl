//VTK::System::Dec
//VTK::Output::Dec
// Specular lobe of a level's texel: its power, and whether one evaluation of a light can represent
// the texel. The levels are a pyramid over the specular target of the geometry buffer.
#include "vtkIndirectLibSurface.glsl"
#include "vtkIndirectLibSubsplat.glsl"
#include "vtkIndirectGlossyState.glsl"

#ifdef VTKI_PIXELS
uniform sampler2D vtkiSurface;
uniform sampler2D vtkiSpecular;
#else
uniform sampler2D vtkiFinerLobe;
#endif
uniform ivec2 vtkiFinerSize;
uniform sampler2D vtkiLevelSurface;

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float least = 65504.0f; // largest half float
  float most = -1.0f;
  bool split = false;
  for (int i = 0; i < 4; ++i)
  {
    ivec2 at = 2 * texel + ivec2(i & 1, i >> 1);
    ivec2 inside = min(at, vtkiFinerSize - 1);
#ifdef VTKI_PIXELS
    vec4 specular = texelFetch(vtkiSpecular, inside, 0);
    bool present = vtkiSurfaceIsLit(texelFetch(vtkiSurface, inside, 0)) && specular.a >= 0.0f &&
      max(max(specular.r, specular.g), specular.b) > 0.0f;
    float power = specular.a;
#else
    vec2 lobe = texelFetch(vtkiFinerLobe, inside, 0).xy;
    bool present = lobe.y != VTKI_GLOSSY_NONE;
    split = split || (at == inside && lobe.y == VTKI_GLOSSY_SPLIT);
    float power = lobe.x;
#endif
    if (present && at == inside)
    {
      least = min(least, power);
      most = max(most, power);
    }
  }
  // Lobes of different powers do not represent each other. Several surfaces have one sample if the
  // level is too fine to be split.
  split = split || least < most || vtkiSubsplatIsSplit(texelFetch(vtkiLevelSurface, texel, 0).w);
  gl_FragData[0] = vec4(
    most, most < 0.0f ? VTKI_GLOSSY_NONE : (split ? VTKI_GLOSSY_SPLIT : VTKI_GLOSSY_WHOLE), 0.0f, 1.0f);
}
