// SPDX-License-Identifier: BSD-3-Clause
#include "CardParts.h"

#include "CardOpenGL.h"
#include "CardSceneParts.h"
#include "CardTestParts.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <stdexcept>

//------------------------------------------------------------------------------
std::vector<card::Part> card::MakeParts(const Options& options)
{
  std::vector<Part> parts = { MakeOpenGLPart(options) };
  auto add = [&](std::vector<Part> more)
  { std::move(more.begin(), more.end(), std::back_inserter(parts)); };
  add(MakeTestParts(options, { { "parity", "IndirectShaderTests" } }));
  add(MakeSceneParts(options, true));
  parts.push_back(MakePathsPart(options));
  add(MakeTestParts(options, { { "contract", "TestPassContract" } }));
  add(MakeSceneParts(options, false));
  add(MakeTestParts(options,
    { { "radiometry", "IndirectRadiometryTests" }, { "convergence", "IndirectConvergenceTests" },
      { "multiresolution", "IndirectMultiresolutionTests" }, { "glossy", "IndirectGlossyTests" },
      { "hard-cases", "IndirectHardCaseTests" } }));
  return parts;
}

//------------------------------------------------------------------------------
std::vector<card::Part> card::Choose(
  const std::vector<Part>& parts, const std::vector<std::string>& words)
{
  if (words.empty())
  {
    return parts;
  }
  std::vector<std::set<std::string>> chosen(parts.size());
  std::string names;
  for (const card::Part& part : parts)
  {
    names += (names.empty() ? "" : ", ") + part.Name;
  }
  for (const std::string& word : words)
  {
    const size_t colon = word.find(':');
    const std::string name = word.substr(0, colon);
    bool found = false;
    for (size_t i = 0; i < parts.size(); ++i)
    {
      const card::Part& part = parts[i];
      if (part.Name != name && part.Name.compare(0, name.size() + 1, name + "-") != 0)
      {
        continue;
      }
      for (const std::string& unit : part.Units)
      {
        if (colon == std::string::npos || unit == word.substr(colon + 1))
        {
          chosen[i].insert(unit);
          found = true;
        }
      }
    }
    if (!found)
    {
      throw std::runtime_error(
        "there is no part '" + word + "', but " + names + "; a unit of a part is PART:UNIT");
    }
  }
  std::vector<card::Part> wanted;
  for (size_t i = 0; i < parts.size(); ++i)
  {
    card::Part part = parts[i];
    part.Units.clear();
    for (const std::string& unit : parts[i].Units)
    {
      if (chosen[i].count(unit))
      {
        part.Units.push_back(unit);
      }
    }
    if (!part.Units.empty())
    {
      wanted.push_back(part);
    }
  }
  return wanted;
}
