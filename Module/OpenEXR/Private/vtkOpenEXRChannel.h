// SPDX-License-Identifier: BSD-3-Clause
// A channel: how its name is made of those of the layer and the component, and in which order the
// channels of a layer become components.
#ifndef vtkOpenEXRChannel_h
#define vtkOpenEXRChannel_h

#include <string> // for names
#include <vector> // for lists

struct vtkOpenEXRChannel
{
  std::string Layer;
  std::string Name;     // within the layer
  std::string FullName; // in the file
  bool Subsampled = false;

  vtkOpenEXRChannel(const std::string& fullName, bool subsampled);

  /** From the order in the file to that of the components. */
  static void Sort(std::vector<vtkOpenEXRChannel>& channels);

  /** The full names under which that many components of a layer are written. */
  static std::vector<std::string> MakeFullNames(const std::string& layer, int components);
};

#endif
