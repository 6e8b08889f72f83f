// SPDX-License-Identifier: BSD-3-Clause
// Machines and drivers that are made up: a tree of files that stands for "/", and an environment.

#ifndef CardTestTools_h
#define CardTestTools_h

#include <map>
#include <string>

namespace headlesstest
{
// A tree of files in a temporary folder, which goes with the object.
class FakeTree
{
public:
  FakeTree();
  ~FakeTree();
  FakeTree(const FakeTree&) = delete;
  void operator=(const FakeTree&) = delete;

  const std::string& GetRoot() const { return this->Root; }

  // Paths begin with "/". Folders above are made too.
  FakeTree& File(const std::string& path, const std::string& content = "");
  FakeTree& Folder(const std::string& path);

  // What the kernel says of a render node, such as "renderD128", and its file in /dev/dri.
  FakeTree& KernelNode(const std::string& name, const std::string& driver);
  FakeTree& Node(const std::string& name, const std::string& driver);

private:
  std::string Root;
};

using Settings = std::map<std::string, std::string>;

// Sets these variables, and takes away all others that Mesa, EGL or NVIDIA's containers read.
void SetEnvironment(const Settings& settings);

// A file that names a library to EGL, as vendors install it. Returns its whole path.
std::string WriteVendorFile(FakeTree& tree, const std::string& path, const std::string& library);
}

#endif
