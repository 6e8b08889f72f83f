// Specular reflection of a parallelogram of one radiance, without occlusion.
#ifndef vtkIndirectLibLobe
#define vtkIndirectLibLobe
#include "vtkIndirectLibAreaLight.glsl"

/* Clips a parallelogram, seen from the receiver, by two planes through the receiver: the horizon,
 * and that of an axis. The clipped outline is that of the parallelogram above both planes, and
 * follows either plane where that crosses it. */
struct vtkiCutter
{
  vec3 corner;
  vec3 edge1;
  vec3 edge2;
  vec3 normal;
  vec3 axis;
  vec3 leave; // ends of the outline along the horizon
  vec3 enter;
  vec3 leaveAxis; // ends of the outline along the axis's plane
  vec3 enterAxis;
};

const int VTKI_CUTTER_EDGES = 6;

struct vtkiCutEdge
{
  vec3 from;
  vec3 to;
  bool there;
};

vtkiCutter vtkiMakeCutter(vec3 corner, vec3 edge1, vec3 edge2, vec3 normal, vec3 axis)
{
  vtkiCutter cutter;
  cutter.corner = corner;
  cutter.edge1 = edge1;
  cutter.edge2 = edge2;
  cutter.normal = normal;
  cutter.axis = axis;
  cutter.leave = vec3(0.0f);
  cutter.enter = vec3(0.0f);
  cutter.leaveAxis = vec3(0.0f);
  cutter.enterAxis = vec3(0.0f);
  return cutter;
}

vec3 vtkiCutterCorner(vtkiCutter cutter, int i)
{
  return cutter.corner + (i == 1 || i == 2 ? cutter.edge1 : vec3(0.0f)) +
    (i == 2 || i == 3 ? cutter.edge2 : vec3(0.0f));
}

/* Part of the outline's edge i above both planes, i from 0 to 5 in turn. */
vtkiCutEdge vtkiNextEdge(VTKI_INOUT(vtkiCutter) cutter, int i)
{
  vec3 a = i < 4 ? vtkiCutterCorner(cutter, i) : (i == 4 ? cutter.leave : cutter.leaveAxis);
  vec3 b =
    i < 4 ? vtkiCutterCorner(cutter, i == 3 ? 0 : i + 1) : (i == 4 ? cutter.enter : cutter.enterAxis);
  // Edges along a plane lie in it in spite of rounding; if both planes coincide, the horizon
  // counts.
  float same = 1.0e-5f * (length(a) + length(b));
  float a1 = i == 4 ? 1.0f : dot(cutter.normal, a) - (i == 5 ? same : 0.0f);
  float b1 = i == 4 ? 1.0f : dot(cutter.normal, b) - (i == 5 ? same : 0.0f);
  float sameAxis = i == 4 ? same * length(cutter.axis) : 0.0f;
  float a2 = i == 5 ? 1.0f : dot(cutter.axis, a) + sameAxis;
  float b2 = i == 5 ? 1.0f : dot(cutter.axis, b) + sameAxis;
  bool falls1 = a1 > 0.0f && b1 <= 0.0f;
  bool rises1 = a1 <= 0.0f && b1 > 0.0f;
  bool falls2 = a2 > 0.0f && b2 <= 0.0f;
  bool rises2 = a2 <= 0.0f && b2 > 0.0f;
  float at1 = falls1 || rises1 ? a1 / (a1 - b1) : 0.0f;
  float at2 = falls2 || rises2 ? a2 / (a2 - b2) : 0.0f;
  vec3 way = b - a;
  cutter.leave = i < 4 && falls1 ? a + at1 * way : cutter.leave;
  cutter.enter = i < 4 && rises1 ? a + at1 * way : cutter.enter;
  cutter.leaveAxis = i < 4 && falls2 ? a + at2 * way : cutter.leaveAxis;
  cutter.enterAxis = i < 4 && rises2 ? a + at2 * way : cutter.enterAxis;
  float begin = max(rises1 ? at1 : 0.0f, rises2 ? at2 : 0.0f);
  float end = min(falls1 ? at1 : 1.0f, falls2 ? at2 : 1.0f);
  vtkiCutEdge edge;
  edge.from = a + begin * way;
  edge.to = a + end * way;
  edge.there = end > begin && max(a1, b1) > 0.0f && max(a2, b2) > 0.0f;
  return edge;
}

