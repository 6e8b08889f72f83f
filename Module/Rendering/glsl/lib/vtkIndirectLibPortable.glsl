// The dialect shared by GLSL and C++ (through GLM): values in, values out. Literals have an f
// suffix, swizzles name one component, output parameters use these macros. A C++ build defines
// VTKI_HOST and its own versions before it includes a kernel.
#ifndef vtkIndirectLibPortable
#define vtkIndirectLibPortable
#ifndef VTKI_HOST
#define VTKI_OUT(T) out T
#define VTKI_INOUT(T) inout T
#endif
const float VTKI_PI = 3.14159265358979f;
#endif
