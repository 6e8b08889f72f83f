// SPDX-License-Identifier: BSD-3-Clause
// Forces a back-end choice by its name during the object's lifetime.
#ifndef vtkIndirectForcedPath_h
#define vtkIndirectForcedPath_h

#include <cstdlib> // for the environment
#include <string>  // for names

struct vtkIndirectForcedPath
{
  explicit vtkIndirectForcedPath(const std::string& paths)
  {
    setenv("VTK_INDIRECT_PATHS", paths.c_str(), 1);
  }
  ~vtkIndirectForcedPath() { unsetenv("VTK_INDIRECT_PATHS"); }
  vtkIndirectForcedPath(const vtkIndirectForcedPath&) = delete;
  void operator=(const vtkIndirectForcedPath&) = delete;
};

#endif
