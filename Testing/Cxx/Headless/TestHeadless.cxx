// SPDX-License-Identifier: BSD-3-Clause
// Tests of vtkEGLHeadlessRenderWindow and vtkIndirectHeadlessFactory: runs the one that is named.
#include "../vtkIndirectTestList.h"
#include "HeadlessTestTools.h"

#include <cstdlib>

using namespace headlesstest;

int main(int argc, char* argv[])
{
  TestMap tests = GetImageTests();
  tests.merge(GetContextTests());
  tests.merge(GetProgramTests());
  tests.merge(GetDriverTests());

  if (vtkIndirectTest::WantsListCheck(argc, argv))
  {
    return vtkIndirectTest::CheckList(tests, argc, argv);
  }
  const std::string name = argc > 1 ? argv[1] : "";
  const auto test = tests.find(name);
  if (test == tests.end())
  {
    std::cerr << "No test is called \"" << name << "\".\n";
    return EXIT_FAILURE;
  }
  if (name != "NoEGL" && name != "OldOpenGL" && !vtkEGLHeadlessRenderWindow::IsSupported())
  {
    vtkNew<vtkEGLHeadlessRenderWindow> window;
    window->SupportsOpenGL();
    std::cout << "SKIPPED: " << window->GetOpenGLSupportMessage() << "\n";
    return SkipReturnCode;
  }
  test->second();
  if (Failures == 0)
  {
    std::cout << name << ": passed\n";
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
