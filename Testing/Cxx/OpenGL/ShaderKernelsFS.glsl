//VTK::System::Dec
//VTK::Output::Dec
// Test stage: one kernel, three texels of input a pixel.
#include "vtkIndirectLibAlbedo.glsl"
#include "vtkIndirectLibAntialiasing.glsl"
#include "vtkIndirectLibColor.glsl"
#include "vtkIndirectLibGlossy.glsl"
#include "vtkIndirectLibHarmonics.glsl"
#include "vtkIndirectLibReceiverGrid.glsl"
#include "vtkIndirectLibLightMap.glsl"
#include "vtkIndirectLibOccupancy.glsl"
#include "vtkIndirectLibPlane.glsl"
#include "vtkIndirectLibSampling.glsl"
#include "vtkIndirectLibSenderLobe.glsl"
#include "vtkIndirectLibShadow.glsl"
#include "vtkIndirectLibSphereProxy.glsl"
#include "vtkIndirectLibLobeSplat.glsl"
#include "vtkIndirectLibSurface.glsl"
#include "vtkIndirectLibVirtualLight.glsl"
#include "ShaderKernels.glsl"

uniform sampler2D vtkiInput;
uniform int vtkiKernel;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  gl_FragData[0] = vtkiTestKernel(vtkiKernel, texelFetch(vtkiInput, ivec2(3 * pixel.x, pixel.y), 0),
    texelFetch(vtkiInput, ivec2(3 * pixel.x + 1, pixel.y), 0),
    texelFetch(vtkiInput, ivec2(3 * pixel.x + 2, pixel.y), 0));
}
