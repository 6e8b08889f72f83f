// Writes a field and a hint's distances.
void vtkiWriteField(vtkiField f, vec4 distances)
{
  gl_FragData[0] = f.c[0];
  gl_FragData[1] = f.c[1];
  gl_FragData[2] = f.c[2];
#if VTKI_HINT_LAYOUT == 2
  gl_FragData[3] = f.c[3];
  gl_FragData[4] = f.c[4];
  gl_FragData[5] = f.c[5];
  gl_FragData[6] = f.c[6];
  gl_FragData[7] = distances;
#else
  gl_FragData[3] = distances;
#endif
}
