// SPDX-License-Identifier: BSD-3-Clause
// Shared parts of the tests of VTK::IndirectHeadless: the scene and the checks.

#ifndef HeadlessTestTools_h
#define HeadlessTestTools_h

// The tests call OpenGL themselves.
#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include "vtkIndirectHarness.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <array>
#include <iostream>
#include <string>

namespace headlesstest
{
// The source line of a check.
struct Place
{
  const char* File;
  int Line;
};

// Counts a failure and begins its message.
std::ostream& Fail(const Place& place);

#define HERE (headlesstest::Place{ __FILE__, __LINE__ })

#define CHECK(condition, ...)                                                                      \
  do                                                                                               \
  {                                                                                                \
    vtkIndirectTest::AddCheck();                                                                   \
    if (!(condition))                                                                              \
    {                                                                                              \
      headlesstest::Fail(HERE) << #condition " " << __VA_ARGS__ << "\n";                           \
    }                                                                                              \
  } while (false)

// True if a text contains these words.
inline bool Has(const std::string& text, const std::string& words)
{
  return text.find(words) != std::string::npos;
}

using Color = std::array<int, 3>;
constexpr Color Red = { 255, 0, 0 };
constexpr Color Green = { 0, 255, 0 };
constexpr Color Blue = { 0, 0, 255 };
constexpr Color Yellow = { 255, 255, 0 };

std::ostream& operator<<(std::ostream& os, const Color& color);

// An unlit square of the given color that fills the left half of the window, 2 in front of the
// camera, between clipping planes at 1 and 5. The background is blue.
struct Scene
{
  vtkNew<vtkPlaneSource> Plane;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;

  explicit Scene(const Color& color);
};

struct SceneWindow : Scene
{
  vtkSmartPointer<vtkEGLHeadlessRenderWindow> Window =
    vtkSmartPointer<vtkEGLHeadlessRenderWindow>::New();

  explicit SceneWindow(const Color& color, int width = 64, int height = 48);
};

void CheckNoGLError(const Place& place);
#define CHECK_NO_GL_ERROR() headlesstest::CheckNoGLError(HERE)

// Checks all pixels: left half in the given color, right half blue, in both buffers.
void CheckImage(vtkRenderWindow* window, const Color& color, const Place& place);
#define CHECK_IMAGE(window, color) headlesstest::CheckImage(window, color, HERE)

// Counts errors instead of printing them, and keeps the last text.
struct ErrorCounter
{
  int Count = 0;
  std::string Text;
  vtkNew<vtkCallbackCommand> Command;

  explicit ErrorCounter(vtkObject* object);
};
}

#endif
