// SPDX-License-Identifier: BSD-3-Clause
// A place where a context may come from, and the order in which such places are tried.
#ifndef vtkEGLPlatform_h
#define vtkEGLPlatform_h

#include <EGL/egl.h>

#include <string> // for names
#include <vector> // for lists

struct vtkEGLPlatform
{
  std::string Name;
  EGLenum Type = EGL_NONE;
  /** An EGLDeviceEXT where there is one. */
  void* Handle = nullptr;
  /** Its number where it is a device, else -1. */
  int DeviceIndex = -1;
  bool IsSoftware = false;
  /** Whether a driver that falls back to software is of no use here. */
  bool MustBeHardware = false;

  /** EGL_NO_DISPLAY where there is none. */
  EGLDisplay GetDisplay() const;

  static std::vector<vtkEGLPlatform> ListDevices();

  /** All platforms in the order in which they are tried, or, for an index from 0, that device. A
   * device that is not one of software must be hardware, unless the environment wants software. */
  static std::vector<vtkEGLPlatform> ListCandidates(int deviceIndex);
};

#endif
