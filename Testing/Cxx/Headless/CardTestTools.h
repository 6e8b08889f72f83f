// SPDX-License-Identifier: BSD-3-Clause
// Simulated machines and drivers: a tree of files in place of "/", and an environment.

#ifndef CardTestTools_h
#define CardTestTools_h

#include <map>
#include <string>

namespace headlesstest
{
// A tree of files in a temporary folder, which is removed with the object.
class FakeTree
{
public:
  FakeTree();
  ~FakeTree();
  FakeTree(const FakeTree&) = delete;
  void operator=(const FakeTree&) = delete;

  const std::string& GetRoot() const { return this->Root; }

  // Paths begin with "/". Creates parent folders, too.
  FakeTree& File(const std::string& path, const std::string& content = "");
  FakeTree& Folder(const std::string& path);

  // The kernel's files of a render node, such as "renderD128"; Node adds its file in /dev/dri.
  FakeTree& KernelNode(const std::string& name, const std::string& driver);
  FakeTree& Node(const std::string& name, const std::string& driver);

private:
  std::string Root;
};

using Settings = std::map<std::string, std::string>;

// Sets these variables, and unsets all others that Mesa, EGL or NVIDIA's containers read.
void SetEnvironment(const Settings& settings);

// Writes a file that names a library to EGL, as vendors install it. Returns its whole path.
std::string WriteVendorFile(FakeTree& tree, const std::string& path, const std::string& library);
}

#endif
