// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXREncoder.h"

#include "vtkErrorCode.h"
#include "vtkOpenEXRFailure.h"
#include "vtkOpenEXRLayout.h"
#include "vtkOpenEXROutputStream.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <climits>
#include <vector>

namespace exr = OPENEXR_IMF_NAMESPACE;
namespace imath = IMATH_NAMESPACE;

//------------------------------------------------------------------------------
vtkOpenEXREncoder::vtkOpenEXREncoder(const vtkOpenEXRImageSet& images, const Settings& settings)
  : Images(images)
  , Options(settings)
{
  const int* extent = images.GetExtent();
  const auto& display = settings.DisplayWindow;
  const std::int64_t flip = this->HasDisplayWindow()
    ? static_cast<std::int64_t>(display[2]) + display[3]
    : static_cast<std::int64_t>(extent[2]) + extent[3];
  this->FirstY = flip - extent[3];
  this->LastY = flip - extent[2];
}

//------------------------------------------------------------------------------
bool vtkOpenEXREncoder::HasDisplayWindow() const
{
  const auto& display = this->Options.DisplayWindow;
  return display[0] <= display[1] && display[2] <= display[3];
}

//------------------------------------------------------------------------------
std::int64_t vtkOpenEXREncoder::GetWidth() const
{
  const int* extent = this->Images.GetExtent();
  return static_cast<std::int64_t>(extent[1]) - extent[0] + 1;
}

//------------------------------------------------------------------------------
void vtkOpenEXREncoder::Write(const std::string& fileName, int slice)
{
  this->CheckWindows();
  vtkOpenEXROutputStream stream(fileName.c_str());
  if (stream.GetResult() != vtkOpenEXROutputStream::Success)
  {
    throw vtkOpenEXRFailure{ vtkErrorCode::CannotOpenFileError, "the file cannot be created." };
  }
  vtkOpenEXRFailure failure;
  try
  {
    this->Encode(stream, slice);
    // The library has written its table of chunks in the destructor, where it tells no failure.
    stream.Commit();
  }
  catch (...)
  {
    failure = vtkOpenEXRFailure::FromCurrentException(vtkErrorCode::UnknownError);
  }
  switch (stream.GetResult())
  {
    case vtkOpenEXROutputStream::Success:
      break;
    case vtkOpenEXROutputStream::CannotWrite:
      failure = { vtkErrorCode::OutOfDiskSpaceError, "writing failed, perhaps the disk is full." };
      break;
    default:
      failure = { vtkErrorCode::CannotOpenFileError,
        "the complete file cannot be given its name." };
      break;
  }
  if (failure.Code != vtkErrorCode::NoError)
  {
    throw failure;
  }
}

//------------------------------------------------------------------------------
void vtkOpenEXREncoder::CheckWindows() const
{
  const int* extent = this->Images.GetExtent();
  const auto& display = this->Options.DisplayWindow;
  const std::int64_t limit = INT_MAX / 2;
  const std::int64_t corners[] = { extent[0], extent[1], this->FirstY, this->LastY, display[0],
    display[1], display[2], display[3] };
  for (std::int64_t corner : corners)
  {
    if (corner <= -limit || corner >= limit)
    {
      throw vtkOpenEXRFailure{ vtkErrorCode::UserError,
        "the format does not allow coordinates as far out as those of the windows." };
    }
  }
}

//------------------------------------------------------------------------------
exr::Header vtkOpenEXREncoder::MakeHeader() const
{
  const int* extent = this->Images.GetExtent();
  const auto& display = this->Options.DisplayWindow;
  const imath::Box2i dataWindow(imath::V2i(extent[0], static_cast<int>(this->FirstY)),
    imath::V2i(extent[1], static_cast<int>(this->LastY)));
  const imath::Box2i displayWindow = this->HasDisplayWindow()
    ? imath::Box2i(imath::V2i(display[0], display[2]), imath::V2i(display[1], display[3]))
    : dataWindow;
  exr::Header header(displayWindow, dataWindow, static_cast<float>(this->Options.PixelAspectRatio));
  header.compression() = this->Options.Compression;
  for (const vtkOpenEXRImageSet::Image& image : this->Images.GetImages())
  {
    for (const std::string& name : image.Channels)
    {
      header.channels().insert(name, exr::Channel(this->Options.UseHalf ? exr::HALF : exr::FLOAT));
    }
  }
  for (const auto& attribute : this->Options.Attributes)
  {
    header.insert(attribute.first, exr::StringAttribute(attribute.second));
  }
  return header;
}

//------------------------------------------------------------------------------
void vtkOpenEXREncoder::Encode(exr::OStream& stream, int slice)
{
  const exr::PixelType type = this->Options.UseHalf ? exr::HALF : exr::FLOAT;
  const std::size_t valueSize = this->Options.UseHalf ? sizeof(half) : sizeof(float);
  const std::int64_t width = this->GetWidth();
  const std::int64_t height = this->GetHeight();
  const int firstX = this->Images.GetExtent()[0];
  std::size_t valuesPerPixel = 0;
  for (const vtkOpenEXRImageSet::Image& image : this->Images.GetImages())
  {
    valuesPerPixel += image.Channels.size();
  }

  // Some chunks at a time: the rows of all images one after the other.
  const std::size_t rowSize = valuesPerPixel * valueSize * static_cast<std::size_t>(width);
  std::int64_t blockRows = vtkOpenEXRLayout::GetRowsPerChunk(this->Options.Compression);
  blockRows *= std::max<std::int64_t>(
    1, static_cast<std::int64_t>((std::size_t(1) << 20) / rowSize) / blockRows);
  blockRows = std::min(blockRows, height);
  std::vector<char> buffer(rowSize * static_cast<std::size_t>(blockRows));

  exr::OutputFile file(stream, this->MakeHeader());
  for (std::int64_t y0 = this->FirstY; y0 <= this->LastY; y0 += blockRows)
  {
    const std::int64_t rows = std::min(blockRows, this->LastY - y0 + 1);
    exr::FrameBuffer frame;
    char* start = buffer.data();
    for (const vtkOpenEXRImageSet::Image& image : this->Images.GetImages())
    {
      const std::size_t xStride = image.Channels.size() * valueSize;
      const std::size_t yStride = xStride * static_cast<std::size_t>(width);
      for (std::int64_t row = 0; row < rows; ++row)
      {
        const vtkIdType vtkRow = static_cast<vtkIdType>(this->LastY - y0 - row);
        const vtkIdType first =
          (slice * static_cast<vtkIdType>(height) + vtkRow) * static_cast<vtkIdType>(width);
        this->ConvertRow(image.Scalars, first, start + yStride * static_cast<std::size_t>(row));
      }
      for (std::size_t c = 0; c < image.Channels.size(); ++c)
      {
        frame.insert(image.Channels[c],
          vtkOpenEXRLayout::MakeSlice(type, start + c * valueSize, firstX, y0, xStride, yStride));
      }
      start += yStride * static_cast<std::size_t>(blockRows);
    }
    file.setFrameBuffer(frame);
    file.writePixels(static_cast<int>(rows));
  }
}

//------------------------------------------------------------------------------
void vtkOpenEXREncoder::ConvertRow(vtkDataArray* scalars, vtkIdType first, char* to)
{
  const vtkIdType count = static_cast<vtkIdType>(this->GetWidth());
  if (this->Options.UseHalf)
  {
    this->Converter.Convert(scalars, first, count, reinterpret_cast<half*>(to));
  }
  else
  {
    this->Converter.Convert(scalars, first, count, reinterpret_cast<float*>(to));
  }
}
