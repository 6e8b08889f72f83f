// The lowest intensity that counts.
uniform sampler2D vtkiSplatMean;  // one texel: mean intensity of the lights that send
uniform float vtkiSplatThreshold; // IntensityThreshold over VTKI_SPLAT_LENGTH squared

// Returns the lowest intensity over a squared distance that counts; 0: all counts.
float vtkiSplatLow()
{
  return vtkiSplatThreshold * texelFetch(vtkiSplatMean, ivec2(0), 0).r;
}
