// SPDX-License-Identifier: BSD-3-Clause
#include "CardTestTools.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace fs = std::filesystem;

namespace headlesstest
{
//------------------------------------------------------------------------------
FakeTree::FakeTree()
{
  std::string pattern = (fs::temp_directory_path() / "headlessXXXXXX").string();
  if (!mkdtemp(&pattern[0]))
  {
    std::cerr << "No temporary folder can be made like " << pattern << ".\n";
    std::exit(EXIT_FAILURE);
  }
  this->Root = pattern;
}

//------------------------------------------------------------------------------
FakeTree::~FakeTree()
{
  std::error_code error;
  fs::remove_all(this->Root, error);
}

//------------------------------------------------------------------------------
FakeTree& FakeTree::File(const std::string& path, const std::string& content)
{
  fs::create_directories(fs::path(this->Root + path).parent_path());
  std::ofstream(this->Root + path) << content;
  return *this;
}

//------------------------------------------------------------------------------
FakeTree& FakeTree::Folder(const std::string& path)
{
  fs::create_directories(this->Root + path);
  return *this;
}

//------------------------------------------------------------------------------
FakeTree& FakeTree::KernelNode(const std::string& name, const std::string& driver)
{
  const std::string line = driver.empty() ? "" : "DRIVER=" + driver + "\n";
  return this->File("/sys/class/drm/" + name + "/device/uevent", line + "PCI_CLASS=30000\n");
}

//------------------------------------------------------------------------------
FakeTree& FakeTree::Node(const std::string& name, const std::string& driver)
{
  return this->KernelNode(name, driver).File("/dev/dri/" + name);
}

//------------------------------------------------------------------------------
void SetEnvironment(const Settings& settings)
{
  for (const char* name : { "LIBGL_ALWAYS_SOFTWARE", "GALLIUM_DRIVER",
         "MESA_LOADER_DRIVER_OVERRIDE", "__EGL_VENDOR_LIBRARY_FILENAMES",
         "__EGL_VENDOR_LIBRARY_DIRS", "NVIDIA_DRIVER_CAPABILITIES", "LD_LIBRARY_PATH" })
  {
    unsetenv(name);
  }
  for (const auto& setting : settings)
  {
    setenv(setting.first.c_str(), setting.second.c_str(), 1);
  }
}

//------------------------------------------------------------------------------
std::string WriteVendorFile(FakeTree& tree, const std::string& path, const std::string& library)
{
  tree.File(path,
    "{ \"file_format_version\" : \"1.0.0\", \"ICD\" : { \"library_path\" : \"" + library +
      "\" } }\n");
  return tree.GetRoot() + path;
}
}
