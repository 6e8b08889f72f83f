// SPDX-License-Identifier: BSD-3-Clause
// The reader gives back what the writer was given.

#include "OpenEXRTestTools.h"

#include "vtkDoubleArray.h"
#include "vtkSOADataArrayTemplate.h"

#include <half.h>

#include <algorithm>
#include <limits>

using namespace exrtest;

namespace
{
void Write(vtkOpenEXRWriter* writer, const std::string& path)
{
  writer->SetFileName(path.c_str());
  writer->Write();
  EXR_CHECK(writer->GetErrorCode() == vtkErrorCode::NoError);
}

void Read(vtkOpenEXRReader* reader, const std::string& path)
{
  reader->SetFileName(path.c_str());
  reader->Update();
  EXR_CHECK(reader->GetErrorCode() == vtkErrorCode::NoError);
}

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
void RoundTrip(const std::string& folder)
{
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
      EXR_CHECK(reader->GetNumberOfParts() == 1);
      EXR_CHECK(reader->GetNumberOfLayers() == 1);
      EXR_CHECK(reader->GetLayerName(0).empty());
      EXR_CHECK(reader->GetNumberOfChannels() == components);
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

  // An array that keeps each component by itself.
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
void HalfValues(const std::string& folder)
{
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
// Rounding to the nearest half, ties to even, from float and from double, against a search.
void HalfRounding(const std::string& folder)
{
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
      different += ToBits(nearest(scalars->GetComponent(i, 0))) == ToBits(result[i]) ? 0 : 1;
    }
    EXR_CHECK(different == 0);
  }
}

//------------------------------------------------------------------------------
// Values beyond the range are clamped, and told once.
void Range(const std::string& folder)
{
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
void Layers(const std::string& folder)
{
  auto beauty = MakeImage({ 0, 19, 0, 14, 0, 0 }, 4, VTK_FLOAT, 1);
  auto albedo = MakeImage({ 0, 19, 0, 14, 0, 0 }, 3, VTK_FLOAT, 2);
  auto depth = MakeImage({ 5, 24, -3, 11, 2, 2 }, 1, VTK_FLOAT, 3); // same dimensions, elsewhere
  auto many = MakeImage({ 0, 19, 0, 14, 0, 0 }, 11, VTK_FLOAT, 4);
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetInputData(beauty);
  writer->SetPixelTypeToFloat();
  writer->AddLayer("rsm0.depth", many);
  writer->AddLayer("albedo", albedo);
  writer->AddLayer("rsm0.depth", depth); // replaces
  writer->AddLayer("many", many);
  EXR_CHECK(writer->GetNumberOfLayers() == 3);
  EXR_CHECK(writer->GetLayerName(0) == "albedo");
  EXR_CHECK(writer->GetLayerName(3).empty());
  Write(writer, folder + "layers.exr");

  vtkNew<vtkOpenEXRReader> reader;
  reader->SetFileName((folder + "layers.exr").c_str());
  EXR_CHECK(reader->GetNumberOfLayers() == 0);
  EXR_CHECK(reader->ReadHeader());
  EXR_CHECK(reader->GetNumberOfLayers() == 4);
  EXR_CHECK(reader->GetLayerName(0).empty());
  EXR_CHECK(reader->GetLayerName(1) == "albedo");
  EXR_CHECK(reader->GetLayerName(2) == "many");
  EXR_CHECK(reader->GetLayerName(3) == "rsm0.depth");
  EXR_CHECK(reader->GetLayerName(4).empty());
  EXR_CHECK(reader->GetLayerName(-1).empty());
  reader->Update();
  EXR_CHECK(SameBits(beauty, reader->GetOutput()));
  const std::string names[] = { "R", "G", "B", "A", "" };
  for (int i = 0; i < 5; ++i)
  {
    EXR_CHECK(reader->GetChannelName(i) == names[i]);
  }
  reader->SetLayer("albedo");
  reader->Update();
  EXR_CHECK(SameBits(albedo, reader->GetOutput()));
  reader->SetLayer("rsm0.depth");
  reader->Update();
  EXR_CHECK(reader->GetChannelName(0) == "Y");
  EXR_CHECK(reader->GetOutput()->GetNumberOfScalarComponents() == 1);
  EXR_CHECK(
    std::memcmp(FloatData(reader->GetOutput()), FloatData(depth), 300 * sizeof(float)) == 0);
  reader->SetLayer("many");
  reader->Update();
  EXR_CHECK(reader->GetChannelName(10) == "C10");
  EXR_CHECK(reader->GetChannelName(0) == "C00");
  EXR_CHECK(SameBits(many, reader->GetOutput()));

  writer->RemoveAllLayers();
  EXR_CHECK(writer->GetNumberOfLayers() == 0);
  Write(writer, folder + "layers.exr");
  EXR_CHECK(reader->ReadHeader());
  EXR_CHECK(reader->GetNumberOfLayers() == 1);
}

//------------------------------------------------------------------------------
void Attributes(const std::string& folder)
{
  const std::string binary = std::string("a\0b\n\xff", 5);
  const std::string longName(255, 'n');
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetInputData(MakeImage({ 0, 3, 0, 3, 0, 0 }, 3));
  writer->SetAttribute("comments", "first");
  writer->SetAttribute("comments", "a frame");
  writer->SetAttribute("empty", "");
  writer->SetAttribute("binary", binary);
  writer->SetAttribute("long", std::string(100000, 'x'));
  writer->SetAttribute(longName, "named");
  EXR_CHECK(writer->GetAttribute("comments") == "a frame");
  EXR_CHECK(writer->GetAttribute("nothing").empty());
  writer->SetPixelAspectRatio(1.5);
  Write(writer, folder + "attributes.exr");
  vtkNew<vtkOpenEXRReader> reader;
  reader->SetFileName((folder + "attributes.exr").c_str());
  EXR_CHECK(reader->ReadHeader());
  EXR_CHECK(reader->GetAttribute("comments") == "a frame");
  EXR_CHECK(reader->HasAttribute("empty"));
  EXR_CHECK(reader->GetAttribute("empty").empty());
  EXR_CHECK(reader->GetAttribute("binary") == binary);
  EXR_CHECK(reader->GetAttribute("long") == std::string(100000, 'x'));
  EXR_CHECK(reader->GetAttribute(longName) == "named");
  EXR_CHECK(!reader->HasAttribute("nothing"));
  EXR_CHECK(reader->GetAttribute("nothing").empty());
  EXR_CHECK(reader->GetNumberOfAttributes() >= 5);
  EXR_CHECK(reader->GetAttributeName(0) == "binary");
  EXR_CHECK(reader->GetAttributeName(-1).empty());
  EXR_CHECK(std::abs(reader->GetPixelAspectRatio() - 1.5) < 1e-6);
  writer->RemoveAllAttributes();
  Write(writer, folder + "attributes.exr");
  EXR_CHECK(reader->ReadHeader());
  EXR_CHECK(!reader->HasAttribute("comments"));
}

//------------------------------------------------------------------------------
void Windows(const std::string& folder)
{
  // The extent becomes the data window, also with negative numbers.
  for (const std::vector<int>& extent :
    { std::vector<int>{ -7, 4, -20, -3, 0, 0 }, std::vector<int>{ 100, 130, -5, 40, 0, 0 } })
  {
    auto image = MakeImage(extent, 3);
    vtkNew<vtkOpenEXRWriter> writer;
    writer->SetInputData(image);
    writer->SetPixelTypeToFloat();
    Write(writer, folder + "window.exr");
    vtkNew<vtkOpenEXRReader> reader;
    Read(reader, folder + "window.exr");
    EXR_CHECK(SameBits(image, reader->GetOutput()));
    for (int i = 0; i < 4; ++i)
    {
      EXR_CHECK(reader->GetDataWindow()[i] == extent[static_cast<std::size_t>(i)]);
      EXR_CHECK(reader->GetDisplayWindow()[i] == extent[static_cast<std::size_t>(i)]);
    }
  }

  // A data window partly outside of the display window.
  auto image = MakeImage({ -3, 8, 4, 12, 0, 0 }, 2);
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetInputData(image);
  writer->SetPixelTypeToFloat();
  writer->SetDisplayWindow(0, 15, 0, 9);
  Write(writer, folder + "display.exr");
  vtkNew<vtkOpenEXRReader> reader;
  EXR_CHECK(!reader->GetUseDisplayWindow());
  Read(reader, folder + "display.exr");
  EXR_CHECK(SameBits(image, reader->GetOutput()));
  const int data[4] = { -3, 8, -3, 5 }; // row y of the extent is row 9 - y of the file
  const int display[4] = { 0, 15, 0, 9 };
  EXR_CHECK(std::equal(data, data + 4, reader->GetDataWindow()));
  EXR_CHECK(std::equal(display, display + 4, reader->GetDisplayWindow()));

  reader->UseDisplayWindowOn();
  reader->Update();
  vtkImageData* output = reader->GetOutput();
  EXR_CHECK(output->GetExtent()[0] == 0 && output->GetExtent()[1] == 15);
  EXR_CHECK(output->GetExtent()[2] == 0 && output->GetExtent()[3] == 9);
  int different = 0;
  for (int y = 0; y <= 9; ++y)
  {
    for (int x = 0; x <= 15; ++x)
    {
      for (int c = 0; c < 2; ++c)
      {
        const bool inside = x <= 8 && y >= 4;
        const float expected = inside ? image->GetScalarComponentAsFloat(x, y, 0, c) : 0.0f;
        different += output->GetScalarComponentAsFloat(x, y, 0, c) == expected ? 0 : 1;
      }
    }
  }
  EXR_CHECK(different == 0);

  // Windows that do not meet at all.
  writer->SetDisplayWindow(1000, 1003, 2000, 2001);
  Write(writer, folder + "display.exr");
  reader->Modified();
  reader->Update();
  EXR_CHECK(reader->GetErrorCode() == vtkErrorCode::NoError);
  EXR_CHECK(reader->GetOutput()->GetNumberOfPoints() == 8);
  EXR_CHECK(reader->GetOutput()->GetScalarRange()[1] == 0.0);
  reader->UseDisplayWindowOff();
  reader->Update();
  EXR_CHECK(SameBits(image, reader->GetOutput()));
}

//------------------------------------------------------------------------------
// The pipeline may ask for a piece of the image.
void SubExtent(const std::string& folder)
{
  auto image = MakeImage({ -10, 89, 5, 204, 0, 0 }, 3);
  for (int compression = 0; compression < 3; ++compression)
  {
    vtkNew<vtkOpenEXRWriter> writer;
    writer->SetInputData(image);
    writer->SetPixelTypeToFloat();
    writer->SetCompression(compression);
    Write(writer, folder + "sub.exr");
    Random random(9);
    for (int i = 0; i < 30; ++i)
    {
      int extent[6] = { -10 + static_cast<int>(random.Below(100)), 0,
        5 + static_cast<int>(random.Below(200)), 0, 0, 0 };
      extent[1] = extent[0] + static_cast<int>(random.Below(static_cast<unsigned>(90 - extent[0])));
      extent[3] =
        extent[2] + static_cast<int>(random.Below(static_cast<unsigned>(205 - extent[2])));
      vtkNew<vtkOpenEXRReader> reader;
      reader->SetFileName((folder + "sub.exr").c_str());
      reader->UpdateExtent(extent);
      vtkNew<vtkImageData> expected;
      expected->DeepCopy(image);
      expected->Crop(extent);
      EXR_CHECK(SameBits(expected, reader->GetOutput()));
    }
  }
}

//------------------------------------------------------------------------------
// A volume is a series of files.
void Series(const std::string& folder)
{
  auto volume = MakeImage({ 0, 7, 0, 5, 3, 6 }, 3);
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetInputData(volume);
  writer->SetPixelTypeToFloat();
  writer->SetFilePrefix((folder + "slice").c_str());
  writer->SetFilePattern("%s_%02d.exr");
  writer->Write();
  EXR_CHECK(writer->GetErrorCode() == vtkErrorCode::NoError);
  EXR_CHECK(CountFiles(folder) == 4);
  EXR_CHECK(std::filesystem::exists(folder + "slice_03.exr"));

  vtkNew<vtkOpenEXRReader> reader;
  reader->SetDataExtent(0, 0, 0, 0, 3, 6);
  reader->SetFilePrefix((folder + "slice").c_str());
  reader->SetFilePattern("%s_%02d.exr");
  reader->Update();
  EXR_CHECK(SameBits(volume, reader->GetOutput()));

  // One slice that differs is an error.
  vtkNew<vtkOpenEXRWriter> other;
  other->SetInputData(MakeImage({ 0, 6, 0, 5, 0, 0 }, 3));
  Write(other, folder + "slice_05.exr");
  reader->Modified();
  ExpectReadError(reader, vtkErrorCode::FileFormatError);
}

//------------------------------------------------------------------------------
void Shapes(const std::string& folder)
{
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

int main(int argc, char* argv[])
{
  return Main(argc, argv,
    { { "RoundTrip", RoundTrip }, { "HalfValues", HalfValues }, { "HalfRounding", HalfRounding },
      { "Range", Range }, { "Layers", Layers }, { "Attributes", Attributes },
      { "Windows", Windows }, { "SubExtent", SubExtent }, { "Series", Series },
      { "Shapes", Shapes } });
}
