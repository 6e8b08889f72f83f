// SPDX-License-Identifier: BSD-3-Clause
// Differences between drivers: devices, limits and versions, and no driver at all.
#include "HeadlessTestTools.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>

using namespace headlesstest;

namespace
{
//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Devices)
{
  vtkNew<vtkEGLHeadlessRenderWindow> any;
  CHECK(any->GetDeviceIndex() == -1, any->GetDeviceIndex());
  // On a machine with a card that does not render, the first window reports it.
  any->Initialize();
  const int count = any->GetNumberOfDevices();
  std::cout << count << " EGL devices\n";
  int working = 0;
  for (int i = 0; i < count; ++i)
  {
    SceneWindow scene(Red);
    ErrorCounter errors(scene.Window);
    scene.Window->SetDeviceIndex(i);
    scene.Window->Render();
    if (errors.Count > 0)
    {
      // A device that this user cannot open.
      CHECK(errors.Count == 1, errors.Count);
      continue;
    }
    ++working;
    CHECK(scene.Window->GetPlatformName() == "EGL device " + std::to_string(i), "");
    std::cout << vtkEGLHeadlessRenderWindow::GetDeviceDescription(i) << ": "
              << scene.Window->GetGLRenderer() << "\n";
    CHECK_IMAGE(scene.Window, Red);
  }
  std::cout << working << " of them work\n";

  SceneWindow scene(Red);
  ErrorCounter errors(scene.Window);
  scene.Window->SetDeviceIndex(count + 7);
  scene.Window->Render();
  scene.Window->Render();
  CHECK(errors.Count == 1, errors.Count);
  CHECK(errors.Text.find("There is no EGL device") != std::string::npos, errors.Text);
  CHECK(scene.Window->SupportsOpenGL() == 0, "");
  // Another device gets a new attempt.
  scene.Window->SetDeviceIndex(-1);
  scene.Window->Render();
  CHECK(errors.Count == 1, errors.Count);
  CHECK_IMAGE(scene.Window, Red);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(TooLarge)
{
  SceneWindow scene(Red);
  scene.Window->Initialize();
  GLint maximum = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &maximum);
  ErrorCounter errors(scene.Window);
  scene.Window->SetSize(maximum + 1, 2);
  scene.Window->Render();
  CHECK(errors.Count == 1, errors.Count);
  CHECK(scene.Window->GetSize()[0] == maximum, scene.Window->GetSize()[0]);
  CHECK_IMAGE(scene.Window, Red);
}

//------------------------------------------------------------------------------
void CheckUnsupported(const std::string& reason)
{
  CHECK(!vtkEGLHeadlessRenderWindow::IsSupported(), "");
  SceneWindow scene(Red, 6, 5);
  ErrorCounter errors(scene.Window);
  scene.Window->Initialize();
  scene.Window->Render();
  scene.Window->Render();
  CHECK(errors.Count == 1, errors.Count);
  CHECK(errors.Text.find(reason) != std::string::npos, errors.Text);
  CHECK(errors.Text.find("Tried: ") != std::string::npos, errors.Text);
  // The remedy depends on the machine.
  CHECK(Has(errors.Text, "Install an EGL driver") || Has(errors.Text, "There is a graphics card: "),
    errors.Text);
  CHECK(!scene.Window->GetLastErrorMessage().empty(), "");
  CHECK(scene.Window->SupportsOpenGL() == 0, "");
  CHECK(!scene.Window->GetOpenGLSupportMessage().empty(), "");
  CHECK(scene.Window->ReportCapabilities() == scene.Window->GetLastErrorMessage(), "");
  CHECK(scene.Window->GetGLVersion().empty(), "");
  CHECK(scene.Window->GetGenericContext() == nullptr, "");
  CHECK(!scene.Window->IsCurrent(), "");
  scene.Window->MakeCurrent();
  scene.Window->ReleaseCurrent();
  scene.Window->WaitForCompletion();
  scene.Window->Frame();

  vtkNew<vtkUnsignedCharArray> pixels;
  CHECK(scene.Window->GetPixelData(0, 0, 5, 4, 1, pixels, 0) == VTK_ERROR, "");
  CHECK(pixels->GetValue(89) == 0, "");
  vtkNew<vtkFloatArray> depths;
  CHECK(scene.Window->GetZbufferData(0, 0, 5, 4, depths) == VTK_ERROR, "");
  CHECK(depths->GetNumberOfValues() == 30 && depths->GetValue(29) == 1.0f, "");
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(scene.Window);
  grab->SetInputBufferTypeToRGBA();
  grab->Update();
  CHECK(grab->GetOutput()->GetNumberOfPoints() == 30, grab->GetOutput()->GetNumberOfPoints());

  auto interactor =
    vtkSmartPointer<vtkRenderWindowInteractor>::Take(scene.Window->MakeRenderWindowInteractor());
  interactor->Initialize();
  interactor->Start();
  CHECK(errors.Count == 1, errors.Count);
  scene.Window->Finalize();
}

VTK_INDIRECT_TEST(NoEGL)
{
  CheckUnsupported("EGL default display (no EGL display)");
}

VTK_INDIRECT_TEST(OldOpenGL)
{
  if (vtkEGLHeadlessRenderWindow::IsSupported())
  {
    vtkIndirectTest::Skip("the driver does not heed MESA_GL_VERSION_OVERRIDE");
  }
  CheckUnsupported("no core profile of OpenGL 3.2 or later");
}

void CheckVersion(const std::string& expected)
{
  SceneWindow scene(Red);
  scene.Window->Render();
  const std::string version = scene.Window->GetGLVersion();
  if (version.find("Mesa") == std::string::npos)
  {
    vtkIndirectTest::Skip("the driver, " + version + ", does not heed MESA_GL_VERSION_OVERRIDE");
  }
  CHECK(version.compare(0, 3, expected) == 0, version);
  CHECK_IMAGE(scene.Window, Red);
}

VTK_INDIRECT_TEST(DeviceOfEnvironment)
{
  SceneWindow scene(Red);
  ErrorCounter errors(scene.Window);
  scene.Window->Render();
  if (scene.Window->GetNumberOfDevices() == 0)
  {
    vtkIndirectTest::Skip("EGL lists no device here");
  }
  CHECK(errors.Count == 0, errors.Text);
  CHECK(scene.Window->GetPlatformName() == "EGL device 0", scene.Window->GetPlatformName());
  CHECK_IMAGE(scene.Window, Red);
}

VTK_INDIRECT_TEST(WrongDeviceOfEnvironment)
{
  CHECK(!vtkEGLHeadlessRenderWindow::IsSupported(), "");
  SceneWindow scene(Red);
  ErrorCounter errors(scene.Window);
  scene.Window->Render();
  CHECK(errors.Count == 1, errors.Count);
  CHECK(errors.Text.find("VTK_INDIRECT_EGL_DEVICE is \"first\", which is no device's number") !=
      std::string::npos,
    errors.Text);
  const std::string message = scene.Window->GetLastErrorMessage();
  CHECK(message.find('\n') == std::string::npos, message);
  // The program's choice takes precedence.
  scene.Window->SetDeviceIndex(0);
  scene.Window->Render();
  CHECK(errors.Text.find("first", errors.Text.find("first") + 1) == std::string::npos, errors.Text);
}

VTK_INDIRECT_TEST(OpenGL32)
{
  CheckVersion("3.2");
}

VTK_INDIRECT_TEST(OpenGL41)
{
  CheckVersion("4.1");
}
}
