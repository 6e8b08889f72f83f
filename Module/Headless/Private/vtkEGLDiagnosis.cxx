// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEGLDiagnosis.h"

#include "vtkEGLMachine.h"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <vector>

namespace
{
using File = vtkEGLMachine::File;
using Attempt = vtkEGLMachine::Attempt;

//------------------------------------------------------------------------------
bool IsNvidia(const File& file)
{
  return file.Driver == "nvidia";
}

//------------------------------------------------------------------------------
// The first of Mesa's cards. NVIDIA's own driver has render nodes too, but needs no Mesa.
const File* FindOther(const std::vector<File>& files)
{
  const auto found = std::find_if_not(files.begin(), files.end(), IsNvidia);
  return found == files.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
// The first file that can be opened, or else the first file.
const File& ChooseFile(const std::vector<File>& files, bool (*isWanted)(const File&))
{
  const auto opened = std::find_if(files.begin(), files.end(),
    [&](const File& file) { return isWanted(file) && file.OpenError == 0; });
  return opened != files.end() ? *opened : *std::find_if(files.begin(), files.end(), isWanted);
}

//------------------------------------------------------------------------------
std::string ExplainOpenError(const File& file, const std::string& container)
{
  std::string text = file.Path + " of a graphics card cannot be opened (" +
    std::generic_category().message(file.OpenError) + "): ";
  switch (file.OpenError)
  {
    case EACCES:
      return text +
        "the user must be in the groups that own it, mostly render and video (in a container "
        "--group-add).";
    case EPERM:
      return text + "in a container pass " + container + ".";
    default:
      return text + "see the kernel's messages (dmesg).";
  }
}

//------------------------------------------------------------------------------
std::string Folder(const std::string& path)
{
  return path.substr(0, path.rfind('/'));
}

//------------------------------------------------------------------------------
std::string AddLibraryFolder(const vtkEGLMachine& machine)
{
  return "add " + Folder(machine.NvidiaLibrary) + " to LD_LIBRARY_PATH";
}

//------------------------------------------------------------------------------
// Explains the case that a file of an NVIDIA card can be opened.
std::string ExplainNvidia(const vtkEGLMachine& machine, const File& file)
{
  const std::string card = "NVIDIA card " + file.Path;
  const std::string version = machine.NvidiaVersion.empty() ? "" : ", " + machine.NvidiaVersion;
  const auto attempt = std::find_if(machine.Attempts.begin(), machine.Attempts.end(),
    [](const Attempt& tried) { return tried.IsNvidia; });
  if (attempt != machine.Attempts.end())
  {
    return attempt->Name + " of the " + card + " does not work (" + attempt->Reason +
      "): the driver's libraries must have the version of its kernel module" + version +
      "; nvidia-smi tells whether they fit.";
  }
  if (machine.NvidiaLibrary.empty() && !machine.NvidiaVendorFile.empty())
  {
    return "the driver of the " + card + " is named to EGL by " + machine.NvidiaVendorFile +
      ", but its library libEGL_nvidia.so.0 is in none of the usual folders: add its folder to "
      "LD_LIBRARY_PATH" +
      (machine.NvidiaVendorFileIsFound
          ? ""
          : " and set __EGL_VENDOR_LIBRARY_FILENAMES=" + machine.NvidiaVendorFile) +
      "; in a container set NVIDIA_DRIVER_CAPABILITIES=all when it is started.";
  }
  if (machine.NvidiaLibrary.empty())
  {
    return "the driver of the " + card +
      " has no EGL here, libEGL_nvidia.so.0: in a container set NVIDIA_DRIVER_CAPABILITIES=all "
      "when it is started" +
      (machine.DriverCapabilities.empty() ? "" : " (it is " + machine.DriverCapabilities + ")") +
      ", elsewhere install it (Debian: libegl-nvidia0; Ubuntu: libnvidia-gl-<version>).";
  }
  if (machine.NvidiaVendorFile.empty())
  {
    return "EGL does not know of the driver of the " + card + ", " + machine.NvidiaLibrary +
      ": the file 10_nvidia.json is missing in /usr/share/glvnd/egl_vendor.d; in a container set "
      "NVIDIA_DRIVER_CAPABILITIES=all when it is started, elsewhere install the driver again.";
  }
  if (!machine.NvidiaVendorFileIsFound)
  {
    return "EGL does not look for the driver of the " + card + " where it is: set " +
      "__EGL_VENDOR_LIBRARY_FILENAMES=" + machine.NvidiaVendorFile +
      (machine.VendorFilenames.empty() ? "" : " (it is " + machine.VendorFilenames + ")") +
      (machine.NvidiaLibraryIsFound ? "" : " and " + AddLibraryFolder(machine)) + ".";
  }
  if (!machine.NvidiaLibraryIsFound)
  {
    return "EGL may not find the driver of the " + card + ", " + machine.NvidiaLibrary + ": " +
      AddLibraryFolder(machine) + ".";
  }
  return "EGL lists no device of the " + card + " although " + machine.NvidiaVendorFile + " and " +
    machine.NvidiaLibrary +
    " are there: the driver's libraries must be complete and have the version of its kernel "
    "module" +
    version + "; in a container set NVIDIA_DRIVER_CAPABILITIES=all when it is started.";
}

//------------------------------------------------------------------------------
// Explains the case that a render node can be opened.
std::string ExplainMesa(const vtkEGLMachine& machine, const File& node)
{
  const std::string card =
    "the graphics card " + node.Path + (node.Driver.empty() ? "" : " (" + node.Driver + ")");
  const auto find = [&](bool exactly)
  {
    return std::find_if(machine.Attempts.begin(), machine.Attempts.end(),
      [&](const Attempt& tried)
      {
        return tried.IsHardware && !tried.IsNvidia &&
          (exactly ? tried.RenderNode == node.Path : tried.RenderNode.empty());
      });
  };
  auto attempt = find(true);
  attempt = attempt == machine.Attempts.end() ? find(false) : attempt;
  if (attempt != machine.Attempts.end())
  {
    return attempt->Name + " of " + card + " does not work (" + attempt->Reason +
      "): Mesa has no driver here that renders OpenGL 3.2 on it (Debian: libgl1-mesa-dri; a new "
      "card may need a newer one).";
  }
  return "EGL lists no device of " + card +
    (machine.VendorFilenames.empty()
        ? ": install Mesa's EGL and drivers (Debian: libegl-mesa0 libgl1-mesa-dri)."
        : ": unset __EGL_VENDOR_LIBRARY_FILENAMES, which is " + machine.VendorFilenames +
          ", or install Mesa's EGL and drivers (Debian: libegl-mesa0 libgl1-mesa-dri).");
}
}

//------------------------------------------------------------------------------
std::string vtkEGLDiagnosis::Explain(const vtkEGLMachine& machine)
{
  if (machine.WantsSoftware)
  {
    return "";
  }
  if (!machine.NvidiaFiles.empty())
  {
    const File& file = ChooseFile(machine.NvidiaFiles, IsNvidia);
    return file.OpenError == 0 ? ExplainNvidia(machine, file)
                               : ExplainOpenError(file, "--gpus all");
  }
  if (FindOther(machine.RenderNodes))
  {
    const File& node =
      ChooseFile(machine.RenderNodes, [](const File& file) { return !IsNvidia(file); });
    return node.OpenError == 0 ? ExplainMesa(machine, node)
                               : ExplainOpenError(node, "--device /dev/dri");
  }
  if (machine.HasNvidiaKernel)
  {
    return "the kernel has an NVIDIA card, but there is no /dev/nvidia0: in a container pass "
           "--gpus all and set NVIDIA_DRIVER_CAPABILITIES=all, elsewhere run nvidia-modprobe.";
  }
  if (const File* node = FindOther(machine.KernelNodes))
  {
    return "the kernel has a graphics card (" + node->Driver + "), but there is no " + node->Path +
      ": in a container pass --device /dev/dri.";
  }
  return "";
}

//------------------------------------------------------------------------------
std::string vtkEGLDiagnosis::ExplainRenderNode(
  const vtkEGLMachine& machine, const std::string& renderNode)
{
  const auto node = std::find_if(machine.RenderNodes.begin(), machine.RenderNodes.end(),
    [&](const File& file) { return file.Path == renderNode; });
  return node == machine.RenderNodes.end() || node->OpenError == 0
    ? ""
    : ExplainOpenError(*node, "--device /dev/dri");
}
