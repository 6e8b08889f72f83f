// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRChannel.h"

#include <algorithm>
#include <cstring>

namespace
{
//------------------------------------------------------------------------------
// R, G, B, Y, A come first, so that RGBA and luminance with alpha have their usual order; Y is
// between X and Z where a layer has these.
int GetRank(const std::string& name, bool coordinates)
{
  const char* order = coordinates ? "RGBA" : "RGBYA";
  const char* found = name.size() == 1 ? std::strchr(order, name[0]) : nullptr;
  return found ? static_cast<int>(found - order) : 5;
}

//------------------------------------------------------------------------------
std::vector<std::string> MakeNames(int components)
{
  switch (components)
  {
    case 1:
      return { "Y" };
    case 2:
      return { "Y", "A" };
    case 3:
      return { "R", "G", "B" };
    case 4:
      return { "R", "G", "B", "A" };
    default:
      break;
  }
  const std::size_t digits = std::to_string(components - 1).size();
  std::vector<std::string> names;
  for (int i = 0; i < components; ++i)
  {
    std::string number = std::to_string(i);
    names.push_back("C" + std::string(digits - number.size(), '0') + number);
  }
  return names;
}
}

//------------------------------------------------------------------------------
vtkOpenEXRChannel::vtkOpenEXRChannel(const std::string& fullName, bool subsampled)
  : FullName(fullName)
  , Subsampled(subsampled)
{
  const std::size_t dot = fullName.rfind('.');
  const bool named = dot != std::string::npos && dot > 0;
  this->Layer = named ? fullName.substr(0, dot) : std::string();
  this->Name = named ? fullName.substr(dot + 1) : fullName;
}

//------------------------------------------------------------------------------
void vtkOpenEXRChannel::Sort(std::vector<vtkOpenEXRChannel>& channels)
{
  const bool coordinates = std::any_of(
    channels.begin(), channels.end(), [](const vtkOpenEXRChannel& c) { return c.Name == "X"; });
  std::sort(channels.begin(), channels.end(),
    [coordinates](const vtkOpenEXRChannel& a, const vtkOpenEXRChannel& b)
    {
      const int rankA = GetRank(a.Name, coordinates);
      const int rankB = GetRank(b.Name, coordinates);
      return rankA != rankB ? rankA < rankB : a.Name < b.Name;
    });
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkOpenEXRChannel::MakeFullNames(const std::string& layer, int components)
{
  std::vector<std::string> names = MakeNames(components);
  for (std::string& name : names)
  {
    name = layer.empty() ? name : layer + "." + name;
  }
  return names;
}
