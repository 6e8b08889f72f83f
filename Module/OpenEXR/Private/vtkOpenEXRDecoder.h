// SPDX-License-Identifier: BSD-3-Clause
// One open file: its headers and its pixels.
#ifndef vtkOpenEXRDecoder_h
#define vtkOpenEXRDecoder_h

#include "vtkOpenEXRHeader.h"      // for the channels
#include "vtkOpenEXRInputStream.h" // for the file

#include <ImfForward.h>

#include <functional> // for progress
#include <memory>     // for std::unique_ptr
#include <string>     // for messages

struct vtkOpenEXRFailure;

class vtkOpenEXRDecoder
{
public:
  explicit vtkOpenEXRDecoder(std::unique_ptr<vtkOpenEXRInputStream> stream);
  ~vtkOpenEXRDecoder();

  ///@{
  /** What follows throws vtkOpenEXRFailure, or what the library throws; call it in Guard. */
  vtkOpenEXRHeader ReadHeader(int part, double maximumBytes);

  /** Reads the rows of the part that the extent needs. Pixels of the extent that the file does not
   * have are left alone. progress(fraction) returns whether to go on. */
  void ReadPixels(int part, const vtkOpenEXRHeader& header,
    const vtkOpenEXRHeader::Channels& channels, const int extent[4], float* output,
    const std::function<bool(double)>& progress);
  ///@}

  /** Runs the code and turns all that it throws into one failure with the name of the file. */
  bool Guard(vtkOpenEXRFailure& failure, const std::function<void()>& code);

  /** "Cannot read "...": " */
  std::string GetErrorPrefix() const;

private:
  std::unique_ptr<vtkOpenEXRInputStream> Stream;
  std::unique_ptr<OPENEXR_IMF_NAMESPACE::MultiPartInputFile> File;
};

#endif
