// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRDecoder.h"

#include "vtkErrorCode.h"
#include "vtkOpenEXRFailure.h"
#include "vtkOpenEXRHeaderCheck.h"
#include "vtkOpenEXRLayout.h"

#include <ImfFrameBuffer.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfThreading.h>

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace exr = OPENEXR_IMF_NAMESPACE;

//------------------------------------------------------------------------------
vtkOpenEXRDecoder::vtkOpenEXRDecoder(std::unique_ptr<vtkOpenEXRInputStream> stream)
  : Stream(std::move(stream))
{
}

//------------------------------------------------------------------------------
vtkOpenEXRDecoder::~vtkOpenEXRDecoder() = default;

//------------------------------------------------------------------------------
vtkOpenEXRHeader vtkOpenEXRDecoder::ReadHeader(int part, double maximumBytes)
{
  if (this->Stream->GetStatus() == vtkOpenEXRInputStream::Missing)
  {
    throw vtkOpenEXRFailure{ vtkErrorCode::FileNotFoundError, "the file does not exist." };
  }
  if (this->Stream->GetStatus() != vtkOpenEXRInputStream::Opened)
  {
    throw vtkOpenEXRFailure{ vtkErrorCode::CannotOpenFileError, "it cannot be opened as a file." };
  }
  if (!this->Stream->HasMagicNumber())
  {
    throw vtkOpenEXRFailure{ vtkErrorCode::UnrecognizedFileTypeError,
      "it is not an OpenEXR file." };
  }
  vtkOpenEXRHeaderCheck::Run(*this->Stream);
  // Without the reconstruction of a lost chunk table: a truncated file is an error here.
  this->File =
    std::make_unique<exr::MultiPartInputFile>(*this->Stream, exr::globalThreadCount(), false);

  const int parts = this->File->parts();
  if (part >= parts)
  {
    throw vtkOpenEXRFailure{ vtkErrorCode::UserError,
      "part " + std::to_string(part) + " was requested, the file has " + std::to_string(parts) +
        " part(s)." };
  }
  return vtkOpenEXRHeader(this->File->header(part), parts, maximumBytes);
}

//------------------------------------------------------------------------------
void vtkOpenEXRDecoder::ReadPixels(int part, const vtkOpenEXRHeader& header,
  const vtkOpenEXRHeader::Channels& channels, const int extent[4], float* output,
  const std::function<bool(double)>& progress)
{
  const std::int64_t flip = header.GetFlip();
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
      frame.insert(channels[c].FullName,
        vtkOpenEXRLayout::MakeSlice(
          exr::FLOAT, buffer.data() + c, header.Data[0], y0, xStride, yStride));
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

//------------------------------------------------------------------------------
bool vtkOpenEXRDecoder::Guard(vtkOpenEXRFailure& failure, const std::function<void()>& code)
{
  try
  {
    code();
    return true;
  }
  catch (...)
  {
    failure = vtkOpenEXRFailure::FromCurrentException(this->Stream->GetEndWasHit()
        ? vtkErrorCode::PrematureEndOfFileError
        : vtkErrorCode::FileFormatError);
  }
  const bool truncated = failure.Code == vtkErrorCode::PrematureEndOfFileError;
  failure.Message = this->GetErrorPrefix() +
    (truncated ? "the file is truncated or damaged: " : "") + failure.Message;
  return false;
}

//------------------------------------------------------------------------------
std::string vtkOpenEXRDecoder::GetErrorPrefix() const
{
  return "Cannot read \"" + std::string(this->Stream->fileName()) + "\": ";
}
