// SPDX-License-Identifier: BSD-3-Clause
// The texture that a renderer lights physically based props with, as an environment light.
#pragma once

#include "vtkEnvironmentLight.h" // for a member
#include "vtkNew.h"              // for a member

class vtkRenderer;

class vtkIndirectImageLight
{
public:
  /** Returns the light of the renderer's current texture; null if there is no readable texture. */
  vtkEnvironmentLight* Find(vtkRenderer* renderer);

private:
  vtkNew<vtkEnvironmentLight> Light;
};
