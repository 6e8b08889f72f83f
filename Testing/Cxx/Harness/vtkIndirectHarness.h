// SPDX-License-Identifier: BSD-3-Clause
// The harness of all C++ tests. A program holds tests that register themselves and runs the one
// that its first argument names, in a process of its own:
//
//   PROGRAM TEST [ARGUMENT...]   0 passed, 1 failed or unknown, 125 skipped
//   PROGRAM --list               the names, one a line
//   PROGRAM --compare NAME...    0 where these are the names
//
// CMake finds them in the sources by their macro (vtkIndirectTests.cmake): no list is kept by hand.
#ifndef vtkIndirectHarness_h
#define vtkIndirectHarness_h

#include <string> // for names
#include <vector> // for arguments

namespace vtkIndirectTest
{
struct Registration
{
  Registration(const char* name, void (*function)());
};

///@{
/** Counted by the checks of each kind of test; a test that checks nothing may say so and fails. */
void AddFailure();
void AddCheck();
int GetNumberOfFailures();
///@}

/** Ends the test as skipped, with its reason. */
[[noreturn]] void Skip(const std::string& reason);

/** Of the program, behind the test's name. */
const std::vector<std::string>& GetArguments();

/** Runs what the arguments ask for; `prepare` is called with the test's name before it. */
int Main(int argc, char* argv[], void (*prepare)(const std::string& name) = nullptr);
}

/** Defines a test. */
#define VTK_INDIRECT_TEST(name)                                                                    \
  static void Test##name();                                                                        \
  static const vtkIndirectTest::Registration Register##name(#name, Test##name);                    \
  static void Test##name()

#endif
