// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenEXRReader
 * @brief   Reads high-dynamic-range images from OpenEXR files.
 *
 * The output is one vtkImageData with float scalars named "OpenEXRImage", one component for each
 * channel of the selected layer, bottom row first. Half, float and unsigned integer channels are
 * read; values are not scaled, and NaN and infinity pass through. Scanline and tiled files (of the
 * latter the full resolution), single-part and multi-part files, and all compressions that the
 * OpenEXR library knows are supported. Deep images and subsampled channels are not.
 *
 * Channels. A channel name is split at its last dot: "rsm0.depth.Y" is channel "Y" of the layer
 * "rsm0.depth", a name without a dot belongs to the default layer "". The components of the output
 * are R, G, B, Y, A in this order, as far as the layer has them, followed by its other channels in
 * alphabetical order (so that X, Y, Z come as such).
 *
 * Extent. OpenEXR counts rows downwards and places the pixels that are stored (the data window)
 * relative to the picture (the display window); both may have negative coordinates. Pixel (x, y) of
 * the file becomes point (x, D - y) of the output, where D is the sum of the first and the last row
 * of the display window. The extent of the output is the data window seen that way. Where both
 * windows are the same, its numbers are those of the data window; in general, images that share a
 * display window stay registered to each other. With UseDisplayWindow the extent is the display
 * window, and 0 where the file has no pixel. Spacing, origin and direction are those set with the
 * methods of the superclass; the pixel aspect ratio is not applied to them.
 *
 * Errors. Each failure is told by exactly one vtkErrorMacro and leaves an empty output.
 * GetErrorCode then returns one of vtkErrorCode: NoFileNameError, FileNotFoundError,
 * CannotOpenFileError (a directory, no permission), UnrecognizedFileTypeError (not OpenEXR),
 * PrematureEndOfFileError (truncated), FileFormatError (damaged, too large, not supported),
 * UserError (no such layer or part, a pattern that does not fit), UnknownError (no memory). The
 * request itself does not fail, so that the pipeline adds no message of its own.
 *
 * Series of files (FileNames, or FilePrefix and FilePattern) make one slice each; all must have the
 * data window and the channels of the first. FilePattern has the syntax of printf ("%s_%03d.exr")
 * or of std::format ("{:s}_{:03d}.exr") with any version of VTK. SetMemoryBuffer is supported, and
 * SetStream where VTK has it (from 9.6 on).
 *
 * @sa vtkOpenEXRWriter
 */

#ifndef vtkOpenEXRReader_h
#define vtkOpenEXRReader_h

