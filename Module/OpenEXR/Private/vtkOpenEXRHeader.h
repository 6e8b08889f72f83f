// SPDX-License-Identifier: BSD-3-Clause
// What the reader keeps of the header of one part, and whether an image can be made of it.
#ifndef vtkOpenEXRHeader_h
#define vtkOpenEXRHeader_h

#include "vtkOpenEXRChannel.h" // for the layers

#include <ImfForward.h>

#include <array>   // for windows
#include <cstddef> // for counts
#include <cstdint> // for coordinates
#include <map>     // for layers
#include <string>  // for names
#include <vector>  // for channels

struct vtkOpenEXRHeader
{
  using Channels = std::vector<vtkOpenEXRChannel>;
  using Window = std::array<std::int64_t, 4>; // first x, last x, first y, last y

  int NumberOfParts = 0;
  Window Data = { 0, -1, 0, -1 };
  Window Display = { 0, -1, 0, -1 };
  double PixelAspectRatio = 1.0;
  // Rows that are decoded together, and the bytes that takes at most.
  std::int64_t RowsPerBlock = 1;
  double BytesPerBlock = 0.0;
  std::map<std::string, Channels> Layers;
  std::map<std::string, std::string> Attributes;

  vtkOpenEXRHeader() = default;

  /** Throws vtkOpenEXRFailure for a part that is not a flat image, or whose blocks are too large.
   */
  vtkOpenEXRHeader(
    const OPENEXR_IMF_NAMESPACE::Header& header, int numberOfParts, double maximumBytes);

  std::int64_t GetWidth() const { return this->Data[1] - this->Data[0] + 1; }

  /** Row y of the file is row GetFlip() - y of the image. */
  std::int64_t GetFlip() const { return this->Display[2] + this->Display[3]; }

  /** Throws vtkOpenEXRFailure where there is no such layer, or it cannot be read. */
  const Channels& GetLayer(const std::string& name) const;

  /** The image's extent in x and y, of the data window or the display window. Throws
   * vtkOpenEXRFailure where that many slices of it are too large, or the numbers are. */
  std::array<int, 4> GetExtent(
    bool useDisplay, std::int64_t slices, std::size_t components, double maximumBytes) const;

  /** Whether the windows are those of the other one, and the layer can be read as these channels.
   */
  bool Matches(
    const vtkOpenEXRHeader& other, const std::string& layer, const Channels& channels) const;

private:
  void TakeChannels(const OPENEXR_IMF_NAMESPACE::Header& header);
  void TakeAttributes(const OPENEXR_IMF_NAMESPACE::Header& header);
  void TakeBlocks(const OPENEXR_IMF_NAMESPACE::Header& header);
};

#endif
