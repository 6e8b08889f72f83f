// SPDX-License-Identifier: BSD-3-Clause
// How VTK's getters ask maps: by an index that may be out of range, by a name that may be missing.
#ifndef vtkOpenEXRMaps_h
#define vtkOpenEXRMaps_h

#include <iterator> // for std::next
#include <map>      // for the maps
#include <string>   // for names

namespace vtkOpenEXRMaps
{
/** "" for an index out of range. */
template <typename Value>
std::string GetKey(const std::map<std::string, Value>& map, int index)
{
  const bool has = index >= 0 && index < static_cast<int>(map.size());
  return has ? std::next(map.begin(), index)->first : std::string();
}

/** An empty value for a name that the map does not have. */
template <typename Value>
Value GetValue(const std::map<std::string, Value>& map, const std::string& name)
{
  const auto found = map.find(name);
  return found == map.end() ? Value() : found->second;
}
}

#endif
