// The light that a frame adds to VTK's shading: images of it, and statements that add them to the
// sums below, which vtkIndirectComposite writes. VTKI_SPECULAR: the frame reflects some of it
// specularly.
#include "vtkIndirectReceiverGrid.glsl"

#ifndef VTKI_LIGHTS
#define VTKI_LIGHTS 1
#define VTKI_ADD_IRRADIANCE
#define VTKI_ADD_RADIANCE
#define VTKI_ADD_OPEN
#endif
uniform sampler2D vtkiLights[VTKI_LIGHTS];
uniform float vtkiUnits[VTKI_LIGHTS];
uniform sampler2D vtkiCoarse;
uniform vec3 vtkiGreatest;
#ifdef VTKI_SPECULAR
uniform sampler2D vtkiSpecular;
#endif
#ifdef VTKI_LAMPS
uniform float vtkiStrength; // factor of all light: vtkIndirectLightBalance
#else
const float vtkiStrength = 1.0f;
#endif

// Returns light interpolated from samples at every vtkiStep-th pixel. If the cell of pixels between
// four samples is one surface, this is their bilinear mean; vtkIndirectHintCell.glsl has tested
// that once a cell. Pixels of mixed cells have a value of their own. position: centre of a pixel,
// in pixels of the view.
vec3 vtkiFetchCoarse(sampler2D pixels, vec2 position)
{
  float edge = float(vtkiStep);
  vec2 cell = floor(position / edge);
  vec2 blend = (position - 0.5f) / edge - cell;
  vec2 texel = 1.0f / vec2(vtkiCoarseSize);
  vec2 first = (cell + 0.5f) * texel;
  vec2 second = first + texel;
  vec4 corner = textureLod(vtkiCoarse, first, 0.0f);
  vec3 below = mix(corner.rgb, textureLod(vtkiCoarse, vec2(second.x, first.y), 0.0f).rgb, blend.x);
  vec3 above = mix(textureLod(vtkiCoarse, vec2(first.x, second.y), 0.0f).rgb,
    textureLod(vtkiCoarse, second, 0.0f).rgb, blend.x);
  // Whole cells do not read the image: one of its texels costs more than the four above, which
  // neighbours share.
  vec2 at = corner.a == VTKI_CELL_WHOLE ? vec2(0.0f) : position / vec2(vtkiSize);
  vec3 own = textureLod(pixels, at, 0.0f).rgb;
  return corner.a == VTKI_CELL_WHOLE ? mix(below, above, blend.y)
                                     : (corner.a == VTKI_CELL_EMPTY ? vec3(0.0f) : own);
}

// Returns the share of lamps' irradiance that a surface of albedo one reflects diffusely: VTK's PBR
// divides by pi.
float vtkiLampShare(vec4 surface)
{
  return vtkiSurfaceKind(surface) == VTKI_SURFACE_ENCODED ? 1.0f / VTKI_PI : 1.0f;
}

// Returns irradiance of the sky in the unit of other irradiance: a preset's sky stands for lamps.
vec3 vtkiFindSky(vec4 surface, vec3 sky)
{
#ifdef VTKI_LAMPS
  return sky * vtkiLampShare(surface);
#else
  return sky;
#endif
}

// The irradiance directly from the sky and from area lights, and that of bounces. Bounces are
// bounded: together with direct light they cannot exceed all the light in the scene. Their errors
// are largest in crevices, where this bound applies.
void vtkiAddIrradiance(
  vec2 position, vec4 surface, inout vec3 sky, inout vec3 area, inout vec3 bounce)
{
  vec2 place = position / vec2(vtkiSize);
  VTKI_ADD_IRRADIANCE
  bounce = min(bounce, max(vtkiGreatest - (sky + area), vec3(0.0f)));
  sky = vtkiFindSky(surface, sky * vtkiStrength);
  area *= vtkiStrength;
  bounce *= vtkiStrength;
}

// Adds the radiance that receivers reflect specularly, times a scale.
void vtkiAddRadiance(vec2 position, float scale, inout vec3 radiance)
{
#ifdef VTKI_SPECULAR
  vec2 place = position / vec2(vtkiSize);
  vec3 specular = textureLod(vtkiSpecular, place, 0.0f).rgb;
  scale *= vtkiStrength;
  VTKI_ADD_RADIANCE
#endif
}
