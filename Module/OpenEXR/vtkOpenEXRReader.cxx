// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRReader.h"

#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenEXRStreams.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <Iex.h>
#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <ImfTileDescription.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <map>
#include <new>
#include <utility>
#include <vector>

namespace exr = OPENEXR_IMF_NAMESPACE;

namespace
{
struct ExrChannel
{
  std::string Name;     // within the layer
  std::string FullName; // in the file
  bool Subsampled = false;
};

//------------------------------------------------------------------------------
// What is kept of the header of one part.
struct ExrHeader
{
  int NumberOfParts = 0;
  std::int64_t Data[4] = { 0, -1, 0, -1 };
  std::int64_t Display[4] = { 0, -1, 0, -1 };
  double PixelAspectRatio = 1.0;
  // Rows that are decoded together, and the bytes that takes at most.
  std::int64_t RowsPerBlock = 1;
  double BytesPerBlock = 0.0;
  std::map<std::string, std::vector<ExrChannel>> Layers;
  std::map<std::string, std::string> Attributes;

  std::int64_t GetWidth() const { return this->Data[1] - this->Data[0] + 1; }
};

//------------------------------------------------------------------------------
// A failure on its way to vtkErrorMacro.
struct ExrFailure
{
  unsigned long Code;
  std::string Message;
};

//------------------------------------------------------------------------------
// R, G, B, Y, A come first, so that RGBA and luminance with alpha have their usual order; Y is
// between X and Z where a layer has these.
int ChannelRank(const std::string& name, bool coordinates)
{
  const char* order = coordinates ? "RGBA" : "RGBYA";
  const char* found = name.size() == 1 ? std::strchr(order, name[0]) : nullptr;
  return found ? static_cast<int>(found - order) : 5;
}

//------------------------------------------------------------------------------
void SortChannels(std::vector<ExrChannel>& channels)
{
  const bool coordinates = std::any_of(
    channels.begin(), channels.end(), [](const ExrChannel& c) { return c.Name == "X"; });
  std::sort(channels.begin(), channels.end(),
    [coordinates](const ExrChannel& a, const ExrChannel& b)
    {
      const int rankA = ChannelRank(a.Name, coordinates);
      const int rankB = ChannelRank(b.Name, coordinates);
      return rankA != rankB ? rankA < rankB : a.Name < b.Name;
    });
}

//------------------------------------------------------------------------------
std::string OneLine(const char* what)
{
  std::string text = what;
  for (char& c : text)
  {
    c = static_cast<unsigned char>(c) < 32 ? ' ' : c;
  }
  return text;
}

//------------------------------------------------------------------------------
std::int64_t RowsPerChunk(exr::Compression compression)
{
  switch (compression)
  {
    case exr::NO_COMPRESSION:
    case exr::RLE_COMPRESSION:
    case exr::ZIPS_COMPRESSION:
      return 1;
    case exr::ZIP_COMPRESSION:
    case exr::PXR24_COMPRESSION:
      return 16;
    case exr::PIZ_COMPRESSION:
    case exr::B44_COMPRESSION:
    case exr::B44A_COMPRESSION:
    case exr::DWAA_COMPRESSION:
      return 32;
    default:
      return 256;
  }
}

//------------------------------------------------------------------------------
// One open file. Methods throw ExrFailure, or what the library throws.
class ExrFile
{
public:
  ExrFile(const char* fileName, const void* memory, vtkIdType memorySize)
    : Stream(memory
          ? std::make_unique<vtkOpenEXRInputStream>(memory, static_cast<std::uint64_t>(memorySize))
          : std::make_unique<vtkOpenEXRInputStream>(fileName))
  {
  }

  const char* GetName() const { return this->Stream->fileName(); }
  bool GetEndWasHit() const { return this->Stream->GetEndWasHit(); }

