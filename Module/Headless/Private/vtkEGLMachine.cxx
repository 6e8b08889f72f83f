// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEGLMachine.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace fs = std::filesystem;

namespace
{
// Library folders, with and without multiarch. "*" stands for the rest of a name.
const char* const LibraryFolders[] = { "/usr/lib/x86_64-linux-gnu", "/usr/lib/aarch64-linux-gnu",
  "/usr/lib64", "/usr/lib", "/lib/x86_64-linux-gnu", "/lib/aarch64-linux-gnu", "/lib64", "/lib" };
const char* const OtherLibraryFolders[] = { "/usr/local/nvidia/lib64", "/usr/local/nvidia/lib",
  "/usr/lib/x86_64-linux-gnu/nvidia/current", "/usr/lib64/nvidia", "/run/opengl-driver/lib",
  "/usr/lib/x86_64-linux-gnu/GL/nvidia-*/lib", "/usr/lib/aarch64-linux-gnu/GL/nvidia-*/lib" };
const char* const VendorFolders[] = { "/etc/glvnd/egl_vendor.d", "/usr/share/glvnd/egl_vendor.d" };
const char* const OtherVendorFolders[] = { "/usr/local/nvidia/share/glvnd/egl_vendor.d",
  "/usr/local/share/glvnd/egl_vendor.d", "/run/opengl-driver/share/glvnd/egl_vendor.d",
  "/usr/lib/x86_64-linux-gnu/GL/glvnd/egl_vendor.d",
  "/usr/lib/aarch64-linux-gnu/GL/glvnd/egl_vendor.d",
  "/usr/lib/x86_64-linux-gnu/GL/nvidia-*/glvnd/egl_vendor.d",
  "/usr/lib/aarch64-linux-gnu/GL/nvidia-*/glvnd/egl_vendor.d" };
const char* const NvidiaLibraryName = "libEGL_nvidia.so.0";

//------------------------------------------------------------------------------
std::string GetEnvironment(const char* name)
{
  const char* value = std::getenv(name);
  return value ? value : "";
}

//------------------------------------------------------------------------------
std::vector<std::string> SplitPath(const std::string& list)
{
  std::vector<std::string> parts;
  std::istringstream stream(list);
  std::string part;
  while (std::getline(stream, part, ':'))
  {
    if (!part.empty())
    {
      parts.push_back(part);
    }
  }
  return parts;
}

//------------------------------------------------------------------------------
// A tree of files. All paths in its methods begin with "/" at its root.
class Tree
{
public:
  explicit Tree(const std::string& root)
    : Root(root == "/" ? "" : root)
  {
  }

  bool Has(const std::string& path) const
  {
    std::error_code error;
    return fs::exists(this->Root + path, error);
  }

  /** The beginning of a file; empty if it cannot be read. */
  std::string Read(const std::string& path) const
  {
    std::error_code error;
    // Reading a pipe or a device would block.
    if (!fs::is_regular_file(this->Root + path, error))
    {
      return "";
    }
    std::ifstream file(this->Root + path);
    std::string text(4096, '\0');
    file.read(&text[0], static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<size_t>(std::max<std::streamsize>(file.gcount(), 0)));
    return text;
  }

  /** The paths in a folder whose names have that beginning, sorted. */
  std::vector<std::string> List(const std::string& folder, const std::string& beginning) const
  {
    std::vector<std::string> paths;
    std::error_code error;
    for (fs::directory_iterator entry(this->Root + folder, error), end; !error && entry != end;
         entry.increment(error))
    {
      const std::string name = entry->path().filename().string();
      if (name.compare(0, beginning.size(), beginning) == 0)
      {
        paths.push_back(folder + "/" + name);
      }
    }
    std::sort(paths.begin(), paths.end());
    return paths;
  }

  /** The folders that match a pattern: the pattern itself, or each name for a "*" at a name's
   * end. */
  std::vector<std::string> Expand(const std::string& pattern) const
  {
    const size_t star = pattern.find('*');
    if (star == std::string::npos)
    {
      return { pattern };
    }
    const size_t slash = pattern.rfind('/', star);
    std::vector<std::string> folders =
      this->List(pattern.substr(0, slash), pattern.substr(slash + 1, star - slash - 1));
    for (std::string& folder : folders)
    {
      folder += pattern.substr(star + 1);
    }
    return folders;
  }

