//VTK::System::Dec
//VTK::Output::Dec
// Irradiance of area lights in a moving frame: interpolated from the four samples around a pixel if
// they are on its surface, else computed at the pixel.
#include "vtkIndirectAreaLamps.glsl"
#include "vtkIndirectAreaSamples.glsl"

uniform sampler2D vtkiAreaLight; // w: distance of the nearest lamp over that of samples
uniform sampler2D vtkiAreaShare;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(pixel, receiver);
  float tolerance = VTKI_INTERPOLATION_DISTANCE * vtkiSampleDistance(receiver.depth);
  vtkiGridCell cell = vtkiFindCell(pixel);
  vec3 light = vec3(0.0f);
  float weights = 0.0f;
  float distances = 1.0e30f;
  for (int k = 0; k < 4; ++k)
  {
    vtkiSample other = vtkiFetchSample(cell, k);
    bool same = vtkiIsNear(receiver, other, tolerance, VTKI_AREA_COSINE);
    vec4 sampled = textureLod(vtkiAreaLight, other.place, 0.0f);
    float weight = same ? other.weight : 0.0f;
    light += weight * sampled.rgb;
    weights += weight;
    distances = same ? min(distances, sampled.a) : distances;
  }
  bool even = (weights > 0.99f && distances >= VTKI_AREA_DISTANCES) ||
    (weights > 0.1f && distances >= VTKI_AREA_DISTANCES_BESIDE);
  float front;
  vec3 own = vtkiFindOpen(receiver, lit && !even, front).rgb;
#ifdef VTKI_VISIBILITY
  vec3 share = vec3(0.0f);
  float shares = 0.0f;
  int count = lit && !even ? 4 : 0;
  for (int k = 0; k < count; ++k)
  {
    vtkiSample other = vtkiFetchSample(cell, k);
    bool same = vtkiIsNear(receiver, other, tolerance, VTKI_INTERPOLATION_COSINE);
    float weight = same ? other.weight : 0.0f;
    share += weight * textureLod(vtkiAreaShare, other.place, 0.0f).rgb;
    shares += weight;
  }
  bool alone = shares < 0.1f;
  vec3 ownShare = vtkiFindOwnShare(receiver, lit && !even && alone);
  own *= alone ? ownShare : share / shares;
#endif
  gl_FragData[0] = vec4(lit ? (even ? light / weights : own) : vec3(0.0f), 1.0f);
}
