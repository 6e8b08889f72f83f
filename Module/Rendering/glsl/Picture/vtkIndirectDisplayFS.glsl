//VTK::System::Dec
//VTK::Output::Dec
// Shows a channel in the window: colours unchanged, vectors and lengths mapped to [0,1].
uniform sampler2D vtkiImage;
uniform vec2 vtkiViewSize;
uniform ivec2 vtkiOrigin;
uniform vec2 vtkiScaleBias;

void main()
{
  vec2 uv = (gl_FragCoord.xy - vec2(vtkiOrigin)) / vtkiViewSize;
  ivec2 size = textureSize(vtkiImage, 0);
  vec3 value = texelFetch(vtkiImage, min(ivec2(uv * vec2(size)), size - 1), 0).rgb;
  gl_FragData[0] = vec4(value * vtkiScaleBias.x + vtkiScaleBias.y, 1.0f);
}
