// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Senders/vtkIndirectLightTable.h"

const vtkIndirectChannels vtkIndirectLightTable = {
  { "lights.position", "vtkiLightPosition", "position, area", GL_RGBA32F, "scene",
    "scene units, scene units squared" },
  { "lights.normal", "vtkiLightNormal", "normal, child distance", GL_RGBA32F, "scene",
    "1, scene units" },
  { "lights.density", "vtkiLightDensity", "reflected radiance times area, source or softening",
    GL_RGBA32F, "-", "VTK radiance times scene units squared" },
};

const vtkIndirectChannels vtkIndirectSenderLobeTable = {
  { "lights.lobe", "vtkiLobeDirection", "direction of the lobe, exponent", GL_RGBA32F, "scene",
    "1" },
  { "lights.flux", "vtkiLobeDensity", "flux density of the lobe times area", GL_RGBA32F, "-",
    "VTK radiance times scene units squared" },
};
