// SPDX-License-Identifier: BSD-3-Clause
#include "CardImages.h"

#include "vtkDataArray.h"
#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkImageData.h"
#include "vtkIndirectIlluminationPass.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace
{
// The same bits everywhere (Wellons' lowbias32).
std::uint32_t Hash(std::uint32_t x)
{
  x ^= x >> 16;
  x *= 0x7feb352du;
  x ^= x >> 15;
  x *= 0x846ca68bu;
  return x ^ (x >> 16);
}

// A value between pixel centres; false where the place is not within the image.
bool Interpolate(const card::Image& image, double x, double y, double color[3])
{
  // Places that rounding has moved off the outermost centres are on them.
  constexpr double slack = 1e-9;
  if (!(x >= -slack && y >= -slack && x <= image.Width - 1 + slack &&
        y <= image.Height - 1 + slack))
  {
    return false;
  }
  x = std::clamp(x, 0.0, image.Width - 1.0);
  y = std::clamp(y, 0.0, image.Height - 1.0);
  const int x0 = static_cast<int>(x);
  const int y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, image.Width - 1);
  const int y1 = std::min(y0 + 1, image.Height - 1);
  const double u = x - x0;
  const double v = y - y0;
  for (int c = 0; c < 3; ++c)
  {
    color[c] = (1.0 - v) * ((1.0 - u) * image.At(x0, y0)[c] + u * image.At(x1, y0)[c]) +
      v * ((1.0 - u) * image.At(x0, y1)[c] + u * image.At(x1, y1)[c]);
  }
  return true;
}
}

//------------------------------------------------------------------------------
card::Image card::CopyBuffer(vtkIndirectIlluminationPass* pass, const std::string& name)
{
  vtkNew<vtkImageData> data;
  if (!pass->CopyBuffer(name, data))
  {
    throw std::runtime_error("the frame has no buffer '" + name + "'");
  }
  vtkDataArray* array = data->GetPointData()->GetScalars();
  Image image;
  image.Width = data->GetDimensions()[0];
  image.Height = data->GetDimensions()[1];
  image.Components = array->GetNumberOfComponents();
  if (array->GetDataType() != VTK_FLOAT)
  {
    throw std::runtime_error("the buffer '" + name + "' does not hold floats");
  }
  const float* values = static_cast<const float*>(array->GetVoidPointer(0));
  image.Values.assign(values, values + array->GetNumberOfValues());
  return image;
}

//------------------------------------------------------------------------------
card::Image card::CopyWindow(Scene& scene)
{
  Image image;
  image.Width = scene.Window->GetSize()[0];
  image.Height = scene.Window->GetSize()[1];
  image.Components = 3;
  vtkNew<vtkUnsignedCharArray> bytes;
  scene.Window->GetPixelData(0, 0, image.Width - 1, image.Height - 1, 1, bytes, 0);
  image.Values.resize(bytes->GetNumberOfValues());
  for (size_t i = 0; i < image.Values.size(); ++i)
  {
    image.Values[i] = static_cast<float>(bytes->GetValue(static_cast<vtkIdType>(i))) / 255.0f;
  }
  return image;
}

//------------------------------------------------------------------------------
std::vector<std::array<int, 2>> card::MakePlaces(int width, int height)
{
  const int columns = std::min(64, width);
  const int rows = std::min(36, height);
  std::vector<std::array<int, 2>> places;
  std::uint32_t seed = 1;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      const int x0 = static_cast<int>(static_cast<std::int64_t>(i) * width / columns);
      const int x1 = static_cast<int>(static_cast<std::int64_t>(i + 1) * width / columns);
      const int y0 = static_cast<int>(static_cast<std::int64_t>(j) * height / rows);
      const int y1 = static_cast<int>(static_cast<std::int64_t>(j + 1) * height / rows);
      const std::uint32_t bits = Hash(seed++);
      places.push_back({ x0 + static_cast<int>((bits & 0xffffu) % (x1 - x0)),
        y0 + static_cast<int>((bits >> 16) % (y1 - y0)) });
    }
  }
  return places;
}

