// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRWriter.h"

#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkOpenEXREncoder.h"
#include "vtkOpenEXRFailure.h"
#include "vtkOpenEXRFileNames.h"
#include "vtkOpenEXRImageSet.h"
#include "vtkOpenEXRMaps.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace
{
//------------------------------------------------------------------------------
// Attributes that describe the file itself.
bool IsReserved(const std::string& name)
{
  static const char* const reserved[] = { "channels", "chunkCount", "compression", "dataWindow",
    "displayWindow", "lineOrder", "maxSamplesPerPixel", "multiView", "name", "pixelAspectRatio",
    "preview", "screenWindowCenter", "screenWindowWidth", "tiles", "type", "version" };
  return std::find(std::begin(reserved), std::end(reserved), name) != std::end(reserved);
}
}

//------------------------------------------------------------------------------
class vtkOpenEXRWriter::vtkInternals
{
public:
  std::map<std::string, vtkSmartPointer<vtkImageData>> Layers;
  std::map<std::string, std::string> Attributes;

  // During a request.
  vtkIdType Clamped = 0;
  bool Executed = false;

  vtkOpenEXREncoder::Settings GetSettings(vtkOpenEXRWriter* self) const
  {
    vtkOpenEXREncoder::Settings settings;
    settings.UseHalf = self->PixelType == HalfPixels;
    settings.Compression = self->Compression == ZIPCompression
      ? OPENEXR_IMF_NAMESPACE::ZIP_COMPRESSION
      : self->Compression == PIZCompression ? OPENEXR_IMF_NAMESPACE::PIZ_COMPRESSION
                                            : OPENEXR_IMF_NAMESPACE::NO_COMPRESSION;
    std::copy(self->DisplayWindow, self->DisplayWindow + 4, settings.DisplayWindow.begin());
    settings.PixelAspectRatio = self->PixelAspectRatio;
    settings.Attributes = this->Attributes;
    return settings;
  }
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
  return vtkOpenEXRMaps::GetKey(this->Internals->Layers, index);
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
  return vtkOpenEXRMaps::GetValue(this->Internals->Attributes, name);
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
void vtkOpenEXRWriter::WriteImages(vtkImageData* input)
{
  const bool hasName = this->FileName && *this->FileName;
  const bool hasPattern = this->FilePattern && *this->FilePattern &&
    (this->FilePrefix || !vtkOpenEXRFileNames::IsDefault(this->FilePattern));
  if (!hasName && !hasPattern)
  {
    this->Fail(vtkErrorCode::NoFileNameError, "Write: no file name was set.");
    return;
  }

  vtkOpenEXRImageSet images;
  std::string reason = images.Add(input, std::string());
  for (const auto& layer : this->Internals->Layers)
  {
    reason = reason.empty() ? images.Add(layer.second, layer.first) : reason;
  }
  const int slices = images.GetNumberOfSlices();
  if (reason.empty() && hasName && slices > 1)
  {
    reason = "a volume needs FilePrefix and FilePattern, since each slice is a file.";
  }
  if (!reason.empty())
  {
    this->Fail(vtkErrorCode::UserError, "Write: " + reason);
    return;
  }

  vtkOpenEXREncoder encoder(images, this->Internals->GetSettings(this));
  const int first = images.GetExtent()[4];
  this->MinimumFileNumber = first;
  for (int slice = 0; slice < slices; ++slice)
  {
    this->FileNumber = this->MaximumFileNumber = first + slice;
    std::string cannot = "Write: ";
    try
    {
      const std::string fileName = hasName
        ? this->FileName
        : vtkOpenEXRFileNames::Make(this->FilePrefix, this->FilePattern, this->FileNumber);
      cannot = "Cannot write \"" + fileName + "\": ";
      encoder.Write(fileName, slice);
    }
    catch (const vtkOpenEXRFailure& failure)
    {
      this->Fail(failure.Code, cannot + failure.Message);
      break;
    }
    this->UpdateProgress((slice + 1.0) / slices);
  }
  this->Internals->Clamped = encoder.GetClamped();
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
