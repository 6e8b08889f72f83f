  // Follows vtkIndirectCaptureImplFS.glsl where something in the scene is specular. VTKI_SPECULAR:
  // the mapper's specular colour and power, zero where it has none.
  gl_FragData[3] = max(VTKI_SPECULAR, vec4(0.0f));
