// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRWriter.h"

#include "vtkDataArrayRange.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <list>
#include <vector>

namespace exr = OPENEXR_IMF_NAMESPACE;
namespace fs = std::filesystem;

namespace
{
// Exception that becomes the one error message.
struct WriteFailure
{
  unsigned long Code; // a value of vtkErrorCode
  std::string Message;
};

// The values of one image as written into the file.
struct Values
{
  vtkSmartPointer<vtkFloatArray> Floats;
  std::vector<half> Halves;
};

//------------------------------------------------------------------------------
Values Convert(vtkDataArray* scalars, bool toHalf, vtkIdType& clamped)
{
  const double largest = toHalf ? HALF_MAX : std::numeric_limits<float>::max();
  auto limit = [&](double value)
  {
    const bool beyond = std::isfinite(value) && std::abs(value) > largest;
    clamped += beyond ? 1 : 0;
    return static_cast<float>(beyond ? std::copysign(largest, value) : value);
  };
  // Floats are not copied, so that every NaN keeps its bits.
  Values values{ vtkFloatArray::SafeDownCast(scalars), {} };
  if (!values.Floats)
  {
    values.Floats = vtkSmartPointer<vtkFloatArray>::New();
    values.Floats->SetNumberOfComponents(scalars->GetNumberOfComponents());
    values.Floats->SetNumberOfTuples(scalars->GetNumberOfTuples());
    const auto range = vtk::DataArrayValueRange(scalars);
    std::transform(range.begin(), range.end(), values.Floats->GetPointer(0), limit);
  }
  if (toHalf)
  {
    const vtkIdType count = values.Floats->GetNumberOfValues();
    const float* from = values.Floats->GetPointer(0);
    values.Halves.resize(static_cast<std::size_t>(count));
    std::transform(from, from + count, values.Halves.begin(), limit);
  }
  return values;
}

//------------------------------------------------------------------------------
std::vector<std::string> MakeChannelNames(const std::string& layer, int components)
{
  const std::string prefix = layer.empty() ? layer : layer + ".";
  const std::string letters[] = { "", "Y", "YA", "RGB", "RGBA" };
  const std::size_t digits = std::to_string(components - 1).size();
  std::vector<std::string> names;
  for (int i = 0; i < components; ++i)
  {
    const std::string number = std::to_string(i);
    names.push_back(prefix +
      (components <= 4 ? letters[components].substr(static_cast<std::size_t>(i), 1)
                       : "C" + std::string(digits - number.size(), '0') + number));
  }
  return names;
}

//------------------------------------------------------------------------------
// The scalars of an image, which must have the dimensions of the input.
vtkDataArray* GetScalars(const std::string& layer, vtkImageData* image, vtkImageData* input)
{
  const std::string what = layer.empty() ? "the input" : "the layer \"" + layer + "\"";
  auto require = [&](bool condition, const char* otherwise)
  {
    if (!condition)
    {
      throw WriteFailure{ vtkErrorCode::UserError, what + otherwise };
    }
  };
  require(layer.empty() ||
      (layer.size() <= 240 && layer.find('\0') == std::string::npos && layer.front() != '.' &&
        layer.back() != '.'),
    " has a name that is not valid.");
  require(image && image->GetNumberOfPoints() > 0, " is empty.");
  const int* own = image->GetDimensions();
  require(own[2] == 1, " is a volume, and only one slice can be written.");
  require(std::equal(own, own + 3, input->GetDimensions()),
    " does not have the dimensions of the input.");
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  require(scalars && scalars->GetNumberOfComponents() > 0 &&
      scalars->GetNumberOfTuples() == image->GetNumberOfPoints(),
    " has no numeric point scalars.");
  return scalars;
}

//------------------------------------------------------------------------------
// Writes a new file beside the existing one, which it replaces when it is complete.
void Replace(const char* fileName, const exr::Header& header, const exr::FrameBuffer& frame)
{
  struct Folder
  {
    fs::path Path;
    ~Folder()
    {
      std::error_code error;
      fs::remove_all(this->Path, error);
    }
  };
  std::error_code error;
  fs::path path = fs::u8path(fileName);
  // Replaces the target of a link, not the link.
  for (int i = 0; i < 40 && fs::is_symlink(path, error); ++i)
  {
    path = path.parent_path() / fs::read_symlink(path, error);
  }
  const fs::file_type type = fs::status(path, error).type();
  bool possible = type == fs::file_type::not_found || type == fs::file_type::regular;
  // An own folder: creating it succeeds only if nobody else has it.
  Folder folder;
  for (int i = 0; possible && folder.Path.empty(); ++i)
  {
    const fs::path candidate = fs::path(path) += ".tmp" + std::to_string(i);
    folder.Path = fs::create_directory(candidate, error) ? candidate : fs::path();
    possible = !error;
  }
  std::ofstream file;
  if (possible)
  {
    file.open(folder.Path / path.filename(), std::ios::binary);
  }
  if (!file.is_open())
  {
    throw WriteFailure{ vtkErrorCode::CannotOpenFileError, "the file cannot be created." };
  }
  try
  {
    exr::StdOFStream stream(file, fileName);
    exr::OutputFile output(stream, header);
    output.setFrameBuffer(frame);
    output.writePixels(header.dataWindow().max.y - header.dataWindow().min.y + 1);
  }
  catch (const std::exception&)
  {
    if (!file.fail())
    {
      throw;
    }
  }
  // Closed here, because the library's destructor writes the table of chunks and reports no
  // failure.
  file.close();
  if (file.fail())
  {
    throw WriteFailure{ vtkErrorCode::OutOfDiskSpaceError,
      "writing failed, perhaps the disk is full." };
  }
  fs::rename(folder.Path / path.filename(), path, error);
  if (error)
  {
    throw WriteFailure{ vtkErrorCode::CannotOpenFileError,
      "the complete file cannot be given its name." };
  }
}
}

