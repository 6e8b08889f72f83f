//VTK::System::Dec
//VTK::Output::Dec
// Irradiance at every pixel: joint bilateral interpolation of the coarse samples that lie on the same
// surface. Where none does, or where something stands between them, nothing is written, nor depth: a second draw finds those pixels by it.
#include "vtkIndirectCoarse.glsl"

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  vec3 sum;
  float weights;
  int agreeing;
  vtkiInterpolateCoarse(pixel, receiver, sum, weights, agreeing);
  // As vtkIndirectHintFS.glsl writes it.
  float alpha = texelFetch(vtkiCoarse, pixel / vtkiStep, 0).a;
  bool divided = abs(alpha - 0.5f) < 0.4f;
  if (lit && (divided || weights < 0.05f))
  {
    discard;
  }
  gl_FragData[0] = lit ? vec4(sum / weights, 1.0f) : vec4(0.0f);
}
