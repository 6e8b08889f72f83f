// SPDX-License-Identifier: BSD-3-Clause
// The settings of an object, in order, by the names of its properties. PrintSelf prints a list of
// the values that are set, and the report has one of the values in force.
#pragma once

#include "vtkIOStream.h" // for printing
#include "vtkIndent.h"   // for printing

#include <array>   // for vectors
#include <string>  // for names
#include <utility> // for pairs
#include <variant> // for values
#include <vector>  // for entries

class vtkIndirectSettingList
{
public:
  /** This is a value of an enumeration, as the end of a setter's name: `AllTexels` of
   * SetModeToAllTexels. */
  struct Choice
  {
    std::string Name;

    /** Returns the name as scripts write it: `all_texels`. */
    std::string GetScriptName() const;
  };
  using Value = std::variant<bool, int, double, std::string, Choice, std::array<int, 3>>;

  /** Adds a setting; the first of several settings with the same name stays. */
  vtkIndirectSettingList& Add(const std::string& name, const Value& value);
  /** Prints a line for each setting. */
  void Print(ostream& os, vtkIndent indent) const;
  const std::vector<std::pair<std::string, Value>>& GetEntries() const { return this->Entries; }

private:
  std::vector<std::pair<std::string, Value>> Entries;
};