vtkStandardNewMacro(vtkOpenEXRWriter);

//------------------------------------------------------------------------------
void vtkOpenEXRWriter::AddLayer(const std::string& name, vtkImageData* image)
{
  this->Layers[name] = image;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkOpenEXRWriter::RemoveAllLayers()
{
  this->Layers.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
// SetErrorCode would mark the writer as modified, and Update would write again.
void vtkOpenEXRWriter::Fail(unsigned long code, std::string message)
{
  std::replace_if(
    message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) < 32; }, ' ');
  this->ErrorCode = code;
  vtkErrorMacro(<< "Cannot write \"" << (this->FileName ? this->FileName : "")
                << "\": " << message);
}

//------------------------------------------------------------------------------
void vtkOpenEXRWriter::Write()
{
  if (this->GetNumberOfInputConnections(0) < 1)
  {
    this->Fail(vtkErrorCode::UserError, "there is no input.");
    return;
  }
  // Remains if the input cannot be updated, which the pipeline reports.
  this->ErrorCode = vtkErrorCode::UnknownError;
  this->Superclass::Write();
}

//------------------------------------------------------------------------------
int vtkOpenEXRWriter::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* vtkNotUsed(outputVector))
{
  this->ErrorCode = vtkErrorCode::NoError;
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkIdType clamped = 0;
  try
  {
    if (!this->FileName || !*this->FileName)
    {
      throw WriteFailure{ vtkErrorCode::NoFileNameError, "no FileName was set." };
    }
    auto images = this->Layers;
    if (!images.emplace("", input).second)
    {
      throw WriteFailure{ vtkErrorCode::UserError, "a layer has no name." };
    }
    const bool toHalf = this->PixelType == HalfPixels;
    const exr::PixelType type = toHalf ? exr::HALF : exr::FLOAT;
    const int* extent = input->GetExtent();
    const IMATH_NAMESPACE::Box2i window({ extent[0], extent[2] }, { extent[1], extent[3] });
    const exr::Compression compressions[] = { exr::NO_COMPRESSION, exr::ZIP_COMPRESSION,
      exr::PIZ_COMPRESSION };
    exr::Header header(window, window);
    header.compression() = compressions[this->Compression];
    exr::FrameBuffer frame;
    std::list<Values> all;
    for (const auto& image : images)
    {
      vtkDataArray* scalars = GetScalars(image.first, image.second, input);
      all.push_back(Convert(scalars, toHalf, clamped));
      const auto names = MakeChannelNames(image.first, scalars->GetNumberOfComponents());
      const char* data = toHalf ? reinterpret_cast<const char*>(all.back().Halves.data())
                                : reinterpret_cast<const char*>(all.back().Floats->GetPointer(0));
      const std::size_t size = toHalf ? sizeof(half) : sizeof(float);
      const std::size_t pixel = size * names.size();
      const std::size_t row = pixel * static_cast<std::size_t>(input->GetDimensions()[0]);
      const std::size_t last = row * static_cast<std::size_t>(input->GetDimensions()[1] - 1);
      for (std::size_t c = 0; c < names.size(); ++c)
      {
        header.channels().insert(names[c], exr::Channel(type));
        // Begins at the last row of the input: the stride is negative, modulo the size's range.
        frame.insert(names[c],
          exr::Slice::Make(type, data + last + c * size, window, pixel, std::size_t(0) - row));
      }
    }
    Replace(this->FileName, header, frame);
  }
  catch (const WriteFailure& failure)
  {
    this->Fail(failure.Code, failure.Message);
  }
  catch (const std::bad_alloc&)
  {
    this->Fail(vtkErrorCode::UnknownError, "there is not enough memory.");
  }
  catch (const std::exception& refusal)
  {
    this->Fail(vtkErrorCode::UserError, refusal.what());
  }
  if (clamped > 0 && this->ErrorCode == vtkErrorCode::NoError)
  {
    vtkWarningMacro(<< clamped << " value(s) beyond the range of "
                    << (this->PixelType == HalfPixels ? "half" : "float")
                    << " were clamped to the largest finite value.");
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkOpenEXRWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const compressions[] = { "None", "ZIP", "PIZ" };
  os << indent << "PixelType: " << (this->PixelType == HalfPixels ? "Half" : "Float") << "\n";
  os << indent << "Compression: " << compressions[this->Compression] << "\n";
  os << indent << "Layers: " << this->Layers.size() << "\n";
  for (const auto& layer : this->Layers)
  {
    os << indent.GetNextIndent() << layer.first << ": " << layer.second.Get() << "\n";
  }
}
