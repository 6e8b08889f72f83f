// Light that falls on what sends: on groups of a few spheres, found where they are open, and on flat polygons.
uniform sampler2D vtkiSenderNormal; // normal; a fourth component of 1 where there is one
uniform sampler2D vtkiProxyBlocks;  // lower, upper corner of the box of each block of entries
uniform int vtkiBlockCount;
uniform int vtkiSenderCount;

// Length of the linear part of what is hidden from the middle of a sphere from which on it is lit at its open side.
const float VTKI_ONE_SIDED = 8.0f;

bool vtkiMeetsBlock(int block, vec3 middle, vec3 halfSize)
{
  vec3 lower = texelFetch(vtkiProxyBlocks, ivec2(0, block), 0).xyz;
  vec3 upper = texelFetch(vtkiProxyBlocks, ivec2(1, block), 0).xyz;
  return all(lessThanEqual(lower, middle + halfSize)) && all(greaterThanEqual(upper, middle - halfSize));
}

void vtkiFetchSender(int number, out vec4 place, out vec4 normal)
{
  ivec2 at = vtkiTableTexel(number);
  place = texelFetch(vtkiSenderPlace, at, 0);
  normal = texelFetch(vtkiSenderNormal, at, 0);
}

// Moves spheres without a normal to the side of theirs from which most of the sky is seen: sums of logarithms are the
// lower the more is hidden, and their linear part points away from that. The shorter it is, the closer they stay to the
// middle: no side of what floats is much more open than others, and the most open one would stand for all. Not where
// the middle is inside of another sphere: what is said there is of no place that is seen.
void vtkiOpenSender(vtkiProxySums around, inout vec4 place, inout vec4 normal)
{
  vec3 open = vec3(around.hidden.A.w, around.hidden.A.y, around.hidden.A.z);
  float size = length(open);
#ifdef VTKI_PROXY_SENDERS
  vtkiOwnCenter = normal.w > 0.0f ? vec3(1.0e30f) : place.xyz;
  vtkiAllNormals = !(normal.w > 0.0f);
#endif
  if (!(normal.w > 0.0f))
  {
    normal = vec4(size > 1.0e-6f ? open / size : vec3(0.0f, 0.0f, 1.0f), 0.0f);
    float share = 1.0f;
#ifdef VTKI_PROXY_SENDERS
    share = clamp(max(size / VTKI_ONE_SIDED, vtkiOwnBuried), 0.0f, 1.0f);
#endif
    place.xyz += share * place.w * normal.xyz;
  }
}

// Irradiance of a sphere's normals, a + b n of each colour, where nothing but what was summed hides the sky, and how
// open it is among spheres alone; of a polygon's one normal.
void vtkiLightOfSender(vtkiProxySums spheres, vec4 place, vec4 normal, out vec4 light[4])
{
  vtkiHarmonics4 seen = vtkiHarmonicsExp(spheres.hidden);
  light[3] = vec4(0.28209479f * seen.A.x, 0.32573501f * seen.A.w, 0.32573501f * seen.A.y, 0.32573501f * seen.A.z);
  vec3 bounce;
  vtkiHarmonics4 all = vtkiSeenSky(place.xyz, normal.xyz, spheres, bounce);
  vec3 a;
  vec3 bx;
  vec3 by;
  vec3 bz;
  for (int color = 0; color < 3; ++color)
  {
    vtkiHarmonics4 sky = vtkiSeenLight(all, color);
    a[color] = 0.28209479f * sky.A.x;
    bx[color] = 0.32573501f * sky.A.w;
    by[color] = 0.32573501f * sky.A.y;
    bz[color] = 0.32573501f * sky.A.z;
    if (normal.w > 0.0f)
    {
      a[color] = max(vtkiHarmonicsDot(sky, vtkiClampedCosine(normal.xyz)), 0.0f);
      bx[color] = 0.0f;
      by[color] = 0.0f;
      bz[color] = 0.0f;
    }
  }
  light[3] = normal.w > 0.0f ? vec4(1.0f, 0.0f, 0.0f, 0.0f) : light[3];
  light[0] = vec4(a, bx.r);
  light[1] = vec4(bx.gb, by.rg);
  light[2] = vec4(by.b, bz);
}
