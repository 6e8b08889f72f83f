// The share of the background that a surface shows which catches light: the light that it sends to
// the eye over the light that it would send if nothing else was in the scene. Both come from the
// same shaders and sums, so that the share is one where nothing is hidden and nothing is added.
uniform sampler2D vtkiOpenLit; // VTK's light if nothing hid any
uniform sampler2D vtkiOpenLights[VTKI_LIGHTS];

// direct: VTK's light, linear or encoded as the surface's kind says.
vec3 vtkiFindCaught(vec2 position, vec4 surface, vec3 direct, vec3 albedo, float scale)
{
  vec2 place = position / vec2(vtkiSize);
  vec3 openLit = textureLod(vtkiOpenLit, place, 0.0f).rgb;
  direct = vtkiKeepLamps(surface, albedo, vtkiDecodeShading(surface, direct));
  openLit = vtkiKeepLamps(surface, albedo, vtkiDecodeShading(surface, openLit));
  vec3 sky = vec3(0.0f);
  vec3 area = vec3(0.0f);
  vec3 bounce = vec3(0.0f);
  vec3 open = vec3(0.0f);
  if (scale > 0.0f)
  {
    vtkiAddIrradiance(position, surface, sky, area, bounce);
    VTKI_ADD_OPEN
    open = vtkiFindSky(surface, open);
  }
  vec3 light = direct + albedo * (sky + area + bounce) * scale;
  vec3 alone = openLit + albedo * open * (scale * vtkiStrength);
  return mix(vec3(1.0f), light / max(alone, vec3(1.0e-30f)), greaterThan(alone, vec3(0.0f)));
}
