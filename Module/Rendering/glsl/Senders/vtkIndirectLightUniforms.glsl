// Virtual lights in a uniform block: a group of fragments reads it once, where each fragment would
// read a texture.
#ifndef VTKI_LIGHTS
#define VTKI_LIGHTS 256 // 12288 of the 16384 bytes that every OpenGL has
#endif
layout(std140) uniform vtkiLightBlock
{
  vec4 vtkiBlockPosition[VTKI_LIGHTS]; // position, area
  vec4 vtkiBlockNormal[VTKI_LIGHTS];   // normal, child distance
  vec4 vtkiBlockDensity[VTKI_LIGHTS];  // reflected density times area, source
};
uniform int vtkiBlockCount;
