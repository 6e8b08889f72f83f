// SPDX-License-Identifier: BSD-3-Clause
// Tests of vtkEGLHeadlessRenderWindow and vtkIndirectHeadlessFactory, one for each name in the
// table at the end.
#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkIndirectHeadlessFactory.h"

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLState.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTestingObjectFactory.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace
{
constexpr int SkipReturnCode = 125;
int Failures = 0;

#define CHECK(condition, ...)                                                                      \
  do                                                                                               \
  {                                                                                                \
    if (!(condition))                                                                              \
    {                                                                                              \
      std::cerr << "FAILED line " << __LINE__ << ": " #condition " " << __VA_ARGS__ << "\n";       \
      ++Failures;                                                                                  \
    }                                                                                              \
  } while (false)

using Color = std::array<int, 3>;
const Color Red = { 255, 0, 0 };
const Color Green = { 0, 255, 0 };
const Color Blue = { 0, 0, 255 };
const Color Yellow = { 255, 255, 0 };
const Color Black = { 0, 0, 0 };

std::ostream& operator<<(std::ostream& os, const Color& color)
{
  return os << "(" << color[0] << ", " << color[1] << ", " << color[2] << ")";
}

// An unlit square of the given color that fills the left half of the window, 2 in front of the
// camera, between clipping planes at 1 and 5. The background is blue.
struct Scene
{
  vtkNew<vtkPlaneSource> Plane;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;

  explicit Scene(const Color& color)
  {
    this->Plane->SetOrigin(-1e4, -1e4, 0);
    this->Plane->SetPoint1(0, -1e4, 0);
    this->Plane->SetPoint2(-1e4, 1e4, 0);
    this->Mapper->SetInputConnection(this->Plane->GetOutputPort());
    this->Actor->SetMapper(this->Mapper);
    this->Actor->GetProperty()->LightingOff();
    this->Actor->GetProperty()->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(0, 0, 1);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0, 0, 2);
    camera->SetFocalPoint(0, 0, 0);
    camera->ParallelProjectionOn();
    camera->SetClippingRange(1, 5);
  }
};

struct SceneWindow : Scene
{
  vtkSmartPointer<vtkEGLHeadlessRenderWindow> Window =
    vtkSmartPointer<vtkEGLHeadlessRenderWindow>::New();

  explicit SceneWindow(const Color& color, int width = 64, int height = 48)
    : Scene(color)
  {
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
  }
};

void CheckNoGLError(int line)
{
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR)
  {
    std::cerr << "FAILED line " << line << ": OpenGL error 0x" << std::hex << error << std::dec
              << "\n";
    ++Failures;
  }
}

// All pixels: left half in the given color, right half blue, in both buffers.
void CheckImage(vtkRenderWindow* window, const Color& color, int line, bool checkFront = true)
{
  const int width = window->GetSize()[0];
  const int height = window->GetSize()[1];
  for (int front = 0; front < (checkFront ? 2 : 1); ++front)
  {
    vtkNew<vtkUnsignedCharArray> pixels;
    if (window->GetPixelData(0, 0, width - 1, height - 1, front, pixels, 0) != VTK_OK)
    {
      std::cerr << "FAILED line " << line << ": no pixels\n";
      ++Failures;
      return;
    }
    if (pixels->GetNumberOfTuples() != static_cast<vtkIdType>(width) * height)
    {
      std::cerr << "FAILED line " << line << ": " << pixels->GetNumberOfTuples() << " pixels\n";
      ++Failures;
      return;
    }
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        if (2 * x + 1 == width)
        {
          continue;
        }
        unsigned char rgb[3] = { 0, 0, 0 };
        pixels->GetTypedTuple(static_cast<vtkIdType>(y) * width + x, rgb);
        const Color actual = { rgb[0], rgb[1], rgb[2] };
        const Color expected = 2 * x + 1 < width ? color : Blue;
        if (actual != expected)
        {
          std::cerr << "FAILED line " << line << ": pixel " << x << ", " << y << " of " << width
                    << " x " << height << " is " << actual << ", not " << expected << "\n";
          ++Failures;
          return;
        }
      }
    }
  }
  CheckNoGLError(line);
}

#define CHECK_IMAGE(window, color) CheckImage(window, color, __LINE__)

// Counts errors, which are then not printed, and keeps the last text.
struct ErrorCounter
{
  int Count = 0;
  std::string Text;
  vtkNew<vtkCallbackCommand> Command;