#include "vtkImageReader2.h"
#include "vtkIndirectOpenEXRModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class VTKINDIRECTOPENEXR_EXPORT vtkOpenEXRReader : public vtkImageReader2
{
public:
  static vtkOpenEXRReader* New();
  vtkTypeMacro(vtkOpenEXRReader, vtkImageReader2);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The layer to read. The default is "", the channels without a layer name. A layer that the file
   * does not have is an error (UserError) when the reader updates.
   */
  vtkSetMacro(Layer, std::string);
  vtkGetMacro(Layer, std::string);
  ///@}

  ///@{
  /**
   * The part of a multi-part file to read, from 0 (the default) to GetNumberOfParts() - 1. A part
   * that the file does not have is an error (UserError).
   */
  vtkSetClampMacro(Part, int, 0, VTK_INT_MAX);
  vtkGetMacro(Part, int);
  ///@}

  ///@{
  /**
   * Whether the output covers the display window, with 0 where the file has no pixel, rather than
   * the data window. Pixels outside of the display window are then dropped. Default: off.
   */
  vtkSetMacro(UseDisplayWindow, bool);
  vtkGetMacro(UseDisplayWindow, bool);
  vtkBooleanMacro(UseDisplayWindow, bool);
  ///@}

  ///@{
  /**
   * The most memory in MiB that the output, or the buffer in which one block of the file is
   * decoded, may take. A file that asks for more is an error (FileFormatError) before anything is
   * allocated; headers of damaged files claim any size. Range: 1 to VTK_INT_MAX. Default: 8192,
   * twice what an image of 16384 x 16384 pixels with four components takes, the largest that most
   * graphics hardware can show.
   */
  vtkSetClampMacro(MaximumSize, int, 1, VTK_INT_MAX);
  vtkGetMacro(MaximumSize, int);
  ///@}

  /**
   * Reads the header (of the first file, if there are several) now, independent of the pipeline and
   * of Layer, so that the getters below can be used to choose a layer. Returns whether that worked;
   * if not, an error has been told and GetErrorCode says which. The pipeline reads the header
   * itself; the getters below are valid after UpdateInformation or Update as well.
   */
  virtual bool ReadHeader();

  ///@{
  /**
   * How many parts the file has, 1 for a single-part file; 0 before a header was read.
   */
  vtkGetMacro(NumberOfParts, int);
  ///@}

  ///@{
  /**
   * The layers of the part, the default layer "" first if the part has one, the others in
   * alphabetical order. GetLayerName returns "" for an index out of range.
   */
  int GetNumberOfLayers();
  std::string GetLayerName(int index);
  ///@}

  ///@{
  /**
   * The channels of the selected layer in the order of the components of the output, without the
   * name of the layer. There are none if the part does not have the layer. GetChannelName returns
   * "" for an index out of range.
   */
  int GetNumberOfChannels();
  std::string GetChannelName(int index);
  ///@}

  ///@{
  /**
   * The attributes of the part's header whose type is string, in alphabetical order.
   * GetAttributeName returns "" for an index out of range, GetAttribute returns "" for an attribute
   * that the header does not have.
   */
  int GetNumberOfAttributes();
  std::string GetAttributeName(int index);
  bool HasAttribute(const std::string& name);
  std::string GetAttribute(const std::string& name);
  ///@}

  ///@{
  /**
   * The data window and the display window as they are in the file, in pixels, rows counted
   * downwards, both ends inclusive: (first x, last x, first y, last y). (0, -1, 0, -1) before a
   * header was read.
   */
  vtkGetVector4Macro(DataWindow, int);
  vtkGetVector4Macro(DisplayWindow, int);
  ///@}

  ///@{
  /**
   * Width of a pixel divided by its height. 1 before a header was read.
   */
  vtkGetMacro(PixelAspectRatio, double);
  ///@}

  /**
   * Returns 3 if the file begins with the magic number of OpenEXR, else 0. Tells no error.
   */
  int CanReadFile(VTK_FILEPATH const char* fname) override;

  /**
   * Finds the name of the file of a slice. A pattern that does not fit is an error (UserError), and
   * InternalFileName is then null.
   */
  void ComputeInternalFileName(int slice) override;

  /**
   * ".exr"
   */
  const char* GetFileExtensions() override { return ".exr"; }

  /**
   * "OpenEXR"
   */
  const char* GetDescriptiveName() override { return "OpenEXR"; }

protected:
  vtkOpenEXRReader();
  ~vtkOpenEXRReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void ExecuteInformation() override;
  void ExecuteDataWithInformation(vtkDataObject* data, vtkInformation* outInfo) override;

  std::string Layer;
  int Part = 0;
  bool UseDisplayWindow = false;
  int MaximumSize = 8192;

  int NumberOfParts = 0;
  int DataWindow[4] = { 0, -1, 0, -1 };
  int DisplayWindow[4] = { 0, -1, 0, -1 };
  double PixelAspectRatio = 1.0;

private:
  vtkOpenEXRReader(const vtkOpenEXRReader&) = delete;
  void operator=(const vtkOpenEXRReader&) = delete;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  void Fail(unsigned long code, const std::string& message);
  bool ReadFirstHeader();
};

#endif
