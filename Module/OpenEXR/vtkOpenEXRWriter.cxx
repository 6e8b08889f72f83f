// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRWriter.h"

#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkOpenEXRStreams.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <half.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <new>
#include <type_traits>
#include <vector>

namespace exr = OPENEXR_IMF_NAMESPACE;

namespace
{
constexpr double LargestHalf = 65504.0;

//------------------------------------------------------------------------------
// Rounds to odd, so that rounding the result to half is as good as rounding the value to half.
float NarrowForHalf(double value)
{
  float narrow = static_cast<float>(value);
  const double error = value - static_cast<double>(narrow);
  std::uint32_t bits;
  std::memcpy(&bits, &narrow, sizeof(bits));
  if (error != 0.0 && !(bits & 1u))
  {
    // The odd neighbour is on the side of the value. Zero has the smallest float as its neighbour.
    const bool away = (error > 0.0) == (value > 0.0);
    bits = away ? bits + 1u : bits - 1u;
    std::memcpy(&narrow, &bits, sizeof(bits));
  }
  return narrow;
}

//------------------------------------------------------------------------------
// Converts values; counts those that were beyond the range.
class Converter
{
public:
  vtkIdType Clamped = 0;

  void Put(float value, float* to)
  {
    // Copied as bits, so that every NaN stays the same.
    std::memcpy(to, &value, sizeof(value));
  }

  void Put(float value, half* to)
  {
    if (std::abs(value) > static_cast<float>(LargestHalf) && std::isfinite(value))
    {
      ++this->Clamped;
      value = std::copysign(static_cast<float>(LargestHalf), value);
    }
    *to = half(value);
  }

  void Put(double value, float* to)
  {
    constexpr double largest = std::numeric_limits<float>::max();
    if (std::abs(value) > largest && std::isfinite(value))
    {
      ++this->Clamped;
      value = std::copysign(largest, value);
    }
    *to = static_cast<float>(value);
  }

  void Put(double value, half* to)
  {
    if (!std::isfinite(value))
    {
      *to = half(static_cast<float>(value));
      return;
    }
    if (std::abs(value) > LargestHalf)
    {
      ++this->Clamped;
      value = std::copysign(LargestHalf, value);
    }
    *to = half(NarrowForHalf(value));
  }

  template <typename From, typename To>
  void Convert(const From* from, std::size_t count, To* to)
  {
    using Via = typename std::conditional<std::is_same<From, float>::value || sizeof(From) <= 2,
      float, double>::type;
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Put(static_cast<Via>(from[i]), to + i);
    }
  }

  // Any array that offers its values one tuple at a time.
  template <typename To>
  void ConvertTuples(vtkDataArray* from, vtkIdType first, vtkIdType count, To* to)
  {
    std::vector<double> tuple(static_cast<std::size_t>(from->GetNumberOfComponents()));
    for (vtkIdType i = 0; i < count; ++i, to += tuple.size())
    {
      from->GetTuple(first + i, tuple.data());
      this->Convert(tuple.data(), tuple.size(), to);
    }
  }

  template <typename To>
  void ConvertRow(vtkDataArray* from, vtkIdType first, vtkIdType count, To* to)
  {
    if (!from->HasStandardMemoryLayout() || from->GetDataType() == VTK_BIT)
    {
      this->ConvertTuples(from, first, count, to);
      return;
    }
    const vtkIdType components = from->GetNumberOfComponents();
    const void* values = from->GetVoidPointer(first * components);
    const std::size_t size = static_cast<std::size_t>(count * components);
    switch (from->GetDataType())
    {
      vtkTemplateMacro(this->Convert(static_cast<const VTK_TT*>(values), size, to));
      default:
        this->ConvertTuples(from, first, count, to);
    }
  }
};

//------------------------------------------------------------------------------
std::vector<std::string> ChannelNames(int components)
{
  switch (components)
  {
    case 1:
      return { "Y" };
    case 2:
      return { "Y", "A" };
    case 3:
      return { "R", "G", "B" };
    case 4:
      return { "R", "G", "B", "A" };
    default:
      break;
  }
  const std::size_t digits = std::to_string(components - 1).size();
  std::vector<std::string> names;
  for (int i = 0; i < components; ++i)
  {
    std::string number = std::to_string(i);
    names.push_back("C" + std::string(digits - number.size(), '0') + number);
  }
  return names;
}

