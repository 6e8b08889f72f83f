// Occlusion and light of spheres, groups of spheres and flat polygons at a receiver.
#include "vtkIndirectProxyBlock.glsl"
#include "vtkIndirectLibTable.glsl"

uniform sampler2D vtkiProxyCenter; // centre, radius
uniform sampler2D vtkiProxyRegion; // vtkiRegion
uniform sampler2D vtkiProxyAlbedo; // albedo, sender
uniform sampler2D vtkiProxyTable;  // a row of zonal logarithms over 1 - cos
uniform int vtkiProxyCount;
uniform bool vtkiProxyHides;
uniform bool vtkiEyeIsInside; // a sphere contains the eye
// This is the light that entries send and, from row vtkiSenderRow on, light that falls on senders,
// in pairs: a + b n of each colour, a and b.x; red b.y and b.z; green, blue; the open share of the
// half space around n, the same.
uniform sampler2D vtkiSentLight0;
uniform sampler2D vtkiSentLight1;
uniform int vtkiSenderRow;
// Scale from texels to texture coordinates of entries and of their light: software samples the
// nearest texel faster than it fetches one.
uniform vec2 vtkiEntryScale;
uniform vec2 vtkiLightScale;
// position; radius, or the area that a place of a polygon represents
uniform sampler2D vtkiSenderPlace;
uniform float vtkiProxyLightReach; // radii within which a sphere sends; 0: everywhere
#ifdef VTKI_PROXY_SENDERS
// Centre of the sphere whose light is summed. A sphere does not hide itself: its normals' cosines
// do that, and the half space behind one of its places is in front of others.
vec3 vtkiOwnCenter = vec3(1.0e30f);
// True if light is summed for all normals of a sphere, at a place of it with the given normal.
bool vtkiAllNormals = false;
// 1 if that place is inside of another sphere; 0 from a quarter of that sphere's radius on.
float vtkiOwnBuried = 0.0f;
#endif

struct vtkiProxySums
{
  vtkiHarmonics4 hidden; // sum of logarithms
  vec4 sent;             // irradiance; solid angle, or with VTKI_PROXY_SHADOWED irradiance of radiance 1
};

vtkiProxySums vtkiNoProxies()
{
  vtkiProxySums sums;
  sums.hidden = vtkiHarmonics4(vec4(0.0f), vec4(0.0f), vec4(0.0f), vec4(0.0f));
  sums.sent = vec4(0.0f);
  return sums;
}

// Returns the logarithm of the visibility that a disk around +z leaves, by half its sine.
vec4 vtkiZonalLog(float sine)
{
  float share = vtkiProxyRow(sine);
  float place = (share * float(VTKI_PROXY_TABLE - 1) + 0.5f) / float(VTKI_PROXY_TABLE);
  return share * textureLod(vtkiProxyTable, vec2(place, 0.5f), 0.0f);
}

// Radiance of a sphere of albedo 1 towards the receiver, in light without occlusion (Eq 15; with
// VTKI_PROXY_MIDDLE Eq 13).
vec3 vtkiSphereRadiance(vtkiHarmonics4 y, float sine)
{
#ifdef VTKI_PROXY_MIDDLE
  // The sphere's normal at its middle is -d.
  vec3 bands = vec3(0.28209479f, -0.48860251f, 0.63078313f);
#else
  vec3 bands = vtkiProxyAverage(sine);
#endif
  bands *= vec3(3.54490770f, 2.04665341f * (2.0f / 3.0f), 1.58533092f * 0.25f);
  vec4 b1 = bands.y * vec4(0.0f, y.A.y, y.A.z, y.A.w);
  vec4 b2 = bands.z * y.B;
  float b3 = bands.z * y.C.x;
  vec3 radiance;
  for (int color = 0; color < 3; ++color)
  {
    int row = VTKI_PROXY_COLOR_ROWS * color + 36;
    vec4 l0 = vtkiProxyRows[row];
    radiance[color] =
      bands.x * y.A.x * l0.x + dot(b1, l0) + dot(b2, vtkiProxyRows[row + 1]) + b3 * vtkiProxyRows[row + 2].x;
  }
  return max(radiance, vec3(0.0f));
}

