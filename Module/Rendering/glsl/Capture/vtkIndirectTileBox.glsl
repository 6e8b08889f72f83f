// Bounding box of the receivers of a group of invocations. Coordinates are stored as unsigned
// integers of the same order, which can be compared atomically.
shared uint vtkiLowest[3];
shared uint vtkiHighest[3];

uint vtkiOrdered(float value)
{
  uint bits = floatBitsToUint(value);
  return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

float vtkiFromOrdered(uint bits)
{
  return uintBitsToFloat((bits & 0x80000000u) != 0u ? bits & 0x7fffffffu : ~bits);
}

vec3 vtkiFromOrdered(uint bits[3])
{
  return vec3(vtkiFromOrdered(bits[0]), vtkiFromOrdered(bits[1]), vtkiFromOrdered(bits[2]));
}

// All invocations call these in order: begin, add each receiver that counts, end.
void vtkiBeginBox()
{
  int number = int(gl_LocalInvocationIndex);
  if (number < 3)
  {
    vtkiLowest[number] = 0xffffffffu;
    vtkiHighest[number] = 0u;
  }
  barrier();
}

void vtkiAddToBox(vec3 position)
{
  for (int i = 0; i < 3; ++i)
  {
    uint at = vtkiOrdered(position[i]);
    atomicMin(vtkiLowest[i], at);
    atomicMax(vtkiHighest[i], at);
  }
}

// Returns false where no receiver was added.
bool vtkiEndBox(out vec3 middle, out vec3 halfSize)
{
  barrier();
  bool any = vtkiLowest[0] <= vtkiHighest[0];
  vec3 lower = any ? vtkiFromOrdered(vtkiLowest) : vec3(0.0f);
  vec3 upper = any ? vtkiFromOrdered(vtkiHighest) : vec3(0.0f);
  middle = 0.5f * (lower + upper);
  // The margin covers the rounding of the middle.
  halfSize = 0.5f * (upper - lower) + 1.0e-6f;
  return any;
}