  ExrHeader ReadHeader(int part, double maximumBytes)
  {
    if (this->Stream->GetStatus() == vtkOpenEXRInputStream::Missing)
    {
      throw ExrFailure{ vtkErrorCode::FileNotFoundError, "the file does not exist." };
    }
    if (this->Stream->GetStatus() != vtkOpenEXRInputStream::Opened)
    {
      throw ExrFailure{ vtkErrorCode::CannotOpenFileError, "it cannot be opened as a file." };
    }
    if (!this->Stream->HasMagicNumber())
    {
      throw ExrFailure{ vtkErrorCode::UnrecognizedFileTypeError, "it is not an OpenEXR file." };
    }
    this->Stream->CheckHeaders();
    // Without the reconstruction of a lost chunk table: a truncated file is an error here.
    this->File =
      std::make_unique<exr::MultiPartInputFile>(*this->Stream, exr::globalThreadCount(), false);

    ExrHeader result;
    result.NumberOfParts = this->File->parts();
    if (part >= result.NumberOfParts)
    {
      throw ExrFailure{ vtkErrorCode::UserError,
        "part " + std::to_string(part) + " was requested, the file has " +
          std::to_string(result.NumberOfParts) + " part(s)." };
    }
    const exr::Header& header = this->File->header(part);
    if (header.type() != exr::SCANLINEIMAGE && header.type() != exr::TILEDIMAGE)
    {
      throw ExrFailure{ vtkErrorCode::FileFormatError,
        "the part is of the type \"" + OneLine(header.type().c_str()) +
          "\", only flat images are supported." };
    }

    const auto& data = header.dataWindow();
    const auto& display = header.displayWindow();
    result.Data[0] = data.min.x;
    result.Data[1] = data.max.x;
    result.Data[2] = data.min.y;
    result.Data[3] = data.max.y;
    result.Display[0] = display.min.x;
    result.Display[1] = display.max.x;
    result.Display[2] = display.min.y;
    result.Display[3] = display.max.y;
    result.PixelAspectRatio = header.pixelAspectRatio();

    double bytesPerPixel = 0.0;
    for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
    {
      ExrChannel channel;
      channel.FullName = i.name();
      const std::size_t dot = channel.FullName.rfind('.');
      const bool named = dot != std::string::npos && dot > 0;
      channel.Name = named ? channel.FullName.substr(dot + 1) : channel.FullName;
      channel.Subsampled = i.channel().xSampling != 1 || i.channel().ySampling != 1;
      result.Layers[named ? channel.FullName.substr(0, dot) : std::string()].push_back(channel);
      bytesPerPixel += i.channel().type == exr::HALF ? 2.0 : 4.0;
    }
    for (auto& layer : result.Layers)
    {
      SortChannels(layer.second);
    }
    for (auto i = header.begin(); i != header.end(); ++i)
    {
      const auto* text = dynamic_cast<const exr::StringAttribute*>(&i.attribute());
      if (text)
      {
        result.Attributes[i.name()] = text->value();
      }
    }

    // The library decodes by chunks of all channels, or by rows of tiles.
    const std::int64_t height = result.Data[3] - result.Data[2] + 1;
    if (header.type() == exr::TILEDIMAGE)
    {
      const exr::TileDescription& tiles = header.tileDescription();
      result.RowsPerBlock = std::min<std::int64_t>(tiles.ySize, height);
      result.BytesPerBlock = bytesPerPixel * tiles.ySize *
        std::max(static_cast<double>(tiles.xSize), static_cast<double>(result.GetWidth()));
    }
    else
    {
      result.RowsPerBlock = RowsPerChunk(header.compression());
      result.BytesPerBlock =
        bytesPerPixel * static_cast<double>(result.RowsPerBlock * result.GetWidth());
    }
    if (result.BytesPerBlock > maximumBytes)
    {
      throw ExrFailure{ vtkErrorCode::FileFormatError,
        "a block of " + std::to_string(result.GetWidth()) + " x " +
          std::to_string(result.RowsPerBlock) + " pixels is larger than MaximumSize allows." };
    }
    return result;
  }