vec4 vtkiFirst(vec4 pairs)
{
  return uintBitsToFloat(floatBitsToUint(pairs) & uvec4(0xffff0000u));
}

vec4 vtkiSecond(vec4 pairs)
{
  return uintBitsToFloat(floatBitsToUint(pairs) << uvec4(16u));
}

// Packs the light of vtkiLightOfSender into pairs.
void vtkiPairLight(vec4 light[4], out vec4 pairs[2])
{
  pairs[0] = vec4(vtkiPair(light[0].r, light[0].a), vtkiPair(light[0].g, light[1].r), vtkiPair(light[0].b, light[1].g),
    vtkiPair(light[1].b, light[2].g));
  pairs[1] = vec4(vtkiPair(light[1].a, light[2].b), vtkiPair(light[2].r, light[2].a),
    vtkiPair(light[3].r, light[3].g), vtkiPair(light[3].b, light[3].a));
}

// Irradiance a + b n of an entry's light, for a vector n; in the fourth component its openness
// there.
vec4 vtkiEntryIrradiance(ivec2 at, vec3 n)
{
  vec2 place = (vec2(at) + 0.5f) * vtkiLightScale;
  vec4 l0 = textureLod(vtkiSentLight0, place, 0.0f);
  vec4 l1 = textureLod(vtkiSentLight1, place, 0.0f);
  vec4 first0 = vtkiFirst(l0);
  vec4 first1 = vtkiFirst(l1);
  vec4 second0 = vtkiSecond(l0);
  vec4 second1 = vtkiSecond(l1);
  vec3 e = first0.rgb + n.x * second0.rgb + n.y * vec3(first0.a, first1.rg) + n.z * vec3(second0.a, second1.rg);
  return max(vec4(e, first1.b + n.x * second1.b + n.y * first1.a + n.z * second1.a), vec4(0.0f, 0.0f, 0.0f, 0.02f));
}

