// Area lights of a moving frame: irradiance without occlusion, and the share that shadow tests from
// points of the lights leave. VTKI_AREA_LAMPS: lamps in the block; VTKI_AREA_POINTS: points of
// each; VTKI_VISIBILITY: without it lamps cast no shadow; VTKI_AREA_IMAGE: some lamps have images.
#ifndef VTKI_AREA_LAMPS
#define VTKI_AREA_LAMPS 16
#define VTKI_AREA_POINTS 16
#endif
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectLibAreaLight.glsl"
#ifdef VTKI_VISIBILITY
#include "vtkIndirectDepthWindows.glsl"
#endif
#ifdef VTKI_AREA_IMAGE
#include "vtkIndirectAreaImage.glsl"
#endif

layout(std140) uniform vtkiAreaBlock
{
  vec4 vtkiAreaCorner[VTKI_AREA_LAMPS];   // scene units; 1 if it has two sides
  vec4 vtkiAreaEdge1[VTKI_AREA_LAMPS];    // level of the single texel of its image, or -1
  vec4 vtkiAreaEdge2[VTKI_AREA_LAMPS];    // first row of its image
  vec4 vtkiAreaNormal[VTKI_AREA_LAMPS];   // the side that sends light; area of a point's disk
  vec4 vtkiAreaRadiance[VTKI_AREA_LAMPS]; // mean
  // For the depth maps of the front and of the back: their axes; one over the depths at which they
  // begin and end.
  vec4 vtkiAreaRight[2 * VTKI_AREA_LAMPS];
  vec4 vtkiAreaUp[2 * VTKI_AREA_LAMPS];
  vec4 vtkiAreaStripRange[2 * VTKI_AREA_LAMPS]; // the same depths of the maps' strips
  vec4 vtkiAreaStrips[8 * VTKI_AREA_LAMPS];     // windows of the strips, see vtkiIsSeenInWindow
  // By lamps: positions along these axes, from the corner; middle of the tile, or -1 if there is
  // none.
  vec4 vtkiAreaFront[VTKI_AREA_LAMPS * VTKI_AREA_POINTS];
  vec4 vtkiAreaBack[VTKI_AREA_LAMPS * VTKI_AREA_POINTS];
  vec4 vtkiAreaFrontWindow[VTKI_AREA_LAMPS * VTKI_AREA_POINTS]; // see vtkiIsSeenInWindow
  vec4 vtkiAreaBackWindow[VTKI_AREA_LAMPS * VTKI_AREA_POINTS];
  // radiance times the area that the point represents
  vec4 vtkiAreaSent[VTKI_AREA_LAMPS * VTKI_AREA_POINTS];
};
uniform int vtkiAreaCount; // lamps

// Returns the irradiance of the lamps without occlusion, and the distance of the nearest lamp.
// front: a bit for each lamp that sends light to the receiver's side of its plane. asked: false
// returns zero; software skips loops of no rounds but takes both sides of a branch.
vec4 vtkiFindOpen(vtkiReceiver receiver, bool asked, out float front)
{
  front = 0.0f;
  vec3 sum = vec3(0.0f);
  float nearest = 1.0e30f;
  int count = asked ? vtkiAreaCount : 0;
  for (int i = 0; i < count; ++i)
  {
    vec3 corner = vtkiAreaCorner[i].xyz - receiver.position;
    vec3 edge1 = vtkiAreaEdge1[i].xyz;
    vec3 edge2 = vtkiAreaEdge2[i].xyz;
    bool lit = dot(vtkiAreaNormal[i].xyz, corner) < 0.0f || vtkiAreaCorner[i].w > 0.0f;
    float whole = lit ? vtkiRectangleFormFactor(corner, edge1, edge2, receiver.normal) : 0.0f;
    vec3 mean = vtkiAreaRadiance[i].rgb;
#ifdef VTKI_AREA_IMAGE
    ivec2 image = ivec2(vtkiAreaEdge2[i].w, vtkiAreaEdge1[i].w);
    vec3 found =
      vtkiMeanOfImage(image, corner, edge1, edge2, receiver.normal, image.y > 0 ? whole : 0.0f);
    mean = image.y > 0 ? found : mean;
#endif
    sum += whole * mean;
    vec2 along = clamp(-vec2(dot(corner, edge1) / max(dot(edge1, edge1), 1.0e-30f),
                         dot(corner, edge2) / max(dot(edge2, edge2), 1.0e-30f)),
      0.0f, 1.0f);
    nearest = lit ? min(nearest, length(corner + along.x * edge1 + along.y * edge2)) : nearest;
    front += lit ? float(1 << i) : 0.0f;
  }
  return vec4(sum, asked ? nearest : 0.0f);
}

