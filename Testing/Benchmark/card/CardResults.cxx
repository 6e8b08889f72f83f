// SPDX-License-Identifier: BSD-3-Clause
#include "CardResults.h"

#include <cstdio>
#include <fstream>
#include <stdexcept>

using Json = nlohmann::json;

namespace
{
std::string GetPath(const std::string& output, const std::string& part)
{
  return output + "/parts/" + part + ".json";
}
}

//------------------------------------------------------------------------------
Json card::LoadPart(const std::string& output, const std::string& part)
{
  std::ifstream file(GetPath(output, part));
  if (!file)
  {
    return { { "units", Json::object() } };
  }
  try
  {
    return Json::parse(file);
  }
  catch (const Json::exception& error)
  {
    throw std::runtime_error(GetPath(output, part) + ": " + error.what());
  }
}

//------------------------------------------------------------------------------
void card::WriteText(const std::string& path, const std::string& text)
{
  const std::string fresh = path + ".new";
  std::ofstream file(fresh, std::ios::binary);
  file << text;
  file.close();
  if (!file || std::rename(fresh.c_str(), path.c_str()) != 0)
  {
    throw std::runtime_error(path + " cannot be written");
  }
}

//------------------------------------------------------------------------------
void card::SavePart(const std::string& output, const std::string& part, const Json& values)
{
  // A driver's description of itself need not be UTF-8.
  const std::string text = values.dump(1, ' ', false, Json::error_handler_t::replace);
  WriteText(GetPath(output, part), text + "\n");
}

//------------------------------------------------------------------------------
bool card::IsDone(const Json& part, const std::string& unit)
{
  const Json& units = part.at("units");
  return units.contains(unit) && units.at(unit).at("status") != "running";
}
