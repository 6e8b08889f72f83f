// Virtual lights in a uniform block: a group of fragments reads it once, where each fragment would
// read a texture. Where there are more lights than the block holds, all come from textures
// (VTKI_MORE_LIGHTS).
#ifdef VTKI_MORE_LIGHTS
#include "vtkIndirectLibTable.glsl"

uniform sampler2D vtkiLightPosition;
uniform sampler2D vtkiLightNormal;
uniform sampler2D vtkiLightDensity;
#else
#ifndef VTKI_LIGHTS
#define VTKI_LIGHTS 256 // 12288 of the 16384 bytes that every OpenGL has
#endif
layout(std140) uniform vtkiLightBlock
{
  vec4 vtkiBlockPosition[VTKI_LIGHTS];
  vec4 vtkiBlockNormal[VTKI_LIGHTS];
  vec4 vtkiBlockDensity[VTKI_LIGHTS];
};
#endif
uniform int vtkiFirstLight; // the first light's number in the table

// Fetches a light: position and area, normal and child distance, density times area. i: from the
// first light on.
void vtkiFetchLight(int i, out vec4 sender, out vec4 senderNormal, out vec3 density)
{
#ifdef VTKI_MORE_LIGHTS
  ivec2 at = vtkiTableTexel(vtkiFirstLight + i);
  sender = texelFetch(vtkiLightPosition, at, 0);
  senderNormal = texelFetch(vtkiLightNormal, at, 0);
  density = texelFetch(vtkiLightDensity, at, 0).rgb;
#else
  sender = vtkiBlockPosition[i];
  senderNormal = vtkiBlockNormal[i];
  density = vtkiBlockDensity[i].rgb;
#endif
}