// Adds an entry of the tree of spheres. Returns the next entry: the first child, which follows it,
// if the children count.
int vtkiAddProxy(vec3 position, vec3 normal, int number, inout vtkiProxySums sums)
{
  ivec2 at = vtkiTableTexel(number);
  vec2 place = (vec2(at) + 0.5f) * vtkiEntryScale;
  vec4 sphere = textureLod(vtkiProxyCenter, place, 0.0f);
  vtkiRegion region = vtkiUnpackRegion(textureLod(vtkiProxyRegion, place, 0.0f));
#if defined(VTKI_PROXY_SENDERS) && defined(VTKI_PROXY_TREE)
  // Groups of up to twice the angle suffice to find where a place is open, and how bright.
  float share = dot(normal, normal) > 0.0f && !vtkiAllNormals ? 1.0f : 0.5f;
  region.Outer *= share;
  region.Inner *= share;
#endif
  vec3 toCenter = sphere.xyz - position;
  float d = length(toCenter);
  float toOuter = length(toCenter + region.ToOuter);
  float weight = vtkiProxyWeight(toOuter, region.Outer, d, region.Inner);
  vec3 direction = toCenter / max(d, 1.0e-30f);
  float sine = 0.0f;
  float inside = 0.0f;
  if (weight > 0.0f)
  {
#ifdef VTKI_PROXY_SENDERS
    bool own = all(equal(sphere.xyz, vtkiOwnCenter));
    if (!(dot(normal, normal) > 0.0f))
    {
      // For a place among spheres: spheres around it count as nothing.
      sine = d > sphere.w ? sphere.w / d : 0.0f;
    }
    else if (vtkiAllNormals && !own)
    {
      sine = vtkiProxySine(toCenter, sphere.w, normal, false);
      vtkiOwnBuried =
        region.Inner > 0.0f ? vtkiOwnBuried : max(vtkiOwnBuried, clamp(5.0f - 4.0f * d / sphere.w, 0.0f, 1.0f));
    }
    else if (!own)
#endif
    {
      sine = vtkiProxySine(toCenter, sphere.w, normal, region.Inner < 0.0f);
      weight *= vtkiProxyAbove(dot(direction, normal), sine);
      inside = vtkiEyeIsInside && !(region.Inner > 0.0f) ? vtkiProxyInside(toCenter, sphere.w, normal) : 0.0f;
    }
  }
  // A receiver inside of a body gets nothing from around the body: this logarithm leaves 2e-9 of
  // the sky, and beside this weight without light no sender counts in the mean of all senders.
  sums.hidden.A.x -= (20.0f / VTKI_HARMONICS_Y00) * inside;
  sums.sent.a += 1.0e3f * inside;
  if (weight > 0.0f && sine > 0.0f)
  {
    vec4 zonal = weight * vtkiZonalShare(vtkiZonalLog(sine), sine, region.Share) *
      vec4(3.54490770f, 2.04665341f, 1.58533092f, 1.33984918f);
    vtkiHarmonics4 y = vtkiHarmonics4At(direction);
    sums.hidden.A += y.A * vec4(zonal.x, zonal.y, zonal.y, zonal.y);
    sums.hidden.B += y.B * zonal.z;
    sums.hidden.C += y.C * vec4(zonal.z, zonal.w, zonal.w, zonal.w);
    sums.hidden.D += y.D * zonal.w;
    weight *= region.Share;
#ifdef VTKI_PROXY_LIGHT
    float reach = vtkiProxyLightReach > 0.0f ? vtkiProxyWithin(d, vtkiProxyLightReach * sphere.w) : 1.0f;
#ifdef VTKI_PROXY_SHADOWED
    // Averaged over the disk, whose mean normal is -d times a length. The part that is closed
    // towards the receiver is not visible from it and does not count in the mean of all that hides
    // the sky.
    vec4 sent = vtkiEntryIrradiance(at, (vtkiProxyAverage(sine).y / 0.48860251f) * direction);
    vec3 radiance = sent.rgb;
    reach *= sent.a;
#elif !defined(VTKI_PROXY_EXACT)
    vec3 radiance = vtkiSphereRadiance(y, sine) * texelFetch(vtkiProxyAlbedo, at, 0).rgb;
#endif
    weight *= reach;
#ifdef VTKI_PROXY_EXACT
    float given = weight * 2.0f * VTKI_PI * vtkiProxyRow(sine);
    vtkiProxyOperator exact = vtkiExactOperator(sine);
    vec3 radiance = vec3(vtkiProxyExactIrradiance(exact, vtkiProxyLightOf(0), direction, normal),
      vtkiProxyExactIrradiance(exact, vtkiProxyLightOf(1), direction, normal),
      vtkiProxyExactIrradiance(exact, vtkiProxyLightOf(2), direction, normal));
    radiance *= texelFetch(vtkiProxyAlbedo, at, 0).rgb;
#else
    float given = weight * vtkiDiskIrradiance(sine, dot(direction, normal));
#endif
#if defined(VTKI_PROXY_SHADOWED) || defined(VTKI_PROXY_EXACT)
    float counted = given;
#else
    float counted = weight * 2.0f * VTKI_PI * vtkiProxyRow(sine);
#endif
    sums.sent += vec4(given * radiance, counted);
#endif
  }
  bool above = dot(toCenter, normal) > -region.Bound;
#ifdef VTKI_PROXY_SENDERS
  above = above || vtkiAllNormals || !(dot(normal, normal) > 0.0f);
#endif
  // An entry wholly below the receiver's horizon hides nothing from it.
  return toOuter < region.Outer && d < region.Inner && above ? number + 1 : int(region.Next);
}

