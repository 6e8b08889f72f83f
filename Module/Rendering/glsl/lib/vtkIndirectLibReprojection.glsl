// Irradiance of the last frame, drawn for this frame.
#ifndef vtkIndirectLibReprojection
#define vtkIndirectLibReprojection
#include "vtkIndirectLibPortable.glsl"

// Alpha of a lit pixel without irradiance of the last frame.
const float VTKI_REPROJECTED_NONE = -1.0f;
#endif
