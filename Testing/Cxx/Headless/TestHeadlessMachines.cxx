// SPDX-License-Identifier: BSD-3-Clause
// The facts of a machine, from simulated trees of files.
#include "CardTestTools.h"
#include "HeadlessTestTools.h"

#include "vtkEGLDiagnosis.h"
#include "vtkEGLMachine.h"

#include <cerrno>
#include <filesystem>

using namespace headlesstest;

namespace
{
//------------------------------------------------------------------------------
vtkEGLMachine Gather(const std::string& root)
{
  vtkEGLMachine::Root = root;
  return vtkEGLMachine::Gather();
}

//------------------------------------------------------------------------------
bool Says(const FakeTree& tree, const std::string& words)
{
  const std::string line = vtkEGLDiagnosis::Explain(Gather(tree.GetRoot()));
  std::cout << (line.empty() ? "(nothing)" : line) << "\n";
  return words.empty() ? line.empty() : line.find(words) != std::string::npos;
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(MachineEmpty)
{
  FakeTree tree;
  SetEnvironment({});
  CHECK(Says(tree, ""), "");
  CHECK(vtkEGLDiagnosis::Explain(Gather("/no/such/folder")).empty(), "");
  // The real root.
  const vtkEGLMachine machine = Gather("/");
  CHECK(!machine.WantsSoftware, "");
  CHECK(machine.NvidiaFiles.empty() != std::filesystem::exists("/dev/nvidia0"), "");
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(MachineNodes)
{
  SetEnvironment({});
  FakeTree tree;
  tree.Node("renderD128", "amdgpu").KernelNode("renderD129", "i915").File("/dev/dri/card0");
  tree.File("/dev/dri/renderDx").Folder("/dev/dri/by-path");
  const vtkEGLMachine machine = Gather(tree.GetRoot());
  CHECK(machine.RenderNodes.size() == 1, machine.RenderNodes.size());
  CHECK(machine.RenderNodes.at(0).Path == "/dev/dri/renderD128", machine.RenderNodes.at(0).Path);
  CHECK(machine.RenderNodes.at(0).Driver == "amdgpu", machine.RenderNodes.at(0).Driver);
  CHECK(machine.RenderNodes.at(0).OpenError == 0, machine.RenderNodes.at(0).OpenError);
  CHECK(machine.KernelNodes.size() == 2, machine.KernelNodes.size());
  CHECK(machine.KernelNodes.at(1).Path == "/dev/dri/renderD129", "");
  CHECK(machine.KernelNodes.at(1).Driver == "i915", "");
  CHECK(machine.NvidiaFiles.empty() && !machine.HasNvidiaKernel, "");
  CHECK(Says(tree, "EGL lists no device of the graphics card /dev/dri/renderD128 (amdgpu)"), "");

  // A file that cannot be opened has a reason. Folders cannot be opened even by root.
  FakeTree closed;
  closed.KernelNode("renderD128", "xe").Folder("/dev/dri/renderD128");
  const vtkEGLMachine refused = Gather(closed.GetRoot());
  CHECK(refused.RenderNodes.at(0).OpenError == EISDIR, refused.RenderNodes.at(0).OpenError);
  CHECK(Says(closed, "/dev/dri/renderD128 of a graphics card cannot be opened"), "");
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(MachineContainer)
{
  SetEnvironment({});
  // The host's /sys without its devices.
  FakeTree mesa;
  mesa.KernelNode("renderD128", "amdgpu").Folder("/sys/class/drm/card0");
  CHECK(Says(mesa, "--device /dev/dri"), "");

  FakeTree nvidia;
  nvidia.File("/proc/driver/nvidia/version",
    "NVRM version: NVIDIA UNIX x86_64 Kernel Module  535.161.07  Sat Feb 17 22:55:48 UTC 2024\n"
    "GCC version:  gcc version 12.2.0 (Debian 12.2.0-14)\n");
  CHECK(Gather(nvidia.GetRoot()).NvidiaVersion == "535.161.07", "");
  CHECK(Says(nvidia, "--gpus all"), "");
  nvidia.Folder("/proc/driver/nvidia/gpus/0000:01:00.0");
  CHECK(Says(nvidia, "--gpus all"), "");

  // The module is loaded without a card.
  FakeTree without;
  without.Folder("/sys/module/nvidia").Folder("/proc/driver/nvidia/gpus");
  CHECK(Says(without, ""), "");
  FakeTree module;
  module.Folder("/sys/module/nvidia");
  CHECK(Says(module, "--gpus all"), "");
  // The card also drives the display, and only its node was passed on.
  FakeTree node;
  node.Node("renderD128", "nvidia");
  CHECK(Says(node, "--gpus all"), "");
  // Other modules may be part of a kernel without such a card.
  FakeTree others;
  others.Folder("/sys/module/i915").Folder("/sys/module/amdgpu").Folder("/sys/class/drm");
  CHECK(Says(others, ""), "");
}

//------------------------------------------------------------------------------
// Cards that only display pictures, and drivers without a card.
VTK_INDIRECT_TEST(MachineFramebuffers)
{
  SetEnvironment({});
  for (const char* driver :
    { "bochs-drm", "cirrus", "simple-framebuffer", "ast", "mgag200", "vkms", "hyperv_drm", "qxl" })
  {
    FakeTree tree;
    tree.File("/sys/class/drm/card0/device/uevent", "DRIVER=" + std::string(driver) + "\n");
    tree.File("/dev/dri/card0").File("/dev/fb0");
    CHECK(Says(tree, ""), driver);
  }
  for (const char* driver : { "", "vgem", "faux_driver", "vmwgfx", "virtio_gpu", "virtio-pci" })
  {
    FakeTree tree;
    tree.Node("renderD128", driver);
    CHECK(Says(tree, ""), driver);
  }
  // For virtio the host's features decide: the first is rendering.
  for (const char* path : { "/sys/class/drm/renderD128/device/features",
         "/sys/class/drm/renderD128/device/virtio3/features" })
  {
    FakeTree tree;
    tree.Node("renderD128", "virtio-pci").File(path, "0100000000");
    CHECK(Says(tree, ""), path);
    tree.File(path, "1100000000");
    CHECK(Says(tree, "virtio_gpu"), path);
  }
}

//------------------------------------------------------------------------------
// A sandbox with the card's files and none of the kernel's.
VTK_INDIRECT_TEST(MachineSandbox)
{
  SetEnvironment({});
  FakeTree tree;
  tree.File("/dev/nvidia0").File("/dev/nvidiactl").File("/dev/nvidia-uvm").Folder("/sys");
  const vtkEGLMachine machine = Gather(tree.GetRoot());
  CHECK(machine.NvidiaFiles.size() == 1, machine.NvidiaFiles.size());
  CHECK(machine.NvidiaVersion.empty() && !machine.HasNvidiaKernel, "");
  CHECK(Says(tree, "libEGL_nvidia.so.0"), "");
  FakeTree mesa;
  mesa.File("/dev/dri/renderD128");
  CHECK(Says(mesa, "/dev/dri/renderD128"), "");
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(MachineNvidiaDriver)
{
  const std::string library = "libEGL_nvidia.so.0";
  const std::string standard = "/usr/share/glvnd/egl_vendor.d/10_nvidia.json";
  SetEnvironment({ { "NVIDIA_DRIVER_CAPABILITIES", "compute" } });
  FakeTree tree;
  tree.File("/dev/nvidia0");
  CHECK(Says(tree, "it is compute"), "");
  WriteVendorFile(tree, "/usr/share/glvnd/egl_vendor.d/50_mesa.json", "libEGL_mesa.so.0");
  tree.File("/usr/lib/x86_64-linux-gnu/" + library);
  CHECK(Says(tree, "10_nvidia.json is missing"), "");
  WriteVendorFile(tree, standard, library);
  vtkEGLMachine machine = Gather(tree.GetRoot());
  CHECK(machine.NvidiaVendorFile == standard && machine.NvidiaVendorFileIsFound, "");
  CHECK(machine.NvidiaLibrary == "/usr/lib/x86_64-linux-gnu/" + library, machine.NvidiaLibrary);
  CHECK(machine.NvidiaLibraryIsFound, "");
  CHECK(Says(tree, "EGL lists no device"), "");

  // The environment redirects EGL.
  SetEnvironment({ { "__EGL_VENDOR_LIBRARY_FILENAMES",
    "/gone.json:/usr/share/glvnd/egl_vendor.d/50_mesa.json" } });
  CHECK(Says(tree, "__EGL_VENDOR_LIBRARY_FILENAMES=" + standard + " (it is /gone.json:"), "");
  SetEnvironment({ { "__EGL_VENDOR_LIBRARY_FILENAMES", standard } });
  CHECK(Says(tree, "EGL lists no device"), "");
  SetEnvironment({ { "__EGL_VENDOR_LIBRARY_DIRS", "/etc/glvnd/egl_vendor.d" } });
  CHECK(Says(tree, "__EGL_VENDOR_LIBRARY_FILENAMES=" + standard), "");

  // A file with the whole path of its library, as NixOS writes it, and one with a missing library.
  SetEnvironment({});
  const std::string stored = "/nix/store/a-nvidia-x11/lib/" + library;
  FakeTree whole;
  whole.File("/dev/nvidia0");
  WriteVendorFile(whole, "/run/opengl-driver/share/glvnd/egl_vendor.d/10_nvidia.json", stored);
  CHECK(Says(whole, "in none of the usual folders"), "");
  whole.File(stored);
  machine = Gather(whole.GetRoot());
  CHECK(machine.NvidiaLibrary == stored && machine.NvidiaLibraryIsFound, machine.NvidiaLibrary);
  CHECK(Says(whole, "egl_vendor.d/10_nvidia.json."), "");
  // A folder in the linker's configuration.
  FakeTree listed;
  listed.File("/dev/nvidia0").File("/opt/nvidia/lib/" + library);
  WriteVendorFile(listed, standard, library);
  CHECK(Says(listed, "in none of the usual folders"), "");
  listed.File("/etc/ld.so.conf.d/nvidia.conf", "# NVIDIA\n/opt/nvidia/lib\n");
  CHECK(Gather(listed.GetRoot()).NvidiaLibraryIsFound, "");

  // Drivers in their own folder.
  struct Place
  {
    const char* Library;
    const char* VendorFile;
  };
  for (const Place& at :
    { Place{ "/usr/local/nvidia/lib64", "/usr/local/nvidia/share/glvnd/egl_vendor.d" },
      Place{ "/run/opengl-driver/lib", "/run/opengl-driver/share/glvnd/egl_vendor.d" },
      Place{ "/usr/lib/x86_64-linux-gnu/GL/nvidia-535-161-07/lib",
        "/usr/lib/x86_64-linux-gnu/GL/nvidia-535-161-07/glvnd/egl_vendor.d" } })
  {
    SetEnvironment({});
    FakeTree other;
    other.File("/dev/nvidia0").File(std::string(at.Library) + "/" + library);
    const std::string file = std::string(at.VendorFile) + "/10_nvidia.json";
    WriteVendorFile(other, file, library);
    CHECK(Says(other,
            "set __EGL_VENDOR_LIBRARY_FILENAMES=" + file + " and add " + at.Library +
              " to LD_LIBRARY_PATH."),
      at.Library);
    SetEnvironment({ { "LD_LIBRARY_PATH", std::string("/a:") + at.Library } });
    CHECK(Says(other, "set __EGL_VENDOR_LIBRARY_FILENAMES=" + file + "."), at.Library);
    SetEnvironment({ { "__EGL_VENDOR_LIBRARY_FILENAMES", file } });
    CHECK(Says(other, std::string("add ") + at.Library + " to LD_LIBRARY_PATH"), at.Library);
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(MachineSoftwareWanted)
{
  const std::string always = "LIBGL_ALWAYS_SOFTWARE";
  FakeTree tree;
  tree.Node("renderD128", "amdgpu");
  for (const Settings& settings : { Settings{ { always, "1" } }, Settings{ { always, "True" } },
         Settings{ { "GALLIUM_DRIVER", "llvmpipe" } },
         Settings{ { "MESA_LOADER_DRIVER_OVERRIDE", "swrast" } } })
  {
    SetEnvironment(settings);
    CHECK(Says(tree, ""), settings.begin()->first << " " << settings.begin()->second);
  }
  for (const Settings& settings : { Settings{ { always, "0" } }, Settings{ { always, "False" } },
         Settings{ { always, "" } }, Settings{ { "GALLIUM_DRIVER", "radeonsi" } } })
  {
    SetEnvironment(settings);
    CHECK(!Says(tree, ""), settings.begin()->first << " " << settings.begin()->second);
  }
}
}
