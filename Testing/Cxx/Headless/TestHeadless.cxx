// SPDX-License-Identifier: BSD-3-Clause
// Tests of vtkEGLHeadlessRenderWindow and vtkIndirectHeadlessFactory.
#include "HeadlessTestTools.h"

int main(int argc, char* argv[])
{
  return vtkIndirectTest::Main(argc, argv,
    [](const std::string& name)
    {
      // These tests expect that windows are not supported.
      if (name == "NoEGL" || name == "OldOpenGL" || name == "WrongDeviceOfEnvironment")
      {
        return;
      }
      vtkNew<vtkEGLHeadlessRenderWindow> window;
      if (!window->SupportsOpenGL())
      {
        vtkIndirectTest::Skip(window->GetOpenGLSupportMessage());
      }
    });
}
