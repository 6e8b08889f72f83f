//VTK::System::Dec
//VTK::Output::Dec
// Specular reflection of one area light by the receivers. The closed form without occlusion
// (transformed cosines for VTK's PBR, an integral over the edges for powers) is multiplied by the
// visible share, which depth maps of a few points of the light give, weighted by the lobe.
// VTKI_LOBE_TABLE: some receivers are VTK's PBR.
#include "vtkIndirectAreaLamps.glsl"
#include "vtkIndirectLibGlossy.glsl"
#include "vtkIndirectLibLobe.glsl"

uniform sampler2D vtkiSpecular;
uniform int vtkiAreaPoints; // points in use

#ifdef VTKI_LOBE_TABLE
uniform sampler2D vtkiLobeTransforms;
uniform sampler2D vtkiLobeIntegrals;
uniform vec2 vtkiLobeShape; // entries along an edge, least roughness

// Interpolates between the middles of the table's texels.
vec4 vtkiFetchLobe(sampler2D table, vec2 place)
{
  return textureLod(table, (place * (vtkiLobeShape.x - 1.0f) + 0.5f) / vtkiLobeShape.x, 0.0f);
}
#endif

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  bool asked = vtkiFetchReceiver(pixel, receiver);
  vec4 specular = texelFetch(vtkiSpecular, pixel, 0);
  vec3 corner = vtkiAreaCorner[0].xyz - receiver.position;
  vec3 drawn1 = vtkiAreaEdge1[0].xyz;
  vec3 drawn2 = vtkiAreaEdge2[0].xyz;
  bool front = dot(vtkiAreaNormal[0].xyz, corner) < 0.0f;
  asked = asked && max(max(specular.r, specular.g), specular.b) > 0.0f &&
    (front || vtkiAreaCorner[0].w > 0.0f);
  vec3 toMirror = mat3(vtkiViewToScene) * vtkiMirror(receiver.positionVC, receiver.normalVC);
  vtkiTransform transform = vtkiPowerTransform(toMirror, max(specular.a, 0.0f));
  // Powers are positive; a negative sign marks roughness.
  bool physical = specular.a < 0.0f;
  vec3 reflected = specular.rgb *
    (vtkiPowerIntegral(corner, drawn1, drawn2, receiver.normal, toMirror, max(specular.a, 0.0f),
       asked && !physical) /
      VTKI_PI);
#ifdef VTKI_LOBE_TABLE
  // The direction to the eye is the mirror direction reflected at the normal.
  vec3 toEye = 2.0f * dot(receiver.normal, toMirror) * receiver.normal - toMirror;
  float cosine = min(max(dot(receiver.normal, toEye), 0.0f), 1.0f);
  vec2 place = vtkiTablePlace(cosine, min(-specular.a, 1.0f), vtkiLobeShape.y);
  vtkiTransform fitted =
    vtkiTableTransform(vtkiFetchLobe(vtkiLobeTransforms, place), receiver.normal, toEye);
  transform.x = physical ? fitted.x : transform.x;
  transform.y = physical ? fitted.y : transform.y;
  transform.z = physical ? fitted.z : transform.z;
  reflected += vtkiFresnelIntegral(specular.rgb, vtkiFetchLobe(vtkiLobeIntegrals, place).xy) *
    vtkiTransformedShare(corner, drawn1, drawn2, receiver.normal, fitted, asked && physical);
#endif
  asked = asked && max(max(reflected.r, reflected.g), reflected.b) > 0.0f;
  vec3 edge1 = vtkiTransformWay(transform, drawn1);
  vec3 edge2 = vtkiTransformWay(transform, drawn2);
  vec3 first = vtkiTransformWay(transform, corner);
#ifdef VTKI_AREA_IMAGE
  // The lobe's transform applies to the image as it applies to the rectangle.
  vec3 up = vec3(0.0f, 0.0f, 1.0f);
  ivec2 image = ivec2(vtkiAreaEdge2[0].w, vtkiAreaEdge1[0].w);
  reflected *= vtkiMeanOfImage(image, first, edge1, edge2, up,
    asked ? vtkiRectangleFormFactor(first, edge1, edge2, up) : 0.0f);
#else
  reflected *= vtkiAreaRadiance[0].rgb;
#endif
#ifdef VTKI_VISIBILITY
  vec3 span = cross(edge1, edge2);
  float area = max(length(span), 1.0e-30f);
  float height = abs(dot(span, first)) / area;
  int side = front ? 0 : 1;
  vec3 axis = front ? vtkiAreaNormal[0].xyz : -vtkiAreaNormal[0].xyz;
  vec3 right = vtkiAreaRight[side].xyz;
  vec3 upward = vtkiAreaUp[side].xyz;
  vec2 range = vec2(vtkiAreaRight[side].w, vtkiAreaUp[side].w);
  vec3 away = -vec3(dot(right, corner), dot(upward, corner), dot(axis, corner));
  vec3 facet = vec3(dot(right, receiver.facet), dot(upward, receiver.facet), dot(axis, receiver.facet));
  vec3 all = vec3(0.0f);
  vec3 seen = vec3(0.0f);
  int count = asked ? vtkiAreaPoints : 0;
  for (int i = 0; i < count; ++i)
  {
    vec4 point = front ? vtkiAreaFront[i] : vtkiAreaBack[i];
    vec4 window = front ? vtkiAreaFrontWindow[i] : vtkiAreaBackWindow[i];
    vec3 way = corner + point.x * right + point.y * upward;
    bool there = point.z >= 0.0f && dot(receiver.normal, way) > 0.0f && dot(receiver.facet, way) > 0.0f;
    vec3 sent = vtkiAreaSent[i].rgb *
      vtkiPointWeight(vtkiTransformWay(transform, way), height, area / float(vtkiAreaPoints));
    vtkiTileView view =
      vtkiFindTileView(vec3(away.xy - point.xy, away.z), facet, VTKI_WINDOW_TANGENT);
    bool ahead = view.strip < 0;
    window = ahead ? window : vtkiAreaStrips[4 * side + max(view.strip, 0)];
    bool visible = there &&
      vtkiIsSeenInWindow(point.zw, view, window, ahead ? range : vtkiAreaStripRange[side].xy);
    all += there ? sent : vec3(0.0f);
    seen += visible ? sent : vec3(0.0f);
  }
  reflected *= vtkiShareOf(seen, all);
#endif
  gl_FragData[0] = vec4(asked ? reflected : vec3(0.0f), 1.0f);
}
