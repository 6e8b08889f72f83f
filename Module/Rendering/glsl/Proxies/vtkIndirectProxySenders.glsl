// Light that falls on senders: on groups of a few spheres, at positions where these are open, and
// on flat polygons.
uniform sampler2D vtkiSenderNormal; // normal; in the fourth component 1 if there is one
uniform sampler2D vtkiProxyBlocks;  // lower, upper corner of the box of each block of entries
uniform int vtkiBlockCount;
uniform int vtkiSenderCount;

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

// Moves spheres without a normal to the side from which most of the sky is visible: the sums of
// logarithms are lower where more is hidden, and their linear part points away from that.
void vtkiOpenSender(vtkiProxySums around, inout vec4 place, inout vec4 normal)
{
#ifdef VTKI_PROXY_SENDERS
  vtkiOwnCenter = normal.w > 0.0f ? vec3(1.0e30f) : place.xyz;
  vtkiAllNormals = !(normal.w > 0.0f);
#endif
  if (!(normal.w > 0.0f))
  {
    vec3 open = vec3(around.hidden.A.w, around.hidden.A.y, around.hidden.A.z);
    float size = length(open);
    normal = vec4(size > 1.0e-6f ? open / size : vec3(0.0f, 0.0f, 1.0f), 0.0f);
    place.xyz += place.w * normal.xyz;
  }
}

#ifdef VTKI_PROXY_SENDERS
// Moves a place to the opposite side of the sphere.
void vtkiTurnSender(inout vec4 place, inout vec4 normal)
{
  place.xyz -= 2.0f * place.w * normal.xyz;
  normal.xyz = -normal.xyz;
  vtkiOwnBuried = 0.0f;
}

// Light of a sphere from the light at both of its sides along n: each side's own normal takes it
// from there, perpendicular normals from both, and the mean is that of an octahedron's corners. The
// open side alone would represent the darker ones as well. A side inside of another sphere is
// invisible; there the open side does represent it.
void vtkiLightOfSides(vec4 front[4], vec4 back[4], vec3 n, out vec4 light[4])
{
  // r, g, b and openness, of a + b n.
  vec4 a = vec4(front[0].rgb, front[3].x);
  vec4 bx = vec4(front[0].a, front[1].rg, front[3].y);
  vec4 by = vec4(front[1].ba, front[2].r, front[3].z);
  vec4 bz = vec4(front[2].gba, front[3].w);
  vec4 backA = mix(vec4(back[0].rgb, back[3].x), a, vtkiOwnBuried);
  vec4 backX = mix(vec4(back[0].a, back[1].rg, back[3].y), bx, vtkiOwnBuried);
  vec4 backY = mix(vec4(back[1].ba, back[2].r, back[3].z), by, vtkiOwnBuried);
  vec4 backZ = mix(vec4(back[2].gba, back[3].w), bz, vtkiOwnBuried);
  vec4 first = a + n.x * bx + n.y * by + n.z * bz;
  vec4 second = backA - n.x * backX - n.y * backY - n.z * backZ;
  a = (first + second) / 6.0f + (a + backA) / 3.0f;
  bx = 0.5f * (bx + backX);
  by = 0.5f * (by + backY);
  bz = 0.5f * (bz + backZ);
  vec4 along = 0.5f * (first - second) - n.x * bx - n.y * by - n.z * bz;
  bx += n.x * along;
  by += n.y * along;
  bz += n.z * along;
  light[0] = vec4(a.rgb, bx.r);
  light[1] = vec4(bx.gb, by.rg);
  light[2] = vec4(by.b, bz.rgb);
  light[3] = vec4(a.a, bx.a, by.a, bz.a);
}
#endif

// Irradiance of a sphere's normals, a + b n of each colour, where only the summed spheres hide the
// sky, and the share that spheres leave open; for a polygon, of its one normal.
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
