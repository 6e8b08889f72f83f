//VTK::System::Dec
//VTK::Output::Dec
// Irradiance of area lights: the unoccluded irradiance times the visible share.
uniform sampler2D vtkiAreaOpen;
uniform sampler2D vtkiAreaSeen;
uniform sampler2D vtkiAreaAll;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 open = texelFetch(vtkiAreaOpen, pixel, 0);
  vec3 seen = texelFetch(vtkiAreaSeen, pixel, 0).rgb;
  vec3 all = texelFetch(vtkiAreaAll, pixel, 0).rgb;
  // If no point faces the receiver, the share is unknown: assume no occlusion.
  vec3 share = mix(vec3(1.0f), seen / max(all, vec3(1.0e-30f)), greaterThan(all, vec3(0.0f)));
  gl_FragData[0] = vec4(open.rgb * share, open.a);
}
