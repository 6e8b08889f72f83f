// Virtual lights in a uniform block: read once for a group of fragments, where a texture would be
// read by each of them.
#ifndef VTKI_LIGHTS
#define VTKI_LIGHTS 256 // 12288 of the 16384 bytes that every OpenGL has
#endif
layout(std140) uniform vtkiLightBlock
{
  vec4 vtkiBlockPosition[VTKI_LIGHTS]; // position, area
  vec4 vtkiBlockNormal[VTKI_LIGHTS];   // normal, reach
  vec4 vtkiBlockDensity[VTKI_LIGHTS];  // reflected density times area, source
};
uniform int vtkiBlockCount;
