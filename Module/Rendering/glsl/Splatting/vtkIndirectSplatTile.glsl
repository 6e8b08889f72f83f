// Tiles of splats share these parts: a group of invocations lists lights of a row of the table in bit sets,
// sums the listed ones, and adds to the image of sums.
layout(local_size_x = 16, local_size_y = 16) in;
layout(rgba32f, binding = 0) uniform image2D vtkiSum;
uniform bool vtkiAdds; // adds to the sum of earlier lights

shared uint vtkiListed[VTKI_ROW_LENGTH / 32];
#ifdef VTKI_SPLAT_LOBES
shared uint vtkiListedLobes[VTKI_ROW_LENGTH / 32];
#endif

// Empties the lists, for all invocations of the group.
void vtkiClearLists(int number)
{
  if (number < VTKI_ROW_LENGTH / 32)
  {
    vtkiListed[number] = 0u;
#ifdef VTKI_SPLAT_LOBES
    vtkiListedLobes[number] = 0u;
#endif
  }
  barrier();
}

// Adds to the sum of earlier lights, or begins the sum with the first value.
void vtkiStoreSum(ivec2 pixel, vec4 first, vec4 added)
{
  vec4 before = first;
  if (vtkiAdds)
  {
    before = imageLoad(vtkiSum, pixel);
  }
  imageStore(vtkiSum, pixel, before + added);
}