//------------------------------------------------------------------------------
// Attributes that describe the file itself.
bool IsReserved(const std::string& name)
{
  static const char* const reserved[] = { "channels", "chunkCount", "compression", "dataWindow",
    "displayWindow", "lineOrder", "maxSamplesPerPixel", "multiView", "name", "pixelAspectRatio",
    "preview", "screenWindowCenter", "screenWindowWidth", "tiles", "type", "version" };
  return std::find(std::begin(reserved), std::end(reserved), name) != std::end(reserved);
}

//------------------------------------------------------------------------------
struct ExrImage
{
  vtkSmartPointer<vtkDataArray> Scalars;
  std::vector<std::string> Channels;
};
}

//------------------------------------------------------------------------------
class vtkOpenEXRWriter::vtkInternals
{
public:
  std::map<std::string, vtkSmartPointer<vtkImageData>> Layers;
  std::map<std::string, std::string> Attributes;

  // During a request: the images, and the extent of the first.
  std::vector<ExrImage> Images;
  int Extent[6] = { 0, -1, 0, -1, 0, -1 };
  vtkIdType Clamped = 0;
  bool Executed = false;
};

vtkStandardNewMacro(vtkOpenEXRWriter);

//------------------------------------------------------------------------------
vtkOpenEXRWriter::vtkOpenEXRWriter()
  : Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkOpenEXRWriter::~vtkOpenEXRWriter() = default;

//------------------------------------------------------------------------------
// Not SetErrorCode, which would mark the writer as modified and have it write again on Update.
void vtkOpenEXRWriter::Fail(unsigned long code, const std::string& message)
{
  this->ErrorCode = code;
  vtkErrorMacro(<< message);
}

