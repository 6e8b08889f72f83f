// SPDX-License-Identifier: BSD-3-Clause
// EGL's description of one of its devices. Drivers report different properties, and some none.
#pragma once

#include <string> // for names
#include <vector> // for lists

struct vtkEGLDevice
{
  int Index = -1;
  /** Name of the card, such as "NVIDIA A40"; vendor of the driver; name of the driver, from the
   * kernel if EGL does not tell it. */
  std::string Renderer;
  std::string Vendor;
  std::string Driver;
  /** Files of the kernel, such as "/dev/dri/card0" and "/dev/dri/renderD128". */
  std::string CardFile;
  std::string RenderNode;
  /** CUDA's number of the card, -1 if it has none. */
  int CudaDevice = -1;
  bool IsSoftware = false;
  /** The first device with the same card, -1 if there is none: two drivers may list one card. */
  int SameCardAs = -1;

  bool IsNvidia() const;

  /** One line: "EGL device 0: hardware, NVIDIA A40, NVIDIA, /dev/dri/renderD128, CUDA device 0". */
  std::string Describe() const;

  /** All devices, in the order of their indices. */
  static std::vector<vtkEGLDevice> List();

  /** The descriptions of all devices in one line, or a text that there are none. */
  static std::string DescribeAll(const std::vector<vtkEGLDevice>& devices);
};
