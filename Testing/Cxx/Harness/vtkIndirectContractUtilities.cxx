// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectContractUtilities.h"

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include "vtkImageData.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace contract
{
//------------------------------------------------------------------------------
View::View(int width, int height)
  : Window(vtkSmartPointer<vtkEGLHeadlessRenderWindow>::New())
  , Renderer(vtkSmartPointer<vtkRenderer>::New())
{
  this->Window->SetMultiSamples(0);
  this->Window->SetAlphaBitPlanes(1);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
}

View::~View() = default;

Pixels View::Grab()
{
  return contract::Grab(this->Window);
}

//------------------------------------------------------------------------------
Pixels Grab(vtkRenderWindow* window, bool render)
{
  if (render)
  {
    window->Render();
  }
  const GLenum error = glGetError();
  CONTRACT_CHECK(error == GL_NO_ERROR, "OpenGL error 0x" << std::hex << error);
  const int* size = window->GetActualSize();
  Pixels result;
  result.Width = size[0];
  result.Height = size[1];
  result.Components = 4;
  vtkNew<vtkUnsignedCharArray> data;
  window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, data);
  result.Values.assign(data->GetPointer(0), data->GetPointer(0) + data->GetNumberOfValues());
  CONTRACT_CHECK(result.Values.size() == static_cast<size_t>(size[0]) * size[1] * 4, "read back");
  return result;
}

//------------------------------------------------------------------------------
std::vector<float> GrabDepth(vtkRenderWindow* window)
{
  const int* size = window->GetActualSize();
  std::vector<float> depth(static_cast<size_t>(size[0]) * size[1]);
  window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depth.data());
  return depth;
}

//------------------------------------------------------------------------------
Pixels Crop(const Pixels& image, int x, int y, int width, int height)
{
  Pixels result;
  result.Width = width;
  result.Height = height;
  result.Components = image.Components;
  for (int row = y; row < y + height; ++row)
  {
    const unsigned char* first = image.At(x, row);
    result.Values.insert(result.Values.end(), first, first + width * image.Components);
  }
  return result;
}

//------------------------------------------------------------------------------
Floats Read(vtkIndirectIlluminationPass* pass, const std::string& name)
{
  Floats result;
  vtkNew<vtkImageData> image;
  const bool copied = pass->CopyBuffer(name, image);
  CONTRACT_CHECK(copied, "buffer " << name);
  if (copied)
  {
    const int* dimensions = image->GetDimensions();
    result.Width = dimensions[0];
    result.Height = dimensions[1];
    result.Components = image->GetNumberOfScalarComponents();
    const auto* values = static_cast<const float*>(image->GetScalarPointer());
    result.Values.assign(
      values, values + static_cast<size_t>(result.Width) * result.Height * result.Components);
    CONTRACT_CHECK(IsFinite(result), "buffer " << name << " holds infinite or undefined values");
  }
  return result;
}

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const Difference& difference)
{
  return os << "largest difference " << difference.Max << " at (" << difference.X << ", "
            << difference.Y << "), mean " << difference.Mean << ", " << difference.Pixels
            << " pixels differ";
}

//------------------------------------------------------------------------------
namespace
{
template <typename T>
double MeanOf(const Image<T>& image, int component)
{
  double sum = 0.0;
  for (size_t i = component; i < image.Values.size(); i += image.Components)
  {
    sum += image.Values[i];
  }
  return sum * image.Components / std::max<size_t>(image.Values.size(), 1);
}
}

double Mean(const Floats& image, int component)
{
  return MeanOf(image, component);
}

double Mean(const Pixels& image, int component)
{
  return MeanOf(image, component);
}

//------------------------------------------------------------------------------
bool IsFinite(const Floats& image)
{
  return std::all_of(
    image.Values.begin(), image.Values.end(), [](float v) { return std::isfinite(v); });
}
}