/* A linear map from directions to a cosine's distribution about the third axis: its rows. Heitz,
 * Dupuy, Hill, Neubelt 2016, "Real-time polygonal-light shading with linearly transformed cosines".
 * The scale is irrelevant. */
struct vtkiTransform
{
  vec3 x;
  vec3 y;
  vec3 z;
};

vec3 vtkiTransformWay(vtkiTransform t, vec3 way)
{
  return vec3(dot(t.x, way), dot(t.y, way), dot(t.z, way));
}

/* entry: the table's four numbers that are neither zero nor one. toEye: unit. */
vtkiTransform vtkiTableTransform(vec4 entry, vec3 normal, vec3 toEye)
{
  vec3 across = toEye - dot(normal, toEye) * normal;
  float square = dot(across, across);
  // For a perpendicular view any direction across the normal serves.
  vec3 other = abs(normal.x) < 0.7f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
  vec3 x = square > 1.0e-10f ? across / sqrt(square) : normalize(cross(normal, other));
  vtkiTransform t;
  t.x = entry.x * x + entry.y * normal;
  t.y = cross(normal, x);
  t.z = entry.z * x + entry.w * normal;
  return t;
}

/* Transformed cosines about the mirror direction, of about the width of cos^power: identical for
 * power 1, of least squared difference for large powers, a third of the lobe apart. Used for shares
 * of a light's parts, not for its total. */
vtkiTransform vtkiPowerTransform(vec3 mirror, float power)
{
  vec3 other = abs(mirror.x) < 0.7f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
  vtkiTransform t;
  t.x = normalize(cross(mirror, other));
  t.y = cross(mirror, t.x);
  t.z = sqrt(1.7f / (power + 0.7f)) * mirror;
  return t;
}

/* Share of transformed cosines over the part of a parallelogram above the horizon. Zero if not
 * asked for. */
float vtkiTransformedShare(
  vec3 corner, vec3 edge1, vec3 edge2, vec3 normal, vtkiTransform t, bool asked)
{
  vtkiCutter cutter = vtkiMakeCutter(corner, edge1, edge2, normal, t.z);
  float sum = 0.0f;
  int count = asked ? VTKI_CUTTER_EDGES : 0;
  for (int i = 0; i < count; ++i)
  {
    vtkiCutEdge edge = vtkiNextEdge(cutter, i);
    float term = vtkiEdgeTerm(vtkiTransformWay(t, edge.from), vtkiTransformWay(t, edge.to),
      vec3(0.0f, 0.0f, 1.0f));
    sum += edge.there ? term : 0.0f;
  }
  // In the rectangle's own plane rounding decides on which side of an edge the receiver is.
  return min(abs(sum) * (0.5f / VTKI_PI), 1.0f);
}

// (1 - (1 - x)^k) / x, without loss of digits for small x.
float vtkiPowerQuotient(float x, float k)
{
  float product = k * x;
  return product < 0.03f && x < 0.03f
    ? k * (1.0f - 0.5f * (k - 1.0f) * x * (1.0f - (k - 2.0f) * x / 3.0f))
    : (1.0f - pow(max(1.0f - x, 0.0f), k)) / x;
}

/* Returns the integral of 1 - cos^(power + 1) over the angle about an axis, along the edge from a
 * to b, both on the axis's side. On a great circle whose normal has the height h over the axis, at
 * the arc t from its nearest point, the axis's cosine is q = sqrt(1 - h^2) cos t, and the angle
 * grows by h / (1 - q^2). The integrand then has no pole and the width of the lobe, over which the
 * nodes are spread: eight Gauss-Legendre nodes over asinh(t / width). */
