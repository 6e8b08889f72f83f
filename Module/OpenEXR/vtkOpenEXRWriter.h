// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenEXRWriter
 * @brief   Writes images to OpenEXR files, losslessly as float or rounded to half.
 *
 * Writes the active point scalars of the input, an image of one slice, of any numeric type and any
 * number of components, as a single-part scanline file. Documentation/openexr.md tells how channels
 * and windows follow from components and the extent. Values are not scaled: they are converted to
 * float, which is rounded to the nearest half (ties to even) for half pixels. NaN and infinity are
 * kept. A finite value beyond the range of the pixel type (+-65504 for half) becomes the largest
 * finite value of its sign, and one vtkWarningMacro reports their number.
 *
 * The file is written beside the final one and renamed when it is complete: after a failure there
 * is no new file, and an existing file is unchanged. (The new file has default permissions. A
 * symbolic link stays, and its target is replaced.)
 *
 * Each failure is reported by exactly one vtkErrorMacro. GetErrorCode then returns one of
 * vtkErrorCode: NoFileNameError (FileName is not set), CannotOpenFileError (the file cannot be
 * created or renamed, or exists and is not a regular file), OutOfDiskSpaceError (writing failed),
 * UserError (no input, no scalars, several slices, layers that do not fit, an extent that the
 * format does not allow), UnknownError (no memory; also if the input could not be updated, which
 * the pipeline has reported).
 *
 * @sa vtkOpenEXRReader
 */

#ifndef vtkOpenEXRWriter_h
#define vtkOpenEXRWriter_h

#include "vtkImageData.h" // For the layers
#include "vtkImageWriter.h"
#include "vtkIndirectOpenEXRModule.h" // For export macro
#include "vtkSmartPointer.h"          // For the layers

#include <map>    // For the layers
#include <string> // For std::string

class VTKINDIRECTOPENEXR_EXPORT vtkOpenEXRWriter : public vtkImageWriter
{
public:
  static vtkOpenEXRWriter* New();
  vtkTypeMacro(vtkOpenEXRWriter, vtkImageWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum PixelTypes
  {
    HalfPixels = 0,
    FloatPixels = 1
  };

  ///@{
  /** The type of all channels in the file, HalfPixels (the default) or FloatPixels. */
  vtkSetClampMacro(PixelType, int, HalfPixels, FloatPixels);
  vtkGetMacro(PixelType, int);
  void SetPixelTypeToHalf() { this->SetPixelType(HalfPixels); }
  void SetPixelTypeToFloat() { this->SetPixelType(FloatPixels); }
  ///@}

  enum CompressionTypes
  {
    NoCompression = 0,
    ZIPCompression = 1,
    PIZCompression = 2
  };

  ///@{
  /**
   * The compression, all of them lossless: NoCompression, ZIPCompression (deflate, the default),
   * PIZCompression (wavelets, often smaller for images with noise).
   */
  vtkSetClampMacro(Compression, int, NoCompression, PIZCompression);
  vtkGetMacro(Compression, int);
  void SetCompressionToNone() { this->SetCompression(NoCompression); }
  void SetCompressionToZIP() { this->SetCompression(ZIPCompression); }
  void SetCompressionToPIZ() { this->SetCompression(PIZCompression); }
  ///@}

  ///@{
  /**
   * Adds an image, which Write writes as the layer of that name (channels "name.R" and so on), with
   * its active point scalars at that time. Replaces an image of the same name. The image must have
   * the dimensions of the input, and the name 1 to 240 characters that neither begin nor end with a
   * dot, or Write fails (UserError).
   */
  void AddLayer(const std::string& name, vtkImageData* image);
  void RemoveAllLayers();
  ///@}

  /** Updates the input and writes the file. */
  void Write() override;

protected:
  vtkOpenEXRWriter() = default;
  ~vtkOpenEXRWriter() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int PixelType = HalfPixels;
  int Compression = ZIPCompression;
  std::map<std::string, vtkSmartPointer<vtkImageData>> Layers;

private:
  vtkOpenEXRWriter(const vtkOpenEXRWriter&) = delete;
  void operator=(const vtkOpenEXRWriter&) = delete;

  void Fail(unsigned long code, std::string message);
};

#endif
