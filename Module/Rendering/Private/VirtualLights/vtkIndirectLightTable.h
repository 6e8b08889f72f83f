// SPDX-License-Identifier: BSD-3-Clause
// Channels of a table of virtual lights, and of their lobes; see vtkIndirectSampler::Channel
// and LobeChannel.
#ifndef vtkIndirectLightTable_h
#define vtkIndirectLightTable_h

#include "OpenGL/vtkIndirectChannel.h"

extern const vtkIndirectChannels vtkIndirectLightTable;
extern const vtkIndirectChannels vtkIndirectSenderLobeTable;

#endif
