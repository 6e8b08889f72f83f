// SPDX-License-Identifier: BSD-3-Clause
// Drawing and reading back: colors, depths, sizes, samples.
#include "HeadlessTestTools.h"

#include "vtkCallbackCommand.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkProperty.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <cmath>
#include <sstream>

using namespace headlesstest;

namespace
{
//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Render)
{
  SceneWindow scene(Red);
  vtkEGLHeadlessRenderWindow* window = scene.Window;
  CHECK(window->GetGLVersion().empty(), window->GetGLVersion());
  CHECK(window->GetMultiSamples() == 0, window->GetMultiSamples());
  CHECK(window->GetNeverRendered(), "");
  window->Render();
  CHECK_IMAGE(window, Red);
  window->Render();
  CHECK_IMAGE(window, Red);

  int major = 0;
  int minor = 0;
  window->GetOpenGLVersion(major, minor);
  CHECK(10 * major + minor >= 32, major << "." << minor);
  CHECK(!window->GetGLVersion().empty(), "");
  CHECK(!window->GetGLRenderer().empty(), "");
  CHECK(!window->GetPlatformName().empty(), "");
  CHECK(window->GetLastErrorMessage().empty(), window->GetLastErrorMessage());
  CHECK(window->GetGenericContext() != nullptr, "");
  CHECK(window->GetGenericDisplayId() == nullptr, "");
  CHECK(window->SupportsOpenGL() == 1, "");
  CHECK(window->IsDirect() == 1, "");
  CHECK(window->IsCurrent(), "");
  CHECK(std::string(window->GetRenderingBackend()) == "OpenGL2", "");
  CHECK(window->GetAlphaBitPlanes() == 8, window->GetAlphaBitPlanes());

  // Always off screen.
  CHECK(window->GetOffScreenRendering() == 1, "");
  window->SetOffScreenRendering(0);
  CHECK(window->GetOffScreenRendering() == 1, "");
  CHECK(window->GetUseOffScreenBuffers(), "");
  window->Render();
  CHECK_IMAGE(window, Red);

  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->SetInputBufferTypeToRGBA();
  grab->Update();
  vtkImageData* image = grab->GetOutput();
  CHECK(image->GetScalarComponentAsDouble(0, 0, 0, 0) == 255, "");
  CHECK(image->GetScalarComponentAsDouble(63, 47, 0, 2) == 255, "");

  // The drawing follows the scene.
  scene.Actor->GetProperty()->SetColor(1, 1, 0);
  window->Render();
  CHECK_IMAGE(window, Yellow);

  vtkNew<vtkEGLHeadlessRenderWindow> unused;
  const std::string capabilities = unused->ReportCapabilities();
  CHECK(capabilities.find("OpenGL version string") != std::string::npos, capabilities);
  vtkNew<vtkEGLHeadlessRenderWindow> untouched;
  CHECK(untouched->SupportsOpenGL() == 1, untouched->GetOpenGLSupportMessage());
  CHECK(untouched->GetGenericContext() == nullptr, "");
  std::ostringstream print;
  window->Print(print);
  CHECK(print.str().find("GLVersion: " + window->GetGLVersion()) != std::string::npos, "");
  std::cout << window->GetGLVersion() << ", " << window->GetGLRenderer() << ", "
            << window->GetPlatformName() << "\n";
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Depth)
{
  SceneWindow scene(Red, 10, 8);
  scene.Window->Render();
  vtkNew<vtkFloatArray> depths;
  CHECK(scene.Window->GetZbufferData(0, 0, 9, 7, depths) == VTK_OK, "");
  CHECK(depths->GetNumberOfValues() == 80, depths->GetNumberOfValues());
  for (int i = 0; i < depths->GetNumberOfValues(); ++i)
  {
    const double expected = i % 10 < 5 ? 0.25 : 1.0;
    CHECK(std::fabs(depths->GetValue(i) - expected) < 1e-6, i << ": " << depths->GetValue(i));
  }
  float* one = scene.Window->GetZbufferData(2, 3, 2, 3);
  CHECK(std::fabs(*one - 0.25) < 1e-6, *one);
  delete[] one;
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(scene.Window);
  grab->SetInputBufferTypeToZBuffer();
  grab->Update();
  CHECK(std::fabs(grab->GetOutput()->GetScalarComponentAsDouble(0, 0, 0, 0) - 0.25) < 1e-6, "");
  CHECK(scene.Window->GetDepthBufferSize() >= 24, scene.Window->GetDepthBufferSize());
  CHECK_NO_GL_ERROR();
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Resize)
{
  SceneWindow scene(Red);
  int events = 0;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&events);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  scene.Window->AddObserver(vtkCommand::WindowResizeEvent, command);
  const int sizes[][2] = { { 211, 37 }, { 1, 1 }, { 640, 480 }, { 3, 500 }, { 64, 48 } };
  for (const auto& size : sizes)
  {
    scene.Window->SetSize(size[0], size[1]);
    scene.Window->Render();
    CHECK(scene.Window->GetActualSize()[0] == size[0], scene.Window->GetActualSize()[0]);
    CHECK(scene.Window->GetActualSize()[1] == size[1], scene.Window->GetActualSize()[1]);
    CHECK_IMAGE(scene.Window, Red);
  }
  CHECK(events == 5, events);

