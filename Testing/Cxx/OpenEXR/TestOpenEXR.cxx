// SPDX-License-Identifier: BSD-3-Clause
// The program of the tests of VTK::IndirectOpenEXR: each test has its own folder, which is kept if
// the test fails.
#include "OpenEXRTestTools.h"

#include "vtkOutputWindow.h"

namespace
{
// Fails the test for all messages without an observer, such as the pipeline's.
class Window : public vtkOutputWindow
{
public:
  static Window* New();
  vtkTypeMacro(Window, vtkOutputWindow);

  void DisplayErrorText(const char* text) override
  {
    vtkIndirectTest::AddFailure();
    std::cerr << "FAILED " << text << "\n";
  }
  void DisplayWarningText(const char* text) override { this->DisplayErrorText(text); }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayText(const char* text) override { std::cerr << text << "\n"; }
};
vtkStandardNewMacro(Window);
}

int main(int argc, char* argv[])
{
  const int result = vtkIndirectTest::Main(argc, argv,
    [](const std::string&)
    {
      if (vtkIndirectTest::GetArguments().size() != 1)
      {
        vtkIndirectTest::Skip("the second argument must be a folder to write to");
      }
      vtkNew<Window> window;
      vtkOutputWindow::SetInstance(window);
      std::filesystem::remove_all(exrtest::GetFolder());
      std::filesystem::create_directories(exrtest::GetFolder());
    });
  vtkOutputWindow::SetInstance(nullptr);
  if (result == 0 && !vtkIndirectTest::GetArguments().empty() && argv[1][0] != '-')
  {
    std::filesystem::remove_all(exrtest::GetFolder());
  }
  return result;
}
