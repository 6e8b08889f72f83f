// SPDX-License-Identifier: BSD-3-Clause
// What keeps a graphics card from rendering, as far as plain facts show.
#ifndef vtkEGLDiagnosis_h
#define vtkEGLDiagnosis_h

#include <string> // for text

struct vtkEGLMachine;

namespace vtkEGLDiagnosis
{
/** Why no card renders, and what to do, in one line. Empty where there is no card that could, or
 * where the environment wants software. Of several reasons the one that is nearest to rendering:
 * cards with files of devices come before those that only the kernel has. */
std::string Explain(const vtkEGLMachine& machine);

/** Why the device with that render node may not be used, in one line; empty where nothing is known
 * against it. */
std::string ExplainRenderNode(const vtkEGLMachine& machine, const std::string& renderNode);
}

#endif
