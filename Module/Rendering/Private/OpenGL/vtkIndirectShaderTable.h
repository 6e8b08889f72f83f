// SPDX-License-Identifier: BSD-3-Clause
// The embedded shader files; filled by CMake/vtkIndirectShaders.cmake.
#pragma once

struct vtkIndirectShaderTableEntry
{
  const char* Name; // file name, or nullptr after the last entry
  const char* Text;
};

extern const vtkIndirectShaderTableEntry vtkIndirectShaderTable[];
extern const char* const vtkIndirectShaderTableHash; // MD5 of all shader text
