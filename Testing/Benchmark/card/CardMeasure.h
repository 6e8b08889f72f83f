// SPDX-License-Identifier: BSD-3-Clause
// Measures the time of a method, and reads its report.
#ifndef CardMeasure_h
#define CardMeasure_h

#include <nlohmann/json.hpp>

class vtkIndirectIlluminationPass;

namespace card
{
class Scene;

/**
 * Renders frames of the scene as it is set up. Returns {rows: [{stage, frames, gpu_ms, gpu_p95_ms,
 * wall_ms, wall_p95_ms}], bytes, virtual_lights, report}. Times that OpenGL does not tell are
 * null. The stages are those of the report, between glFinish calls, and
 * - `frame`: whole frames with nothing reused between them, each finished before the next;
 * - `frames in flight`: the same, finished after the last, per frame;
 * - `camera turns`: as `frame`, but maps and lights are kept, as in interaction.
 */
nlohmann::json Measure(Scene& scene, vtkIndirectIlluminationPass* pass);
}

#endif
