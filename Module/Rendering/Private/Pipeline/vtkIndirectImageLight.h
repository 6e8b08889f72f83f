// SPDX-License-Identifier: BSD-3-Clause
// The texture that a renderer lights physically based props with, as light from all around.
#ifndef vtkIndirectImageLight_h
#define vtkIndirectImageLight_h

#include "vtkEnvironmentLight.h" // for a member
#include "vtkNew.h"              // for a member

class vtkRenderer;

class vtkIndirectImageLight
{
public:
  /** As the renderer has it now; null where there is no texture that can be read. */
  vtkEnvironmentLight* Find(vtkRenderer* renderer);

private:
  vtkNew<vtkEnvironmentLight> Light;
};

#endif
