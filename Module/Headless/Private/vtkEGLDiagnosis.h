// SPDX-License-Identifier: BSD-3-Clause
// Explains why a graphics card does not render, from plain facts.
#pragma once

#include <string> // for text

struct vtkEGLMachine;

namespace vtkEGLDiagnosis
{
/** Reason why no card renders, and the remedy, in one line. Empty if no card could render, or if
 * the environment requests software. If there are several reasons, it is the one nearest to
 * rendering: cards with device files come before those that only the kernel lists. */
std::string Explain(const vtkEGLMachine& machine);

/** Reason why the device with that render node cannot be used, in one line; empty if none is
 * known. */
std::string ExplainRenderNode(const vtkEGLMachine& machine, const std::string& renderNode);
}
