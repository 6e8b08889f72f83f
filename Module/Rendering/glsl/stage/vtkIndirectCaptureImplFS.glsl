  // The mapper's names are bound to these by vtkSurfaceCapturePass: VTKI_ALBEDO, VTKI_NORMAL,
  // VTKI_POSITION, VTKI_FACET_NORMAL, VTKI_KIND, VTKI_DEPTH.
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
    vec4 vtkiDensity = vec4(0.0f, 0.0f, 0.0f, 1.0f);
    if (vtkiStage != 0)
    {
      if (vtkiKind != VTKI_SURFACE_UNLIT)
      {
        vtkiDensity = vtkiReflectedDensity(
          VTKI_POSITION, vtkiNormal, VTKI_FACET_NORMAL, vtkiAlbedo * VTKI_SENDER_SCALE);
      }
      gl_FragData[0] = vec4(vtkiDensity.rgb, 1.0f);
      gl_FragData[2] = vec4(vtkiDensity.a, 0.0f, 0.0f, 1.0f);
    }
    else
    {
      gl_FragData[2] = vec4(vtkiAlbedo, 1.0f);
    }
    gl_FragData[1] = vtkiPackSurface(vtkiNormal, VTKI_DEPTH, vtkiKind);
  }