  // Reads the rows of the part that the extent needs. Pixels of the extent that the file does not
  // have are left alone. progress(fraction) returns whether to go on.
  template <typename Progress>
  void ReadPixels(int part, const ExrHeader& header, const std::vector<ExrChannel>& channels,
    const int extent[4], float* output, Progress&& progress)
  {
    const std::int64_t flip = header.Display[2] + header.Display[3];
    const std::int64_t firstX = std::max<std::int64_t>(header.Data[0], extent[0]);
    const std::int64_t lastX = std::min<std::int64_t>(header.Data[1], extent[1]);
    const std::int64_t firstY = std::max<std::int64_t>(header.Data[2], flip - extent[3]);
    const std::int64_t lastY = std::min<std::int64_t>(header.Data[3], flip - extent[2]);
    if (firstX > lastX || firstY > lastY)
    {
      return;
    }

    // Whole chunks, and enough of them to be worth the call.
    const std::size_t components = channels.size();
    const std::size_t width = static_cast<std::size_t>(header.GetWidth());
    const std::size_t rowSize = width * components;
    const std::int64_t preferred = static_cast<std::int64_t>((std::size_t(1) << 18) / rowSize);
    const std::int64_t rows =
      header.RowsPerBlock * std::max<std::int64_t>(1, preferred / header.RowsPerBlock);
    const std::int64_t start =
      header.Data[2] + (firstY - header.Data[2]) / header.RowsPerBlock * header.RowsPerBlock;
    const std::int64_t bufferRows = std::min(rows, lastY - start + 1);
    std::vector<float> buffer(rowSize * static_cast<std::size_t>(bufferRows));

    exr::InputPart input(*this->File, part);
    const std::size_t xStride = components * sizeof(float);
    const std::size_t yStride = rowSize * sizeof(float);
    const std::size_t outWidth =
      static_cast<std::size_t>(static_cast<std::int64_t>(extent[1]) - extent[0] + 1);
    for (std::int64_t y0 = start; y0 <= lastY; y0 += rows)
    {
      const std::int64_t y1 = std::min(y0 + rows - 1, lastY);
      exr::FrameBuffer frame;
      for (std::size_t c = 0; c < components; ++c)
      {
        // The library adds x and y times the strides, starting at the corner of the data window.
        std::intptr_t base = reinterpret_cast<std::intptr_t>(buffer.data() + c);
        base -= static_cast<std::intptr_t>(header.Data[0]) * static_cast<std::intptr_t>(xStride);
        base -= static_cast<std::intptr_t>(y0) * static_cast<std::intptr_t>(yStride);
        frame.insert(channels[c].FullName,
          exr::Slice(exr::FLOAT, reinterpret_cast<char*>(base), xStride, yStride));
      }
      input.setFrameBuffer(frame);
      const std::int64_t readFirst = std::max(y0, firstY);
      input.readPixels(static_cast<int>(readFirst), static_cast<int>(y1));
      for (std::int64_t y = readFirst; y <= y1; ++y)
      {
        const float* from = buffer.data() + static_cast<std::size_t>(y - y0) * rowSize +
          static_cast<std::size_t>(firstX - header.Data[0]) * components;
        float* to = output +
          (static_cast<std::size_t>(flip - y - extent[2]) * outWidth +
            static_cast<std::size_t>(firstX - extent[0])) *
            components;
        std::memcpy(
          to, from, static_cast<std::size_t>(lastX - firstX + 1) * components * sizeof(float));
      }
      if (!progress(static_cast<double>(y1 - start + 1) / static_cast<double>(lastY - start + 1)))
      {
        return;
      }
    }
  }

private:
  std::unique_ptr<vtkOpenEXRInputStream> Stream;
  std::unique_ptr<exr::MultiPartInputFile> File;
};

//------------------------------------------------------------------------------
// Runs the code and turns all that it throws into one failure with the name of the file.
template <typename Code>
bool Guard(ExrFile& file, ExrFailure& failure, Code&& code)
{
  try
  {
    code();
    return true;
  }
  catch (const ExrFailure& e)
  {
    failure = e;
  }
  catch (const std::bad_alloc&)
  {
    failure = ExrFailure{ vtkErrorCode::UnknownError, "there is not enough memory." };
  }
  catch (const std::exception& e)
  {
    failure.Code = file.GetEndWasHit()
      ? static_cast<unsigned long>(vtkErrorCode::PrematureEndOfFileError)
      : static_cast<unsigned long>(vtkErrorCode::FileFormatError);
    failure.Message =
      (file.GetEndWasHit() ? "the file is truncated or damaged: " : "") + OneLine(e.what());
  }
  catch (...)
  {
    failure = ExrFailure{ vtkErrorCode::UnknownError, "unknown exception." };
  }
  failure.Message = "Cannot read \"" + std::string(file.GetName()) + "\": " + failure.Message;
  return false;
}
}

//------------------------------------------------------------------------------
class vtkOpenEXRReader::vtkInternals
{
public:
  ExrHeader Header;
  std::vector<ExrChannel> Channels;
  // Whether the last request for information worked.
  bool Ready = false;
};

vtkStandardNewMacro(vtkOpenEXRReader);

//------------------------------------------------------------------------------
vtkOpenEXRReader::vtkOpenEXRReader()
  : Internals(new vtkInternals)
{
  this->DataScalarType = VTK_FLOAT;
}

//------------------------------------------------------------------------------
vtkOpenEXRReader::~vtkOpenEXRReader() = default;