  Scene other(Green);
  vtkNew<vtkEGLHeadlessRenderWindow> window;
  window->AddRenderer(other.Renderer);
  window->Render();
  CHECK(window->GetSize()[0] == 300 && window->GetSize()[1] == 300, window->GetSize()[0]);
  CHECK_IMAGE(window, Green);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Shapes)
{
  const int sizes[][2] = { { 1, 1 }, { 1, 2000 }, { 2000, 1 }, { 7, 3 }, { 2, 2 } };
  for (const auto& size : sizes)
  {
    SceneWindow scene(Red, size[0], size[1]);
    scene.Window->Render();
    CHECK_IMAGE(scene.Window, Red);
    unsigned char* corner =
      scene.Window->GetPixelData(size[0] - 1, size[1] - 1, size[0] - 1, size[1] - 1, 1, 0);
    const Color actual = { corner[0], corner[1], corner[2] };
    CHECK(size[0] == 1 || actual == Blue, actual);
    delete[] corner;
    vtkNew<vtkFloatArray> depths;
    CHECK(scene.Window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depths) == VTK_OK, "");
    CHECK(depths->GetNumberOfValues() == size[0] * size[1], depths->GetNumberOfValues());
    vtkNew<vtkFloatArray> floats;
    CHECK(scene.Window->GetRGBAPixelData(0, 0, size[0] - 1, size[1] - 1, 1, floats) == VTK_OK, "");
    CHECK(floats->GetNumberOfValues() == 4 * size[0] * size[1], floats->GetNumberOfValues());
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Tiles)
{
  SceneWindow scene(Red, 40, 30);
  scene.Window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(scene.Window);
  grab->SetScale(3, 2);
  grab->Update();
  vtkImageData* image = grab->GetOutput();
  CHECK(image->GetDimensions()[0] == 120, image->GetDimensions()[0]);
  CHECK(image->GetDimensions()[1] == 60, image->GetDimensions()[1]);
  for (int y = 0; y < 60; ++y)
  {
    for (int x = 0; x < 120; ++x)
    {
      Color actual;
      for (int i = 0; i < 3; ++i)
      {
        actual[i] = static_cast<int>(image->GetScalarComponentAsDouble(x, y, 0, i));
      }
      CHECK(actual == (x < 60 ? Red : Blue), x << ", " << y << " " << actual);
    }
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(MultiSamples)
{
  SceneWindow scene(Red, 65, 49);
  scene.Window->SetMultiSamples(4);
  scene.Actor->RotateZ(10);
  // Even columns and rows away from the edge keep their color; the edge is mixed.
  int mixtures[2] = { 0, 0 };
  for (int i = 0; i < 2; ++i)
  {
    scene.Window->SetMultiSamples(i == 0 ? 4 : 0);
    scene.Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    CHECK(scene.Window->GetPixelData(0, 0, 64, 48, 1, pixels, 0) == VTK_OK, "");
    for (vtkIdType j = 0; j < pixels->GetNumberOfTuples(); ++j)
    {
      unsigned char rgb[3] = { 0, 0, 0 };
      pixels->GetTypedTuple(j, rgb);
      mixtures[i] += rgb[0] > 0 && rgb[2] > 0;
    }
    CHECK_NO_GL_ERROR();
  }
  CHECK(mixtures[0] >= 20, mixtures[0]);
  CHECK(mixtures[1] == 0, mixtures[1]);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Stencil)
{
  SceneWindow scene(Red);
  scene.Window->StencilCapableOn();
  scene.Window->Render();
  CHECK_IMAGE(scene.Window, Red);
  // VTK up to 9.1 makes the stencil buffer but does not attach it, in any window.
  vtkTextureObject* depth =
    scene.Window->GetRenderFramebuffer()->GetDepthAttachmentAsTextureObject();
  CHECK(depth != nullptr, "");
  scene.Window->MakeCurrent();
  glBindTexture(GL_TEXTURE_2D, depth->GetHandle());
  GLint size = 0;
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_STENCIL_SIZE, &size);
  glBindTexture(GL_TEXTURE_2D, 0);
  CHECK(size == 8, size);
  CHECK_NO_GL_ERROR();
}
}
