// SPDX-License-Identifier: BSD-3-Clause
#include "CardRun.h"

#include "CardPage.h"
#include "CardProcess.h"
#include "CardResults.h"

#include "vtkLogger.h"

#include <chrono>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <set>
#include <stdexcept>

using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;
namespace fs = std::filesystem;

namespace
{
// A unit that takes longer hangs.
constexpr double UnitSeconds = 150.0;
// Kept back for the page.
constexpr double LastSeconds = 5.0;

double GetSeconds(Clock::time_point since)
{
  return std::chrono::duration<double>(Clock::now() - since).count();
}

// VTK's first error of a unit.
std::string FirstError;
void KeepError(void*, const vtkLogger::Message& message)
{
  if (FirstError.empty())
  {
    FirstError = message.message;
  }
}

//------------------------------------------------------------------------------
// The part as it is after its process: a unit that was running has ended with it.
void Settle(const card::Options& options, const card::Part& part, const card::ProcessResult& result,
  bool timeIsUp)
{
  Json found = card::LoadPart(options.Output, part.Name);
  bool moved = false;
  for (auto& [name, unit] : found.at("units").items())
  {
    if (unit.at("status") == "running")
    {
      moved = true;
      if (timeIsUp)
      {
        unit["status"] = "not run";
        unit["why"] = "time ran out";
      }
      else
      {
        unit["status"] = "failed";
        unit["why"] = "it ended the program: " +
          (result.End.empty() ? "code " + std::to_string(result.Code) : result.End);
        std::cout << part.Name << " " << name << ": FAILED, " << unit["why"].get<std::string>()
                  << std::endl;
      }
    }
  }
  if (!moved && !timeIsUp && (!result.End.empty() || result.Code != 0))
  {
    // The process could not even begin.
    for (const std::string& unit : part.Units)
    {
      if (!card::IsDone(found, unit))
      {
        found["units"][unit] = { { "status", "failed" },
          { "why", result.End.empty() ? "the part could not begin" : result.End } };
      }
    }
  }
  card::SavePart(options.Output, part.Name, found);
}

//------------------------------------------------------------------------------
// Returns true if a unit is left to do; units that had no time earlier are left.
bool IsPending(const card::Options& options, const card::Part& part)
{
  Json found = card::LoadPart(options.Output, part.Name);
  for (const std::string& unit : part.Units)
  {
    if (!card::IsDone(found, unit))
    {
      return true;
    }
  }
  return false;
}

void ForgetWhatHadNoTime(const card::Options& options, const card::Part& part)
{
  Json found = card::LoadPart(options.Output, part.Name);
  Json kept = Json::object();
  for (const auto& [name, unit] : found.at("units").items())
  {
    if (unit.at("status") != "not run" && unit.at("status") != "running")
    {
      kept[name] = unit;
    }
  }
  found["units"] = kept;
  card::SavePart(options.Output, part.Name, found);
}

//------------------------------------------------------------------------------
void DoPart(const card::Options& options, const card::Part& part, Clock::time_point begin)
{
  ForgetWhatHadNoTime(options, part);
  while (IsPending(options, part))
  {
    const double left = options.Seconds - LastSeconds - GetSeconds(begin);
    if (left <= 0.0)
    {
      return;
    }
    std::vector<std::string> arguments = { options.Program, "part", "--pack", options.Pack,
      "--output", options.Output, "--seconds", std::to_string(left), part.Name };
    arguments.insert(arguments.end(), part.Units.begin(), part.Units.end());
    const fs::path progress = options.Output + "/parts/" + part.Name + ".json";
    const Clock::time_point started = Clock::now();
    bool timeIsUp = false;
    fs::file_time_type last = fs::last_write_time(progress);
    Clock::time_point changed = started;
    const card::ProcessResult result = card::RunProcess(arguments, "",
      [&]() -> std::string
      {
        std::error_code error;
        const fs::file_time_type now = fs::last_write_time(progress, error);
        if (!error && now != last)
        {
          last = now;
          changed = Clock::now();
        }
        timeIsUp = GetSeconds(started) > left;
        if (timeIsUp)
        {
          return "time ran out";
        }
        return GetSeconds(changed) > UnitSeconds
          ? "no end after " + std::to_string(static_cast<int>(UnitSeconds)) + " s"
          : "";
      });
    Settle(options, part, result, timeIsUp);
  }
}

//------------------------------------------------------------------------------
// Only what this program has written goes; the folder may be anybody's.
void ForgetAll(const card::Options& options)
{
  for (const char* name : { "parts", "logs", "pictures", "rows.csv", "page.md" })
  {
    fs::remove_all(options.Output + "/" + name);
  }
}

//------------------------------------------------------------------------------
// Names the system and the pack that the results are of, or null. Results of another OpenGL or
// another pack are not mixed with them.
Json GetContext(const card::Options& options)
{
  const Json found = card::LoadPart(options.Output, "opengl");
  const Json& units = found.at("units");
  return units.contains("context") && units.at("context").at("status") == "passed"
    ? units.at("context")
    : Json();
}

void FindContext(const card::Options& options, const card::Part& part, Clock::time_point begin)
{
  const Json before = GetContext(options);
  card::SavePart(options.Output, part.Name, { { "units", Json::object() } });
  DoPart(options, part, begin);
  const Json now = GetContext(options);
  for (const char* key : { "renderer", "version", "pack" })
  {
    if (!before.is_null() && !now.is_null() && before.value(key, "") != now.value(key, ""))
    {
      card::SavePart(options.Output, part.Name, { { "units", { { "context", before } } } });
      throw std::runtime_error(options.Output + " has results of \"" + before.value(key, "") +
        "\", and this is \"" + now.value(key, "") + "\": name another folder with --output, or " +
        "forget them with --fresh");
    }
  }
}
}

