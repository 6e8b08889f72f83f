// SPDX-License-Identifier: BSD-3-Clause
// What EGL reports of one of its devices. Drivers report different things, and some nothing.
#ifndef vtkEGLDevice_h
#define vtkEGLDevice_h

#include <string> // for names
#include <vector> // for lists

struct vtkEGLDevice
{
  int Index = -1;
  /** Of the card, such as "NVIDIA A40"; of who made the driver; of the driver, which the kernel
   * tells where EGL does not. */
  std::string Renderer;
  std::string Vendor;
  std::string Driver;
  /** Files of the kernel, such as "/dev/dri/card0" and "/dev/dri/renderD128". */
  std::string CardFile;
  std::string RenderNode;
  /** The number that CUDA gives to the card, -1 where it gives none. */
  int CudaDevice = -1;
  bool IsSoftware = false;
  /** The first device that is the same card, -1 where there is none. Two drivers may list one. */
  int SameCardAs = -1;

  bool IsNvidia() const;

  /** One line: "EGL device 0: hardware, NVIDIA A40, NVIDIA, /dev/dri/renderD128, CUDA device 0". */
  std::string Describe() const;

  /** All devices, in the order of their indices. */
  static std::vector<vtkEGLDevice> List();

  /** The descriptions of all, in one line, or that there are none. */
  static std::string DescribeAll(const std::vector<vtkEGLDevice>& devices);
};

#endif
