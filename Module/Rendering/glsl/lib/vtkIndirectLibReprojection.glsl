// Irradiance of the last frame, drawn for this frame.
#ifndef vtkIndirectLibReprojection
#define vtkIndirectLibReprojection
#include "vtkIndirectLibPortable.glsl"

// Alpha of a lit pixel without irradiance of the last frame.
const float VTKI_REPROJECTED_NONE = -1.0f;

// Alpha of a pixel with irradiance of its own is 1. A pixel with the irradiance of pixels around
// its place has this much less.
const float VTKI_REPROJECTED_STEP = 0.25f;
#endif