//------------------------------------------------------------------------------
int card::RunPart(const Options& options)
{
  const std::string name = options.Words.at(0);
  const std::set<std::string> wanted(options.Words.begin() + 1, options.Words.end());
  const Clock::time_point begin = Clock::now();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkLogger::AddCallback("card", KeepError, nullptr, vtkLogger::VERBOSITY_ERROR);
  for (const Part& part : MakeParts(options))
  {
    if (part.Name != name)
    {
      continue;
    }
    Json found = LoadPart(options.Output, name);
    for (const std::string& unit : part.Units)
    {
      if (!wanted.count(unit) || IsDone(found, unit) || GetSeconds(begin) > options.Seconds)
      {
        continue;
      }
      found["units"][unit] = { { "status", "running" } };
      SavePart(options.Output, name, found);
      const Clock::time_point started = Clock::now();
      Json result;
      FirstError.clear();
      try
      {
        result = part.Run(unit);
        if (!FirstError.empty())
        {
          result["status"] = "failed";
          result["why"] = FirstError;
        }
      }
      catch (const std::exception& error)
      {
        result = { { "status", "failed" },
          { "why", FirstError.empty() ? std::string(error.what()) : FirstError } };
      }
      result["seconds"] = GetSeconds(started);
      found["units"][unit] = result;
      SavePart(options.Output, name, found);
      std::cout << name << " " << unit << ": " << DescribeUnit(result) << std::endl;
    }
    return 0;
  }
  throw std::runtime_error("there is no part '" + name + "'");
}

//------------------------------------------------------------------------------
int card::Run(const Options& options)
{
  const Clock::time_point begin = Clock::now();
  if (options.Fresh)
  {
    ForgetAll(options);
  }
  fs::create_directories(options.Output + "/parts");
  const std::vector<Part> parts = MakeParts(options);
  const std::vector<Part> wanted = Choose(parts, options.Words);
  FindContext(options, parts.front(), begin);
  if (GetContext(options).is_null())
  {
    WritePage(options, parts, GetSeconds(begin));
    throw std::runtime_error("there is no OpenGL to measure");
  }
  for (const Part& part : wanted)
  {
    DoPart(options, part, begin);
  }
  return WritePage(options, parts, GetSeconds(begin));
}
