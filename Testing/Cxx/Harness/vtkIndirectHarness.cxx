// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectHarness.h"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>

namespace vtkIndirectTest
{
namespace
{
constexpr int SkipReturnCode = 125;
int Failures = 0;
int Checks = 0;
std::vector<std::string> Arguments;

struct Skipped
{
  std::string Reason;
};

// Filled by the tests' registrations before main.
std::map<std::string, void (*)()>& Table()
{
  static std::map<std::string, void (*)()> table;
  return table;
}

// Compares the arguments with the compiled tests: CMake must have found the same names.
int Compare()
{
  std::set<std::string> found(Arguments.begin(), Arguments.end());
  int missing = 0;
  for (const auto& known : Table())
  {
    if (found.erase(known.first) == 0)
    {
      std::printf("FAILED %s was not found in the sources\n", known.first.c_str());
      ++missing;
    }
  }
  for (const std::string& name : found)
  {
    std::printf("FAILED %s was not compiled\n", name.c_str());
    ++missing;
  }
  return missing == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
}

//------------------------------------------------------------------------------
Registration::Registration(const char* name, void (*function)())
{
  if (!Table().emplace(name, function).second)
  {
    std::printf("FAILED two tests are called %s\n", name);
    std::abort();
  }
}

//------------------------------------------------------------------------------
void AddFailure()
{
  ++Failures;
}

//------------------------------------------------------------------------------
void AddCheck()
{
  ++Checks;
}

//------------------------------------------------------------------------------
int GetNumberOfFailures()
{
  return Failures;
}

//------------------------------------------------------------------------------
void Skip(const std::string& reason)
{
  throw Skipped{ reason };
}

//------------------------------------------------------------------------------
const std::vector<std::string>& GetArguments()
{
  return Arguments;
}

//------------------------------------------------------------------------------
int Main(int argc, char* argv[], void (*prepare)(const std::string& name))
{
  const std::string name = argc > 1 ? argv[1] : "";
  if (argc > 1)
  {
    Arguments.assign(argv + 2, argv + argc);
  }
  if (name == "--compare")
  {
    return Compare();
  }
  const auto test = Table().find(name);
  if (name == "--list" || test == Table().end())
  {
    const bool asked = name == "--list";
    if (!asked)
    {
      std::printf("FAILED no test is called \"%s\"; known are\n", name.c_str());
    }
    for (const auto& known : Table())
    {
      std::printf("%s\n", known.first.c_str());
    }
    return asked ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  std::string skipped;
  try
  {
    if (prepare)
    {
      prepare(name);
    }
    test->second();
  }
  catch (const Skipped& why)
  {
    skipped = why.Reason;
  }
  if (!skipped.empty())
  {
    std::printf("%s %s: %s\n", Failures ? "FAILED" : "SKIPPED", name.c_str(), skipped.c_str());
    return Failures ? EXIT_FAILURE : SkipReturnCode;
  }
  if (Checks == 0)
  {
    std::printf("FAILED %s checked nothing\n", name.c_str());
    return EXIT_FAILURE;
  }
  std::printf("%s: %d of %d checks failed\n", name.c_str(), Failures, Checks);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
}
