  // The mapper's names are bound to these by vtkSurfaceCapturePass: VTKI_ALBEDO, VTKI_NORMAL,
  // VTKI_SLOPE, VTKI_KIND, VTKI_DEPTH, VTKI_SENDER_SCALE.
  {
    vec3 vtkiAlbedo = max(VTKI_ALBEDO, vec3(0.0f));
    vec3 vtkiNormal = VTKI_NORMAL;
    float vtkiKind = VTKI_KIND;
    if (!(dot(vtkiNormal, vtkiNormal) > 0.5f))
    {
      // A zero or undefined normal: the surface is drawn, and takes no part in indirect light.
      vtkiNormal = vec3(0.0f, 0.0f, 1.0f);
      vtkiKind = VTKI_SURFACE_UNLIT;
    }
    gl_FragData[1] = vtkiPackSurface(vtkiNormal, VTKI_DEPTH, vtkiKind);
    if (vtkiStage != 0)
    {
      gl_FragData[0] = vec4(vtkiAlbedo * VTKI_SENDER_SCALE, 1.0f);
      gl_FragData[2] = vec4(VTKI_SLOPE, 0.0f, 1.0f);
    }
    else
    {
      gl_FragData[2] = vec4(vtkiAlbedo, 1.0f);
    }
  }
