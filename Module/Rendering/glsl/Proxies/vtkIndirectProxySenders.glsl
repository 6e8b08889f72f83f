// Light that falls on what sends: on groups of a few spheres, found where they are open, and on flat polygons.
uniform sampler2D vtkiSenderPlace;  // place, radius
uniform sampler2D vtkiSenderNormal; // normal; a fourth component of 1 where there is one
uniform sampler2D vtkiProxyBlocks;  // lower, upper corner of the box of each block of entries
uniform int vtkiBlockCount;

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
// lower the more is hidden, and their linear part points away from that.
void vtkiOpenSender(vtkiProxySums around, inout vec4 place, inout vec4 normal)
{
  vec3 open = vec3(around.hidden.A.w, around.hidden.A.y, around.hidden.A.z);
  float size = length(open);
  if (!(normal.w > 0.0f))
  {
    normal = vec4(size > 1.0e-6f ? open / size : vec3(0.0f, 0.0f, 1.0f), 0.0f);
    place.xyz += place.w * normal.xyz;
  }
}

// Irradiance of a sphere's normals, a + b n of each colour, where nothing but what was summed hides the sky, and how
// open it is among spheres alone; of a polygon's one normal.
void vtkiLightOfSender(vtkiProxySums spheres, vec4 place, vec4 normal, out vec4 light[4])
{
  vtkiHarmonics4 seen = vtkiHarmonicsExp(spheres.hidden);
  light[3] = vec4(0.28209479f * seen.A.x, 0.32573501f * seen.A.w, 0.32573501f * seen.A.y, 0.32573501f * seen.A.z);
  vtkiProxyLit lit = vtkiResolveProxies(place.xyz, normal.xyz, spheres);
  vec3 a = 0.28209479f * lit.sky[0];
  vec3 bx = 0.32573501f * lit.sky[3];
  vec3 by = 0.32573501f * lit.sky[1];
  vec3 bz = 0.32573501f * lit.sky[2];
  if (normal.w > 0.0f)
  {
    a = vtkiProxyIrradiance(lit.sky, normal.xyz);
    bx = vec3(0.0f);
    by = vec3(0.0f);
    bz = vec3(0.0f);
    light[3] = vec4(1.0f, 0.0f, 0.0f, 0.0f);
  }
  light[0] = vec4(a, bx.r);
  light[1] = vec4(bx.gb, by.rg);
  light[2] = vec4(by.b, bz);
}
