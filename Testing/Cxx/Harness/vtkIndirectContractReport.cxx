// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectContractReport.h"

#include "vtkIndirectContractUtilities.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <locale>
#include <sstream>

namespace contract
{
namespace
{
// Collects every value by its path.
void Collect(
  const nlohmann::json& value, const std::string& path, std::map<std::string, std::string>& values)
{
  values[path] = value.is_structured() ? std::to_string(value.size())
    : value.is_string()                ? value.get<std::string>()
                                       : value.dump();
  if (!value.is_structured())
  {
    return;
  }
  for (const auto& member : value.items())
  {
    Collect(member.value(), (path.empty() ? "" : path + ".") + member.key(), values);
  }
}
}

//------------------------------------------------------------------------------
Report::Report(const std::string& text)
  : Text(text)
{
  // Bytes that are not UTF-8 are refused, too.
  const nlohmann::json value = nlohmann::json::parse(text, nullptr, false);
  this->Valid = !value.is_discarded();
  if (this->Valid)
  {
    Collect(value, "", this->Values);
  }
}

//------------------------------------------------------------------------------
Report::Report(vtkIndirectIlluminationPass* pass)
  : Report(pass->GetReport(false))
{
  CONTRACT_CHECK(this->Valid, "no valid JSON: " << this->Text);
  for (const char* key : { "schema", "scene", "size", "method", "settings", "frames", "stages",
         "indirect_ms", "frame_ms", "virtual_lights", "bytes", "estimated_error", "modelled",
         "left_out", "gl", "vtk", "version", "shader_hash" })
  {
    CONTRACT_CHECK(this->Has(key), "the report has no " << key);
  }
  CONTRACT_CHECK(this->Get("schema") == "vtkindirect.report/1", "schema");
}

//------------------------------------------------------------------------------
std::string Report::Get(const std::string& path) const
{
  const auto found = this->Values.find(path);
  return found != this->Values.end() ? found->second : std::string();
}

//------------------------------------------------------------------------------
double Report::GetNumber(const std::string& path) const
{
  std::istringstream text(this->Get(path));
  text.imbue(std::locale::classic());
  double value = NAN;
  text >> value;
  return text && text.eof() ? value : NAN;
}

//------------------------------------------------------------------------------
std::string Report::FindReason(const std::string& list, const std::string& what) const
{
  for (int i = 0; this->Has(list + "." + std::to_string(i)); ++i)
  {
    const std::string entry = list + "." + std::to_string(i);
    const std::string name = this->Get(entry + ".what");
    if (name == what || (name.compare(0, what.size() + 2, what + " (") == 0 && name.back() == ')'))
    {
      return this->Get(entry + ".why");
    }
  }
  return {};
}

//------------------------------------------------------------------------------
long long CountOf(vtkIndirectIlluminationPass* pass, const std::string& counter)
{
  return static_cast<long long>(Report(pass).GetNumber("counters." + counter));
}
}