//------------------------------------------------------------------------------
// Not SetErrorCode, which would mark the reader as modified and have the pipeline ask again.
void vtkOpenEXRReader::Fail(unsigned long code, const std::string& message)
{
  this->ErrorCode = code;
  vtkErrorMacro(<< message);
}

//------------------------------------------------------------------------------
int vtkOpenEXRReader::CanReadFile(const char* fname)
{
  if (!fname)
  {
    return 0;
  }
  try
  {
    vtkOpenEXRInputStream stream(fname);
    return stream.HasMagicNumber() ? 3 : 0;
  }
  catch (const std::exception&)
  {
    return 0;
  }
}

//------------------------------------------------------------------------------
bool vtkOpenEXRReader::ReadFirstHeader()
{
  this->Internals->Header = ExrHeader();
  this->NumberOfParts = 0;
  this->PixelAspectRatio = 1.0;
  for (int i = 0; i < 4; ++i)
  {
    this->DataWindow[i] = this->DisplayWindow[i] = -(i % 2);
  }

  if (!this->MemoryBuffer)
  {
    // The superclass has a pattern from the start, which means nothing without a prefix.
    const bool series = this->FilePrefix ||
      (this->FilePattern && *this->FilePattern && std::strcmp(this->FilePattern, "%s.%d") != 0);
    const bool names = this->FileNames && this->FileNames->GetNumberOfValues() > 0;
    if (!names && (this->FileNames || (!(this->FileName && *this->FileName) && !series)))
    {
      this->Fail(vtkErrorCode::NoFileNameError, "No file name was set.");
      return false;
    }
    if (names)
    {
      this->DataExtent[4] = 0;
      this->DataExtent[5] = static_cast<int>(this->FileNames->GetNumberOfValues()) - 1;
    }
    this->ComputeInternalFileName(names || this->FileName ? 0 : this->DataExtent[4]);
  }
  if (this->MemoryBuffer || this->FileName)
  {
    this->DataExtent[4] = this->DataExtent[5] = 0;
  }

  ExrFailure failure{};
  ExrHeader header;
  ExrFile file(this->InternalFileName ? this->InternalFileName : "", this->MemoryBuffer,
    this->MemoryBufferLength);
  if (!Guard(file, failure,
        [&]() { header = file.ReadHeader(this->Part, this->MaximumSize * 1048576.0); }))
  {
    this->Fail(failure.Code, failure.Message);
    return false;
  }
  this->NumberOfParts = header.NumberOfParts;
  this->PixelAspectRatio = header.PixelAspectRatio;
  for (int i = 0; i < 4; ++i)
  {
    this->DataWindow[i] = static_cast<int>(header.Data[i]);
    this->DisplayWindow[i] = static_cast<int>(header.Display[i]);
  }
  this->Internals->Header = std::move(header);
  return true;
}

//------------------------------------------------------------------------------
bool vtkOpenEXRReader::ReadHeader()
{
  this->ErrorCode = vtkErrorCode::NoError;
  return this->ReadFirstHeader();
}

//------------------------------------------------------------------------------
int vtkOpenEXRReader::GetNumberOfLayers()
{
  return static_cast<int>(this->Internals->Header.Layers.size());
}

//------------------------------------------------------------------------------
std::string vtkOpenEXRReader::GetLayerName(int index)
{
  if (index < 0 || index >= this->GetNumberOfLayers())
  {
    return std::string();
  }
  return std::next(this->Internals->Header.Layers.begin(), index)->first;
}

//------------------------------------------------------------------------------
int vtkOpenEXRReader::GetNumberOfChannels()
{
  const auto found = this->Internals->Header.Layers.find(this->Layer);
  return found == this->Internals->Header.Layers.end() ? 0 : static_cast<int>(found->second.size());
}

//------------------------------------------------------------------------------
std::string vtkOpenEXRReader::GetChannelName(int index)
{
  if (index < 0 || index >= this->GetNumberOfChannels())
  {
    return std::string();
  }
  return this->Internals->Header.Layers[this->Layer][static_cast<std::size_t>(index)].Name;
}

//------------------------------------------------------------------------------
int vtkOpenEXRReader::GetNumberOfAttributes()
{
  return static_cast<int>(this->Internals->Header.Attributes.size());
}

//------------------------------------------------------------------------------
std::string vtkOpenEXRReader::GetAttributeName(int index)
{
  if (index < 0 || index >= this->GetNumberOfAttributes())
  {
    return std::string();
  }
  return std::next(this->Internals->Header.Attributes.begin(), index)->first;
}

