// SPDX-License-Identifier: BSD-3-Clause
// The images that go into one file or one series of files: the input and the layers, which all have
// its dimensions.
#ifndef vtkOpenEXRImageSet_h
#define vtkOpenEXRImageSet_h

#include "vtkDataArray.h"    // for scalars
#include "vtkSmartPointer.h" // for scalars

#include <string> // for names
#include <vector> // for images

class vtkImageData;

class vtkOpenEXRImageSet
{
public:
  struct Image
  {
    vtkSmartPointer<vtkDataArray> Scalars;
    std::vector<std::string> Channels; // as they are called in the file
  };

  /** Adds the input, which is the layer "" and comes first, or a layer. Returns an empty string, or
   * why the image cannot be written. */
  std::string Add(vtkImageData* image, const std::string& layer);

  const std::vector<Image>& GetImages() const { return this->Images; }

  ///@{
  /** Of the input. */
  const int* GetExtent() const { return this->Extent; }
  int GetNumberOfSlices() const { return this->Dimensions[2]; }
  ///@}

private:
  std::vector<Image> Images;
  int Extent[6] = { 0, -1, 0, -1, 0, -1 };
  int Dimensions[3] = { 0, 0, 0 };
};

#endif
