// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRReader.h"

#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
#include "vtkResourceStream.h"
#endif

#include <Iex.h>
#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfTestFile.h>
#include <ImfThreading.h>
#include <ImfTileDescription.h>
#include <ImfVersion.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace exr = OPENEXR_IMF_NAMESPACE;

namespace
{
// Exception that becomes the one error message.
struct Failure
{
  unsigned long Code; // a value of vtkErrorCode
  std::string Message;
};

//------------------------------------------------------------------------------
// Source for the OpenEXR library. A read beyond the end throws and is remembered.
class InputStream : public exr::IStream
{
public:
  InputStream(const std::string& name, std::unique_ptr<std::streambuf> buffer)
    : exr::IStream(name.c_str())
    , Buffer(std::move(buffer))
  {
    const std::streamoff size = this->Buffer->pubseekoff(0, std::ios::end, std::ios::in);
    if (size < 0 || this->Buffer->pubseekpos(0, std::ios::in) != std::streampos(0))
    {
      throw Failure{ vtkErrorCode::CannotOpenFileError, "it is not a file that can seek." };
    }
    this->Size = static_cast<std::uint64_t>(size);
  }

  bool read(char c[], int n) override
  {
    if (n < 0 || this->Position > this->Size || this->Buffer->sgetn(c, n) != n)
    {
      this->EndWasHit = true;
      throw IEX_NAMESPACE::InputExc("Unexpected end of file.");
    }
    this->Position += static_cast<std::uint64_t>(n);
    return this->Position < this->Size;
  }

  void seekg(std::uint64_t position) override
  {
    if (position != this->Position && position <= this->Size)
    {
      this->Buffer->pubseekpos(static_cast<std::streamoff>(position), std::ios::in);
    }
    this->Position = position;
  }

  std::uint64_t tellg() override { return this->Position; }
  void clear() override {}

