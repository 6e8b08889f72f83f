// SPDX-License-Identifier: BSD-3-Clause
// The reader returns the writer's values.

#include "OpenEXRTestTools.h"

#include "vtkDoubleArray.h"
#include "vtkSOADataArrayTemplate.h"

#include <half.h>

#include <algorithm>
#include <limits>

using namespace exrtest;

namespace
{
float FromBits(std::uint32_t bits)
{
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

std::uint32_t ToBits(float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

//------------------------------------------------------------------------------
// Any bit pattern survives as float, with every compression and number of components.
VTK_INDIRECT_TEST(RoundTrip)
{
  const std::string folder = GetFolder();
  Random random(7);
  for (int compression = 0; compression < 3; ++compression)
  {
    for (int components : { 1, 2, 3, 4, 5, 12 })
    {
      auto image = MakeImage({ 0, 36, 0, 52, 0, 0 }, components);
      float* data = FloatData(image);
      for (vtkIdType i = 0; i < 37 * 53 * components; ++i)
      {
        data[i] = FromBits(random.Next());
      }
      data[0] = std::numeric_limits<float>::infinity();
      data[1] = -std::numeric_limits<float>::infinity();
      data[2] = std::numeric_limits<float>::quiet_NaN();
      data[3] = FromBits(0x7fa12345u); // a signalling NaN
      data[4] = -0.0f;
      vtkNew<vtkOpenEXRWriter> writer;
      EXR_CHECK(writer->GetPixelType() == vtkOpenEXRWriter::HalfPixels);
      EXR_CHECK(writer->GetCompression() == vtkOpenEXRWriter::ZIPCompression);
      writer->SetInputData(image);
      writer->SetPixelTypeToFloat();
      writer->SetCompression(compression);
      Write(writer, folder + "image.exr");
      vtkNew<vtkOpenEXRReader> reader;
      Read(reader, folder + "image.exr");
      EXR_CHECK(SameBits(image, reader->GetOutput()));
      EXR_CHECK(reader->GetOutput()->GetPointData()->GetScalars()->GetName() ==
        std::string("OpenEXRImage"));
      EXR_CHECK(reader->GetNumberOfLayers() == 1);
      EXR_CHECK(reader->GetLayerName(0).empty());
      EXR_CHECK(reader->GetOutput()->GetNumberOfScalarComponents() == components);
    }
  }
  EXR_CHECK(CountFiles(folder) == 1);

  // The other scalar types are converted by value.
  for (int type : { VTK_DOUBLE, VTK_INT, VTK_UNSIGNED_INT, VTK_SHORT, VTK_UNSIGNED_SHORT,
         VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_CHAR, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
         VTK_ID_TYPE, VTK_LONG, VTK_UNSIGNED_LONG })
  {
    auto image = MakeImage({ 0, 9, 0, 6, 0, 0 }, 3, VTK_FLOAT, 3, 50.0f);
    vtkDataArray* scalars = image->GetPointData()->GetScalars();
    auto other = vtkSmartPointer<vtkImageData>::New();
    other->SetDimensions(10, 7, 1);
    other->AllocateScalars(type, 3);
    for (int half = 0; half < 2; ++half)
    {
      for (vtkIdType i = 0; i < 70; ++i)
      {
        for (int c = 0; c < 3; ++c)
        {
          const double value = std::abs(std::floor(scalars->GetComponent(i, c)));
          scalars->SetComponent(i, c, value);
          other->GetPointData()->GetScalars()->SetComponent(i, c, value);
        }
      }
      vtkNew<vtkOpenEXRWriter> writer;
      writer->SetInputData(other);
      writer->SetPixelType(half);
      Write(writer, folder + "image.exr");
      vtkNew<vtkOpenEXRReader> reader;
      Read(reader, folder + "image.exr");
      EXR_CHECK(SameBits(image, reader->GetOutput()));
    }
  }

  // An array with separate components.
  vtkNew<vtkSOADataArrayTemplate<float>> separate;
  separate->SetNumberOfComponents(3);
  separate->SetNumberOfTuples(70);
  auto image = MakeImage({ 0, 9, 0, 6, 0, 0 }, 3);
  separate->DeepCopy(image->GetPointData()->GetScalars());
  vtkNew<vtkImageData> other;
  other->SetDimensions(10, 7, 1);
  other->GetPointData()->SetScalars(separate);
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetInputData(other);
  writer->SetPixelTypeToFloat();
  Write(writer, folder + "image.exr");
  vtkNew<vtkOpenEXRReader> reader;
  Read(reader, folder + "image.exr");
  EXR_CHECK(SameBits(image, reader->GetOutput()));
}

//------------------------------------------------------------------------------
// All 65536 values of half.
VTK_INDIRECT_TEST(HalfValues)
{
  const std::string folder = GetFolder();
  for (int compression = 0; compression < 3; ++compression)
  {
    auto image = MakeImage({ 0, 255, 0, 255, 0, 0 }, 1);
    float* data = FloatData(image);
    for (int i = 0; i < 65536; ++i)
    {
      half value;
      value.setBits(static_cast<unsigned short>(i));
      data[i] = value;
    }
    vtkNew<vtkOpenEXRWriter> writer;
    writer->SetInputData(image);
    writer->SetCompression(compression);
    Write(writer, folder + "half.exr");
    vtkNew<vtkOpenEXRReader> reader;
    Read(reader, folder + "half.exr");
    const float* result = FloatData(reader->GetOutput());
    int nans = 0;
    int different = 0;
    for (int i = 0; i < 65536; ++i)
    {
      if (std::isnan(data[i]))
      {
        ++nans;
        different += std::isnan(result[i]) ? 0 : 1;
        different += std::signbit(data[i]) == std::signbit(result[i]) ? 0 : 1;
      }
      else
      {
        different += ToBits(data[i]) == ToBits(result[i]) ? 0 : 1;
      }
    }
    EXR_CHECK(nans == 2046);
    EXR_CHECK(different == 0);
  }
}

//------------------------------------------------------------------------------
// Rounding to the nearest half, ties to even, of floats and of doubles that become floats first,
// against a search.
VTK_INDIRECT_TEST(HalfRounding)
{
  const std::string folder = GetFolder();
  std::vector<double> values; // the finite halves that are not negative, by their bits
  for (int i = 0; i < 0x7c00; ++i)
  {
    half value;
    value.setBits(static_cast<unsigned short>(i));
    values.push_back(static_cast<double>(static_cast<float>(value)));
  }
  auto nearest = [&](double value)
  {
    const double size = std::abs(value);
    const auto above = std::lower_bound(values.begin(), values.end(), size);
    std::size_t index = static_cast<std::size_t>(above - values.begin());
    if (index == values.size())
    {
      index = values.size() - 1;
    }
    else if (index > 0)
    {
      const double up = values[index] - size;
      const double down = size - values[index - 1];
      index -= down < up || (down == up && index % 2 == 1) ? 1 : 0;
    }
    return static_cast<float>(std::copysign(values[index], value));
  };

  Random random(11);
  for (int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    auto image = MakeImage({ 0, 255, 0, 255, 0, 0 }, 1, type);
    vtkDataArray* scalars = image->GetPointData()->GetScalars();
    for (int i = 0; i < 65536; ++i)
    {
      // Between two neighbours, at the middle or a little beside it.
      const std::size_t index = random.Below(0x7bff);
      const double gap = values[index + 1] - values[index];
      const double offsets[] = { 0.5, 0.5 + 1e-5, 0.5 - 1e-5, 0.5 + 1e-12, 0.5 - 1e-12, 0.25, 0.75,
        1e-9 };
      double value = values[index] + gap * offsets[random.Below(8)];
      value = random.Below(2) ? value : -value;
      scalars->SetComponent(i, 0, type == VTK_FLOAT ? static_cast<float>(value) : value);
    }
    vtkNew<vtkOpenEXRWriter> writer;
    writer->SetInputData(image);
    Write(writer, folder + "half.exr");
    vtkNew<vtkOpenEXRReader> reader;
    Read(reader, folder + "half.exr");
    const float* result = FloatData(reader->GetOutput());
    int different = 0;
    for (int i = 0; i < 65536; ++i)
    {
      different +=
        ToBits(nearest(static_cast<float>(scalars->GetComponent(i, 0)))) == ToBits(result[i]) ? 0
                                                                                              : 1;
    }
    EXR_CHECK(different == 0);
  }
}

//------------------------------------------------------------------------------
// Values beyond the range are clamped, and reported once.
VTK_INDIRECT_TEST(Range)
{
  const std::string folder = GetFolder();
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double input[8] = { 65504.0, 65505.0, -70000.0, 1e30, -1e300, infinity, -infinity, nan };
  const double halves[8] = { 65504.0, 65504.0, -65504.0, 65504.0, -65504.0, infinity, -infinity,
    nan };
  const double largest = std::numeric_limits<float>::max();
  const double floats[8] = { 65504.0, 65505.0, -70000.0, 1e30, -largest, infinity, -infinity, nan };
  for (int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    for (int pixels = 0; pixels < 2; ++pixels)
    {
      auto image = MakeImage({ 0, 7, 0, 0, 0, 0 }, 1, type);
      for (int i = 0; i < 8; ++i)
      {
        const double limited = std::isfinite(input[i]) && type == VTK_FLOAT
          ? std::max(-largest, std::min(largest, input[i]))
          : input[i];
        image->GetPointData()->GetScalars()->SetComponent(i, 0, limited);
      }
      vtkNew<vtkOpenEXRWriter> writer;
      vtkNew<Messages> messages;
      messages->Watch(writer);
      writer->SetInputData(image);
      writer->SetPixelType(pixels);
      Write(writer, folder + "range.exr");
      EXR_CHECK(messages->Errors == 0);
      EXR_CHECK(messages->Warnings == (pixels == 0 || type == VTK_DOUBLE ? 1 : 0));
      vtkNew<vtkOpenEXRReader> reader;
      Read(reader, folder + "range.exr");
      const float* result = FloatData(reader->GetOutput());
      for (int i = 0; i < 8; ++i)
      {
        const float expected = static_cast<float>(pixels ? floats[i] : halves[i]);
        EXR_CHECK(std::isnan(expected) ? std::isnan(result[i]) : result[i] == expected);
      }
    }
  }
  vtkNew<vtkOpenEXRWriter> writer;
  vtkNew<Messages> messages;
  messages->Watch(writer);
  writer->SetInputData(MakeImage({ 0, 7, 0, 7, 0, 0 }, 4, VTK_FLOAT, 5, 65504.0f));
  Write(writer, folder + "range.exr");
  EXR_CHECK(messages->Warnings == 0);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Shapes)
{
  const std::string folder = GetFolder();
  for (int compression = 0; compression < 3; ++compression)
  {
    for (int pixels = 0; pixels < 2; ++pixels)
    {
      for (const std::vector<int>& size : { std::vector<int>{ 1, 1 }, std::vector<int>{ 1, 257 },
             std::vector<int>{ 257, 1 }, std::vector<int>{ 2, 2 }, std::vector<int>{ 1000, 33 } })
      {
        for (int components = 1; components <= 5; ++components)
        {
          auto image = MakeImage({ 0, size[0] - 1, 0, size[1] - 1, 0, 0 }, components);
          float* data = FloatData(image);
          for (vtkIdType i = 0; i < image->GetNumberOfPoints() * components; ++i)
          {
            data[i] = half(data[i]);
          }
          vtkNew<vtkOpenEXRWriter> writer;
          writer->SetInputData(image);
          writer->SetPixelType(pixels);
          writer->SetCompression(compression);
          Write(writer, folder + "shape.exr");
          vtkNew<vtkOpenEXRReader> reader;
          Read(reader, folder + "shape.exr");
          EXR_CHECK(SameBits(image, reader->GetOutput()));
        }
      }
    }
  }
}
}
