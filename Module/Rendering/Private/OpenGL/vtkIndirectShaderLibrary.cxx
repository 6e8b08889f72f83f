// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectShaderLibrary.h"

#include "OpenGL/vtkIndirectShaderTable.h"
#include "vtkObject.h" // for the error macro

#include <algorithm>
#include <set>
#include <sstream>

namespace
{
const char* FindText(const std::string& fileName)
{
  for (const vtkIndirectShaderTableEntry* entry = vtkIndirectShaderTable; entry->Name; ++entry)
  {
    if (fileName == entry->Name)
    {
      return entry->Text;
    }
  }
  return nullptr;
}

bool Expand(const std::string& fileName, const std::string& gather, std::set<std::string>& seen,
  std::string& out)
{
  if (!seen.insert(fileName).second)
  {
    return true;
  }
  const char* text = FindText(fileName);
  if (!text)
  {
    vtkGenericWarningMacro("ERROR: shader file '" << fileName << "' is not embedded.");
    return false;
  }
  std::istringstream lines(text);
  std::string line;
  const std::string directive = "#include ";
  while (std::getline(lines, line))
  {
    if (line.compare(0, directive.size(), directive) != 0)
    {
      out += line + "\n";
      continue;
    }
    std::string name = line.substr(directive.size());
    name = name == "VTKI_GATHER" ? gather : name.substr(1, name.find_last_of('"') - 1);
    if (!Expand(name, gather, seen, out))
    {
      return false;
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
std::string vtkIndirectShaderLibrary::GetText(
  const std::string& fileName, const std::string& gather)
{
  std::set<std::string> seen;
  std::string out;
  return Expand(fileName, gather, seen, out) ? out : std::string();
}

//------------------------------------------------------------------------------
const char* const vtkIndirectShaderLibrary::Extensions =
  "#extension GL_ARB_shader_bit_encoding : enable\n";

//------------------------------------------------------------------------------
std::string vtkIndirectShaderLibrary::GetShader(
  const std::string& fileName, const std::string& definitions, const std::string& gather)
{
  std::string text = GetText(fileName, gather);
  const size_t begin = std::min(text.find('\n') + 1, text.size());
  if (definitions.compare(0, 8, "#version") != 0)
  {
    return text.insert(begin, Extensions + definitions);
  }
  const size_t line = definitions.find('\n') + 1;
  return text.replace(
    0, begin, definitions.substr(0, line) + Extensions + definitions.substr(line));
}

//------------------------------------------------------------------------------
std::string vtkIndirectShaderLibrary::GetHash()
{
  return vtkIndirectShaderTableHash;
}
