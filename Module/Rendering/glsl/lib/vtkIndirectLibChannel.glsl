// Numbers of the channels of a frame and of a light's map, shared by C++ and shaders. The table of
// vtkIndirectComposite describes the channels.
#ifndef vtkIndirectLibChannel
#define vtkIndirectLibChannel
#include "vtkIndirectLibPortable.glsl"

const int VTKI_CHANNEL_FINAL = 0;
const int VTKI_CHANNEL_DIRECT = 1;
const int VTKI_CHANNEL_INDIRECT = 2;
const int VTKI_CHANNEL_IRRADIANCE = 3;
const int VTKI_CHANNEL_GLOSSY = 4;
const int VTKI_CHANNEL_ALBEDO = 5;
const int VTKI_CHANNEL_NORMAL = 6;
const int VTKI_CHANNEL_DEPTH = 7;
const int VTKI_CHANNEL_SPECULAR = 8;
const int VTKI_CHANNEL_SKY = 9;
const int VTKI_CHANNEL_BOUNCE = 10;
const int VTKI_CHANNEL_AREA = 11;
const int VTKI_CHANNEL_CAUGHT = 12;

const int VTKI_MAP_CHANNEL_DEPTH = 0;
const int VTKI_MAP_CHANNEL_NORMAL = 1;
const int VTKI_MAP_CHANNEL_DENSITY = 2;
#endif
