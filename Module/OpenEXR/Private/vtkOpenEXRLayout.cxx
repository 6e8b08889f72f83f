// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRLayout.h"

namespace exr = OPENEXR_IMF_NAMESPACE;

//------------------------------------------------------------------------------
std::int64_t vtkOpenEXRLayout::GetRowsPerChunk(exr::Compression compression)
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
exr::Slice vtkOpenEXRLayout::MakeSlice(exr::PixelType type, void* first, std::int64_t x,
  std::int64_t y, std::size_t xStride, std::size_t yStride)
{
  // The library adds x and y times the strides to a base, which may lie outside of the memory.
  std::intptr_t base = reinterpret_cast<std::intptr_t>(first);
  base -= static_cast<std::intptr_t>(x) * static_cast<std::intptr_t>(xStride);
  base -= static_cast<std::intptr_t>(y) * static_cast<std::intptr_t>(yStride);
  return exr::Slice(type, reinterpret_cast<char*>(base), xStride, yStride);
}
