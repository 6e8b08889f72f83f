// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpenEXRReader
 * @brief   Reads high-dynamic-range images from OpenEXR files.
 *
 * The output is one vtkImageData with float scalars named "OpenEXRImage", one component for each
 * channel of the selected layer, bottom row first. Documentation/openexr.md lists the supported
 * files, and tells how layers, components and the extent follow from channels and windows.
 * SetMemoryBuffer is supported, and SetStream from VTK 9.6 on; series of files are not.
 *
 * Each failure is reported by exactly one vtkErrorMacro and leaves an empty output. GetErrorCode
 * then returns one of vtkErrorCode: NoFileNameError, FileNotFoundError, CannotOpenFileError (a
 * directory, no permission), UnrecognizedFileTypeError (not OpenEXR), PrematureEndOfFileError
 * (truncated), FileFormatError (damaged, too large, not supported), UserError (no such layer),
 * UnknownError (no memory). The request itself does not fail, so that the pipeline adds no message.
 *
 * @sa vtkOpenEXRWriter
 */

#ifndef vtkOpenEXRReader_h
#define vtkOpenEXRReader_h

#include "vtkImageReader2.h"
#include "vtkIndirectOpenEXRModule.h" // For export macro

#include <string> // For std::string
#include <vector> // For std::vector

class VTKINDIRECTOPENEXR_EXPORT vtkOpenEXRReader : public vtkImageReader2
{
public:
  static vtkOpenEXRReader* New();
  vtkTypeMacro(vtkOpenEXRReader, vtkImageReader2);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The layer to read. The default is "", the channels without a layer name. */
  vtkSetMacro(Layer, std::string);
  vtkGetMacro(Layer, std::string);
  ///@}

  ///@{
  /**
   * Memory limit in MiB for the output, and for the buffer in which one block of the file is
   * decoded. A file that needs more is an error (FileFormatError) before any allocation; headers of
   * damaged files claim any size. Default: 8192, twice the size of an image of 16384 x 16384 pixels
   * with four components, the largest that most graphics hardware shows.
   */
  vtkSetClampMacro(MaximumSize, int, 1, VTK_INT_MAX);
  vtkGetMacro(MaximumSize, int);
  ///@}

  ///@{
  /**
   * The layers of the file after UpdateInformation or Update, the default layer "" first if there
   * is one, the others in alphabetical order. GetLayerName returns "" for an index out of range.
   */
  int GetNumberOfLayers() { return static_cast<int>(this->LayerNames.size()); }
  std::string GetLayerName(int index);
  ///@}

  /** 3 if the file begins with the magic number of OpenEXR, else 0. Reports no error. */
  int CanReadFile(VTK_FILEPATH const char* fname) override;

  const char* GetFileExtensions() override { return ".exr"; }
  const char* GetDescriptiveName() override { return "OpenEXR"; }

protected:
  vtkOpenEXRReader() { this->DataScalarType = VTK_FLOAT; }
  ~vtkOpenEXRReader() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void ExecuteInformation() override;

  std::string Layer;
  int MaximumSize = 8192;
  std::vector<std::string> LayerNames;

private:
  vtkOpenEXRReader(const vtkOpenEXRReader&) = delete;
  void operator=(const vtkOpenEXRReader&) = delete;

  /** Reads the header, and the pixels if there is an output. Reports errors. */
  void ReadFile(vtkImageData* output);
};

#endif
