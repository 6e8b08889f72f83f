// SPDX-License-Identifier: BSD-3-Clause
// The harness of all C++ tests. A program contains tests that register themselves and runs the test
// of its first argument, in a process of its own:
//
//     PROGRAM TEST [ARGUMENT...]   0 passed, 1 failed or unknown, 125 skipped
//     PROGRAM --list               the names, one a line
//     PROGRAM --compare NAME...    0 if these are the names
//
// CMake finds the tests in the sources by their macro (vtkIndirectTests.cmake): no list is kept by
// hand.
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
/** Called by the checks of each kind of test; a test without any check fails. */
void AddFailure();
void AddCheck();
int GetNumberOfFailures();
///@}

/** Ends the test as skipped, with its reason. */
[[noreturn]] void Skip(const std::string& reason);

/** Arguments of the program after the test's name. */
const std::vector<std::string>& GetArguments();

/** Runs the test or the option of the arguments; `prepare` is called before it with the test's
 * name. */
int Main(int argc, char* argv[], void (*prepare)(const std::string& name) = nullptr);
}

/** Defines a test. */
#define VTK_INDIRECT_TEST(name)                                                                    \
  static void Test##name();                                                                        \
  static const vtkIndirectTest::Registration Register##name(#name, Test##name);                    \
  static void Test##name()

#endif