// Adds all entries that count for a receiver, if `lit`.
vtkiProxySums vtkiSumProxies(vec3 position, vec3 normal, bool lit)
{
  vtkiProxySums sums = vtkiNoProxies();
  int next = lit && vtkiProxyCount > 0 ? 0 : -1;
  while (next >= 0)
  {
    next = vtkiAddProxy(position, normal, next, sums);
  }
  return sums;
}

// This is the light of a receiver: from the unoccluded sky, a + b n of each colour for normals
// about its own; and from proxies, at its own normal.
struct vtkiProxyLit
{
  vec4 sky[3]; // b, a
  vec3 bounce;
};

// Visible light of one colour, in the first nine coefficients.
vtkiHarmonics4 vtkiSeenLight(vtkiHarmonics4 seen, int color)
{
  int row = VTKI_PROXY_COLOR_ROWS * color;
  vtkiHarmonics4 light;
  for (int i = 0; i < 4; ++i)
  {
    light.A[i] = vtkiHarmonicsDot(vtkiProxyHarmonics(row + 4 * i), seen);
    light.B[i] = vtkiHarmonicsDot(vtkiProxyHarmonics(row + 16 + 4 * i), seen);
  }
  light.C = vec4(vtkiHarmonicsDot(vtkiProxyHarmonics(row + 32), seen), 0.0f, 0.0f, 0.0f);
  light.D = vec4(0.0f);
  return light;
}

#ifdef VTKI_PROXY_SHADOWED
// Returns the mean irradiance of the places on a polygon's side, each weighted as a disk by its
// form factor.
vec3 vtkiPolygonRadiance(vec3 position, vec3 normal, vec3 side, int first, int count)
{
  vec4 sum = vec4(0.0f);
  for (int i = first; i < first + count; ++i)
  {
    ivec2 at = vtkiTableTexel(i);
    vec4 place = texelFetch(vtkiSenderPlace, at, 0);
    vec3 offset = place.xyz - position;
    float d2 = max(dot(offset, offset), 1.0e-30f);
    // The small constant weights all places by distance if none is above the receiver's plane.
    float cosines = max(dot(offset, normal), 0.0f) * abs(dot(offset, side)) / d2 + 1.0e-4f;
    vec4 light = vtkiFirst(texelFetch(vtkiSentLight0, at + ivec2(0, vtkiSenderRow), 0));
    sum += cosines / (VTKI_PI * d2 + place.w) * vec4(light.rgb, 1.0f);
  }
  return sum.rgb / max(sum.a, 1.0e-30f);
}
#endif

