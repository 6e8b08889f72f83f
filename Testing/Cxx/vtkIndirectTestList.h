// SPDX-License-Identifier: BSD-3-Clause
// CMake's list of tests against those that an executable has: a test that no list names would never
// run, and nobody would miss it.
#ifndef vtkIndirectTestList_h
#define vtkIndirectTestList_h

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace vtkIndirectTest
{
/** Whether the program is to compare lists: `--check-list NAME...`. */
inline bool WantsListCheck(int argc, char* argv[])
{
  return argc > 1 && std::string(argv[1]) == "--check-list";
}

/** tests: a map by name. Neither list may have a name that the other lacks. */
template <typename Tests>
int CheckList(const Tests& tests, int argc, char* argv[])
{
  const std::vector<std::string> listed(argv + 2, argv + argc);
  int missing = 0;
  for (const auto& test : tests)
  {
    if (std::find(listed.begin(), listed.end(), test.first) == listed.end())
    {
      std::cerr << test.first << " is not run\n";
      ++missing;
    }
  }
  for (const std::string& name : listed)
  {
    if (tests.find(name) == tests.end())
    {
      std::cerr << name << " is not there\n";
      ++missing;
    }
  }
  return missing ? EXIT_FAILURE : EXIT_SUCCESS;
}
}

#endif
