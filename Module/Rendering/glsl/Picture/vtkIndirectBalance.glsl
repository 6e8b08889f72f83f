// A preset's own light in place of a share of the renderer's lamps: vtkIndirectLightBalance. The
// lamps are far away, and nothing hides them. VTKI_LAMPS: their number; undefined: VTK's shading
// stays as it is. VTKI_ENCODED: the frame has pixels of VTK's PBR, which are encoded.
#include "vtkIndirectLibColor.glsl"
#include "vtkIndirectLibSurface.glsl"

#ifdef VTKI_LAMPS
uniform vec3 vtkiLampDirections[VTKI_LAMPS]; // to the lamps, in view coordinates
uniform vec3 vtkiLampColors[VTKI_LAMPS];
uniform float vtkiReplaced;
#endif

// Returns a colour of VTK's shading as linear light.
vec3 vtkiDecodeShading(vec4 surface, vec3 color)
{
#ifdef VTKI_ENCODED
  return vtkiSurfaceKind(surface) == VTKI_SURFACE_ENCODED ? vtkiDecodeGamma(color) : color;
#else
  return color;
#endif
}

// Returns linear light as the surface's pixels hold it.
vec3 vtkiEncodeShading(vec4 surface, vec3 light)
{
#ifdef VTKI_ENCODED
  return vtkiSurfaceKind(surface) == VTKI_SURFACE_ENCODED ? vtkiEncodeGamma(light) : light;
#else
  return light;
#endif
}

// Returns the diffuse part of VTK's shading by the lamps, zero where VTK draws without lighting.
// direct: linear.
vec3 vtkiFindLampLight(vec4 surface, vec3 albedo, vec3 direct)
{
  vec3 light = vec3(0.0f);
#ifdef VTKI_LAMPS
  vec3 normal = vtkiSurfaceNormal(surface);
  for (int i = 0; i < VTKI_LAMPS; ++i)
  {
    light += max(dot(normal, vtkiLampDirections[i]), 0.0f) * vtkiLampColors[i];
  }
  // VTK's PBR loses what its specular lobe reflects, which is ignored here.
  light *= albedo * vtkiLampShare(surface);
  light = vtkiSurfaceIsLit(surface) ? light : vec3(0.0f);
#endif
  return min(light, max(direct, vec3(0.0f)));
}

// Returns VTK's shading without the share of the lamps' diffuse light that is replaced.
vec3 vtkiKeepLamps(vec4 surface, vec3 albedo, vec3 direct)
{
#ifdef VTKI_LAMPS
  direct -= vtkiReplaced * vtkiFindLampLight(surface, albedo, direct);
#endif
  return direct;
}