  explicit ErrorCounter(vtkObject* object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void* text)
      {
        auto counter = static_cast<ErrorCounter*>(self);
        ++counter->Count;
        counter->Text = static_cast<const char*>(text);
        // Without the word that makes a test fail.
        const size_t start = counter->Text.find("): ");
        std::cout << "expected: "
                  << counter->Text.substr(start == std::string::npos ? 0 : start + 3) << "\n";
      });
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
    object->AddObserver(vtkCommand::WarningEvent, this->Command);
  }
};

//------------------------------------------------------------------------------
void Render()
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

  // What is drawn follows the scene.
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
void Depth()
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
  CheckNoGLError(__LINE__);
}

//------------------------------------------------------------------------------
void Resize()
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
void Shapes()
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
void Tiles()
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
void MultiSamples()
{
  SceneWindow scene(Red, 65, 49);
  scene.Window->SetMultiSamples(4);
  scene.Actor->RotateZ(10);
  // Even columns and rows away from the edge keep their color; the edge gets mixtures.
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
    CheckNoGLError(__LINE__);
  }
  CHECK(mixtures[0] >= 20, mixtures[0]);
  CHECK(mixtures[1] == 0, mixtures[1]);
}

//------------------------------------------------------------------------------
void Stencil()
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
  CheckNoGLError(__LINE__);
}

//------------------------------------------------------------------------------
void TwoWindows()
{
  SceneWindow first(Red, 64, 48);
  SceneWindow second(Green, 31, 77);
  for (int i = 0; i < 4; ++i)
  {
    first.Window->Render();
    CHECK(first.Window->IsCurrent(), "");
    second.Window->Render();
    CHECK(second.Window->IsCurrent() && !first.Window->IsCurrent(), "");
    // Reading makes the window that is read current.
    CHECK_IMAGE(first.Window, Red);
    CHECK_IMAGE(second.Window, Green);
    first.Window->SetSize(64 + i, 48);
    second.Window->SetSize(31, 77 - i);
  }
  CHECK(first.Window->GetGenericContext() != second.Window->GetGenericContext(), "");

  // The end of one leaves the other current and usable.
  first.Window->Render();
  second.Window->Finalize();
  CHECK(first.Window->IsCurrent(), "");
  first.Window->Render();
  CHECK_IMAGE(first.Window, Red);
  second.Window->Render();
  CHECK_IMAGE(second.Window, Green);

  second.Window->MakeCurrent();
  first.Window->PushContext();
  CHECK(first.Window->IsCurrent(), "");
  first.Window->PopContext();
  CHECK(second.Window->IsCurrent(), "");
  second.Window->ReleaseCurrent();
  CHECK(!second.Window->IsCurrent() && !first.Window->IsCurrent(), "");
  first.Window->Render();
  CHECK_IMAGE(first.Window, Red);
}

