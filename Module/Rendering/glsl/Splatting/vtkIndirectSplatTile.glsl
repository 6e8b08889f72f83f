// The box about a tile's surfaces: coordinates as unsigned integers in the same order, which can be compared
// atomically.
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
