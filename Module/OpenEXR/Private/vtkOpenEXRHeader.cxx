// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRHeader.h"

#include "vtkErrorCode.h"
#include "vtkOpenEXRFailure.h"
#include "vtkOpenEXRLayout.h"
#include "vtkType.h"

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <ImfTileDescription.h>

#include <algorithm>

namespace exr = OPENEXR_IMF_NAMESPACE;

namespace
{
//------------------------------------------------------------------------------
vtkOpenEXRHeader::Window MakeWindow(const IMATH_NAMESPACE::Box2i& box)
{
  return { box.min.x, box.max.x, box.min.y, box.max.y };
}
}

//------------------------------------------------------------------------------
vtkOpenEXRHeader::vtkOpenEXRHeader(
  const exr::Header& header, int numberOfParts, double maximumBytes)
  : NumberOfParts(numberOfParts)
{
  if (header.type() != exr::SCANLINEIMAGE && header.type() != exr::TILEDIMAGE)
  {
    throw vtkOpenEXRFailure{ vtkErrorCode::FileFormatError,
      "the part is of the type \"" + vtkOpenEXRFailure::OneLine(header.type().c_str()) +
        "\", only flat images are supported." };
  }
  this->Data = MakeWindow(header.dataWindow());
  this->Display = MakeWindow(header.displayWindow());
  this->PixelAspectRatio = header.pixelAspectRatio();
  this->TakeChannels(header);
  this->TakeAttributes(header);
  this->TakeBlocks(header);
  if (this->BytesPerBlock > maximumBytes)
  {
    throw vtkOpenEXRFailure{ vtkErrorCode::FileFormatError,
      "a block of " + std::to_string(this->GetWidth()) + " x " +
        std::to_string(this->RowsPerBlock) + " pixels is larger than MaximumSize allows." };
  }
}

//------------------------------------------------------------------------------
void vtkOpenEXRHeader::TakeChannels(const exr::Header& header)
{
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
  {
    const vtkOpenEXRChannel channel(
      i.name(), i.channel().xSampling != 1 || i.channel().ySampling != 1);
    this->Layers[channel.Layer].push_back(channel);
  }
  for (auto& layer : this->Layers)
  {
    vtkOpenEXRChannel::Sort(layer.second);
  }
}

//------------------------------------------------------------------------------
void vtkOpenEXRHeader::TakeAttributes(const exr::Header& header)
{
  for (auto i = header.begin(); i != header.end(); ++i)
  {
    const auto* text = dynamic_cast<const exr::StringAttribute*>(&i.attribute());
    if (text)
    {
      this->Attributes[i.name()] = text->value();
    }
  }
}

//------------------------------------------------------------------------------
// The library decodes by chunks of all channels, or by rows of tiles.
void vtkOpenEXRHeader::TakeBlocks(const exr::Header& header)
{
  double bytesPerPixel = 0.0;
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i)
  {
    bytesPerPixel += i.channel().type == exr::HALF ? 2.0 : 4.0;
  }
  if (header.type() == exr::TILEDIMAGE)
  {
    const exr::TileDescription& tiles = header.tileDescription();
    const std::int64_t height = this->Data[3] - this->Data[2] + 1;
    this->RowsPerBlock = std::min<std::int64_t>(tiles.ySize, height);
    this->BytesPerBlock = bytesPerPixel * tiles.ySize *
      std::max(static_cast<double>(tiles.xSize), static_cast<double>(this->GetWidth()));
  }
  else
  {
    this->RowsPerBlock = vtkOpenEXRLayout::GetRowsPerChunk(header.compression());
    this->BytesPerBlock =
      bytesPerPixel * static_cast<double>(this->RowsPerBlock * this->GetWidth());
  }
}

//------------------------------------------------------------------------------
const vtkOpenEXRHeader::Channels& vtkOpenEXRHeader::GetLayer(const std::string& name) const
{
  const auto layer = this->Layers.find(name);
  if (layer == this->Layers.end())
  {
    std::string message =
      "it has no " + (name.empty() ? "default layer" : "layer \"" + name + "\"") + "; it has";
    int count = 0;
    for (const auto& other : this->Layers)
    {
      message += count++ ? "," : "";
      if (count > 8)
      {
        message += " ...";
        break;
      }
      message += " \"" + vtkOpenEXRFailure::OneLine(other.first) + "\"";
    }
    throw vtkOpenEXRFailure{ vtkErrorCode::UserError, message + "." };
  }
  for (const vtkOpenEXRChannel& channel : layer->second)
  {
    if (channel.Subsampled)
    {
      throw vtkOpenEXRFailure{ vtkErrorCode::FileFormatError,
        "the channel \"" + vtkOpenEXRFailure::OneLine(channel.FullName) +
          "\" is subsampled, which is not supported." };
    }
  }
  return layer->second;
}

//------------------------------------------------------------------------------
std::array<int, 4> vtkOpenEXRHeader::GetExtent(
  bool useDisplay, std::int64_t slices, std::size_t components, double maximumBytes) const
{
  const Window& window = useDisplay ? this->Display : this->Data;
  const std::int64_t flip = this->GetFlip();
  const Window extent = { window[0], window[1], flip - window[3], flip - window[2] };
  const std::int64_t width = extent[1] - extent[0] + 1;
  const std::int64_t height = extent[3] - extent[2] + 1;
  const double bytes = static_cast<double>(width) * static_cast<double>(height) *
    static_cast<double>(components) * static_cast<double>(std::max<std::int64_t>(slices, 1)) *
    sizeof(float);
  if (bytes > maximumBytes)
  {
    throw vtkOpenEXRFailure{ vtkErrorCode::FileFormatError,
      "an image of " + std::to_string(width) + " x " + std::to_string(height) + " pixels with " +
        std::to_string(components) + " channel(s) is larger than MaximumSize allows." };
  }
  std::array<int, 4> result;
  for (std::size_t i = 0; i < 4; ++i)
  {
    if (extent[i] < VTK_INT_MIN || extent[i] > VTK_INT_MAX)
    {
      throw vtkOpenEXRFailure{ vtkErrorCode::FileFormatError,
        "the data window is too far from the display window." };
    }
    result[i] = static_cast<int>(extent[i]);
  }
  return result;
}

//------------------------------------------------------------------------------
bool vtkOpenEXRHeader::Matches(
  const vtkOpenEXRHeader& other, const std::string& layer, const Channels& channels) const
{
  const auto own = this->Layers.find(layer);
  return own != this->Layers.end() && this->Data == other.Data && this->Display == other.Display &&
    std::equal(own->second.begin(), own->second.end(), channels.begin(), channels.end(),
      [](const vtkOpenEXRChannel& a, const vtkOpenEXRChannel& b)
      { return a.FullName == b.FullName && !a.Subsampled; });
}
