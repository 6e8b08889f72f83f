// SPDX-License-Identifier: BSD-3-Clause
// From VTK 9.6 on the superclass calls its MemoryBuffer deprecated, which is supported all the
// same.
#define VTK_DEPRECATION_LEVEL 0

#include "vtkOpenEXRReader.h"

#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenEXRDecoder.h"
#include "vtkOpenEXRFailure.h"
#include "vtkOpenEXRFileNames.h"
#include "vtkOpenEXRHeader.h"
#include "vtkOpenEXRInputStream.h"
#include "vtkOpenEXRMaps.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
#include "vtkResourceStream.h"
#endif

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <utility>

//------------------------------------------------------------------------------
class vtkOpenEXRReader::vtkInternals
{
public:
  vtkOpenEXRHeader Header;
  vtkOpenEXRHeader::Channels Channels;
  std::string ErrorPrefix; // of the file of the header
  // Whether the last request for information worked.
  bool Ready = false;

  // Whether there are no files: the bytes come from memory or from VTK's stream.
  static bool HasBytes(vtkOpenEXRReader* self)
  {
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
    if (self->GetStream())
    {
      return true;
    }
#endif
    return self->MemoryBuffer != nullptr;
  }

  // The current file of the reader, or its bytes.
  static std::unique_ptr<vtkOpenEXRInputStream> Open(vtkOpenEXRReader* self)
  {
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
    if (self->GetStream())
    {
      return std::make_unique<vtkOpenEXRInputStream>(self->GetStream()->ToStreambuf());
    }
#endif
    if (self->MemoryBuffer)
    {
      return std::make_unique<vtkOpenEXRInputStream>(
        self->MemoryBuffer, static_cast<std::uint64_t>(self->MemoryBufferLength));
    }
    return std::make_unique<vtkOpenEXRInputStream>(self->InternalFileName);
  }

  static double GetMaximumBytes(vtkOpenEXRReader* self)
  {
    return self->MaximumSize * 1048576.0;
  }
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
// The superclass knows one syntax of patterns or both, by VTK's version, and fits no types.
void vtkOpenEXRReader::ComputeInternalFileName(int slice)
{
  if (this->FileNames || this->FileName)
  {
    this->Superclass::ComputeInternalFileName(slice);
    return;
  }
  delete[] this->InternalFileName;
  this->InternalFileName = nullptr;
  if (!this->FilePattern)
  {
    this->Fail(vtkErrorCode::NoFileNameError, "There is a FilePrefix, but no FilePattern.");
    return;
  }
  try
  {
    const int number = slice * this->FileNameSliceSpacing + this->FileNameSliceOffset;
    const std::string name = vtkOpenEXRFileNames::Make(this->FilePrefix, this->FilePattern, number);
    this->InternalFileName = new char[name.size() + 1]();
    name.copy(this->InternalFileName, name.size());
  }
  catch (const vtkOpenEXRFailure& failure)
  {
    this->Fail(failure.Code, failure.Message);
  }
}

//------------------------------------------------------------------------------
bool vtkOpenEXRReader::ReadFirstHeader()
{
  this->Internals->Header = vtkOpenEXRHeader();
  this->NumberOfParts = 0;
  this->PixelAspectRatio = 1.0;
  for (int i = 0; i < 4; ++i)
  {
    this->DataWindow[i] = this->DisplayWindow[i] = -(i % 2);
  }

  if (!vtkInternals::HasBytes(this))
  {
    // The superclass has a pattern from the start, which means nothing without a prefix.
    const bool series = this->FilePrefix ||
      (this->FilePattern && *this->FilePattern &&
        !vtkOpenEXRFileNames::IsDefault(this->FilePattern));
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
    if (!this->InternalFileName)
    {
      return false;
    }
  }
  if (vtkInternals::HasBytes(this) || this->FileName)
  {
    this->DataExtent[4] = this->DataExtent[5] = 0;
  }

  vtkOpenEXRFailure failure;
  vtkOpenEXRHeader header;
  vtkOpenEXRDecoder file(vtkInternals::Open(this));
  if (!file.Guard(failure,
        [&]() { header = file.ReadHeader(this->Part, vtkInternals::GetMaximumBytes(this)); }))
  {
    this->Fail(failure.Code, failure.Message);
    return false;
  }
  this->NumberOfParts = header.NumberOfParts;
  this->PixelAspectRatio = header.PixelAspectRatio;
  for (int i = 0; i < 4; ++i)
  {
    this->DataWindow[i] = static_cast<int>(header.Data[static_cast<std::size_t>(i)]);
    this->DisplayWindow[i] = static_cast<int>(header.Display[static_cast<std::size_t>(i)]);
  }
  this->Internals->Header = std::move(header);
  this->Internals->ErrorPrefix = file.GetErrorPrefix();
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
  return vtkOpenEXRMaps::GetKey(this->Internals->Header.Layers, index);
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
  return vtkOpenEXRMaps::GetKey(this->Internals->Header.Attributes, index);
}

//------------------------------------------------------------------------------
bool vtkOpenEXRReader::HasAttribute(const std::string& name)
{
  return this->Internals->Header.Attributes.count(name) != 0;
}

//------------------------------------------------------------------------------
std::string vtkOpenEXRReader::GetAttribute(const std::string& name)
{
  return vtkOpenEXRMaps::GetValue(this->Internals->Header.Attributes, name);
}

//------------------------------------------------------------------------------
void vtkOpenEXRReader::ExecuteInformation()
{
  if (!this->ReadFirstHeader())
  {
    return;
  }
  const vtkOpenEXRHeader& header = this->Internals->Header;
  try
  {
    this->Internals->Channels = header.GetLayer(this->Layer);
    const std::int64_t slices =
      static_cast<std::int64_t>(this->DataExtent[5]) - this->DataExtent[4] + 1;
    const std::array<int, 4> extent = header.GetExtent(this->UseDisplayWindow, slices,
      this->Internals->Channels.size(), vtkInternals::GetMaximumBytes(this));
    std::copy(extent.begin(), extent.end(), this->DataExtent);
  }
  catch (const vtkOpenEXRFailure& failure)
  {
    this->Fail(failure.Code, this->Internals->ErrorPrefix + failure.Message);
    return;
  }
  this->DataScalarType = VTK_FLOAT;
  this->NumberOfScalarComponents = static_cast<int>(this->Internals->Channels.size());
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

  const vtkOpenEXRHeader& header = this->Internals->Header;
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
    if (!vtkInternals::HasBytes(this))
    {
      this->ComputeInternalFileName(extent[4] + slice);
      if (!this->InternalFileName)
      {
        return;
      }
    }
    vtkOpenEXRFailure failure;
    vtkOpenEXRDecoder file(vtkInternals::Open(this));
    const bool success = file.Guard(failure,
      [&]()
      {
        const vtkOpenEXRHeader current =
          file.ReadHeader(this->Part, vtkInternals::GetMaximumBytes(this));
        if (!current.Matches(header, this->Layer, this->Internals->Channels))
        {
          throw vtkOpenEXRFailure{ vtkErrorCode::FileFormatError,
            "its windows or channels differ from those of the header read first." };
        }
        file.ReadPixels(this->Part, current, this->Internals->Channels, extent,
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
