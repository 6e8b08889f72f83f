// SPDX-License-Identifier: BSD-3-Clause
#include "Emitters/vtkIndirectRadianceImage.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cmath>

//------------------------------------------------------------------------------
bool vtkIndirectRadianceImage::CanRead(vtkImageData* image)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  return image->GetDimensions()[2] == 1 && image->GetNumberOfPoints() > 0 && values &&
    values->GetNumberOfComponents() > 0 &&
    values->GetNumberOfTuples() >= image->GetNumberOfPoints();
}

//------------------------------------------------------------------------------
vtkIndirectRadianceImage::vtkIndirectRadianceImage(vtkImageData* image, bool encoded)
  : Size{ image->GetDimensions()[0], image->GetDimensions()[1] }
  , Values(image->GetPointData()->GetScalars())
  , Components(Values->GetNumberOfComponents())
  , Unit(Values->GetDataType() == VTK_UNSIGNED_CHAR ? 1.0 / 255.0 : 1.0)
  , Encoded(encoded)
{
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectRadianceImage::Get(int column, int row)
{
  const vtkIdType tuple = static_cast<vtkIdType>(row) * this->Size[0] + column;
  glm::dvec3 value;
  for (int c = 0; c < 3; ++c)
  {
    double v = this->Unit * this->Values->GetComponent(tuple, this->Components < 3 ? 0 : c);
    if (!(v >= 0.0) || !std::isfinite(v))
    {
      ++this->NumberOfInvalid;
      v = 0.0;
    }
    // This is the transfer function of sRGB (IEC 61966-2-1).
    value[c] = !this->Encoded ? v : v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  }
  return value;
}