//------------------------------------------------------------------------------
void vtkOpenEXRWriter::AddLayer(const std::string& name, vtkImageData* image)
{
  if (name.empty() || name.size() > 240 || name.front() == '.' || name.back() == '.' ||
    name.find('\0') != std::string::npos)
  {
    this->Fail(vtkErrorCode::UserError, "AddLayer: the name of the layer is not valid.");
    return;
  }
  if (!image)
  {
    this->Fail(vtkErrorCode::UserError, "AddLayer: there is no image.");
    return;
  }
  this->Internals->Layers[name] = image;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkOpenEXRWriter::RemoveAllLayers()
{
  this->Internals->Layers.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkOpenEXRWriter::GetNumberOfLayers()
{
  return static_cast<int>(this->Internals->Layers.size());
}

//------------------------------------------------------------------------------
std::string vtkOpenEXRWriter::GetLayerName(int index)
{
  if (index < 0 || index >= this->GetNumberOfLayers())
  {
    return std::string();
  }
  return std::next(this->Internals->Layers.begin(), index)->first;
}

//------------------------------------------------------------------------------
void vtkOpenEXRWriter::SetAttribute(const std::string& name, const std::string& value)
{
  if (name.empty() || name.size() > 255 || name.find('\0') != std::string::npos)
  {
    this->Fail(vtkErrorCode::UserError, "SetAttribute: the name of the attribute is not valid.");
    return;
  }
  if (IsReserved(name))
  {
    this->Fail(vtkErrorCode::UserError,
      "SetAttribute: the attribute \"" + name + "\" is used by the format itself.");
    return;
  }
  this->Internals->Attributes[name] = value;
  this->Modified();
}

//------------------------------------------------------------------------------
std::string vtkOpenEXRWriter::GetAttribute(const std::string& name)
{
  const auto found = this->Internals->Attributes.find(name);
  return found == this->Internals->Attributes.end() ? std::string() : found->second;
}

//------------------------------------------------------------------------------
void vtkOpenEXRWriter::RemoveAllAttributes()
{
  this->Internals->Attributes.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkOpenEXRWriter::Write()
{
  this->ErrorCode = vtkErrorCode::NoError;
  if (this->GetNumberOfInputConnections(0) < 1)
  {
    this->Fail(vtkErrorCode::UserError, "Write: there is no input.");
    return;
  }
  this->Internals->Executed = false;
  this->Superclass::Write();
  if (!this->Internals->Executed)
  {
    this->ErrorCode = vtkErrorCode::UnknownError;
  }
}

//------------------------------------------------------------------------------
int vtkOpenEXRWriter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* vtkNotUsed(outputVector))
{
  this->ErrorCode = vtkErrorCode::NoError;
  this->Internals->Executed = true;
  this->Internals->Clamped = 0;
  this->InvokeEvent(vtkCommand::StartEvent);
  this->UpdateProgress(0.0);
  this->WriteImages(vtkImageData::GetData(inputVector[0]));
  this->Internals->Images.clear();
  if (this->Internals->Clamped > 0)
  {
    vtkWarningMacro(<< this->Internals->Clamped << " value(s) beyond the range of "
                    << (this->PixelType == HalfPixels ? "half" : "float")
                    << " were clamped to the largest finite value.");
  }
  this->UpdateProgress(1.0);
  this->InvokeEvent(vtkCommand::EndEvent);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkOpenEXRWriter::WriteImages(vtkImageData* input)
{
  const bool hasName = this->FileName && *this->FileName;
  const bool hasPattern = this->FilePattern && *this->FilePattern &&
    (this->FilePrefix || std::strcmp(this->FilePattern, "%s.%d") != 0);
  if (!hasName && !hasPattern)
  {
    this->Fail(vtkErrorCode::NoFileNameError, "Write: no file name was set.");
    return false;
  }

  // Collect the images.
  std::vector<ExrImage>& images = this->Internals->Images;
  images.clear();
  int* extent = this->Internals->Extent;
  int dimensions[3] = { 0, 0, 0 };
  auto collect = [&](vtkImageData* image, const std::string& layer) -> bool
  {
    const std::string what = layer.empty() ? "the input" : "the layer \"" + layer + "\"";
    int own[3] = { 0, 0, 0 };
    if (image)
    {
      image->GetDimensions(own);
    }
    vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
    if (own[0] < 1 || own[1] < 1 || own[2] < 1)
    {
      this->Fail(vtkErrorCode::UserError, "Write: " + what + " is empty.");
      return false;
    }
    if (layer.empty())
    {
      std::copy(own, own + 3, dimensions);
      image->GetExtent(extent);
    }
    if (!std::equal(own, own + 3, dimensions))
    {
      this->Fail(
        vtkErrorCode::UserError, "Write: " + what + " does not have the dimensions of the input.");
      return false;
    }
    const vtkIdType points =
      static_cast<vtkIdType>(own[0]) * static_cast<vtkIdType>(own[1]) * own[2];
    if (!scalars || scalars->GetNumberOfComponents() < 1 || scalars->GetNumberOfTuples() != points)
    {
      this->Fail(vtkErrorCode::UserError, "Write: " + what + " has no numeric point scalars.");
      return false;
    }
    ExrImage entry;
    entry.Scalars = scalars;
    entry.Channels = ChannelNames(scalars->GetNumberOfComponents());
    for (std::string& name : entry.Channels)
    {
      name = layer.empty() ? name : layer + "." + name;
      if (name.size() > 255)
      {
        this->Fail(
          vtkErrorCode::UserError, "Write: the channel names of " + what + " are too long.");
        return false;
      }
    }
    images.push_back(entry);
    return true;
  };
  if (!collect(input, std::string()))
  {
    return false;
  }
  for (const auto& layer : this->Internals->Layers)
  {
    if (!collect(layer.second, layer.first))
    {
      return false;
    }
  }
  if (hasName && dimensions[2] > 1)
  {
    this->Fail(vtkErrorCode::UserError,
      "Write: a volume needs FilePrefix and FilePattern, since each slice is a file.");
    return false;
  }

  this->MinimumFileNumber = extent[4];
  for (int slice = 0; slice < dimensions[2]; ++slice)
  {
    this->FileNumber = this->MaximumFileNumber = extent[4] + slice;
    std::string fileName = hasName ? this->FileName : "";
    if (!hasName)
    {
      // The pattern has at most one %s and one %d, as for all image writers.
      std::vector<char> buffer(std::strlen(this->FilePattern) +
        (this->FilePrefix ? std::strlen(this->FilePrefix) : 0) + 256);
      if (this->FilePrefix)
      {
        std::snprintf(
          buffer.data(), buffer.size(), this->FilePattern, this->FilePrefix, this->FileNumber);
      }
      else
      {
        std::snprintf(buffer.data(), buffer.size(), this->FilePattern, this->FileNumber);
      }
      fileName = buffer.data();
    }
    if (!this->WriteSlice(fileName, slice))
    {
      return false;
    }
    this->UpdateProgress((slice + 1.0) / dimensions[2]);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkOpenEXRWriter::WriteSlice(const std::string& fileName, int slice)
{
  const std::string prefix = "Cannot write \"" + fileName + "\": ";
  const std::vector<ExrImage>& images = this->Internals->Images;
  const int* extent = this->Internals->Extent;
  const int* display = this->DisplayWindow;
  const bool hasDisplay = display[0] <= display[1] && display[2] <= display[3];

  const std::int64_t flip = hasDisplay ? static_cast<std::int64_t>(display[2]) + display[3]
                                       : static_cast<std::int64_t>(extent[2]) + extent[3];
  const std::int64_t firstY = flip - extent[3];
  const std::int64_t lastY = flip - extent[2];
  const std::int64_t limit = INT_MAX / 2;
  const std::int64_t corners[] = { extent[0], extent[1], firstY, lastY, display[0], display[1],
    display[2], display[3] };
  for (std::int64_t corner : corners)
  {
    if (corner <= -limit || corner >= limit)
    {
      this->Fail(vtkErrorCode::UserError,
        prefix + "the format does not allow coordinates as far out as those of the windows.");
      return false;
    }
  }

  using Box = typename std::decay<decltype(exr::Header().dataWindow())>::type;
  using Point = decltype(Box::min);
  const Box dataWindow(
    Point(extent[0], static_cast<int>(firstY)), Point(extent[1], static_cast<int>(lastY)));
  const Box displayWindow =
    hasDisplay ? Box(Point(display[0], display[2]), Point(display[1], display[3])) : dataWindow;

  unsigned long code = vtkErrorCode::NoError;
  std::string message;
  Converter converter;
  vtkOpenEXROutputStream stream(fileName.c_str());
  if (stream.GetResult() != vtkOpenEXROutputStream::Success)
  {
    this->Fail(vtkErrorCode::CannotOpenFileError, prefix + "the file cannot be created.");
    return false;
  }
  try
  {
    const bool useHalf = this->PixelType == HalfPixels;
    const std::size_t valueSize = useHalf ? sizeof(half) : sizeof(float);
    std::int64_t blockRows = 1;
    exr::Header header(displayWindow, dataWindow, static_cast<float>(this->PixelAspectRatio));
    switch (this->Compression)
    {
      case ZIPCompression:
        header.compression() = exr::ZIP_COMPRESSION;
        blockRows = 16;
        break;
      case PIZCompression:
        header.compression() = exr::PIZ_COMPRESSION;
        blockRows = 32;
        break;
      default:
        header.compression() = exr::NO_COMPRESSION;
        break;
    }
    std::size_t valuesPerPixel = 0;
    for (const ExrImage& image : images)
    {
      for (const std::string& name : image.Channels)
      {
        header.channels().insert(name, exr::Channel(useHalf ? exr::HALF : exr::FLOAT));
      }
      valuesPerPixel += image.Channels.size();
    }
    for (const auto& attribute : this->Internals->Attributes)
    {
      header.insert(attribute.first, exr::StringAttribute(attribute.second));
    }

    // Some chunks at a time: the rows of all images one after the other.
    const std::int64_t width = static_cast<std::int64_t>(extent[1]) - extent[0] + 1;
    const std::int64_t height = lastY - firstY + 1;
    const std::size_t pixelSize = valuesPerPixel * valueSize;
    const std::size_t rowSize = pixelSize * static_cast<std::size_t>(width);
    blockRows *= std::max<std::int64_t>(
      1, static_cast<std::int64_t>((std::size_t(1) << 20) / rowSize) / blockRows);
    blockRows = std::min(blockRows, height);
    std::vector<char> buffer(rowSize * static_cast<std::size_t>(blockRows));

    {
      exr::OutputFile file(stream, header);
      for (std::int64_t y0 = firstY; y0 <= lastY; y0 += blockRows)
      {
        const std::int64_t rows = std::min(blockRows, lastY - y0 + 1);
        exr::FrameBuffer frame;
        std::size_t offset = 0;
        for (const ExrImage& image : images)
        {
          const std::size_t stride = image.Channels.size() * valueSize;
          const std::size_t imageRowSize = stride * static_cast<std::size_t>(width);
          char* start = buffer.data() + offset;
          for (std::int64_t row = 0; row < rows; ++row)
          {
            const vtkIdType vtkRow = static_cast<vtkIdType>(lastY - y0 - row);
            const vtkIdType first =
              (slice * static_cast<vtkIdType>(height) + vtkRow) * static_cast<vtkIdType>(width);
            char* to = start + imageRowSize * static_cast<std::size_t>(row);
            if (useHalf)
            {
              converter.ConvertRow(
                image.Scalars, first, static_cast<vtkIdType>(width), reinterpret_cast<half*>(to));
            }
            else
            {
              converter.ConvertRow(
                image.Scalars, first, static_cast<vtkIdType>(width), reinterpret_cast<float*>(to));
            }
          }
          for (std::size_t c = 0; c < image.Channels.size(); ++c)
          {
            // The library adds x and y times the strides, starting at the corner of the window.
            std::intptr_t base = reinterpret_cast<std::intptr_t>(start + c * valueSize);
            base -= static_cast<std::intptr_t>(extent[0]) * static_cast<std::intptr_t>(stride);
            base -= static_cast<std::intptr_t>(y0) * static_cast<std::intptr_t>(imageRowSize);
            frame.insert(image.Channels[c],
              exr::Slice(useHalf ? exr::HALF : exr::FLOAT, reinterpret_cast<char*>(base), stride,
                imageRowSize));
          }
          offset += imageRowSize * static_cast<std::size_t>(blockRows);
        }
        file.setFrameBuffer(frame);
        file.writePixels(static_cast<int>(rows));
      }
    }
    // The library has written its table of chunks in the destructor, where it tells no failure.
    stream.Commit();
  }
  catch (const std::bad_alloc&)
  {
    code = vtkErrorCode::UnknownError;
    message = "there is not enough memory.";
  }
  catch (const std::exception& e)
  {
    code = vtkErrorCode::UnknownError;
    message = e.what();
    std::replace(message.begin(), message.end(), '\n', ' ');
  }
  switch (stream.GetResult())
  {
    case vtkOpenEXROutputStream::Success:
      break;
    case vtkOpenEXROutputStream::CannotWrite:
      code = vtkErrorCode::OutOfDiskSpaceError;
      message = "writing failed, perhaps the disk is full.";
      break;
    default:
      code = vtkErrorCode::CannotOpenFileError;
      message = "the complete file cannot be given its name.";
      break;
  }
  this->Internals->Clamped += converter.Clamped;
  if (code != vtkErrorCode::NoError)
  {
    this->Fail(code, prefix + message);
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkOpenEXRWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  static const char* const compressions[] = { "None", "ZIP", "PIZ" };
  os << indent << "PixelType: " << (this->PixelType == HalfPixels ? "Half" : "Float") << "\n";
  os << indent << "Compression: " << compressions[this->Compression] << "\n";
  os << indent << "DisplayWindow: (" << this->DisplayWindow[0] << ", " << this->DisplayWindow[1]
     << ", " << this->DisplayWindow[2] << ", " << this->DisplayWindow[3] << ")\n";
  os << indent << "PixelAspectRatio: " << this->PixelAspectRatio << "\n";
  os << indent << "Layers: " << this->GetNumberOfLayers() << "\n";
  for (const auto& layer : this->Internals->Layers)
  {
    os << indent.GetNextIndent() << layer.first << ": " << layer.second.Get() << "\n";
  }
  os << indent << "Attributes: " << this->Internals->Attributes.size() << "\n";
  for (const auto& attribute : this->Internals->Attributes)
  {
    os << indent.GetNextIndent() << attribute.first << ": " << attribute.second << "\n";
  }
}
