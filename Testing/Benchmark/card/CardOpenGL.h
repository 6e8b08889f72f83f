// SPDX-License-Identifier: BSD-3-Clause
// The machine and the OpenGL of the results.
#ifndef CardOpenGL_h
#define CardOpenGL_h

#include "CardParts.h" // for Part

namespace card
{
/** One unit, which fails where no context can be made: renderer, version, limits, devices. */
Part MakeOpenGLPart(const Options& options);
}

#endif
