// SPDX-License-Identifier: BSD-3-Clause
// The tests that an executable has: printed, or against CMake's list of them, because a test that no
// list names would never run, and nobody would miss it.
#ifndef vtkIndirectTestList_h
#define vtkIndirectTestList_h

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace vtkIndirectTest
{
/** Whether the program is asked for its list: `--list`, or `--check-list NAME...`. */
inline bool WantsList(int argc, char* argv[])
{
  const std::string word = argc > 1 ? argv[1] : "";
  return word == "--list" || word == "--check-list";
}

/**
 * tests: a map by name. Prints the names, one a line, or compares them: neither list may have a name
 * that the other lacks.
 */
template <typename Tests>
int List(const Tests& tests, int argc, char* argv[])
{
  if (std::string(argv[1]) == "--list")
  {
    for (const auto& test : tests)
    {
      std::cout << test.first << "\n";
    }
    return EXIT_SUCCESS;
  }
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