// Removes the sky behind flat polygons from the visible sky, each as the disk that gives all
// receivers above it the same irradiance. The polygon that the receiver lies on hides nothing.
// Polygons are few and large: the product with the visibility of one is exact to order 4, whereas a
// disk that fills half of the sphere has no logarithm.
void vtkiAddPolygons(vec3 position, vec3 normal, inout vtkiHarmonics4 seen, inout vec3 bounce)
{
  vtkiHarmonics4 open = seen; // visibility that spheres leave, also of the polygons
  for (int i = 0; i < vtkiPolygonCount; ++i)
  {
    int row = VTKI_PROXY_LIGHT_ROWS + VTKI_POLYGON_ROWS * i;
    vec4 plane = vtkiProxyRows[row];
    vec4 albedo = vtkiProxyRows[row + 1];
    int corners = int(plane.w);
    // Moved off its surface, so that in a crease with the polygon the receiver is on the side that
    // it faces.
    vec3 place = position + (2.0e-4f * albedo.w + 1.0e-6f) * normal;
    float height = dot(plane.xyz, place - vtkiProxyRows[row + 2].xyz);
    vec3 sum = vec3(0.0f);
    vec3 before = normalize(vtkiProxyRows[row + 1 + corners].xyz - place);
    for (int k = 0; k < corners; ++k)
    {
      vec3 next = normalize(vtkiProxyRows[row + 2 + k].xyz - place);
      sum += vtkiPolygonEdge(before, next);
      before = next;
    }
    // Polygons are visible from either side.
    vec3 side = height >= 0.0f ? plane.xyz : -plane.xyz;
    sum = dot(sum, side) > 0.0f ? -sum : sum;
    vec4 disk = vtkiPolygonDisk(sum);
    // A polygon below the receiver's horizon would count only by the ringing of order 4 into the
    // upper half.
    bool own = abs(height) < 4.0e-4f * albedo.w + 2.0e-6f && abs(dot(plane.xyz, normal)) > 0.9f;
    bool below = dot(disk.xyz, normal) < -0.9999f * max(disk.w, 1.0e-6f);
    if (!own && !below && disk.w > 0.0f)
    {
      vtkiHarmonics4 filled = vtkiZonalTo(vtkiZonalDisk(disk.w), disk.xyz);
      seen = vtkiHarmonicsAdd(seen, -1.0f, vtkiHarmonicProduct(seen, filled));
#ifdef VTKI_PROXY_LIGHT
#ifdef VTKI_PROXY_SHADOWED
      int count = int(vtkiProxyRows[row + 3].w);
      int first = int(vtkiProxyRows[row + 2].w) + (height >= 0.0f ? 0 : count);
      vec3 radiance = vtkiPolygonRadiance(position, normal, plane.xyz, first, count);
#else
      vtkiHarmonics4 cosine = vtkiClampedCosine(side);
      vec3 radiance = max(vec3(vtkiHarmonicsDot(cosine, vtkiProxyLightOf(0)),
        vtkiHarmonicsDot(cosine, vtkiProxyLightOf(1)), vtkiHarmonicsDot(cosine, vtkiProxyLightOf(2))), vec3(0.0f));
#endif
      vtkiHarmonics4 sent = vtkiHarmonicProduct(open, filled);
      bounce += max(vtkiHarmonicsDot(sent, vtkiClampedCosine(normal)), 0.0f) * albedo.rgb * radiance;
#endif
    }
  }
}

// Returns the sky that remains visible. bounce: light from proxies.
vtkiHarmonics4 vtkiSeenSky(vec3 position, vec3 normal, vtkiProxySums sums, out vec3 bounce)
{
  vtkiHarmonics4 seen = vtkiHarmonicsExp(sums.hidden);
  bounce = vec3(0.0f);
#ifdef VTKI_PROXY_LIGHT
#ifdef VTKI_PROXY_SHADOWED
  bounce = vtkiProxyMean(seen, normal, sums.sent.a) * sums.sent.rgb;
#else
  bounce = vtkiProxyOverlap(seen, sums.sent.a) * sums.sent.rgb;
#endif
#endif
  if (vtkiPolygonCount > 0)
  {
    vtkiAddPolygons(position, normal, seen, bounce);
  }
  if (!vtkiProxyHides)
  {
    seen = vtkiHarmonics4(vec4(1.0f / VTKI_HARMONICS_Y00, 0.0f, 0.0f, 0.0f), vec4(0.0f), vec4(0.0f), vec4(0.0f));
  }
  return seen;
}

vtkiProxyLit vtkiResolveProxies(vec3 position, vec3 normal, vtkiProxySums sums)
{
  vtkiProxyLit lit;
  vtkiHarmonics4 seen = vtkiSeenSky(position, normal, sums, lit.bounce);
  for (int color = 0; color < 3; ++color)
  {
    vtkiHarmonics4 light = vtkiSeenLight(seen, color);
    vec3 gradient = vtkiIrradianceGradient(light, normal);
    float own = vtkiHarmonicsDot(light, vtkiClampedCosine(normal));
    lit.sky[color] = vec4(gradient, own - dot(gradient, normal));
  }
  return lit;
}

// Returns the irradiance of the sky at a normal.
vec3 vtkiProxyIrradiance(vec4 sky[3], vec3 normal)
{
  vec4 n = vec4(normal, 1.0f);
  return max(vec3(dot(sky[0], n), dot(sky[1], n), dot(sky[2], n)), vec3(0.0f));
}
