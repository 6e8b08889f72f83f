// SPDX-License-Identifier: BSD-3-Clause
// How pixels lie in a file, and where the OpenEXR library finds them in memory.
#ifndef vtkOpenEXRLayout_h
#define vtkOpenEXRLayout_h

#include <ImfCompression.h>
#include <ImfFrameBuffer.h>

#include <cstddef> // for strides
#include <cstdint> // for coordinates

namespace vtkOpenEXRLayout
{
/** The rows that a compression puts into one chunk of a scanline file. */
std::int64_t GetRowsPerChunk(OPENEXR_IMF_NAMESPACE::Compression compression);

/** The values of one channel, of which that of the pixel (x, y) of the file is at first. */
OPENEXR_IMF_NAMESPACE::Slice MakeSlice(OPENEXR_IMF_NAMESPACE::PixelType type, void* first,
  std::int64_t x, std::int64_t y, std::size_t xStride, std::size_t yStride);
}

#endif