  int GetOpenError(const std::string& path) const
  {
    // Opens the file, because a container may refuse access that the permissions allow.
    const int file = open((this->Root + path).c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
    if (file < 0)
    {
      return errno;
    }
    close(file);
    return 0;
  }

private:
  std::string Root;
};

//------------------------------------------------------------------------------
bool IsNumbered(const std::string& path, const std::string& beginning)
{
  const std::string name = path.substr(path.rfind('/') + 1);
  return name.size() > beginning.size() && name.compare(0, beginning.size(), beginning) == 0 &&
    name.find_first_not_of("0123456789", beginning.size()) == std::string::npos;
}

//------------------------------------------------------------------------------
// The driver that the kernel has bound to the card of a render node; empty if the card cannot
// render.
std::string GetRenderingDriver(const Tree& tree, const std::string& name)
{
  const std::string device = "/sys/class/drm/" + name + "/device";
  std::istringstream lines(tree.Read(device + "/uevent"));
  std::string line;
  std::string driver;
  while (std::getline(lines, line))
  {
    if (line.compare(0, 7, "DRIVER=") == 0)
    {
      driver = line.substr(7);
    }
  }
  // vgem has no card, and depending on the kernel's version no driver or a driver of this name. A
  // card of VMware has a render node whether or not its host renders, which cannot be queried.
  if (driver == "faux_driver" || driver == "vgem" || driver == "vmwgfx")
  {
    return "";
  }
  if (driver == "virtio_gpu" || driver == "virtio-pci" || driver == "virtio-mmio")
  {
    // As with VMware, but the first of the features that the host offers is rendering. The device
    // is the one on the virtio bus, or depending on the kernel's version its parent.
    std::vector<std::string> folders = tree.List(device, "virtio");
    folders.push_back(device);
    const bool renders = std::any_of(folders.begin(), folders.end(),
      [&](const std::string& folder)
      { return tree.Read(folder + "/features").compare(0, 1, "1") == 0; });
    return renders ? "virtio_gpu" : "";
  }
  return driver;
}

//------------------------------------------------------------------------------
void GatherNodes(const Tree& tree, vtkEGLMachine& machine)
{
  for (const std::string& path : tree.List("/sys/class/drm", "renderD"))
  {
    const std::string name = path.substr(path.rfind('/') + 1);
    const std::string driver = GetRenderingDriver(tree, name);
    if (!driver.empty())
    {
      machine.KernelNodes.push_back({ "/dev/dri/" + name, driver, 0 });
    }
  }
  for (const std::string& path : tree.List("/dev/dri", "renderD"))
  {
    const auto known = std::find_if(machine.KernelNodes.begin(), machine.KernelNodes.end(),
      [&](const vtkEGLMachine::File& node) { return node.Path == path; });
    const bool isKnown = known != machine.KernelNodes.end();
    // Some sandboxes show devices but none of the kernel's files.
    const bool isUnknown = !tree.Has("/sys/class/drm" + path.substr(path.rfind('/')));
    if (IsNumbered(path, "renderD") && (isKnown || isUnknown))
    {
      machine.RenderNodes.push_back(
        { path, isKnown ? known->Driver : "", tree.GetOpenError(path) });
    }
  }
}

//------------------------------------------------------------------------------
// Finds the word of digits and points in "NVRM version: NVIDIA UNIX x86_64 Kernel Module 535.161.07
// Sat Feb 17 ...".
std::string FindVersion(const std::string& text)
{
  std::istringstream words(text);
  std::string word;
  while (words >> word)
  {
    if (word.find('.') != std::string::npos && word.front() != '.' && word.back() != '.' &&
      word.find_first_not_of("0123456789.") == std::string::npos)
    {
      return word;
    }
  }
  return "";
}

//------------------------------------------------------------------------------
void GatherNvidia(const Tree& tree, vtkEGLMachine& machine)
{
  for (const std::string& path : tree.List("/dev", "nvidia"))
  {
    if (IsNumbered(path, "nvidia"))
    {
      machine.NvidiaFiles.push_back({ path, "nvidia", tree.GetOpenError(path) });
    }
  }
  machine.NvidiaVersion = FindVersion(tree.Read("/proc/driver/nvidia/version"));
  const bool isLoaded = tree.Has("/proc/driver/nvidia/version") || tree.Has("/sys/module/nvidia");
  // The module may have outlived its last card.
  const bool hasNoCard =
    tree.Has("/proc/driver/nvidia/gpus") && tree.List("/proc/driver/nvidia/gpus", "").empty();
  machine.HasNvidiaKernel = (isLoaded && !hasNoCard) ||
    std::any_of(machine.KernelNodes.begin(), machine.KernelNodes.end(),
      [](const vtkEGLMachine::File& node) { return node.Driver == "nvidia"; });
}

//------------------------------------------------------------------------------
std::string FindLibrary(const Tree& tree, const std::vector<std::string>& folders)
{
  for (const std::string& pattern : folders)
  {
    for (const std::string& folder : tree.Expand(pattern))
    {
      std::string path = folder + "/" + NvidiaLibraryName;
      if (tree.Has(path))
      {
        return path;
      }
    }
  }
  return "";
}

//------------------------------------------------------------------------------
std::string FindVendorFile(const Tree& tree, const std::vector<std::string>& files)
{
  const auto found = std::find_if(files.begin(), files.end(),
    [&](const std::string& path)
    { return tree.Read(path).find("libEGL_nvidia") != std::string::npos; });
  return found == files.end() ? "" : *found;
}

//------------------------------------------------------------------------------
std::vector<std::string> ListFiles(const Tree& tree, const std::vector<std::string>& folders)
{
  std::vector<std::string> files;
  for (const std::string& pattern : folders)
  {
    for (const std::string& folder : tree.Expand(pattern))
    {
      const std::vector<std::string> more = tree.List(folder, "");
      std::copy_if(more.begin(), more.end(), std::back_inserter(files),
        [](const std::string& path)
        { return path.size() > 5 && path.compare(path.size() - 5, 5, ".json") == 0; });
    }
  }
  return files;
}

//------------------------------------------------------------------------------
std::string GetNamedLibrary(const Tree& tree, const std::string& vendorFile)
{
  const std::string text = vendorFile.empty() ? "" : tree.Read(vendorFile);
  const size_t name = text.find("libEGL_nvidia");
  const size_t begin = name == std::string::npos ? name : text.rfind('"', name);
  const size_t end = text.find('"', name);
  if (begin == std::string::npos || end == std::string::npos)
  {
    return "";
  }
  const std::string path = text.substr(begin + 1, end - begin - 1);
  return path.front() == '/' && tree.Has(path) ? path : "";
}

//------------------------------------------------------------------------------
// Folders that the dynamic linker searches.
std::vector<std::string> ListLibraryFolders(const Tree& tree)
{
  std::vector<std::string> folders = SplitPath(GetEnvironment("LD_LIBRARY_PATH"));
  for (const std::string& file : tree.List("/etc/ld.so.conf.d", ""))
  {
    std::istringstream words(tree.Read(file));
    std::string word;
    while (words >> word)
    {
      if (word.front() == '/')
      {
        folders.push_back(word);
      }
    }
  }
  folders.insert(folders.end(), std::begin(LibraryFolders), std::end(LibraryFolders));
  return folders;
}

//------------------------------------------------------------------------------
void GatherNvidiaDriver(const Tree& tree, vtkEGLMachine& machine)
{
  // Files named in the environment replace the folders that EGL searches by default.
  const std::vector<std::string> standard(std::begin(VendorFolders), std::end(VendorFolders));
  std::vector<std::string> files = SplitPath(machine.VendorFilenames);
  if (files.empty())
  {
    const std::vector<std::string> named = SplitPath(GetEnvironment("__EGL_VENDOR_LIBRARY_DIRS"));
    files = ListFiles(tree, named.empty() ? standard : named);
  }
  machine.NvidiaVendorFile = FindVendorFile(tree, files);
  machine.NvidiaVendorFileIsFound = !machine.NvidiaVendorFile.empty();
  if (!machine.NvidiaVendorFileIsFound)
  {
    std::vector<std::string> all = standard;
    all.insert(all.end(), std::begin(OtherVendorFolders), std::end(OtherVendorFolders));
    machine.NvidiaVendorFile = FindVendorFile(tree, ListFiles(tree, all));
  }

  // A vendor's file may have the whole path of its library.
  const std::string named = GetNamedLibrary(tree, machine.NvidiaVendorFile);
  const std::vector<std::string> folders = ListLibraryFolders(tree);
  machine.NvidiaLibrary = named.empty() ? FindLibrary(tree, folders) : named;
  machine.NvidiaLibraryIsFound = !machine.NvidiaLibrary.empty();
  if (!machine.NvidiaLibraryIsFound)
  {
    machine.NvidiaLibrary =
      FindLibrary(tree, { std::begin(OtherLibraryFolders), std::end(OtherLibraryFolders) });
  }
}
}

//------------------------------------------------------------------------------
bool vtkEGLMachine::EnvironmentWantsSoftware()
{
  // Mesa takes each of these, in upper or lower case, for no.
  std::string always = GetEnvironment("LIBGL_ALWAYS_SOFTWARE");
  std::transform(always.begin(), always.end(), always.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto is = [](const std::string& text, std::initializer_list<const char*> words)
  { return std::find(words.begin(), words.end(), text) != words.end(); };
  return !is(always, { "", "0", "n", "no", "f", "false" }) ||
    is(GetEnvironment("GALLIUM_DRIVER"), { "llvmpipe", "softpipe", "swr" }) ||
    is(GetEnvironment("MESA_LOADER_DRIVER_OVERRIDE"), { "swrast", "kms_swrast" });
}

//------------------------------------------------------------------------------
std::string vtkEGLMachine::GetKernelDriver(const std::string& renderNode)
{
  return GetRenderingDriver(Tree(Root), renderNode.substr(renderNode.rfind('/') + 1));
}

//------------------------------------------------------------------------------
vtkEGLMachine vtkEGLMachine::Gather()
{
  const Tree tree(Root);
  vtkEGLMachine machine;
  machine.VendorFilenames = GetEnvironment("__EGL_VENDOR_LIBRARY_FILENAMES");
  machine.DriverCapabilities = GetEnvironment("NVIDIA_DRIVER_CAPABILITIES");
  machine.WantsSoftware = EnvironmentWantsSoftware();
  GatherNodes(tree, machine);
  GatherNvidia(tree, machine);
  GatherNvidiaDriver(tree, machine);
  return machine;
}
