// SPDX-License-Identifier: BSD-3-Clause
// Explanations of a card that does not render, from facts alone.
#include "HeadlessTestTools.h"

#include "vtkEGLDiagnosis.h"
#include "vtkEGLMachine.h"
#include "vtkEGLUtilities.h"

#include <cerrno>

using namespace headlesstest;

namespace
{
//------------------------------------------------------------------------------
// Checks for one line that contains each of the words and can end a sentence; or for an empty text.
void CheckLine(const vtkEGLMachine& machine, const std::vector<std::string>& words, Place place)
{
  vtkIndirectTest::AddCheck();
  const std::string line = vtkEGLDiagnosis::Explain(machine);
  std::cout << (line.empty() ? "(nothing)" : line) << "\n";
  if (words.empty() != line.empty() || line.find('\n') != std::string::npos ||
    (!line.empty() && line.back() != '.'))
  {
    Fail(place) << "\"" << line << "\"\n";
  }
  for (const std::string& word : words)
  {
    if (!Has(line, word))
    {
      Fail(place) << "no \"" << word << "\" in \"" << line << "\"\n";
    }
  }
}
#define CHECK_LINE(machine, ...) CheckLine(machine, __VA_ARGS__, HERE)

vtkEGLMachine::Attempt MakeAttempt(bool isNvidia, const std::string& node = "")
{
  vtkEGLMachine::Attempt attempt;
  attempt.Name = "EGL device 3";
  attempt.Reason = "eglInitialize: EGL_NOT_INITIALIZED";
  attempt.IsHardware = true;
  attempt.DeviceIndex = 3;
  attempt.IsNvidia = isNvidia;
  attempt.RenderNode = node;
  return attempt;
}

vtkEGLMachine::File MakeFile(const std::string& path, const std::string& driver, int openError = 0)
{
  vtkEGLMachine::File file;
  file.Path = path;
  file.Driver = driver;
  file.OpenError = openError;
  return file;
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(DiagnosisNoCard)
{
  vtkEGLMachine machine;
  CHECK_LINE(machine, {});
  // Facts that do not come from a card change nothing.
  machine.VendorFilenames = "/x.json";
  machine.DriverCapabilities = "all";
  machine.NvidiaLibrary = "/usr/lib/libEGL_nvidia.so.0";
  machine.Attempts.push_back(MakeAttempt(false));
  CHECK_LINE(machine, {});
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(DiagnosisSoftwareWanted)
{
  vtkEGLMachine machine;
  machine.NvidiaFiles = { MakeFile("/dev/nvidia0", "nvidia") };
  machine.RenderNodes = machine.KernelNodes = { MakeFile("/dev/dri/renderD128", "amdgpu") };
  machine.HasNvidiaKernel = true;
  CHECK(!vtkEGLDiagnosis::Explain(machine).empty(), "");
  machine.WantsSoftware = true;
  CHECK_LINE(machine, {});
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(DiagnosisNvidia)
{
  vtkEGLMachine machine;
  machine.NvidiaFiles = { MakeFile("/dev/nvidia1", "nvidia") };
  CHECK_LINE(machine,
    { "/dev/nvidia1", "libEGL_nvidia.so.0", "NVIDIA_DRIVER_CAPABILITIES=all", "libegl-nvidia0" });
  machine.DriverCapabilities = "compute,utility";
  CHECK_LINE(machine, { "NVIDIA_DRIVER_CAPABILITIES=all", "it is compute,utility" });

  machine.NvidiaVendorFile = "/usr/share/glvnd/egl_vendor.d/10_nvidia.json";
  CHECK_LINE(machine, { "FILENAMES=" + machine.NvidiaVendorFile, "LD_LIBRARY_PATH" });
  machine.NvidiaVendorFileIsFound = true;
  CHECK_LINE(machine, { machine.NvidiaVendorFile, "LD_LIBRARY_PATH", "CAPABILITIES=all" });
  CHECK(!Has(vtkEGLDiagnosis::Explain(machine), "FILENAMES"), "");
  machine.NvidiaVendorFile = "";
  machine.NvidiaVendorFileIsFound = false;

  machine.NvidiaLibrary = "/usr/lib64/libEGL_nvidia.so.0";
  machine.NvidiaLibraryIsFound = true;
  CHECK_LINE(machine,
    { "/usr/lib64/libEGL_nvidia.so.0", "10_nvidia.json is missing",
      "NVIDIA_DRIVER_CAPABILITIES=all" });

  machine.NvidiaVendorFile = "/usr/local/nvidia/share/glvnd/egl_vendor.d/10_nvidia.json";
  CHECK_LINE(machine, { "__EGL_VENDOR_LIBRARY_FILENAMES=" + machine.NvidiaVendorFile + "." });
  machine.VendorFilenames = "/usr/share/glvnd/egl_vendor.d/50_mesa.json";
  CHECK_LINE(machine,
    { "__EGL_VENDOR_LIBRARY_FILENAMES=" + machine.NvidiaVendorFile,
      "it is " + machine.VendorFilenames });
  machine.VendorFilenames = "";
  machine.NvidiaLibrary = "/usr/local/nvidia/lib64/libEGL_nvidia.so.0";
  machine.NvidiaLibraryIsFound = false;
  CHECK_LINE(machine,
    { "__EGL_VENDOR_LIBRARY_FILENAMES=" + machine.NvidiaVendorFile,
      "add /usr/local/nvidia/lib64 to LD_LIBRARY_PATH" });
  machine.NvidiaVendorFileIsFound = true;
  CHECK_LINE(machine, { "add /usr/local/nvidia/lib64 to LD_LIBRARY_PATH" });
  CHECK(vtkEGLDiagnosis::Explain(machine).find("FILENAMES") == std::string::npos, "");

  machine.NvidiaLibraryIsFound = true;
  machine.NvidiaVersion = "535.161.07";
  CHECK_LINE(
    machine, { "lists no device", machine.NvidiaVendorFile, machine.NvidiaLibrary, "535.161.07" });

  // Mesa's entry for the card tells nothing about NVIDIA's driver.
  machine.Attempts.push_back(MakeAttempt(false, "/dev/dri/renderD128"));
  CHECK_LINE(machine, { "lists no device" });
  machine.Attempts.push_back(MakeAttempt(true));
  CHECK_LINE(
    machine, { "EGL device 3", "/dev/nvidia1", "EGL_NOT_INITIALIZED", "535.161.07", "nvidia-smi" });
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(DiagnosisMesa)
{
  vtkEGLMachine machine;
  machine.RenderNodes = { MakeFile("/dev/dri/renderD129", "amdgpu") };
  machine.KernelNodes = machine.RenderNodes;
  CHECK_LINE(machine, { "/dev/dri/renderD129", "amdgpu", "libegl-mesa0", "libgl1-mesa-dri" });
  machine.VendorFilenames = "/nvidia.json";
  CHECK_LINE(machine, { "unset __EGL_VENDOR_LIBRARY_FILENAMES", "/nvidia.json" });
  machine.Attempts.push_back(MakeAttempt(false));
  CHECK_LINE(machine,
    { "EGL device 3", "/dev/dri/renderD129 (amdgpu)", "EGL_NOT_INITIALIZED", "libgl1-mesa-dri" });
  // If there are several attempts, the one on that card counts.
  machine.Attempts.push_back(MakeAttempt(false, "/dev/dri/renderD129"));
  machine.Attempts.back().Name = "EGL device 4";
  CHECK_LINE(machine, { "EGL device 4" });
  // With an unknown driver of the kernel.
  machine.RenderNodes[0].Driver = "";
  CHECK_LINE(machine, { "card /dev/dri/renderD129 does" });
  // Attempts on another card or with software do not count for this card.
  machine.Attempts.clear();
  machine.VendorFilenames = "";
  machine.Attempts.push_back(MakeAttempt(false, "/dev/dri/renderD128"));
  machine.Attempts.push_back(MakeAttempt(false));
  machine.Attempts.back().IsHardware = false;
  CHECK_LINE(machine, { "EGL lists no device" });
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(DiagnosisPermission)
{
  vtkEGLMachine machine;
  machine.RenderNodes = { MakeFile("/dev/dri/renderD128", "i915", EACCES) };
  CHECK_LINE(machine, { "/dev/dri/renderD128", "Permission denied", "render and video" });
  machine.RenderNodes[0].OpenError = EPERM;
  CHECK_LINE(machine, { "/dev/dri/renderD128", "--device /dev/dri" });
  machine.RenderNodes[0].OpenError = EIO;
  CHECK_LINE(machine, { "/dev/dri/renderD128", "Input/output error", "dmesg" });
  CHECK(Has(vtkEGLDiagnosis::ExplainRenderNode(machine, "/dev/dri/renderD128"), "dmesg"), "");
  CHECK(vtkEGLDiagnosis::ExplainRenderNode(machine, "/dev/dri/renderD129").empty(), "");
  CHECK(vtkEGLDiagnosis::ExplainRenderNode(machine, "").empty(), "");
  // A card that can be opened takes precedence.
  machine.RenderNodes.push_back(MakeFile("/dev/dri/renderD129", "i915"));
  CHECK_LINE(machine, { "/dev/dri/renderD129" });

  machine.NvidiaFiles = { MakeFile("/dev/nvidia0", "nvidia", EACCES) };
  CHECK_LINE(machine, { "/dev/nvidia0", "Permission denied" });
  machine.NvidiaFiles[0].OpenError = EPERM;
  CHECK_LINE(machine, { "/dev/nvidia0", "--gpus all" });
  machine.NvidiaFiles.push_back(MakeFile("/dev/nvidia1", "nvidia"));
  CHECK_LINE(machine, { "/dev/nvidia1", "libEGL_nvidia.so.0" });
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(DiagnosisContainer)
{
  vtkEGLMachine machine;
  machine.KernelNodes = { MakeFile("/dev/dri/renderD128", "xe") };
  CHECK_LINE(machine, { "xe", "no /dev/dri/renderD128", "--device /dev/dri" });
  // The node of an NVIDIA card does not suffice without /dev/nvidia0.
  machine.KernelNodes = { MakeFile("/dev/dri/renderD128", "nvidia") };
  machine.RenderNodes = machine.KernelNodes;
  machine.HasNvidiaKernel = true;
  CHECK_LINE(machine, { "no /dev/nvidia0", "--gpus all", "NVIDIA_DRIVER_CAPABILITIES=all" });
  machine.KernelNodes.clear();
  machine.RenderNodes.clear();
  CHECK_LINE(machine, { "no /dev/nvidia0", "--gpus all" });
  // A present card takes precedence over an absent one.
  machine.RenderNodes = { MakeFile("/dev/dri/renderD129", "i915") };
  CHECK_LINE(machine, { "/dev/dri/renderD129" });
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(SoftwareNames)
{
  for (const char* name : { "llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Software Rasterizer",
         "Mesa DRI swrast", "SWR (LLVM 9.0, 256 bits)",
         "zink Vulkan 1.3(llvmpipe (LLVM 15.0.6, 256 bits) (LLVMPIPE_DRIVER))", "zink (lavapipe)",
         "virgl (LLVMPIPE (LLVM 15.0.6, 256 bits))",
         "ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)",
         "D3D12 (Microsoft Basic Render Driver)" })
  {
    CHECK(vtkEGLUtilities::IsSoftwareRenderer(name), name);
  }
  for (const char* name : { "", "NVIDIA H100 PCIe/PCIe/SSE2",
         "AMD Radeon RX 6800 (radeonsi, navi21, LLVM 15.0.6, DRM 3.49, 6.1.0)",
         "Mesa Intel(R) UHD Graphics 630 (CFL GT2)", "virgl (NVIDIA GeForce RTX 3080)",
         "zink Vulkan 1.3(NVIDIA GeForce RTX 3080 (NVIDIA_PROPRIETARY))",
         "SVGA3D; build: RELEASE;  LLVM;", "D3D12 (NVIDIA GeForce RTX 3080)", "SWRX 1000" })
  {
    CHECK(!vtkEGLUtilities::IsSoftwareRenderer(name), name);
  }
}
}
