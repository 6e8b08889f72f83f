// SPDX-License-Identifier: BSD-3-Clause
// A possible source of a context, and the order in which sources are tried.
#pragma once

#include <EGL/egl.h>

#include <string> // for names
#include <vector> // for lists

struct vtkEGLPlatform
{
  std::string Name;
  EGLenum Type = EGL_NONE;
  /** The EGLDeviceEXT of a device. */
  void* Handle = nullptr;
  /** Number of a device, else -1. */
  int DeviceIndex = -1;
  bool IsSoftware = false;
  /** True if a driver's fallback to software is to be refused. */
  bool MustBeHardware = false;

  /** EGL_NO_DISPLAY if there is none. */
  EGLDisplay GetDisplay() const;

  static std::vector<vtkEGLPlatform> ListDevices();

  /** All platforms in the order of their trial, or, for an index from 0, that device. A device that
   * is not a software device must render in hardware, unless the environment requests software. */
  static std::vector<vtkEGLPlatform> ListCandidates(int deviceIndex);
};
