//VTK::System::Dec
//VTK::Output::Dec
// Specular reflection of one area light by the receivers. The closed form without occlusion
// (transformed cosines for VTK's PBR, an integral over the edges for powers) is multiplied by the
// visible share, which depth maps of a few points of the light give, weighted by the lobe.
// VTKI_AREA_POINTS: points in the block; VTKI_VISIBILITY: without it the light casts no shadow;
// VTKI_AREA_IMAGE: its radiance is an image; VTKI_LOBE_TABLE: some receivers are VTK's PBR.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectLibGlossy.glsl"
#include "vtkIndirectLibLobe.glsl"
#ifdef VTKI_VISIBILITY
#include "vtkIndirectDepthWindows.glsl"
#endif

uniform sampler2D vtkiSpecular;
uniform vec3 vtkiAreaCorner; // scene units
uniform vec3 vtkiAreaEdge1;
uniform vec3 vtkiAreaEdge2;
uniform vec3 vtkiAreaNormal; // the side that sends light
uniform bool vtkiAreaTwoSided;
#ifndef VTKI_AREA_IMAGE
uniform vec3 vtkiAreaRadiance;
#endif

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

#ifdef VTKI_VISIBILITY
layout(std140) uniform vtkiAreaLobeBlock
{
  vec4 vtkiAreaPlace[VTKI_AREA_POINTS];       // scene units
  vec4 vtkiAreaWeight[VTKI_AREA_POINTS];      // radiance of the point's part over the mean
  // middles of the front and back tiles, or -1 if there is none
  vec4 vtkiAreaMiddles[VTKI_AREA_POINTS];
  vec4 vtkiAreaFrontWindow[VTKI_AREA_POINTS]; // see vtkiIsSeenInWindow
  vec4 vtkiAreaBackWindow[VTKI_AREA_POINTS];
  // For the front and the back: one over the depths at which maps and their strips begin and end;
  // windows of the strips.
  vec4 vtkiAreaRange[2];
  vec4 vtkiAreaStrips[8];
};
uniform int vtkiAreaCount;
#endif

#ifdef VTKI_AREA_IMAGE
#include "vtkIndirectAreaImage.glsl"

uniform ivec2 vtkiAreaImage; // first row of its pyramid, level of the single texel
#endif

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vtkiReceiver receiver;
  bool asked = vtkiFetchReceiver(pixel, receiver);
  vec4 specular = texelFetch(vtkiSpecular, pixel, 0);
  vec3 corner = vtkiAreaCorner - receiver.position;
  bool front = dot(vtkiAreaNormal, corner) < 0.0f;
  asked = asked && max(max(specular.r, specular.g), specular.b) > 0.0f && (front || vtkiAreaTwoSided);
  vec3 toMirror = mat3(vtkiViewToScene) * vtkiMirror(receiver.positionVC, receiver.normalVC);
  vtkiTransform transform = vtkiPowerTransform(toMirror, max(specular.a, 0.0f));
  // Powers are positive; a negative sign marks roughness.
  bool physical = specular.a < 0.0f;
  vec3 reflected = specular.rgb *
    (vtkiPowerIntegral(corner, vtkiAreaEdge1, vtkiAreaEdge2, receiver.normal, toMirror,
       max(specular.a, 0.0f), asked && !physical) /
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
    vtkiTransformedShare(
      corner, vtkiAreaEdge1, vtkiAreaEdge2, receiver.normal, fitted, asked && physical);
#endif
  asked = asked && max(max(reflected.r, reflected.g), reflected.b) > 0.0f;
  vec3 edge1 = vtkiTransformWay(transform, vtkiAreaEdge1);
  vec3 edge2 = vtkiTransformWay(transform, vtkiAreaEdge2);
  vec3 first = vtkiTransformWay(transform, corner);
#ifdef VTKI_AREA_IMAGE
  // The lobe's transform applies to the image as it applies to the rectangle.
  vec3 up = vec3(0.0f, 0.0f, 1.0f);
  reflected *= vtkiMeanOfImage(vtkiAreaImage, first, edge1, edge2, up,
    asked ? vtkiRectangleFormFactor(first, edge1, edge2, up) : 0.0f);
#else
  reflected *= vtkiAreaRadiance;
#endif
#ifdef VTKI_VISIBILITY
  vec3 span = cross(edge1, edge2);
  float area = max(length(span), 1.0e-30f);
  float height = abs(dot(span, first)) / area;
  vec3 axis = front ? vtkiAreaNormal : -vtkiAreaNormal;
  vec3 upward;
  vec3 right;
  vtkiFrameAlong(axis, upward, right);
  int side = front ? 0 : 1;
  vec4 range = vtkiAreaRange[side];
  vec3 facet = vec3(dot(right, receiver.facet), dot(upward, receiver.facet), dot(axis, receiver.facet));
  vec3 all = vec3(0.0f);
  vec3 seen = vec3(0.0f);
  int count = asked ? vtkiAreaCount : 0;
  for (int i = 0; i < count; ++i)
  {
    vec4 place = vtkiAreaPlace[i];
    vec4 weight = vtkiAreaWeight[i];
    vec2 middle = front ? vtkiAreaMiddles[i].xy : vtkiAreaMiddles[i].zw;
    vec4 window = front ? vtkiAreaFrontWindow[i] : vtkiAreaBackWindow[i];
    vec3 way = receiver.position - place.xyz;
    bool there = middle.x >= 0.0f && dot(receiver.normal, way) < 0.0f && dot(receiver.facet, way) < 0.0f;
    vec3 sent = weight.rgb *
      vtkiPointWeight(vtkiTransformWay(transform, place.xyz - receiver.position), height,
        area / float(vtkiAreaCount));
    vtkiTileView view = vtkiFindTileView(
      vec3(dot(right, way), dot(upward, way), dot(axis, way)), facet, VTKI_WINDOW_TANGENT);
    bool ahead = view.strip < 0;
    window = ahead ? window : vtkiAreaStrips[4 * side + max(view.strip, 0)];
    bool visible =
      there && vtkiIsSeenInWindow(middle, view, window, ahead ? range.xy : range.zw);
    all += there ? sent : vec3(0.0f);
    seen += visible ? sent : vec3(0.0f);
  }
  // If the lobe meets no point, the share is unknown: assume no occlusion.
  reflected *= mix(vec3(1.0f), seen / max(all, vec3(1.0e-30f)), greaterThan(all, vec3(0.0f)));
#endif
  gl_FragData[0] = vec4(asked ? reflected : vec3(0.0f), 1.0f);
}
