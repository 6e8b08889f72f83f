// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRImageSet.h"

#include "vtkImageData.h"
#include "vtkOpenEXRChannel.h"
#include "vtkPointData.h"

#include <algorithm>

//------------------------------------------------------------------------------
std::string vtkOpenEXRImageSet::Add(vtkImageData* image, const std::string& layer)
{
  const std::string what = layer.empty() ? "the input" : "the layer \"" + layer + "\"";
  int own[3] = { 0, 0, 0 };
  if (image)
  {
    image->GetDimensions(own);
  }
  if (own[0] < 1 || own[1] < 1 || own[2] < 1)
  {
    return what + " is empty.";
  }
  if (layer.empty())
  {
    std::copy(own, own + 3, this->Dimensions);
    image->GetExtent(this->Extent);
  }
  if (!std::equal(own, own + 3, this->Dimensions))
  {
    return what + " does not have the dimensions of the input.";
  }
  const vtkIdType points = static_cast<vtkIdType>(own[0]) * static_cast<vtkIdType>(own[1]) * own[2];
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfComponents() < 1 || scalars->GetNumberOfTuples() != points)
  {
    return what + " has no numeric point scalars.";
  }
  Image entry;
  entry.Scalars = scalars;
  entry.Channels = vtkOpenEXRChannel::MakeFullNames(layer, scalars->GetNumberOfComponents());
  for (const std::string& name : entry.Channels)
  {
    if (name.size() > 255)
    {
      return "the channel names of " + what + " are too long.";
    }
  }
  this->Images.push_back(entry);
  return std::string();
}
