// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenEXRWriter
 * @brief   Writes images to OpenEXR files, losslessly as float or rounded to half.
 *
 * Writes the active point scalars of the input, of any numeric type and any number of components,
 * as a single-part scanline file. Values are converted by value, without scaling: to float, or
 * rounded to the nearest half (ties to even). NaN and infinity stay what they are. A finite value
 * beyond the range of the pixel type (+-65504 for half) becomes the largest finite value of its
 * sign, and one vtkWarningMacro tells how many there were.
 *
 * Channels. One component is written as Y, two as Y and A, three as R, G, B, four as R, G, B, A.
 * Other counts are written as C0, C1, ..., with leading zeros where there are more than ten, so
 * that their alphabetical order is that of the components. AddLayer adds images with a layer name,
 * whose channels are called "name.R" and so on.
 *
 * Extent. The extent of the input becomes the data window. OpenEXR counts rows downwards: the point
 * (x, y) becomes the pixel (x, D - y), where D is the sum of the first and the last row of the
 * display window. The display window is the data window unless it is set, and then the window has
 * the numbers of the extent.
 *
 * The file appears under its name when it is complete: it is written beside it with a temporary
 * name and then renamed. After a failure there is no new file, and a file that existed is as it
 * was. (The new file is a new one with default permissions. A symbolic link stays, and its target
 * is replaced.)
 *
 * A volume is written as one file for each slice and needs FilePrefix and FilePattern, in the
 * syntax of printf ("%s_%03d.exr") or of std::format ("{:s}_{:03d}.exr") with any version of VTK;
 * those slices that were written before a failure stay.
 *
 * Errors. Each failure is told by exactly one vtkErrorMacro. GetErrorCode then returns one of
 * vtkErrorCode: NoFileNameError, CannotOpenFileError (the file cannot be created or renamed, or the
 * name is that of something that is not a regular file), OutOfDiskSpaceError (writing failed),
 * UserError (no input, no scalars, layers or a pattern that do not fit), UnknownError (anything
 * else; also where the input could not be updated, which the pipeline has told).
 *
 * @sa vtkOpenEXRReader
 */

#ifndef vtkOpenEXRWriter_h
#define vtkOpenEXRWriter_h

#include "vtkImageWriter.h"
#include "vtkIndirectOpenEXRModule.h" // For export macro

#include <memory> // For std::unique_ptr
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
  /**
   * The type of all channels in the file, HalfPixels (16 bits, the default) or FloatPixels (32
   * bits).
   */
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
   * The compression, all of them lossless: NoCompression, ZIPCompression (the default; deflate, for
   * rendered images), PIZCompression (wavelets, often smaller for images with noise).
   */
  vtkSetClampMacro(Compression, int, NoCompression, PIZCompression);
  vtkGetMacro(Compression, int);
  void SetCompressionToNone() { this->SetCompression(NoCompression); }
  void SetCompressionToZIP() { this->SetCompression(ZIPCompression); }
  void SetCompressionToPIZ() { this->SetCompression(PIZCompression); }
  ///@}

  ///@{
  /**
   * The display window in pixels, rows counted downwards, both ends inclusive: (first x, last x,
   * first y, last y). The default (0, -1, 0, -1), like any empty window, stands for the data
   * window.
   */
  vtkSetVector4Macro(DisplayWindow, int);
  vtkGetVector4Macro(DisplayWindow, int);
  ///@}

  ///@{
  /**
   * Width of a pixel divided by its height, stored in the header. It is not taken from the spacing
   * of the input. Range: 1e-6 to 1e6. Default: 1.
   */
  vtkSetClampMacro(PixelAspectRatio, double, 1e-6, 1e6);
  vtkGetMacro(PixelAspectRatio, double);
  ///@}

  ///@{
  /**
   * Adds an image that is written as the layer of that name, with its current active point scalars
   * when Write is called. It must have the dimensions of the input, or Write fails (UserError). A
   * name that exists is replaced. The name is any text of 1 to 240 characters without NUL that
   * neither begins nor ends with a dot; another name, or no image, is an error (UserError), and
   * nothing is added. The writer holds a reference to the image.
   */
  void AddLayer(const std::string& name, vtkImageData* image);
  void RemoveAllLayers();
  int GetNumberOfLayers();
  ///@}

  /**
   * The name of a layer that was added; they are in alphabetical order. "" for an index out of
   * range.
   */
  std::string GetLayerName(int index);

  ///@{
  /**
   * String attributes of the header, such as "comments" or "owner". A value replaces one that was
   * set before. The name has 1 to 255 characters without NUL; another name, or one that the format
   * itself uses ("channels", "compression", "dataWindow", ...), is an error (UserError), and
   * nothing is set. GetAttribute returns "" for an attribute that was not set.
   */
  void SetAttribute(const std::string& name, const std::string& value);
  std::string GetAttribute(const std::string& name);
  void RemoveAllAttributes();
  ///@}

  /**
   * Updates the input and writes the file.
   */
  void Write() override;

protected:
  vtkOpenEXRWriter();
  ~vtkOpenEXRWriter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int PixelType = HalfPixels;
  int Compression = ZIPCompression;
  int DisplayWindow[4] = { 0, -1, 0, -1 };
  double PixelAspectRatio = 1.0;

private:
  vtkOpenEXRWriter(const vtkOpenEXRWriter&) = delete;
  void operator=(const vtkOpenEXRWriter&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  void Fail(unsigned long code, const std::string& message);
  void WriteImages(vtkImageData* input);
};

#endif
