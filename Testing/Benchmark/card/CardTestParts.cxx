// SPDX-License-Identifier: BSD-3-Clause
#include "CardTestParts.h"

#include "CardProcess.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>

using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace
{
constexpr int SkipReturnCode = 125;
// Output that ctest takes for a failure, too.
const char* const FailureSigns[] = { "ERR|", "ERROR: ", "still around" };
constexpr double TestSeconds = 100.0;

//------------------------------------------------------------------------------
std::string Watch(std::chrono::steady_clock::time_point begin)
{
  const double seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return seconds > TestSeconds
    ? "longer than " + std::to_string(static_cast<int>(TestSeconds)) + " s"
    : "";
}

//------------------------------------------------------------------------------
std::vector<std::string> ListTests(const card::Options& options, const std::string& program)
{
  fs::create_directories(options.Output + "/logs");
  const std::string log =
    options.Output + "/logs/" + fs::path(program).filename().string() + ".list";
  // Every process asks; the first answer holds.
  if (!fs::exists(log) || fs::last_write_time(log) < fs::last_write_time(program))
  {
    const auto begin = std::chrono::steady_clock::now();
    const card::ProcessResult result =
      card::RunProcess({ program, "--list" }, log + ".new", [&]() { return Watch(begin); });
    if (!result.End.empty() || result.Code != 0)
    {
      throw std::runtime_error(program + " does not list its tests: " + result.End + " " +
        card::ReadTail(log + ".new", 1));
    }
    fs::rename(log + ".new", log);
  }
  std::vector<std::string> names;
  std::ifstream file(log);
  for (std::string line; std::getline(file, line);)
  {
    names.push_back(line);
  }
  return names;
}

//------------------------------------------------------------------------------
Json RunTest(const card::Options& options, const std::string& program, const std::string& part,
  const std::string& test)
{
  const std::string log = options.Output + "/logs/" + part + "-" + test + ".txt";
  const auto begin = std::chrono::steady_clock::now();
  const card::ProcessResult result =
    card::RunProcess({ program, test }, log, [&]() { return Watch(begin); });
  const std::string said = card::ReadTail(log, 1000000);
  std::string sign;
  for (const char* text : FailureSigns)
  {
    sign = said.find(text) == std::string::npos ? sign : text;
  }
  Json unit = { { "status", "passed" } };
  if (result.End.empty() && result.Code == SkipReturnCode)
  {
    unit["status"] = "skipped";
    unit["why"] = card::ReadTail(log, 1);
  }
  else if (!result.End.empty() || result.Code != 0 || !sign.empty())
  {
    unit["status"] = "failed";
    unit["why"] = !result.End.empty() ? result.End
      : result.Code != 0              ? "it returned " + std::to_string(result.Code)
                                      : "it printed '" + sign + "'";
    unit["said"] = card::ReadTail(log, 12);
  }
  if (unit["status"] == "passed")
  {
    fs::remove(log);
  }
  return unit;
}

}

//------------------------------------------------------------------------------
std::vector<card::Part> card::MakeTestParts(
  const Options& options, const std::vector<std::pair<std::string, std::string>>& programs)
{
  std::vector<Part> parts;
  for (const auto& row : programs)
  {
    const std::string name = row.first;
    const std::string program = options.Pack + "/bin/" + row.second;
    if (fs::exists(program))
    {
      parts.push_back({ name, ListTests(options, program),
        [&options, name, program](const std::string& test)
        { return RunTest(options, program, name, test); } });
    }
  }
  return parts;
}