//------------------------------------------------------------------------------
card::Errors card::Compare(const Image& image, const Image& reference, const Image& mask)
{
  // relMSE's floor in the dark: this part of the squared mean.
  constexpr double floor = 0.01;
  std::vector<std::array<double, 6>> pairs;
  double mean = 0.0;
  // One pixel of the reference is so many of the image, in both directions.
  const double scale = static_cast<double>(image.Height) / reference.Height;
  for (int j = 0; j < reference.Height; ++j)
  {
    for (int i = 0; i < reference.Width; ++i)
    {
      double color[3];
      const double x = 0.5 * image.Width + scale * (i + 0.5 - 0.5 * reference.Width) - 0.5;
      const double y = scale * (j + 0.5) - 0.5;
      if (mask.At(i, j)[0] > 0.5f && Interpolate(image, x, y, color))
      {
        const float* truth = reference.At(i, j);
        pairs.push_back({ color[0], color[1], color[2], truth[0], truth[1], truth[2] });
        mean += truth[0] + truth[1] + truth[2];
      }
    }
  }
  Errors errors;
  errors.Receivers = static_cast<long>(pairs.size());
  if (pairs.empty() || !(mean > 0.0))
  {
    throw std::runtime_error("the reference has no light on what the image shows");
  }
  const double values = 3.0 * pairs.size();
  mean /= values;
  double squared = 0.0;
  double relative = 0.0;
  double bias = 0.0;
  for (const auto& pair : pairs)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double difference = pair[c] - pair[3 + c];
      bias += difference;
      squared += difference * difference;
      relative += difference * difference / (pair[3 + c] * pair[3 + c] + floor * mean * mean);
    }
  }
  errors.RootMeanSquare = std::sqrt(squared / values) / mean;
  errors.Relative = relative / values;
  errors.Bias = bias / values / mean;
  return errors;
}

//------------------------------------------------------------------------------
bool card::WritePicture(const std::string& path, const Image& image, double white,
  const std::vector<std::array<int, 2>>& crosses)
{
  // Buffers of a few columns, such as the lights', are enlarged: crosses would cover them.
  constexpr int maximumWidth = 960;
  constexpr int minimumWidth = 32;
  const int step = (image.Width + maximumWidth - 1) / maximumWidth;
  const int zoom = std::max(1, minimumWidth / image.Width);
  const int width = std::max(1, zoom * image.Width / step);
  const int height = std::max(1, zoom * image.Height / step);
  std::vector<unsigned char> bytes(3 * static_cast<size_t>(width) * height);
  auto at = [&](int x, int y) { return &bytes[3 * (static_cast<size_t>(y) * width + x)]; };
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const float* values = image.At(x * step / zoom, y * step / zoom);
      for (int c = 0; c < 3; ++c)
      {
        const double value = std::abs(values[std::min(c, image.Components - 1)]) / white;
        const double shown = value >= 0.0 ? std::pow(std::min(1.0, value), 1.0 / 2.2) : 1.0;
        at(x, y)[c] = static_cast<unsigned char>(std::lround(255.0 * shown));
      }
    }
  }
  constexpr int arm = 3;
  for (const auto& cross : crosses)
  {
    for (int k = -arm; k <= arm; ++k)
    {
      const int x = (cross[0] * zoom + zoom / 2) / step;
      const int y = (cross[1] * zoom + zoom / 2) / step;
      const int places[2][2] = { { x + k, y }, { x, y + k } };
      for (const auto& place : places)
      {
        if (place[0] >= 0 && place[1] >= 0 && place[0] < width && place[1] < height)
        {
          const unsigned char red[3] = { 255, 0, 0 };
          std::copy(red, red + 3, at(place[0], place[1]));
        }
      }
    }
  }
  png_image file;
  std::memset(&file, 0, sizeof file);
  file.version = PNG_IMAGE_VERSION;
  file.width = static_cast<png_uint_32>(width);
  file.height = static_cast<png_uint_32>(height);
  file.format = PNG_FORMAT_RGB;
  // Bottom row first.
  return png_image_write_to_file(&file, path.c_str(), 0, bytes.data(), -3 * width, nullptr) != 0;
}
