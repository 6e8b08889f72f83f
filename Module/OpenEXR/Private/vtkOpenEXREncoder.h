// SPDX-License-Identifier: BSD-3-Clause
// Writes slices of a set of images, one file each.
#ifndef vtkOpenEXREncoder_h
#define vtkOpenEXREncoder_h

#include "vtkOpenEXRConverter.h" // for a member
#include "vtkOpenEXRImageSet.h"  // for the images

#include <ImfCompression.h>
#include <ImfForward.h>

#include <array>   // for windows
#include <cstdint> // for coordinates
#include <map>     // for attributes
#include <string>  // for names

class vtkOpenEXREncoder
{
public:
  struct Settings
  {
    bool UseHalf = true;
    OPENEXR_IMF_NAMESPACE::Compression Compression = OPENEXR_IMF_NAMESPACE::ZIP_COMPRESSION;
    /** First x, last x, first y, last y. An empty window stands for the data window. */
    std::array<int, 4> DisplayWindow = { 0, -1, 0, -1 };
    double PixelAspectRatio = 1.0;
    std::map<std::string, std::string> Attributes;
  };

  /** The images must outlive the encoder. */
  vtkOpenEXREncoder(const vtkOpenEXRImageSet& images, const Settings& settings);

  /** Throws vtkOpenEXRFailure; there is no new file then. */
  void Write(const std::string& fileName, int slice);

  /** How many values were beyond the range, in all files. */
  vtkIdType GetClamped() const { return this->Converter.GetClamped(); }

private:
  bool HasDisplayWindow() const;
  void CheckWindows() const;
  OPENEXR_IMF_NAMESPACE::Header MakeHeader() const;
  void Encode(OPENEXR_IMF_NAMESPACE::OStream& stream, int slice);
  void ConvertRow(vtkDataArray* scalars, vtkIdType first, char* to);
  std::int64_t GetWidth() const;
  std::int64_t GetHeight() const { return this->LastY - this->FirstY + 1; }

  const vtkOpenEXRImageSet& Images;
  const Settings Options;
  vtkOpenEXRConverter Converter;
  // Rows of the file.
  std::int64_t FirstY = 0;
  std::int64_t LastY = -1;
};

#endif
