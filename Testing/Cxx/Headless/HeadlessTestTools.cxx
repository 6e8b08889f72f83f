// SPDX-License-Identifier: BSD-3-Clause
#include "HeadlessTestTools.h"

#include "vtkCamera.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

namespace headlesstest
{
//------------------------------------------------------------------------------
std::ostream& Fail(const Place& place)
{
  vtkIndirectTest::AddFailure();
  return std::cerr << "FAILED " << place.File << ":" << place.Line << ": ";
}

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const Color& color)
{
  return os << "(" << color[0] << ", " << color[1] << ", " << color[2] << ")";
}

//------------------------------------------------------------------------------
Scene::Scene(const Color& color)
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

//------------------------------------------------------------------------------
SceneWindow::SceneWindow(const Color& color, int width, int height)
  : Scene(color)
{
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
void CheckNoGLError(const Place& place)
{
  vtkIndirectTest::AddCheck();
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR)
  {
    Fail(place) << "OpenGL error 0x" << std::hex << error << std::dec << "\n";
  }
}

//------------------------------------------------------------------------------
void CheckImage(vtkRenderWindow* window, const Color& color, const Place& place)
{
  vtkIndirectTest::AddCheck();
  const int width = window->GetSize()[0];
  const int height = window->GetSize()[1];
  for (int front = 0; front < 2; ++front)
  {
    vtkNew<vtkUnsignedCharArray> pixels;
    if (window->GetPixelData(0, 0, width - 1, height - 1, front, pixels, 0) != VTK_OK)
    {
      Fail(place) << "no pixels\n";
      return;
    }
    if (pixels->GetNumberOfTuples() != static_cast<vtkIdType>(width) * height)
    {
      Fail(place) << pixels->GetNumberOfTuples() << " pixels\n";
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
          Fail(place) << "pixel " << x << ", " << y << " of " << width << " x " << height << " is "
                      << actual << ", not " << expected << "\n";
          return;
        }
      }
    }
  }
  CheckNoGLError(place);
}

//------------------------------------------------------------------------------
ErrorCounter::ErrorCounter(vtkObject* object)
{
  this->Command->SetClientData(this);
  this->Command->SetCallback(
    [](vtkObject*, unsigned long, void* self, void* text)
    {
      auto counter = static_cast<ErrorCounter*>(self);
      ++counter->Count;
      counter->Text = static_cast<const char*>(text);
      // Without the word that would fail the test.
      const size_t start = counter->Text.find("): ");
      std::cout << "expected: " << counter->Text.substr(start == std::string::npos ? 0 : start + 3)
                << "\n";
    });
  object->AddObserver(vtkCommand::ErrorEvent, this->Command);
  object->AddObserver(vtkCommand::WarningEvent, this->Command);
}
}