//------------------------------------------------------------------------------
bool vtkOpenEXRReader::HasAttribute(const std::string& name)
{
  return this->Internals->Header.Attributes.count(name) != 0;
}

//------------------------------------------------------------------------------
std::string vtkOpenEXRReader::GetAttribute(const std::string& name)
{
  const auto found = this->Internals->Header.Attributes.find(name);
  return found == this->Internals->Header.Attributes.end() ? std::string() : found->second;
}

//------------------------------------------------------------------------------
void vtkOpenEXRReader::ExecuteInformation()
{
  if (!this->ReadFirstHeader())
  {
    return;
  }
  const ExrHeader& header = this->Internals->Header;
  const std::string name = this->MemoryBuffer ? "(memory)" : this->InternalFileName;
  const std::string prefix = "Cannot read \"" + name + "\": ";

  const auto layer = header.Layers.find(this->Layer);
  if (layer == header.Layers.end())
  {
    std::string message = prefix + "it has no " +
      (this->Layer.empty() ? "default layer" : "layer \"" + this->Layer + "\"") + "; it has";
    int count = 0;
    for (const auto& other : header.Layers)
    {
      message += count++ ? "," : "";
      if (count > 8)
      {
        message += " ...";
        break;
      }
      message += " \"" + OneLine(other.first.c_str()) + "\"";
    }
    this->Fail(vtkErrorCode::UserError, message + ".");
    return;
  }
  for (const ExrChannel& channel : layer->second)
  {
    if (channel.Subsampled)
    {
      this->Fail(vtkErrorCode::FileFormatError,
        prefix + "the channel \"" + OneLine(channel.FullName.c_str()) +
          "\" is subsampled, which is not supported.");
      return;
    }
  }

  const std::int64_t* window = this->UseDisplayWindow ? header.Display : header.Data;
  const std::int64_t flip = header.Display[2] + header.Display[3];
  const std::int64_t extent[4] = { window[0], window[1], flip - window[3], flip - window[2] };
  const std::int64_t slices =
    static_cast<std::int64_t>(this->DataExtent[5]) - this->DataExtent[4] + 1;
  const double bytes = static_cast<double>(extent[1] - extent[0] + 1) *
    static_cast<double>(extent[3] - extent[2] + 1) * static_cast<double>(layer->second.size()) *
    static_cast<double>(std::max<std::int64_t>(slices, 1)) * sizeof(float);
  if (bytes > this->MaximumSize * 1048576.0)
  {
    this->Fail(vtkErrorCode::FileFormatError,
      prefix + "an image of " + std::to_string(extent[1] - extent[0] + 1) + " x " +
        std::to_string(extent[3] - extent[2] + 1) + " pixels with " +
        std::to_string(layer->second.size()) + " channel(s) is larger than MaximumSize allows.");
    return;
  }
  for (int i = 0; i < 4; ++i)
  {
    if (extent[i] < VTK_INT_MIN || extent[i] > VTK_INT_MAX)
    {
      this->Fail(vtkErrorCode::FileFormatError,
        prefix + "the data window is too far from the display window.");
      return;
    }
    this->DataExtent[i] = static_cast<int>(extent[i]);
  }
  this->DataScalarType = VTK_FLOAT;
  this->NumberOfScalarComponents = static_cast<int>(layer->second.size());
  this->Internals->Channels = layer->second;
  this->Internals->Ready = true;
}

//------------------------------------------------------------------------------
int vtkOpenEXRReader::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->ErrorCode = vtkErrorCode::NoError;
  this->Internals->Ready = false;
  if (!this->Superclass::RequestInformation(request, inputVector, outputVector))
  {
    const int empty[6] = { 0, -1, 0, -1, 0, -1 };
    outputVector->GetInformationObject(0)->Set(
      vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), empty, 6);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkOpenEXRReader::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->Internals->Ready)
  {
    // Already told.
    vtkImageData::GetData(outputVector)->Initialize();
    return 1;
  }
  this->ErrorCode = vtkErrorCode::NoError;
  this->Superclass::RequestData(request, inputVector, outputVector);
  return 1;
}

