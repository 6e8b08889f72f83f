//VTK::System::Dec
//VTK::Output::Dec
// A further bounce at a hint: light that the surrounding surfaces reflect, one ray for each share
// of the sphere.
#include "vtkIndirectHintField.glsl"
#include "vtkIndirectHintPlaces.glsl"
#include "vtkIndirectHintOutput.glsl"

uniform sampler2D vtkiRays; // four surfaces a texel, -1 for a ray that meets none
uniform sampler2D vtkiDirections;
uniform sampler2D vtkiRadiosity;
uniform int vtkiRayEdge;
uniform int vtkiRayRowLength;

void main()
{
  ivec2 at = ivec2(gl_FragCoord.xy);
  int hint = vtkiTableEntry(at);
  bool used = hint < vtkiHintCount && texelFetch(vtkiHints, at, 0).w > 0.0f;
  vtkiField f = vtkiZeroField();
  int rays = vtkiRayEdge * vtkiRayEdge;
  int first = hint * (rays / 4);
  int count = used ? rays : 0;
  for (int ray = 0; ray < count; ++ray)
  {
    int texel = first + ray / 4;
    vec4 four = texelFetch(vtkiRays, ivec2(texel % vtkiRayRowLength, texel / vtkiRayRowLength), 0);
    int surfel = int(four[ray & 3]);
    if (surfel >= 0)
    {
      vec4 direction = texelFetch(vtkiDirections, vtkiHintTexel(ray), 0);
      vtkiAddLight(f,
        direction.w * texelFetch(vtkiRadiosity, vtkiTableTexel(surfel), 0).rgb,
        direction.xyz);
    }
  }
  vtkiWriteField(f, vec4(0.0f));
}
