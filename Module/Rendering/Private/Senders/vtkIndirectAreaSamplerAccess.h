// SPDX-License-Identifier: BSD-3-Clause
// Gives the pipeline the list of lights of vtkAreaLightSampler, which users do not set.
#pragma once

#include "vtkAreaLight.h"        // for the lights
#include "vtkAreaLightSampler.h" // for its lights
#include "vtkSmartPointer.h"     // for lists

#include <vector> // for lists

struct vtkIndirectAreaSamplerAccess
{
  /** Replaces the lights of a sampler; nothing changes if they are the same. */
  static void SetLights(
    vtkAreaLightSampler* sampler, const std::vector<vtkSmartPointer<vtkAreaLight>>& lights)
  {
    sampler->SetLights(lights);
  }
};
