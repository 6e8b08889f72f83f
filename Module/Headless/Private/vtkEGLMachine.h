// SPDX-License-Identifier: BSD-3-Clause
// A machine's, or a container's, graphics cards as seen outside of EGL: device files, the kernel's
// drivers, the place of NVIDIA's driver, and the environment's choices. Plain facts, so that the
// conclusions from them can be tested without a card.
#pragma once

#include <string> // for paths
#include <vector> // for lists

struct vtkEGLMachine
{
  /** The file of a device. */
  struct File
  {
    std::string Path;
    /** The kernel's driver, such as "amdgpu"; empty if unknown. */
    std::string Driver;
    /** Reason why it cannot be opened, as in errno; 0 if it can. */
    int OpenError = 0;
  };

  /** An attempt with EGL, and the reason of its failure. */
  struct Attempt
  {
    std::string Name;
    std::string Reason;
    /** True if it is a hardware device; and its number. */
    bool IsHardware = false;
    int DeviceIndex = -1;
    bool IsNvidia = false;
    std::string RenderNode;
  };

  /** /dev/dri/renderD* of cards that can render. Cards that only display pictures, as in most
   * virtual machines and servers, have no such file. */
  std::vector<File> RenderNodes;
  /** Render nodes in the kernel's list, with or without a file in /dev. A container sees those of
   * its host. Their OpenError is 0. */
  std::vector<File> KernelNodes;

  /** /dev/nvidia0 and so on. */
  std::vector<File> NvidiaFiles;
  /** True if the kernel has NVIDIA's own driver, with a card; and its version if known. */
  bool HasNvidiaKernel = false;
  std::string NvidiaVersion;
  /** NVIDIA's library for EGL, and the file that names it to EGL; empty if there is none. Each may
   * be in a searched folder, or in another known one. */
  std::string NvidiaLibrary;
  bool NvidiaLibraryIsFound = false;
  std::string NvidiaVendorFile;
  bool NvidiaVendorFileIsFound = false;

  /** The environment's __EGL_VENDOR_LIBRARY_FILENAMES and NVIDIA_DRIVER_CAPABILITIES. */
  std::string VendorFilenames;
  std::string DriverCapabilities;
  /** True if the environment requests software. */
  bool WantsSoftware = false;

  std::vector<Attempt> Attempts;

  /** The root of all files, which tests replace. */
  static inline std::string Root = "/";

  /** Gathers all but the attempts. */
  static vtkEGLMachine Gather();

  /** The kernel's driver of the card with that file, such as "/dev/dri/renderD128"; empty if it is
   * unknown or cannot render. */
  static std::string GetKernelDriver(const std::string& renderNode);

  /** True if the environment requests that Mesa renders in software. */
  static bool EnvironmentWantsSoftware();
};
