// SPDX-License-Identifier: BSD-3-Clause
// What a machine, or a container on it, shows of its graphics cards beside EGL: files of devices,
// what the kernel knows, where NVIDIA's driver lies, and what the environment asks for. Plain
// facts, so that what follows from them can be tried out without a card.
#ifndef vtkEGLMachine_h
#define vtkEGLMachine_h

#include <string> // for paths
#include <vector> // for lists

struct vtkEGLMachine
{
  /** The file of a device. */
  struct File
  {
    std::string Path;
    /** The kernel's driver, such as "amdgpu"; empty where it is not known. */
    std::string Driver;
    /** Why it cannot be opened, as in errno; 0 when it can. */
    int OpenError = 0;
  };

  /** What was tried with EGL, and why it was of no use. */
  struct Attempt
  {
    std::string Name;
    std::string Reason;
    /** Whether it is a device that is not one of software, and its number. */
    bool IsHardware = false;
    int DeviceIndex = -1;
    bool IsNvidia = false;
    std::string RenderNode;
  };

  /** /dev/dri/renderD* of cards that can render. Cards that only show pictures, as most virtual
   * machines and servers have them, have no such file. */
  std::vector<File> RenderNodes;
  /** The same as the kernel lists them, whether or not /dev has them. A container sees those of its
   * host. Their OpenError is 0. */
  std::vector<File> KernelNodes;

  /** /dev/nvidia0 and so on. */
  std::vector<File> NvidiaFiles;
  /** Whether the kernel has NVIDIA's own driver, with a card, and its version where it is known. */
  bool HasNvidiaKernel = false;
  std::string NvidiaVersion;
  /** NVIDIA's library for EGL, and the file that names it to EGL; empty where there is none. Each
   * is in a place where it is looked for, or in another that is known. */
  std::string NvidiaLibrary;
  bool NvidiaLibraryIsFound = false;
  std::string NvidiaVendorFile;
  bool NvidiaVendorFileIsFound = false;

  /** The environment's __EGL_VENDOR_LIBRARY_FILENAMES and NVIDIA_DRIVER_CAPABILITIES. */
  std::string VendorFilenames;
  std::string DriverCapabilities;
  /** Whether software is what was asked for. */
  bool WantsSoftware = false;

  std::vector<Attempt> Attempts;

  /** The root of all files. Tests put another tree in its place. */
  static inline std::string Root = "/";

  /** All but the attempts. */
  static vtkEGLMachine Gather();

  /** The kernel's driver of the card with that file, such as "/dev/dri/renderD128"; empty where it
   * is not known or cannot render. */
  static std::string GetKernelDriver(const std::string& renderNode);

  /** Whether the environment asks Mesa to render in software. */
  static bool EnvironmentWantsSoftware();
};

#endif
