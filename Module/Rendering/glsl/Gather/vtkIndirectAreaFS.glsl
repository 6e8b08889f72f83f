//VTK::System::Dec
//VTK::Output::Dec
// What comes directly from one area light: in closed form if nothing hid it, times the share of it that is seen, by
// the depth maps of a few points of it.
// VTKI_AREA_POINTS: points in the block. VTKI_VISIBILITY: without it nothing hides the light.
// VTKI_AREA_IMAGE: its radiance is an image.
#include "vtkIndirectReceiver.glsl"
#include "vtkIndirectLibAreaLight.glsl"
#ifdef VTKI_VISIBILITY
#include "vtkIndirectDepthTiles.glsl"
#endif

uniform vec3 vtkiAreaCorner; // scene units
uniform vec3 vtkiAreaEdge1;
uniform vec3 vtkiAreaEdge2;
uniform vec3 vtkiAreaNormal; // where it sends light to
uniform bool vtkiAreaTwoSided;
#ifndef VTKI_AREA_IMAGE
uniform vec3 vtkiAreaRadiance;
#endif

#ifdef VTKI_VISIBILITY
layout(std140) uniform vtkiAreaBlock
{
  vec4 vtkiAreaPlace[VTKI_AREA_POINTS];  // scene units; tile of the side that light is sent to, or -1
  vec4 vtkiAreaWeight[VTKI_AREA_POINTS]; // radiance of what it stands for, over the mean; tile of the other side
};
uniform int vtkiAreaCount;
uniform float vtkiAreaShare; // area that a point stands for
#endif

#ifdef VTKI_AREA_IMAGE
#include "vtkIndirectAreaImage.glsl"

uniform ivec2 vtkiAreaImage; // first row of its pyramid, level of the single texel
#endif

void main()
{
  vtkiReceiver receiver;
  bool lit = vtkiFetchReceiver(ivec2(gl_FragCoord.xy), receiver);
  vec3 corner = vtkiAreaCorner - receiver.position;
  bool front = dot(vtkiAreaNormal, corner) < 0.0f;
  lit = lit && (front || vtkiAreaTwoSided);
  if (!lit)
  {
    discard;
  }
  float whole = vtkiRectangleFormFactor(corner, vtkiAreaEdge1, vtkiAreaEdge2, receiver.normal);
#ifdef VTKI_AREA_IMAGE
  vec3 mean = vtkiMeanOfImage(
    vtkiAreaImage, corner, vtkiAreaEdge1, vtkiAreaEdge2, receiver.normal, whole);
#else
  vec3 mean = vtkiAreaRadiance;
#endif
  vec3 irradiance = whole * mean;
#ifdef VTKI_VISIBILITY
  vec3 axis = front ? vtkiAreaNormal : -vtkiAreaNormal;
  vec3 all = vec3(0.0f);
  vec3 seen = vec3(0.0f);
  for (int i = 0; i < vtkiAreaCount; ++i)
  {
    vec4 place = vtkiAreaPlace[i];
    vec4 weight = vtkiAreaWeight[i];
    float tile = front ? place.w : weight.w;
    vec3 sent = weight.rgb *
      vtkiVirtualLightWeight(place.xyz - receiver.position, axis, receiver.normal, vtkiAreaShare);
    bool there = tile >= 0.0f;
    bool visible = there &&
      vtkiIsSeenInTile(vtkiMakeTile(int(max(tile, 0.0f)), place.xyz, axis), receiver.position,
        receiver.normal);
    all += there ? sent : vec3(0.0f);
    seen += visible ? sent : vec3(0.0f);
  }
  // Where no point faces the receiver nothing is known of what hides the rest.
  irradiance *= mix(vec3(1.0f), seen / max(all, vec3(1.0e-30f)), greaterThan(all, vec3(0.0f)));
#endif
  gl_FragData[0] = vec4(irradiance, 1.0f);
}
