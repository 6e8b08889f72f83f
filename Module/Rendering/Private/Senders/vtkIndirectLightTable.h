// SPDX-License-Identifier: BSD-3-Clause
// Channels of a table of virtual lights, and of their lobes; see vtkIndirectSampler::Channel
// and LobeChannel.
#pragma once

#include "OpenGL/vtkIndirectChannel.h"

extern const vtkIndirectChannels vtkIndirectLightTable;
extern const vtkIndirectChannels vtkIndirectSenderLobeTable;