  std::uint64_t Size = 0;
  bool EndWasHit = false;

private:
  std::unique_ptr<std::streambuf> Buffer;
  std::uint64_t Position = 0;
};

//------------------------------------------------------------------------------
// Accepts only regular files: opening a pipe would block, and the format needs seeking.
std::unique_ptr<std::streambuf> OpenBuffer(const char* name)
{
  if (!*name)
  {
    throw Failure{ vtkErrorCode::NoFileNameError, "no FileName was set." };
  }
  std::error_code error;
  const std::filesystem::path path = std::filesystem::u8path(name);
  const std::filesystem::file_type type = std::filesystem::status(path, error).type();
  if (type == std::filesystem::file_type::not_found)
  {
    throw Failure{ vtkErrorCode::FileNotFoundError, "the file does not exist." };
  }
  auto buffer = std::make_unique<std::filebuf>();
  if (type != std::filesystem::file_type::regular ||
    !buffer->open(path, std::ios::in | std::ios::binary))
  {
    throw Failure{ vtkErrorCode::CannotOpenFileError, "it cannot be opened as a file." };
  }
  return buffer;
}

//------------------------------------------------------------------------------
// Walks all headers before the library, which allocates whatever size an attribute claims. The
// library reads most types by their own length: if the size differs, it would take the following
// bytes for attributes of any size. A size beyond the end of the file makes the next read fail.
void CheckHeaders(InputStream& stream)
{
  static const std::map<std::string, std::uint64_t> sizes = { { "box2f", 16 }, { "box2i", 16 },
    { "chromaticities", 32 }, { "compression", 1 }, { "deepImageState", 1 }, { "double", 8 },
    { "envmap", 1 }, { "float", 4 }, { "int", 4 }, { "keycode", 28 }, { "lineOrder", 1 },
    { "m33d", 72 }, { "m33f", 36 }, { "m44d", 128 }, { "m44f", 64 }, { "rational", 8 },
    { "tiledesc", 9 }, { "timecode", 8 }, { "v2d", 16 }, { "v2f", 8 }, { "v2i", 8 }, { "v3d", 24 },
    { "v3f", 12 }, { "v3i", 12 } };
  auto skip = [&](std::uint64_t bytes) { stream.seekg(stream.tellg() + bytes); };
  auto readInt = [&]()
  {
    unsigned char b[4];
    stream.read(reinterpret_cast<char*>(b), 4);
    return b[0] | b[1] << 8 | b[2] << 16 | static_cast<std::uint32_t>(b[3]) << 24;
  };
  auto readText = [&]()
  {
    std::string text; // the library refuses more than 255 characters
    for (char c; text.size() < 256 && (stream.read(&c, 1), c != '\0');)
    {
      text += c;
    }
    return text;
  };

  stream.seekg(4); // behind the magic number
  const bool multiPart = exr::isMultiPart(static_cast<int>(readInt()));
  std::set<std::string> names;
  do
  {
    names.clear();
    for (std::string name = readText(); !name.empty(); name = readText())
    {
      const std::string type = readText();
      const std::uint32_t size = readInt();
      const std::uint64_t end = stream.tellg() + size;
      if (type == "chlist")
      {
        while (!readText().empty())
        {
          skip(16); // type, linearity, sampling
        }
      }
      else if (type == "stringvector")
      {
        while (stream.tellg() < end)
        {
          skip(readInt());
        }
      }
      else
      {
        const auto fixed = sizes.find(type);
        skip(fixed != sizes.end() ? fixed->second : type == "floatvector" ? size / 4 * 4 : size);
      }
      if (stream.tellg() != end || !names.insert(name).second)
      {
        throw IEX_NAMESPACE::InputExc("The header attribute \"" + name +
          "\" is there twice or has a size that does not fit its type.");
      }
    }
  } while (multiPart && !names.empty());
  stream.seekg(0);
}

//------------------------------------------------------------------------------
// The first part with a flat image.
int FindPart(const exr::MultiPartInputFile& file)
{
  for (int part = 0; part < file.parts(); ++part)
  {
    const std::string& type = file.header(part).type();
    if (type == exr::SCANLINEIMAGE || type == exr::TILEDIMAGE)
    {
      return part;
    }
  }
  throw Failure{ vtkErrorCode::FileFormatError,
    "it has no flat image, and deep images are not supported." };
}

//------------------------------------------------------------------------------
// The full names of the channels of each layer in the order of the components.
std::map<std::string, std::vector<std::string>> GetLayers(const exr::ChannelList& channels)
{
  std::map<std::string, std::vector<std::string>> layers;
  for (auto i = channels.begin(); i != channels.end(); ++i)
  {
    const std::string name = i.name();
    const std::size_t dot = name.rfind('.');
    layers[dot == std::string::npos ? "" : name.substr(0, dot)].push_back(name);
  }
  for (auto& layer : layers)
  {
    const std::string prefix = layer.first.empty() ? "" : layer.first + ".";
    // Y is between X and Z in a layer that has these.
    const std::string order = channels.findChannel(prefix + "X") ? "RGBA" : "RGBYA";
    auto rank = [&](const std::string& name)
    { return name.size() == prefix.size() + 1 ? order.find(name.back()) : std::string::npos; };
    std::stable_sort(layer.second.begin(), layer.second.end(),
      [&](const std::string& a, const std::string& b) { return rank(a) < rank(b); });
  }
  return layers;
}

//------------------------------------------------------------------------------
// The extent of the output. Throws if the output or a block of the file is too large.
std::vector<int> GetExtent(const exr::Header& header, std::size_t components, double maximumBytes)
{
  const auto& data = header.dataWindow();
  const auto& display = header.displayWindow();
  const std::int64_t width = static_cast<std::int64_t>(data.max.x) - data.min.x + 1;
  const std::int64_t height = static_cast<std::int64_t>(data.max.y) - data.min.y + 1;
  const std::int64_t flip = static_cast<std::int64_t>(display.min.y) + display.max.y;
  double blockWidth = static_cast<double>(width);
  // The library decodes the rows that a compression combines, or those of tiles, together.
  double blockHeight = std::min(static_cast<double>(height), 256.0);
  if (header.hasTileDescription())
  {
    blockWidth = std::max(blockWidth, static_cast<double>(header.tileDescription().xSize));
    blockHeight = std::max(blockHeight, static_cast<double>(header.tileDescription().ySize));
  }
  double blockBytes = 0.0;
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
  {
    blockBytes += blockWidth * blockHeight * (i.channel().type == exr::HALF ? 2.0 : 4.0);
  }
  const double bytes = static_cast<double>(width) * static_cast<double>(height) *
    static_cast<double>(components * sizeof(float));
  if (std::max(bytes, blockBytes) > maximumBytes || flip - data.max.y < VTK_INT_MIN ||
    flip - data.min.y > VTK_INT_MAX)
  {
    throw Failure{ vtkErrorCode::FileFormatError,
      "its image of " + std::to_string(width) + " x " + std::to_string(height) + " pixels with " +
        std::to_string(components) +
        " channel(s), or a block of it, is larger than MaximumSize allows or too far out." };
  }
  return { data.min.x, data.max.x, static_cast<int>(flip - data.max.y),
    static_cast<int>(flip - data.min.y), 0, 0 };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFloatArray> ReadPixels(exr::MultiPartInputFile& file, int part,
  const std::vector<std::string>& channels, std::size_t prefixLength)
{
  const auto& window = file.header(part).dataWindow();
  const std::size_t height = static_cast<std::size_t>(window.max.y - window.min.y) + 1;
  const std::size_t row =
    (static_cast<std::size_t>(window.max.x - window.min.x) + 1) * channels.size();
  // calloc gets zeroed memory from the system without touching it.
  auto* values = static_cast<float*>(std::calloc(row * height, sizeof(float)));
  if (!values)
  {
    throw std::bad_alloc();
  }
  auto scalars = vtkSmartPointer<vtkFloatArray>::New();
  scalars->SetName("OpenEXRImage");
  scalars->SetNumberOfComponents(static_cast<int>(channels.size()));
  scalars->SetArray(
    values, static_cast<vtkIdType>(row * height), 0, vtkFloatArray::VTK_DATA_ARRAY_FREE);
  exr::FrameBuffer frame;
  for (std::size_t c = 0; c < channels.size(); ++c)
  {
    scalars->SetComponentName(static_cast<vtkIdType>(c), channels[c].substr(prefixLength).c_str());
    // Begins at the last row of the output: the stride is negative, modulo the size's range.
    frame.insert(channels[c],
      exr::Slice::Make(exr::FLOAT, values + (height - 1) * row + c, window,
        channels.size() * sizeof(float), std::size_t(0) - row * sizeof(float)));
  }
  exr::InputPart input(file, part);
  input.setFrameBuffer(frame);
  input.readPixels(window.min.y, window.max.y);
  return scalars;
}
}

vtkStandardNewMacro(vtkOpenEXRReader);

//------------------------------------------------------------------------------
std::string vtkOpenEXRReader::GetLayerName(int index)
{
  const bool has = index >= 0 && index < this->GetNumberOfLayers();
  return has ? this->LayerNames[static_cast<std::size_t>(index)] : std::string();
}

//------------------------------------------------------------------------------
int vtkOpenEXRReader::CanReadFile(const char* fname)
{
  try
  {
    InputStream stream("", OpenBuffer(fname ? fname : ""));
    return exr::isOpenExrFile(stream) ? 3 : 0;
  }
  catch (...)
  {
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkOpenEXRReader::ReadFile(vtkImageData* output)
{
  std::string name = this->FileName ? this->FileName : "";
  std::unique_ptr<InputStream> stream;
  Failure failure;
  try
  {
    std::unique_ptr<std::streambuf> buffer;
    if (this->MemoryBuffer)
    {
      name = "(memory)";
      const auto* bytes = static_cast<const char*>(this->MemoryBuffer);
      buffer = std::make_unique<std::stringbuf>(
        std::string(bytes, bytes + this->MemoryBufferLength), std::ios::in);
    }
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
    if (this->GetStream())
    {
      name = "(stream)";
      buffer = this->GetStream()->ToStreambuf();
    }
#endif
    stream =
      std::make_unique<InputStream>(name, buffer ? std::move(buffer) : OpenBuffer(name.c_str()));
    if (!exr::isOpenExrFile(*stream))
    {
      throw Failure{ vtkErrorCode::UnrecognizedFileTypeError, "it is not an OpenEXR file." };
    }
    CheckHeaders(*stream);
    // A lost chunk table is not reconstructed: a truncated file is an error here.
    exr::MultiPartInputFile file(*stream, exr::globalThreadCount(), false);
    const int part = FindPart(file);
    const exr::Header& header = file.header(part);
    const auto layers = GetLayers(header.channels());
    this->LayerNames.clear();
    std::string known;
    for (const auto& layer : layers)
    {
      this->LayerNames.push_back(layer.first);
      known += (known.empty() ? "\"" : ", \"") + layer.first + "\"";
    }
    const auto found = layers.find(this->Layer);
    if (found == layers.end())
    {
      throw Failure{ vtkErrorCode::UserError,
        "it has no layer \"" + this->Layer + "\"; it has " + known.substr(0, 400) + "." };
    }
    const std::vector<std::string>& channels = found->second;
    for (const std::string& channel : channels)
    {
      const exr::Channel& values = *header.channels().findChannel(channel);
      if (values.xSampling != 1 || values.ySampling != 1)
      {
        throw Failure{ vtkErrorCode::FileFormatError,
          "the channel \"" + channel + "\" is subsampled, which is not supported." };
      }
    }
    const int components = static_cast<int>(channels.size());
    std::vector<int> extent = GetExtent(header, channels.size(), this->MaximumSize * 1048576.0);
    if (!output)
    {
      std::copy(extent.begin(), extent.end(), this->DataExtent);
      this->DataScalarType = VTK_FLOAT;
      this->NumberOfScalarComponents = components;
      return;
    }
    if (!std::equal(extent.begin(), extent.end(), this->DataExtent) ||
      components != this->NumberOfScalarComponents)
    {
      throw Failure{ vtkErrorCode::FileFormatError, "it has changed since its header was read." };
    }
    output->GetPointData()->SetScalars(
      ReadPixels(file, part, channels, this->Layer.empty() ? 0 : this->Layer.size() + 1));
    output->SetExtent(extent.data());
    return;
  }
  catch (const Failure& thrown)
  {
    failure = thrown;
  }
  catch (const std::bad_alloc&)
  {
    failure = { vtkErrorCode::UnknownError, "there is not enough memory." };
  }
  catch (const std::exception& thrown)
  {
    const bool ended = stream && stream->EndWasHit;
    failure = { ended ? vtkErrorCode::PrematureEndOfFileError : vtkErrorCode::FileFormatError,
      (ended ? "the file is truncated or damaged: " : "") + std::string(thrown.what()) };
  }
  // One line, even if the file has control characters in its names.
  std::replace_if(
    failure.Message.begin(), failure.Message.end(),
    [](char c) { return static_cast<unsigned char>(c) < 32; }, ' ');
  // SetErrorCode would mark the reader as modified, and the pipeline would update it again.
  this->ErrorCode = failure.Code;
  vtkErrorMacro(<< "Cannot read \"" << name << "\": " << failure.Message);
}

//------------------------------------------------------------------------------
void vtkOpenEXRReader::ExecuteInformation()
{
  this->LayerNames.clear();
  this->ReadFile(nullptr);
}

//------------------------------------------------------------------------------
int vtkOpenEXRReader::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->ErrorCode = vtkErrorCode::NoError;
  if (!this->Superclass::RequestInformation(request, inputVector, outputVector))
  {
    const int empty[6] = { 0, -1, 0, -1, 0, -1 };
    outputVector->GetInformationObject(0)->Set(
      vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), empty, 6);
  }
  // The reader always makes the whole extent.
  outputVector->GetInformationObject(0)->Remove(CAN_PRODUCE_SUB_EXTENT());
  return 1;
}

//------------------------------------------------------------------------------
int vtkOpenEXRReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  // Otherwise the header's error has been reported.
  if (this->ErrorCode == vtkErrorCode::NoError)
  {
    this->ReadFile(output);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkOpenEXRReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Layer: \"" << this->Layer << "\"\n";
  os << indent << "MaximumSize: " << this->MaximumSize << "\n";
  os << indent << "Layers: " << this->LayerNames.size() << "\n";
}
