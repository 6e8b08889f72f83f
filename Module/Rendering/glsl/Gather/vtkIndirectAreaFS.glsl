//VTK::System::Dec
//VTK::Output::Dec
// What comes directly from one area light: in closed form if nothing hid it, times the share of it that is seen, by
// the depth maps of a few points of it.
// VTKI_AREA_POINTS: points in the block. VTKI_VISIBILITY: without it nothing hides the light.
// VTKI_AREA_IMAGE: its radiance is an image: a pyramid of it, summed down to where it does not matter.
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
uniform vec3 vtkiAreaRadiance; // the mean

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
uniform sampler2D vtkiAreaPyramid; // radiance; greatest deviation of its sum over the colours from the mean
uniform int vtkiAreaLevel;         // of the single texel
uniform float vtkiAreaTolerance;

// Levels lie beside each other, the finest one alone to the left.
vec4 vtkiFetchAreaTexel(int level, ivec2 texel)
{
  int edge = 1 << vtkiAreaLevel;
  ivec2 first = level == 0 ? ivec2(0) : ivec2(edge, edge - (edge >> (level - 1)));
  return texelFetch(vtkiAreaPyramid, first + texel, 0);
}

// Irradiance from the image if nothing hid it. A texel stands for all below it where their differences make less
// than the tolerance of the whole.
vec3 vtkiFromAreaImage(vec3 corner, vec3 normal)
{
  vec4 whole = vtkiFetchAreaTexel(vtkiAreaLevel, ivec2(0));
  float goal = vtkiAreaTolerance * (whole.r + whole.g + whole.b) *
    vtkiRectangleFormFactor(corner, vtkiAreaEdge1, vtkiAreaEdge2, normal);
  int level = vtkiAreaLevel;
  ivec2 texel = ivec2(0);
  vec3 sum = vec3(0.0f);
  // More are not worth their time: what is left is taken as it is.
  for (int round = 0; round < 2048 && level <= vtkiAreaLevel; ++round)
  {
    float width = 1.0f / float(1 << (vtkiAreaLevel - level));
    vec3 edge1 = width * vtkiAreaEdge1;
    vec3 edge2 = width * vtkiAreaEdge2;
    vec3 at = corner + float(texel.x) * edge1 + float(texel.y) * edge2;
    vec4 radiance = vtkiFetchAreaTexel(level, texel);
    float factor = vtkiRectangleFormFactor(at, edge1, edge2, normal);
    vec3 middle = at + 0.5f * (edge1 + edge2);
    float radius2 = 0.25f * (dot(edge1, edge1) + dot(edge2, edge2));
    // How much what it sends changes over it.
    float change = min(2.0f * sqrt(radius2 / max(dot(middle, middle), 1.0e-20f)), 1.0f);
    bool taken = level == 0 || radiance.a * factor * change <= goal || round > 1536;
    sum += taken ? radiance.rgb * factor : vec3(0.0f);
    if (!taken)
    {
      --level;
      texel *= 2;
    }
    else
    {
      while ((texel.x & texel.y & 1) == 1 && level < vtkiAreaLevel)
      {
        texel >>= 1;
        ++level;
      }
      bool last = level >= vtkiAreaLevel;
      level += last ? 1 : 0;
      texel += (texel.x & 1) == 0 ? ivec2(1, 0) : ivec2(-1, 1);
    }
  }
  return sum;
}
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
#ifdef VTKI_AREA_IMAGE
  vec3 irradiance = vtkiFromAreaImage(corner, receiver.normal);
#else
  vec3 irradiance = vtkiAreaRadiance *
    vtkiRectangleFormFactor(corner, vtkiAreaEdge1, vtkiAreaEdge2, receiver.normal);
#endif
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