#ifdef VTKI_VISIBILITY
// Adds the irradiance from some points of each lamp to all, and of the visible points to seen. Adds
// none if count is 0.
void vtkiAddShares(int first, int count, vtkiReceiver receiver, inout vec3 seen, inout vec3 all)
{
  int lamps = count > 0 ? vtkiAreaCount : 0;
  for (int i = 0; i < lamps; ++i)
  {
    vec3 from = receiver.position - vtkiAreaCorner[i].xyz;
    float height = dot(vtkiAreaNormal[i].xyz, from);
    bool front = height > 0.0f;
    bool lit = front || vtkiAreaCorner[i].w > 0.0f;
    vec3 right = front ? vtkiAreaRight[2 * i].xyz : vtkiAreaRight[2 * i + 1].xyz;
    vec2 range = front ? vec2(vtkiAreaRight[2 * i].w, vtkiAreaUp[2 * i].w)
                       : vec2(vtkiAreaRight[2 * i + 1].w, vtkiAreaUp[2 * i + 1].w);
    vec3 up = front ? vtkiAreaUp[2 * i].xyz : vtkiAreaUp[2 * i + 1].xyz;
    vec3 axis = front ? vtkiAreaNormal[i].xyz : -vtkiAreaNormal[i].xyz;
    vec3 place = vec3(dot(right, from), dot(up, from), abs(height));
    vec3 normal = vec3(
      dot(right, receiver.normal), dot(up, receiver.normal), dot(axis, receiver.normal));
    vec3 facet =
      vec3(dot(right, receiver.facet), dot(up, receiver.facet), dot(axis, receiver.facet));
    float area = vtkiAreaNormal[i].w;
    int side = 2 * i + (front ? 0 : 1);
    for (int k = first; k < first + count; ++k)
    {
      int row = i * VTKI_AREA_POINTS + k;
      vec4 point = front ? vtkiAreaFront[row] : vtkiAreaBack[row];
      vec3 away = vec3(place.xy - point.xy, place.z);
      // The disk has vtkiVirtualLightWeight.
      float r2 = max(dot(away, away), 1.0e-30f);
      float weight = place.z * max(-dot(normal, away), 0.0f) / (r2 * (VTKI_PI * r2 + area));
      vtkiTileView view = vtkiFindTileView(away, facet, VTKI_WINDOW_TANGENT);
      bool ahead = view.strip < 0;
      vec4 window = front ? vtkiAreaFrontWindow[row] : vtkiAreaBackWindow[row];
      window = ahead ? window : vtkiAreaStrips[4 * side + max(view.strip, 0)];
      bool visible = vtkiIsSeenInWindow(
        point.zw, view, window, ahead ? range : vtkiAreaStripRange[side].xy);
      // Points below the facet and above the shading normal's horizon take no part, as sky
      // directions do not.
      vec3 given =
        lit && point.z >= 0.0f && dot(facet, away) < 0.0f ? weight * vtkiAreaSent[row].rgb : vec3(0.0f);
      all += given;
      seen += visible ? given : vec3(0.0f);
    }
  }
}

// If no point faces the receiver, the share is unknown: assume no occlusion.
vec3 vtkiShareOf(vec3 seen, vec3 all)
{
  return mix(vec3(1.0f), seen / max(all, vec3(1.0e-30f)), greaterThan(all, vec3(0.0f)));
}

// Returns the share of all points; one if it is not asked for.
vec3 vtkiFindOwnShare(vtkiReceiver receiver, bool asked)
{
  vec3 seen = vec3(0.0f);
  vec3 all = vec3(0.0f);
  vtkiAddShares(0, asked ? VTKI_AREA_POINTS : 0, receiver, seen, all);
  return vtkiShareOf(seen, all);
}
#endif
