// SPDX-License-Identifier: BSD-3-Clause
// Comparison of pictures with baselines.
#ifndef vtkIndirectImageUtilities_h
#define vtkIndirectImageUtilities_h

#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkIndirectHeadlessFactory.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

namespace contract
{
/** Whether a window can be made here; tests return VTK_SKIP_RETURN_CODE where none can. */
bool PrepareImageTest();

/**
 * Compares a window with the baseline that -V names, and returns what main returns. First by VTK's
 * own test; that one does not notice any colour that is off by less than about 100 of 255, so then
 * pixel by pixel: at most 1 % of the pixels may be off by more than 4 of 255 in any channel, and
 * the mean over all channels by 0.3. Both are above what drivers round differently, a step or two
 * and single pixels along edges. A tenth less indirect light is off by 4 in 2.9 % and 8.4 % of the
 * pixels of ImageComposition and ImageRoom, and by 0.42 and 1.9 in the mean.
 */
int CompareWithBaseline(int argc, char* argv[], vtkRenderWindow* window);
}

#endif