//------------------------------------------------------------------------------
// A framebuffer of one window keeps its content while the other one is drawn.
void Framebuffers()
{
  SceneWindow first(Red);
  SceneWindow second(Green);
  first.Window->Render();
  second.Window->Render();

  vtkNew<vtkOpenGLFramebufferObject> framebuffers[2];
  vtkEGLHeadlessRenderWindow* windows[2] = { first.Window, second.Window };
  for (int i = 0; i < 2; ++i)
  {
    windows[i]->MakeCurrent();
    vtkOpenGLState* state = windows[i]->GetState();
    state->PushFramebufferBindings();
    framebuffers[i]->SetContext(windows[i]);
    framebuffers[i]->PopulateFramebuffer(16, 16, true, 1, VTK_FLOAT, true, 32, 0);
    framebuffers[i]->Bind();
    framebuffers[i]->ActivateDrawBuffer(0);
    CHECK(framebuffers[i]->CheckFrameBufferStatus(GL_FRAMEBUFFER), "");
    state->vtkglViewport(0, 0, 16, 16);
    state->vtkglScissor(0, 0, 16, 16);
    state->vtkglClearColor(0.25f + 0.5f * i, 1e-9f, 1e9f, 1.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    state->PopFramebufferBindings();
    CheckNoGLError(__LINE__);
  }
  for (int i = 0; i < 2; ++i)
  {
    windows[i]->Render();
    CHECK_IMAGE(windows[i], i == 0 ? Red : Green);
  }
  for (int i = 0; i < 2; ++i)
  {
    windows[i]->MakeCurrent();
    vtkOpenGLState* state = windows[i]->GetState();
    state->PushFramebufferBindings();
    framebuffers[i]->Bind();
    framebuffers[i]->ActivateReadBuffer(0);
    float rgba[4] = { 0, 0, 0, 0 };
    glReadPixels(8, 8, 1, 1, GL_RGBA, GL_FLOAT, rgba);
    CHECK(rgba[0] == 0.25f + 0.5f * i && rgba[1] == 1e-9f && rgba[2] == 1e9f, rgba[0]);
    state->PopFramebufferBindings();
    CheckNoGLError(__LINE__);
  }
  // Released with the window or before it.
  framebuffers[0]->ReleaseGraphicsResources(first.Window);
}

//------------------------------------------------------------------------------
int CountOpenFiles()
{
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
  {
    (void)entry;
    ++count;
  }
  return count;
}

long GetResidentKilobytes()
{
  long pages = 0;
  long resident = 0;
  FILE* file = std::fopen("/proc/self/statm", "r");
  if (file)
  {
    if (std::fscanf(file, "%ld %ld", &pages, &resident) != 2)
    {
      resident = 0;
    }
    std::fclose(file);
  }
  return resident * 4;
}

void Recreate()
{
  SceneWindow scene(Red);
  int files = 0;
  long memory = 0;
  for (int i = 0; i < 25; ++i)
  {
    scene.Window->Render();
    CHECK_IMAGE(scene.Window, Red);
    scene.Window->Finalize();
    CHECK(scene.Window->GetGenericContext() == nullptr, "");
    CHECK(scene.Window->GetGLVersion().empty(), scene.Window->GetGLVersion());
    if (i == 4)
    {
      files = CountOpenFiles();
      memory = GetResidentKilobytes();
    }
  }
  CHECK(CountOpenFiles() == files, CountOpenFiles() << " instead of " << files);
  std::cout << "grown by " << GetResidentKilobytes() - memory << " KiB in 20 cycles\n";

  // Twice, and before a first render.
  scene.Window->Finalize();
  vtkNew<vtkEGLHeadlessRenderWindow> unused;
  unused->Finalize();

  for (int i = 0; i < 20; ++i)
  {
    SceneWindow other(Green);
    other.Window->Render();
    CHECK_IMAGE(other.Window, Green);
  }
  CHECK(CountOpenFiles() == files, CountOpenFiles() << " instead of " << files);

  // Graphics resources alone.
  scene.Window->Render();
  scene.Window->ReleaseGraphicsResources(scene.Window);
  scene.Window->Render();
  CHECK_IMAGE(scene.Window, Red);
}

//------------------------------------------------------------------------------
void DestructionOrder()
{
  // The window before its renderer, which goes on in another window.
  {
    SceneWindow scene(Red);
    scene.Window->Render();
    scene.Window = nullptr;
    CHECK(scene.Renderer->GetRenderWindow() == nullptr, "");
    vtkNew<vtkEGLHeadlessRenderWindow> window;
    window->SetSize(20, 20);
    window->AddRenderer(scene.Renderer);
    window->Render();
    CHECK_IMAGE(window, Red);
  }
  // The renderer before its window.
  {
    vtkNew<vtkEGLHeadlessRenderWindow> window;
    window->SetSize(20, 20);
    {
      Scene scene(Red);
      window->AddRenderer(scene.Renderer);
      window->Render();
      window->RemoveRenderer(scene.Renderer);
    }
    Scene scene(Green);
    window->AddRenderer(scene.Renderer);
    window->Render();
    CHECK_IMAGE(window, Green);
  }
  // An actor that was taken out, and outlives the window.
  {
    SceneWindow scene(Red);
    scene.Window->Render();
    scene.Renderer->RemoveActor(scene.Actor);
    scene.Window->Render();
    scene.Window = nullptr;
  }
  // Several windows, in both orders, with the other one current.
  for (int i = 0; i < 2; ++i)
  {
    SceneWindow first(Red);
    SceneWindow second(Green);
    first.Window->Render();
    second.Window->Render();
    (i == 0 ? first : second).Window = nullptr;
    SceneWindow& left = i == 0 ? second : first;
    left.Window->Render();
    CHECK_IMAGE(left.Window, i == 0 ? Green : Red);
  }
  // A texture that outlives its window.
  {
    vtkNew<vtkTextureObject> texture;
    SceneWindow scene(Red);
    scene.Window->Render();
    texture->SetContext(scene.Window);
    texture->Create2D(8, 8, 4, VTK_FLOAT, false);
    scene.Window = nullptr;
  }
  // Never rendered.
  {
    SceneWindow scene(Red);
  }
}

//------------------------------------------------------------------------------
void Threads()
{
  SceneWindow scene(Red);
  scene.Window->Render();
  scene.Window->ReleaseCurrent();
  std::thread other(
    [&scene]()
    {
      scene.Window->Render();
      CHECK_IMAGE(scene.Window, Red);
      scene.Window->ReleaseCurrent();
    });
  other.join();
  scene.Window->Render();
  CHECK_IMAGE(scene.Window, Red);

  // While it is current here, another thread gets an error rather than a crash.
  ErrorCounter errors(scene.Window);
  std::thread refused([&scene]() { scene.Window->Render(); });
  refused.join();
  CHECK(errors.Count == 1, errors.Count);
  scene.Window->Render();
  CHECK_IMAGE(scene.Window, Red);

  // A window in each of several threads.
  std::vector<std::thread> threads;
  std::array<bool, 4> drawn = {};
  for (size_t i = 0; i < drawn.size(); ++i)
  {
    threads.emplace_back(
      [&drawn, i]()
      {
        vtkNew<vtkEGLHeadlessRenderWindow> window;
        window->Initialize();
        drawn[i] = window->GetGenericContext() != nullptr && window->IsCurrent();
      });
  }
  for (auto& thread : threads)
  {
    thread.join();
  }
  CHECK(drawn[0] && drawn[1] && drawn[2] && drawn[3], "");
}

//------------------------------------------------------------------------------
void Devices()
{
  vtkNew<vtkEGLHeadlessRenderWindow> any;
  CHECK(any->GetDeviceIndex() == -1, any->GetDeviceIndex());
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
      // A device that this user may not open.
      CHECK(errors.Count == 1, errors.Count);
      continue;
    }
    ++working;
    CHECK(scene.Window->GetPlatformName() == "EGL device " + std::to_string(i), "");
    std::cout << i << ": " << scene.Window->GetGLRenderer() << "\n";
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
  // Another choice is another chance.
  scene.Window->SetDeviceIndex(-1);
  scene.Window->Render();
  CHECK(errors.Count == 1, errors.Count);
  CHECK_IMAGE(scene.Window, Red);
}

