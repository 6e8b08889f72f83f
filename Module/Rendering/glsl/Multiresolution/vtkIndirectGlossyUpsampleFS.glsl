//VTK::System::Dec
//VTK::Output::Dec
// Interpolates the reflection of the level above; lights that this level resolves further are added
// afterwards. Zero under a split texel, whose lights are all summed on this level.
#include "vtkIndirectGlossyTexel.glsl"

uniform sampler2D vtkiCoarserGlossy;

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vtkiGlossyReceiver receiver = vtkiFetchGlossyReceiver(texel);
  bool covered = texelFetch(vtkiCoarserLobe, texel >> 1, 0).y == VTKI_GLOSSY_WHOLE;
  vec3 sum = vec3(0.0f);
  if (covered && receiver.state == VTKI_GLOSSY_WHOLE)
  {
    vec4 weights = vtkiCoarserWeights(
      texel, receiver.position, receiver.normal, receiver.depth, receiver.power);
    for (int i = 0; i < 4; ++i)
    {
      sum += weights[i] * texelFetch(vtkiCoarserGlossy, vtkiCoarserTexel(texel, i), 0).rgb;
    }
  }
  gl_FragData[0] = vec4(sum, 1.0f);
}
