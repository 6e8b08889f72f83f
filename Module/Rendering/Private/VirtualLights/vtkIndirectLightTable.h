// SPDX-License-Identifier: BSD-3-Clause
// Channels of a table of virtual lights; see vtkVirtualLightSampler::Channel.
#ifndef vtkIndirectLightTable_h
#define vtkIndirectLightTable_h

#include "OpenGL/vtkIndirectChannel.h"

extern const vtkIndirectChannel vtkIndirectLightTable[];

#endif
