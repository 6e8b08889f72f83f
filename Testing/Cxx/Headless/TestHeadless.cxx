// SPDX-License-Identifier: BSD-3-Clause
// Tests of vtkEGLHeadlessRenderWindow and vtkIndirectHeadlessFactory: runs the one that is named.
#include "HeadlessTestTools.h"

#include <cstdlib>

using namespace headlesstest;

int main(int argc, char* argv[])
{
  TestMap tests = GetImageTests();
  tests.merge(GetContextTests());
  tests.merge(GetProgramTests());
  tests.merge(GetDriverTests());

  return RunNamedTest(tests, argc, argv,
    [](const std::string& name)
    {
      if (name != "NoEGL" && name != "OldOpenGL" && name != "WrongDeviceOfEnvironment" && !vtkEGLHeadlessRenderWindow::IsSupported())
      {
        vtkNew<vtkEGLHeadlessRenderWindow> window;
        window->SupportsOpenGL();
        std::cout << "SKIPPED: " << window->GetOpenGLSupportMessage() << "\n";
        std::exit(SkipReturnCode);
      }
    });
}
