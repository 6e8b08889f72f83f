//VTK::System::Dec
//VTK::Output::Dec
// At one pixel in each texel of the coarsest level: luminance of the irradiance, which shows how
// the lighting varies before the image is subdivided; and the light whose curvature of the
// irradiance is largest there: texels between the probes compute its effect where they are near to
// it.
#include "vtkIndirectSubsplatTexel.glsl"
#ifdef VTKI_REPROJECTED
#include "vtkIndirectLibReprojection.glsl"

uniform sampler2D vtkiReprojected; // irradiance of the last frame

// Pixels are tested on a grid of this many along an edge, over the texel and those beside it.
const int VTKI_PROBE_TESTS = 8;

// Returns true if lights are summed in the texel or beside it.
bool vtkiProbeIsNeeded()
{
  bool needed = false;
  for (int i = 0; i < VTKI_PROBE_TESTS * VTKI_PROBE_TESTS; ++i)
  {
    vec2 test = vec2(ivec2(i % VTKI_PROBE_TESTS, i / VTKI_PROBE_TESTS)) + 0.5f;
    vec2 place = floor(gl_FragCoord.xy) - 1.0f + 3.0f / float(VTKI_PROBE_TESTS) * test;
    ivec2 pixel = clamp(ivec2(vtkiEdge * place), ivec2(0), vtkiSize - 1);
    needed = needed || texelFetch(vtkiReprojected, pixel, 0).a == VTKI_REPROJECTED_NONE;
  }
  return needed;
}
#endif

struct vtkiProbeSums
{
  float sum;
  float curvature; // largest of a light
  vec4 sender;     // position and area of that light
  vec4 normal;     // its normal; luminance of density times area
};

void vtkiAddToProbe(inout vtkiProbeSums sums, vec3 position, vec3 normal, vec3 open, int light, vec4 sender,
  vec4 senderNormal, vec3 density)
{
  vec3 irradiance = vec3(0.0f);
  vec3 unused = vec3(0.0f);
  vtkiAddWholeLight(position, normal, open, light, sender, senderNormal, density, irradiance, unused);
  float luminance = vtkiLuminance(irradiance);
  sums.sum += luminance;
  // Light from a direction does not bend the irradiance of a plane.
  vec3 toSender = sender.xyz - position;
  float spread = sender.w > 0.0f ? dot(toSender, toSender) + sender.w / VTKI_PI : 0.0f;
  float curvature = spread > 0.0f ? luminance / spread : 0.0f;
  if (curvature > sums.curvature)
  {
    sums.curvature = curvature;
    sums.sender = sender;
    sums.normal = vec4(senderNormal.xyz, vtkiLuminance(density));
  }
}

void main()
{
  vec2 center = vtkiSubsplatCenter(floor(gl_FragCoord.xy), vtkiEdge, vec2(vtkiSize));
  vec4 surface = textureLod(vtkiSurface, 0.5f * center + 0.5f, 0.0f);
  vec3 position = vtkiReconstruct(center, vtkiSurfaceDepth(surface), vtkiRayOrigin, vtkiRayDirection);
  position = (vtkiViewToScene * vec4(position, 1.0f)).xyz;
  vec3 normal = mat3(vtkiViewToScene) * vtkiSurfaceNormal(surface);
  bool lit = vtkiSurfaceIsLit(surface);
  vec3 open = vtkiOpenPlace(position, normal, mat3(vtkiViewToScene) * vtkiSurfaceFacet(surface),
    vtkiTexelPixel(ivec2(gl_FragCoord.xy)));
  vtkiProbeSums sums = vtkiProbeSums(
    0.0f, 0.0f, vec4(position, 1.0f), vec4(0.0f, 0.0f, 1.0f, 0.0f));
#ifdef VTKI_REPROJECTED
  lit = lit && vtkiProbeIsNeeded();
#endif
  int count = lit ? vtkiLightCount : 0;
  for (int i = 0; i < count; ++i)
  {
    vec4 sender;
    vec4 senderNormal;
    vec3 density;
    vtkiFetchLight(i, sender, senderNormal, density);
    vtkiAddToProbe(sums, position, normal, open, vtkiFirstLight + i, sender, senderNormal, density);
  }
  gl_FragData[0] = vec4(sums.sum * vtkiStorageScale, 0.0f, 0.0f, 0.0f);
  // Texels test the light in view coordinates.
  vec3 senderVC = (sums.sender.xyz - vtkiViewToScene[3].xyz) * mat3(vtkiViewToScene);
  gl_FragData[1] = vec4(senderVC, sums.sender.w);
  float density = sums.sum > 0.0f ? sums.normal.w / sums.sum : 0.0f;
  gl_FragData[2] = vec4(density * (sums.normal.xyz * mat3(vtkiViewToScene)), 0.0f);
}
