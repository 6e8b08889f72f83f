//VTK::System::Dec
//VTK::Output::Dec
// Makes the lobe of one virtual light a fragment from a pattern of map coordinates.
#include "vtkIndirectMapLobe.glsl"

// map coordinates in [0,1)^2, layer, texels that the sample represents
uniform sampler2D vtkiPattern;

void main()
{
  vec4 sampled = texelFetch(vtkiPattern, ivec2(gl_FragCoord.xy), 0);
  int layer = int(sampled.z + 0.5f);
  float edge = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_SHAPE, max(layer, 0)), 0).z;
  ivec2 texel = ivec2(min(sampled.xy * edge, vec2(edge - 1.0f)));
  float weight = sampled.w;
  vtkiTexelLobe lobe;
  // The pattern has weight zero after its last sample.
  if (!(weight > 0.0f) || !vtkiLobeFromTexel(layer, texel, weight, lobe))
  {
    lobe.direction = vec3(0.0f, 0.0f, 1.0f);
    lobe.exponent = 0.0f;
    lobe.densityArea = vec3(0.0f);
    weight = 1.0f;
  }
  gl_FragData[0] = vec4(lobe.direction, lobe.exponent);
  gl_FragData[1] = vec4(lobe.densityArea * weight, 0.0f);
}