//------------------------------------------------------------------------------
void vtkOpenEXRReader::ExecuteDataWithInformation(vtkDataObject* output, vtkInformation* outInfo)
{
  vtkImageData* image = vtkImageData::SafeDownCast(output);
  image->Initialize();
  int extent[6];
  outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  if (extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5])
  {
    return;
  }

  const ExrHeader& header = this->Internals->Header;
  const std::size_t components = this->Internals->Channels.size();
  const std::int64_t width = static_cast<std::int64_t>(extent[1]) - extent[0] + 1;
  const std::int64_t height = static_cast<std::int64_t>(extent[3]) - extent[2] + 1;
  const std::size_t sliceSize = static_cast<std::size_t>(width * height) * components;
  const int slices = extent[5] - extent[4] + 1;
  const std::size_t size = sliceSize * static_cast<std::size_t>(slices);
  // Zeros, which the system hands out without touching the memory.
  auto* values = static_cast<float*>(std::calloc(size, sizeof(float)));
  if (!values)
  {
    this->Fail(vtkErrorCode::UnknownError,
      "There is not enough memory for an image of " + std::to_string(size) + " values.");
    return;
  }
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("OpenEXRImage");
  scalars->SetNumberOfComponents(static_cast<int>(components));
  scalars->SetArray(values, static_cast<vtkIdType>(size), 0, vtkFloatArray::VTK_DATA_ARRAY_FREE);

  for (int slice = 0; slice < slices; ++slice)
  {
    if (!this->MemoryBuffer)
    {
      this->ComputeInternalFileName(extent[4] + slice);
    }
    ExrFailure failure{};
    ExrFile file(this->InternalFileName ? this->InternalFileName : "", this->MemoryBuffer,
      this->MemoryBufferLength);
    const bool success = Guard(file, failure,
      [&]()
      {
        const ExrHeader current = file.ReadHeader(this->Part, this->MaximumSize * 1048576.0);
        const auto layer = current.Layers.find(this->Layer);
        bool same = layer != current.Layers.end() && layer->second.size() == components &&
          std::equal(current.Data, current.Data + 4, header.Data) &&
          std::equal(current.Display, current.Display + 4, header.Display);
        for (std::size_t c = 0; same && c < components; ++c)
        {
          same = layer->second[c].FullName == this->Internals->Channels[c].FullName &&
            !layer->second[c].Subsampled;
        }
        if (!same)
        {
          throw ExrFailure{ vtkErrorCode::FileFormatError,
            "its windows or channels differ from those of the header read first." };
        }
        file.ReadPixels(this->Part, current, layer->second, extent,
          values + sliceSize * static_cast<std::size_t>(slice),
          [&](double fraction)
          {
            this->UpdateProgress((slice + fraction) / slices);
            return !this->AbortExecute;
          });
      });
    if (!success)
    {
      this->Fail(failure.Code, failure.Message);
      return;
    }
    if (this->AbortExecute)
    {
      return;
    }
  }
  image->SetExtent(extent);
  image->GetPointData()->SetScalars(scalars);
}

//------------------------------------------------------------------------------
void vtkOpenEXRReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Layer: \"" << this->Layer << "\"\n";
  os << indent << "Part: " << this->Part << "\n";
  os << indent << "UseDisplayWindow: " << (this->UseDisplayWindow ? "On" : "Off") << "\n";
  os << indent << "MaximumSize: " << this->MaximumSize << "\n";
  os << indent << "NumberOfParts: " << this->NumberOfParts << "\n";
  os << indent << "DataWindow: (" << this->DataWindow[0] << ", " << this->DataWindow[1] << ", "
     << this->DataWindow[2] << ", " << this->DataWindow[3] << ")\n";
  os << indent << "DisplayWindow: (" << this->DisplayWindow[0] << ", " << this->DisplayWindow[1]
     << ", " << this->DisplayWindow[2] << ", " << this->DisplayWindow[3] << ")\n";
  os << indent << "PixelAspectRatio: " << this->PixelAspectRatio << "\n";
  os << indent << "Layers: " << this->GetNumberOfLayers() << "\n";
  for (int i = 0; i < this->GetNumberOfLayers(); ++i)
  {
    os << indent.GetNextIndent() << "\"" << this->GetLayerName(i) << "\"\n";
  }
  os << indent << "Channels: " << this->GetNumberOfChannels() << "\n";
  for (int i = 0; i < this->GetNumberOfChannels(); ++i)
  {
    os << indent.GetNextIndent() << this->GetChannelName(i) << "\n";
  }
  os << indent << "Attributes: " << this->GetNumberOfAttributes() << "\n";
  for (const auto& attribute : this->Internals->Header.Attributes)
  {
    os << indent.GetNextIndent() << attribute.first << ": " << attribute.second << "\n";
  }
}