//------------------------------------------------------------------------------
void Interactor()
{
  SceneWindow scene(Red);
  auto interactor =
    vtkSmartPointer<vtkRenderWindowInteractor>::Take(scene.Window->MakeRenderWindowInteractor());
  CHECK(interactor->IsA("vtkGenericRenderWindowInteractor"), interactor->GetClassName());
  CHECK(scene.Window->GetInteractor() == interactor, "");
  interactor->Initialize();
  interactor->Render();
  interactor->Start();
  CHECK_IMAGE(scene.Window, Red);
  interactor->UpdateSize(30, 20);
  interactor->Render();
  CHECK(scene.Window->GetSize()[0] == 30, scene.Window->GetSize()[0]);
  CHECK_IMAGE(scene.Window, Red);
  // Events come from the program.
  interactor->SetEventInformation(5, 5, 0, 0, 'w');
  interactor->InvokeEvent(vtkCommand::CharEvent);
  CHECK(scene.Actor->GetProperty()->GetRepresentation() == VTK_WIREFRAME, "");

  // The usual one on Linux needs X.
  vtkNew<vtkRenderWindowInteractor> onDisplay;
  if (onDisplay->IsA("vtkXRenderWindowInteractor"))
  {
    SceneWindow other(Green);
    ErrorCounter errors(other.Window);
    onDisplay->SetRenderWindow(other.Window);
    CHECK(errors.Count == 1, errors.Count);
    CHECK(other.Window->GetInteractor() == nullptr, "");
    other.Window->Render();
    CHECK_IMAGE(other.Window, Green);
  }
}