float vtkiPowerEdge(vec3 a, vec3 b, vec3 axis, float power, bool asked)
{
  vec3 c = cross(a, b - a);
  float sine = length(c);
  vec3 normal = c / max(sine, 1.0e-30f);
  float h = dot(normal, axis);
  vec3 nearest = axis - h * normal;
  float most2 = dot(nearest, nearest);
  float first = most2 > 1.0e-12f ? atan(dot(cross(normal, nearest), a), dot(nearest, a)) : 0.0f;
  float last = first + atan(sine, dot(a, b));
  float k = 0.5f * (power + 1.0f);
  float width = 1.0f / sqrt(k);
  float begin = asinh(first / width);
  float reach = 0.5f * (asinh(last / width) - begin);
  float middle = begin + reach;
  vec4 nodes = vec4(0.1834346425f, 0.5255324099f, 0.7966664774f, 0.9602898565f);
  vec4 weights = vec4(0.3626837834f, 0.3137066459f, 0.2223810345f, 0.1012285363f);
  float sum = 0.0f;
  int count = asked && sine > 0.0f ? 4 : 0;
  for (int i = 0; i < count; ++i)
  {
    float both = 0.0f;
    for (int side = 0; side < 2; ++side)
    {
      float e = exp(middle + (side == 0 ? reach : -reach) * nodes[i]);
      float along = sin(0.5f * width * (e - 1.0f / e));
      both += 0.5f * (e + 1.0f / e) * vtkiPowerQuotient(h * h + most2 * along * along, k);
    }
    sum += weights[i] * both;
  }
  return h * reach * width * sum;
}

/* Returns the integral of cos^power about the mirror direction, unit, over the part of a
 * parallelogram above the horizon and in the mirror direction's hemisphere: VTK's lobe under light
 * of radiance one, times pi. Zero if not asked for. */
float vtkiPowerIntegral(
  vec3 corner, vec3 edge1, vec3 edge2, vec3 normal, vec3 mirror, float power, bool asked)
{
  vtkiCutter cutter = vtkiMakeCutter(corner, edge1, edge2, normal, mirror);
  float sum = 0.0f;
  int count = asked ? VTKI_CUTTER_EDGES : 0;
  for (int i = 0; i < count; ++i)
  {
    vtkiCutEdge edge = vtkiNextEdge(cutter, i);
    float term = vtkiPowerEdge(edge.from, edge.to, mirror, power, edge.there);
    sum += edge.there ? term : 0.0f;
  }
  return min(abs(sum), 2.0f * VTKI_PI) / (power + 1.0f);
}

/* Weight of one of several points of a light that represent equal areas: the disk of its share in
 * the transformed directions, where a smooth lobe resolves nothing finer than the distance of
 * points. way: to the point, transformed; height: of the light's plane over the receiver,
 * transformed; area: transformed. */
float vtkiPointWeight(vec3 way, float height, float area)
{
  float r2 = max(dot(way, way), 1.0e-30f);
  return height * max(way.z, 0.0f) / (r2 * (VTKI_PI * r2 + area));
}

/* Returns the place of a lobe in the table, in [0,1], by the cosine of the view and the roughness.
 */
vec2 vtkiTablePlace(float cosine, float roughness, float least)
{
  return vec2(sqrt(max(1.0f - cosine, 0.0f)), max(roughness - least, 0.0f) / (1.0f - least));
}

/* Reflectance of a lobe under uniform light with VTK's Fresnel term: F0 at perpendicular view, and
 * at grazing angles VTK's value for materials of that F0. integrals: of the lobe, and with
 * Schlick's weight. */
vec3 vtkiFresnelIntegral(vec3 straight, vec2 integrals)
{
  float grazing = min((straight.x + straight.y + straight.z) * 16.5f, 1.0f);
  return straight * (integrals.x - integrals.y) + vec3(grazing * integrals.y);
}
#endif
