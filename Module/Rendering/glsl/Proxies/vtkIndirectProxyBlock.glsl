// The environment's light and the flat polygons; see vtkIndirectProxyLight.
#include "vtkIndirectLibSphereProxy.glsl"
#include "vtkIndirectLibProxyRegion.glsl"

const int VTKI_PROXY_COLOR_ROWS = 40;  // nine columns and the light itself, four rows each
const int VTKI_PROXY_LIGHT_ROWS = 120; // for three colours
const int VTKI_POLYGON_ROWS = 10;      // normal, corners; albedo, size; the corners
layout(std140) uniform vtkiProxyBlock
{
  vec4 vtkiProxyRows[440];
};
uniform int vtkiPolygonCount;

vtkiHarmonics4 vtkiProxyHarmonics(int row)
{
  return vtkiHarmonics4(
    vtkiProxyRows[row], vtkiProxyRows[row + 1], vtkiProxyRows[row + 2], vtkiProxyRows[row + 3]);
}

// Coefficients of the light of one colour.
vtkiHarmonics4 vtkiProxyLightOf(int color)
{
  return vtkiProxyHarmonics(VTKI_PROXY_COLOR_ROWS * color + 36);
}
