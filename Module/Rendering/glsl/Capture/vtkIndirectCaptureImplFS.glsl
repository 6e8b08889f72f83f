  // vtkSurfaceCapturePass binds the mapper's names to VTKI_ALBEDO, VTKI_NORMAL, VTKI_FACET,
  // VTKI_SLOPE, VTKI_KIND, VTKI_DEPTH, VTKI_SENDER_SCALE; and, if the scene has a specular surface,
  // VTKI_SPECULAR: the mapper's specular colour and power, for VTK's PBR F0 and minus the
  // roughness, zero if it has none; and VTKI_SPECULAR_SENDER, the same for light maps.
  {
    // VTK clamps the picture, so colours may be anything; no surface reflects more than it gets.
    vec3 vtkiAlbedo = clamp(VTKI_ALBEDO, vec3(0.0f), vec3(1.0f));
    vec3 vtkiNormal = VTKI_NORMAL;
    vec3 vtkiFacet = VTKI_FACET;
    float vtkiKind = VTKI_KIND;
    float vtkiDepth = VTKI_DEPTH;
    if (!(dot(vtkiNormal, vtkiNormal) > 0.5f) || !(abs(vtkiDepth) < 1.0e18f))
    {
      // The normal is zero or undefined, or the impostor has no size or one whose square overflows:
      // the surface is drawn and takes no part in indirect light.
      vtkiNormal = vec3(0.0f, 0.0f, 1.0f);
      vtkiFacet = vtkiNormal;
      vtkiKind = VTKI_SURFACE_UNLIT;
      vtkiDepth = abs(vtkiDepth) < 1.0e18f ? vtkiDepth : 1.0e18f;
    }
    gl_FragData[1] = vtkiKind == VTKI_SURFACE_UNLIT
      ? vtkiPackUnlit(vtkiDepth, vtkiNumber)
      : vtkiPackSurface(vtkiNormal, vtkiFacet, vtkiDepth, vtkiKind);
    if (vtkiNumber < 0 && vtkiKind != VTKI_SURFACE_UNLIT)
    {
      gl_FragData[1] = vtkiMarkCatcher(gl_FragData[1]);
    }
    if (vtkiStage != 0)
    {
      gl_FragData[0] = vec4(VTKI_SLOPE, 0.0f, 1.0f);
      gl_FragData[2] = vec4(vtkiAlbedo * VTKI_SENDER_SCALE, 1.0f);
#ifdef VTKI_SPECULAR
      vec4 vtkiLobe = VTKI_SPECULAR_SENDER;
      gl_FragData[3] = vec4(max(vtkiLobe.rgb * vtkiMapLight.z, vec3(0.0f)), max(vtkiLobe.a, -1.0f));
#endif
    }
    else
    {
      // Light on an undefined normal is not a number. Images of bytes show it as black; an image of
      // floats would keep it and pass it on to filters.
      vec3 vtkiLit = gl_FragData[0].rgb;
      gl_FragData[0].rgb = min(mix(vtkiLit, vec3(0.0f), isnan(vtkiLit)), vec3(1.0e38f));
      // Alpha is one here, so the albedo takes its place and needs no texture of its own.
      gl_FragData[2] = vec4(vtkiPackAlbedo(vtkiAlbedo), 0.0f, 0.0f, 1.0f);
      gl_FragData[0].a = vtkiAlbedoInAlpha != 0 ? gl_FragData[2].r : gl_FragData[0].a;
#ifdef VTKI_SOFT
      // If the surface is less than half opaque, the surface behind it stays the receiver.
      gl_FragData[1].a = gl_FragData[0].a < 0.5f ? 0.0f : 1.0f;
      gl_FragData[2].a = gl_FragData[1].a;
#endif
#ifdef VTKI_SPECULAR
      gl_FragData[3] = max(VTKI_SPECULAR, vec4(vec3(0.0f), -1.0f));
#endif
    }
  }
