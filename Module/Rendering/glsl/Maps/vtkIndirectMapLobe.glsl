// The specular lobe of a map's texel.
#include "vtkIndirectMapTexel.glsl"
#include "vtkIndirectLibSenderLobe.glsl"
#include "vtkIndirectLibLobe.glsl"

uniform sampler2DArray vtkiMapSpecular; // specular colour and power, or F0 and minus the roughness
uniform sampler2D vtkiMapFresnel;       // reflectance of VTK's PBR; see vtkiTablePlace
uniform vec2 vtkiMapFresnelShape;       // its entries along an edge, its least roughness

struct vtkiTexelLobe
{
  vec3 direction; // scene, unit
  float exponent;
  vec3 densityArea; // flux of one texel, with the light's colour and intensity
};

// Finds a texel's surface in its face's view coordinates, and its specular reflectance. Returns
// false if it reflects nothing specularly.
bool vtkiFetchMirror(int layer, ivec2 texel, vec4 map, out vec3 p, out vec3 normal, out vec3 toLight, out vec4 specular)
{
  specular = texelFetch(vtkiMapSpecular, ivec3(texel, layer), 0);
  vec4 surface = texelFetch(vtkiMapSurface, ivec3(texel, layer), 0);
  bool lit = vtkiSurfaceIsLit(surface) && max(max(specular.r, specular.g), specular.b) > 0.0f;
  p = vec3(0.0f, 0.0f, -1.0f);
  normal = vec3(0.0f, 0.0f, 1.0f);
  toLight = normal;
  if (lit)
  {
    bool parallel = int(map.x + 0.5f) == VTKI_MAP_PARALLEL;
    p = vtkiMapPosition(map, texel, vtkiSurfaceDepth(surface));
    normal = vtkiSurfaceNormal(surface);
    toLight = parallel ? toLight : -p / max(length(p), 1.0e-20f);
  }
  // VTK does not light a surface whose normal faces away from the light.
  return lit && dot(normal, toLight) > 0.0f;
}

// Returns the squared angle by which lobes turn over so many texels along an axis of the map, from
// a texel to neighbours on the same side and surface.
float vtkiTurnOfMirror(int layer, ivec2 texel, ivec2 axis, float texels, vec4 map, vec3 p, vec3 direction)
{
  int count = int(map.z + 0.5f);
  int reach = max(int(0.5f * texels + 0.5f), 1);
  float most = 0.0f;
  for (int side = -1; side <= 1; side += 2)
  {
    ivec2 at = texel + side * reach * axis;
    bool inside = min(at.x, at.y) >= 0 && max(at.x, at.y) < count;
    vec3 position;
    vec3 normal;
    vec3 toLight;
    vec4 specular;
    if (vtkiFetchMirror(layer, clamp(at, ivec2(0), ivec2(count - 1)), map, position, normal, toLight, specular) && inside)
    {
      vec3 other = vtkiMirroredLight(toLight, normal);
      // Beyond an edge another surface begins, which has its own lobes: its angle does not count.
      float turn2 = dot(other - direction, other - direction);
      float scale = texels / float(reach);
      most = max(most, turn2 < 0.5f ? turn2 * scale * scale : 0.0f);
    }
  }
  return most;
}

// Finds the lobe of a texel that represents so many texels. Its flux is the light that VTK's
// specular term sends to all directions, in VTK units (over pi): for Phong's model ks I
// vtkiPhongFlux / pi, for PBR the lobe's reflection of I cos, over pi.
bool vtkiLobeFromTexel(int layer, ivec2 texel, float texels, out vtkiTexelLobe lobe)
{
  vec4 map = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_SHAPE, layer), 0);
  vec4 power = texelFetch(vtkiMapTable, ivec2(VTKI_MAP_LIGHT, layer), 0);
  lobe.direction = vec3(0.0f, 0.0f, 1.0f);
  lobe.exponent = 0.0f;
  lobe.densityArea = vec3(0.0f);
  vec3 p;
  vec3 normal;
  vec3 toLight;
  vec4 specular;
  if (!vtkiFetchMirror(layer, texel, map, p, normal, toLight, specular))
  {
    return false;
  }
  bool parallel = int(map.x + 0.5f) == VTKI_MAP_PARALLEL;
  float texelSize = 2.0f * map.y / map.z;
  float footprint = parallel
    ? texelSize * texelSize
    : vtkiTexelSolidAngle((vec2(texel) + 0.5f) * texelSize - map.y, texelSize);
  vec2 slope = texelFetch(vtkiMapSlope, ivec3(texel, layer), 0).rg;
  float facet = vtkiMapFacetCosine(map, slope, p);
  float cosine = min(dot(normal, toLight), 1.0f);
  float roughness = max(-specular.a, 0.0f);
  vec3 reflected;
  if (specular.a < 0.0f)
  {
    vec2 place = vtkiTablePlace(cosine, min(roughness, 1.0f), vtkiMapFresnelShape.y);
    float entries = vtkiMapFresnelShape.x;
    vec2 integrals = textureLod(vtkiMapFresnel, (place * (entries - 1.0f) + 0.5f) / entries, 0.0f).xy;
    reflected = vtkiFresnelIntegral(specular.rgb, integrals) * (cosine / VTKI_PI);
    lobe.exponent = vtkiExponentOfRoughness(roughness);
  }
  else
  {
    reflected = specular.rgb * (vtkiPhongFlux(specular.a, cosine) / VTKI_PI);
    lobe.exponent = specular.a;
  }
  vec3 direction = vtkiMirroredLight(toLight, normal);
  // Neighbours' lobes shall join: widen the lobe by the variance of the texels' evenly spread
  // directions, a twelfth of the squared angle.
  float along = vtkiTurnOfMirror(layer, texel, ivec2(1, 0), sqrt(texels), map, p, direction);
  float across = vtkiTurnOfMirror(layer, texel, ivec2(0, 1), sqrt(texels), map, p, direction);
  lobe.exponent /= 1.0f + lobe.exponent * max(along, across) * (1.0f / 12.0f);
  lobe.direction = vtkiTransformRows(layer, VTKI_MAP_TO_SCENE, vec4(direction, 0.0f));
  lobe.direction = normalize(lobe.direction);
  lobe.densityArea =
    reflected * power.rgb * (vtkiMapFalloff(layer, map, p) * footprint / facet);
  return true;
}