//------------------------------------------------------------------------------
void Factory()
{
  const auto windowClass = []()
  { return std::string(vtkSmartPointer<vtkRenderWindow>::New()->GetClassName()); };
  const auto interactorClass = []()
  { return std::string(vtkSmartPointer<vtkRenderWindowInteractor>::New()->GetClassName()); };
  const std::string window = windowClass();
  const std::string interactor = interactorClass();
  CHECK(window != "vtkEGLHeadlessRenderWindow", window);
  CHECK(!vtkIndirectHeadlessFactory::IsEnabled(), "");
  vtkIndirectHeadlessFactory::Disable();

  for (int i = 0; i < 3; ++i)
  {
    vtkIndirectHeadlessFactory::Enable();
    vtkIndirectHeadlessFactory::Enable();
    CHECK(vtkIndirectHeadlessFactory::IsEnabled(), "");
    CHECK(windowClass() == "vtkEGLHeadlessRenderWindow", windowClass());
    CHECK(interactorClass() == "vtkGenericRenderWindowInteractor", interactorClass());
    vtkIndirectHeadlessFactory::Disable();
    CHECK(!vtkIndirectHeadlessFactory::IsEnabled(), "");
    CHECK(windowClass() == window, windowClass());
    CHECK(interactorClass() == interactor, interactorClass());
  }

  // A program as it is found everywhere.
  vtkIndirectHeadlessFactory::Enable();
  {
    Scene scene(Red);
    vtkNew<vtkRenderWindow> plain;
    plain->SetSize(40, 30);
    plain->AddRenderer(scene.Renderer);
    vtkNew<vtkRenderWindowInteractor> iren;
    iren->SetRenderWindow(plain);
    iren->Initialize();
    iren->CreateRepeatingTimer(10);
    plain->Render();
    iren->Start();
    CHECK_IMAGE(plain, Red);
  }
  // VTK's test harness puts its interactor in place by first disabling all others.
  vtkNew<vtkTestingObjectFactory> testing;
  for (int i = 0; i < 2; ++i)
  {
    vtkObjectFactory::RegisterFactory(testing);
    if (i == 1)
    {
      vtkIndirectHeadlessFactory::Disable();
      vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
      factories->InitTraversal();
      while (vtkObjectFactory* factory = factories->GetNextItem())
      {
        if (factory != testing)
        {
          factory->Disable("vtkRenderWindowInteractor");
        }
      }
      vtkIndirectHeadlessFactory::Enable();
      CHECK(interactorClass() == "vtkTestingInteractor", interactorClass());
    }
    CHECK(windowClass() == "vtkEGLHeadlessRenderWindow", windowClass());
    vtkObjectFactory::UnRegisterFactory(testing);
  }
  vtkIndirectHeadlessFactory::Disable();
}

//------------------------------------------------------------------------------
void TooLarge()
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
  CHECK(errors.Text.find("libgl1-mesa-dri") != std::string::npos, errors.Text);
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

void NoEGL()
{
  CheckUnsupported("EGL default display (no EGL display)");
}

void OldOpenGL()
{
  if (vtkEGLHeadlessRenderWindow::IsSupported())
  {
    std::cout << "SKIPPED: the driver does not heed MESA_GL_VERSION_OVERRIDE\n";
    std::exit(SkipReturnCode);
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
    std::cout << "SKIPPED: the driver, " << version << ", does not heed MESA_GL_VERSION_OVERRIDE\n";
    std::exit(SkipReturnCode);
  }
  CHECK(version.compare(0, 3, expected) == 0, version);
  CHECK_IMAGE(scene.Window, Red);
}

void OpenGL32()
{
  CheckVersion("3.2");
}

void OpenGL41()
{
  CheckVersion("4.1");
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  const std::map<std::string, std::function<void()>> tests = { { "Render", Render },
    { "Depth", Depth }, { "Resize", Resize }, { "Shapes", Shapes }, { "Tiles", Tiles },
    { "MultiSamples", MultiSamples }, { "Stencil", Stencil }, { "TwoWindows", TwoWindows },
    { "Framebuffers", Framebuffers }, { "Recreate", Recreate },
    { "DestructionOrder", DestructionOrder }, { "Threads", Threads }, { "Devices", Devices },
    { "Interactor", Interactor }, { "Factory", Factory }, { "TooLarge", TooLarge },
    { "NoEGL", NoEGL }, { "OldOpenGL", OldOpenGL }, { "OpenGL32", OpenGL32 },
    { "OpenGL41", OpenGL41 } };
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
