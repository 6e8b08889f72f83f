// Every kernel of glsl/lib by number, in the dialect of both sides: the shader calls it with values
// from a texture, the test with the same values on the host.
#ifndef ShaderKernels
#define ShaderKernels

const int VTKI_KERNEL_COUNT = 32;

mat3 vtkiTestMatrix(vec4 a, vec4 b, float c)
{
  return mat3(vec3(a.x, a.y, a.z), vec3(a.w, b.x, b.y), vec3(b.z, b.w, c));
}

vec4 vtkiTestKernel(int kernel, vec4 a, vec4 b, vec4 c)
{
  vec3 a3 = vec3(a.x, a.y, a.z);
  vec3 b3 = vec3(b.x, b.y, b.z);
  vec3 c3 = vec3(c.x, c.y, c.z);
  if (kernel == 0)
  {
    vec2 p = vtkiOctahedralEncode(a3);
    return vec4(p.x, p.y, vtkiSignNotZero(a.x), 0.0f);
  }
  if (kernel == 1)
  {
    return vec4(vtkiOctahedralDecode(vec2(a.x, a.y)), 0.0f);
  }
  if (kernel == 2)
  {
    vec4 surface = vtkiPackSurface(a3, a3, a.w, 1.0f + floor(2.99f * b.w));
    vec2 code = vtkiSurfaceCode(surface);
    return vec4(vtkiSurfaceDepth(surface), code.x, code.y, surface.w);
  }
  if (kernel == 3)
  {
    vec4 surface = vtkiPackSurface(a3, a3, a.w, 1.0f + floor(2.99f * b.w));
    return vec4(vtkiSurfaceNormal(surface), vtkiSurfaceKind(surface));
  }
  if (kernel == 4)
  {
    return vec4(vtkiSurfaceIsLit(vtkiPackSurface(a3, a3, a.w, 1.0f + floor(2.99f * b.w))) ? 1.0f : 0.0f,
      vtkiSurfaceIsLit(vec4(0.0f)) ? 1.0f : 0.0f, 0.0f, 0.0f);
  }
  if (kernel == 5)
  {
    mat3 origin = vtkiTestMatrix(a, b, c.w);
    mat3 direction = vtkiTestMatrix(b, a, c.z);
    return vec4(vtkiReconstruct(vec2(c.x, c.y), c.z, origin, direction), 0.0f);
  }
  if (kernel == 6)
  {
    return vec4(float(vtkiFaceOf(a3)), float(vtkiFaceOf(b3)), float(vtkiFaceOf(c3)), 0.0f);
  }
  if (kernel == 7)
  {
    return vec4(vtkiToFace(a3, int(5.99f * b.w)), 0.0f);
  }
  if (kernel == 8)
  {
    return vec4(vtkiTexelSolidAngle(vec2(a.x, a.y), b.w), 0.0f, 0.0f, 0.0f);
  }
  if (kernel == 9)
  {
    return vec4(vtkiAttenuationTimesDistance2(abs(a3), a.w),
      vtkiAttenuationTimesDistance2(abs(b3), 0.0f),
      vtkiAttenuationTimesDistance2(vec3(0.0f, 0.0f, 1.0f + b.w), 0.0f), 0.0f);
  }
  if (kernel == 10)
  {
    return vec4(vtkiConeFactor(a.x, b.w, 0.0f), vtkiConeFactor(a.x, b.w, 8.0f * a.w),
      vtkiConeFactor(a.x, -2.0f, 3.0f), 0.0f);
  }
  if (kernel == 11)
  {
    return vec4(vtkiCosineRatio(a.x, b.x, 0.01f), vtkiCosineRatio(a.x, -b.x, 0.5f), 0.0f, 0.0f);
  }
  if (kernel == 12)
  {
    return vec4(vtkiVirtualLightWeight(2.0f * a.w * c3, a3, b3, 0.001f + b.w),
      vtkiVirtualLightWeight(vec3(0.0f), a3, b3, b.w), 0.0f, 0.0f);
  }
  if (kernel == 13)
  {
    vec3 p = vec3(a.x, a.y, -0.1f - a.w);
    vec3 n = vec3(0.1f * b.x, 0.1f * b.y, 0.99f);
    vec3 inside = vtkiPlaneDepthGradient(p, n, 0.01f, 0.1f, 1.2f, false);
    vec3 across = vtkiPlaneDepthGradient(p, n, 0.01f, 0.1f, 1.2f, true);
    return vec4(inside.x, inside.y, across.x,
      vtkiPlaneDepthGradient(p, vec3(-n.x, -n.y, -n.z), 0.01f, 0.1f, 1.2f, false).z + inside.z);
  }
  if (kernel == 14)
  {
    return vec4(vtkiDepthToBuffer(0.1f + a.w, 0.1f, 1.2f, false),
      vtkiDepthToBuffer(0.1f + a.w, 0.1f, 1.2f, true),
      vtkiDepthToBufferSlope(0.1f + a.w, 0.1f, 1.2f, false), vtkiShadowWeight(vec2(floor(2.0f * b.x), 1.0f), vec2(a.z, a.w)));
  }
  if (kernel == 15)
  {
    return vec4(vtkiSameSurface(0.3f * a.w * c3, a3, b3, 0.5f, 0.1f) ? 1.0f : 0.0f,
      vtkiSameSurface(vec3(0.0f), a3, a3, 0.9f, 0.0f) ? 1.0f : 0.0f,
      vtkiSameSurface(vec3(0.0f), a3, -a3, 0.9f, 1.0f) ? 1.0f : 0.0f, 0.0f);
  }
  if (kernel == 16)
  {
    return vec4(vtkiDiskSample(int(255.99f * a.w), 256), 0.0f);
  }
  if (kernel == 17)
  {
    return vec4(vtkiDecodeGamma(4.0f * a3), 0.0f);
  }
  if (kernel == 18)
  {
    return vec4(vtkiEncodeGamma(4.0f * a3), 0.0f);
  }
  if (kernel == 19)
  {
    return vec4(vtkiEncodeGamma(vtkiDecodeGamma(abs(a3))), 0.0f);
  }
  if (kernel == 20)
  {
    return vtkiHarmonicsLow(a3) + vtkiHarmonicsHigh(b3);
  }
  if (kernel == 21)
  {
    return vec4(vtkiHarmonicsLast(a3), vtkiIrradianceLow(a, b3), vtkiIrradianceHigh(a, b.w, b3),
      vtkiIrradianceLobe(vec4(1.0f, a.x, a.y, a.z), b3));
  }
  if (kernel == 22)
  {
    vec3 offset = vtkiPatchOffset((0.1f + a.w) * c3, b3, 0.01f);
    return vec4(offset, vtkiPatchSolidAngle(offset, b3)) +
      vec4(vtkiPatchSolidAngle(vec3(0.0f), b3));
  }
  if (kernel == 23)
  {
    // A walk of a few columns: position, passed voxels, and remaining length.
    vtkiWalk walk = vtkiBeginWalk(60.0f * (a3 + 1.0f), 60.0f * (b3 + 1.0f));
    int length = walk.remaining;
    uvec4 bits = vtkiWalkBits(walk);
    for (int i = 0; i < 5; ++i)
    {
      vtkiAdvance(walk);
    }
    return vec4(float(length), float(walk.column.x), float(walk.column.y),
      float(((bits.x >> 1u) ^ bits.y ^ bits.z ^ (bits.w << 1u)) & 0xffffu));
  }
  if (kernel == 24)
  {
    vec3 mirror = vtkiMirror(-a3, b3);
    vec3 toSender = (0.1f + a.w) * c3;
    float power = 128.0f * b.w * b.w;
    return vec4(vtkiGlossyWeight(toSender, a3, b3, mirror, power, 0.1f + a.w),
      vtkiGlossyVariation(toSender, a3, mirror, power, 0.1f + a.w, 0.05f * b.w, 0.1f * a.w,
        0.2f + b.w, c.w > 0.0f),
      mirror.x, mirror.y);
  }
  if (kernel == 25)
  {
    // Codes are packed on the host; here random codes are unpacked.
    vec4 plane = vtkiUnpackPlane(
      int(30.99f * a.w) | (int(30.99f * b.w * b.w) << 5) | (int(1.0f + 62.99f * a.w * a.w) << 10));
    vec3 place = 8.0f * (a3 + 1.0f);
    return vec4(vtkiLeavePlane(place, plane), dot(vec3(plane.x, plane.y, plane.z), c3) + plane.w);
  }
  if (kernel == 26)
  {
    return vec4(vtkiUnpackAlbedo(vtkiPackAlbedo(a3)), 0.0f);
  }
  if (kernel == 27)
  {
    // Words with many ones, so that runs have all lengths.
    uint bit = 1u << uint(int(31.0f * a.w));
    uint edges = floatBitsToUint(a.x) | 0xf0fff0ffu;
    uint breaks = floatBitsToUint(a.y) & floatBitsToUint(b.x) & floatBitsToUint(b.y) & bit;
    int forward = vtkiRunForward(edges | 1u, breaks);
    int backward = vtkiRunBackward(edges | 0x80000000u, breaks);
    uint across = floatBitsToUint(c.x) & 15u;
    float end = vtkiRunEnd(across, bit & 15u, floatBitsToUint(c.y) & 15u, c.w > 0.0f);
    vec2 areas = vtkiRunAreas(backward, forward, end, c.w > 0.0f ? 0.5f : -0.5f);
    vec2 shares = vtkiNeighborShares(areas.x, areas.y);
    return vec4(areas.x + float(forward), areas.y + float(backward),
      shares.x + vtkiEdgeStrength(0.2f * b.w), shares.y);
  }
  if (kernel == 28)
  {
    float power = pow(10.0f, 6.0f * b.w) - 1.0f;
    vec3 up = dot(a3, b3) < 0.0f ? -a3 : a3;
    vec3 toSender = (0.1f + a.w) * (c.w > 0.0f ? c3 : normalize(-b3 + 0.002f * c3));
    return vec4(vtkiSenderLobeWeight(toSender, up, -b3, b3, power, 0.01f + a.w * a.w),
      vtkiPhongFlux(power, a.w), vtkiLobeIntegral(power, a.w),
      vtkiExponentOfRoughness(0.1f + 0.9f * b.w));
  }
  if (kernel == 29)
  {
    // A sphere, seen from a position with the normal b3 under a light from around c3.
    float sine = vtkiProxySine((0.2f + a.w) * a3, 0.3f * b.w, b3, false);
    vec4 zonal = -4.0f * vtkiProxyRow(sine) * vec4(1.0f, 1.4f, 1.3f, 1.0f);
    vtkiHarmonics4 seen = vtkiHarmonicsExp(vtkiZonalTo(zonal, a3));
    vtkiHarmonics4 light = vtkiZonalTo(vec4(1.0f, 0.8f, 0.5f, 0.2f), c3);
    return vec4(vtkiHarmonicsDot(seen, vtkiLitCosine(vtkiMakeLightMatrix(light), b3)),
      vtkiProxyRadiance(light, a3, sine), vtkiProxyRadianceAtMiddle(light, a3), vtkiProxyOverlap(seen, 0.5f + b.w));
  }
  if (kernel == 30)
  {
    // A lobe along b3, or narrower than a ball of its reach, of any exponent.
    float power = pow(10.0f, 6.0f * b.w) - 1.0f;
    float flux = 0.01f * pow(10.0f, 4.0f * a.w);
    vtkiSplat lobe = vtkiMakeLobeSplat(0.3f * a3, b3, abs(c.w), power, 1.0e-3f, flux);
    vtkiSplat light = vtkiMakeSplat(0.3f * a3, b3, power, a.w, 0.1f * b.w);
    return vec4(dot(lobe.center - 0.3f * a3, b3), lobe.along, lobe.across, light.across);
  }
  return vec4(VTKI_PI, VTKI_GAMMA, float(VTKI_MAP_FACES), VTKI_SURFACE_UNLIT);
}
#endif
