// SPDX-License-Identifier: BSD-3-Clause
#include "Plan/vtkIndirectSettingList.h"

#include <algorithm>
#include <cctype>

namespace
{
struct Printer
{
  ostream& OS;

  void operator()(bool on) const { this->OS << (on ? "On" : "Off"); }
  void operator()(int number) const { this->OS << number; }
  void operator()(double number) const { this->OS << number; }
  void operator()(const std::string& text) const { this->OS << '"' << text << '"'; }
  void operator()(const vtkIndirectSettingList::Choice& choice) const { this->OS << choice.Name; }
  void operator()(const std::array<int, 3>& numbers) const
  {
    this->OS << numbers[0] << ' ' << numbers[1] << ' ' << numbers[2];
  }
};
}

//------------------------------------------------------------------------------
std::string vtkIndirectSettingList::Choice::GetScriptName() const
{
  std::string script;
  for (const char letter : this->Name)
  {
    const auto code = static_cast<unsigned char>(letter);
    script += std::isupper(code) && !script.empty() ? "_" : "";
    script += static_cast<char>(std::tolower(code));
  }
  return script;
}

//------------------------------------------------------------------------------
vtkIndirectSettingList& vtkIndirectSettingList::Add(const std::string& name, const Value& value)
{
  if (std::none_of(this->Entries.begin(), this->Entries.end(),
        [&](const auto& entry) { return entry.first == name; }))
  {
    this->Entries.emplace_back(name, value);
  }
  return *this;
}

//------------------------------------------------------------------------------
void vtkIndirectSettingList::Print(ostream& os, vtkIndent indent) const
{
  for (const auto& entry : this->Entries)
  {
    os << indent << entry.first << ": ";
    std::visit(Printer{ os }, entry.second);
    os << "\n";
  }
}
