// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEmitter.h"

#include "vtkImageData.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>

vtkCxxSetObjectMacro(vtkEmitter, Image, vtkImageData);
vtkCxxSetObjectMacro(vtkEmitter, Texture, vtkTexture);

//------------------------------------------------------------------------------
vtkEmitter::vtkEmitter() = default;

vtkEmitter::~vtkEmitter()
{
  this->SetImage(nullptr);
  this->SetTexture(nullptr);
}

//------------------------------------------------------------------------------
void vtkEmitter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radiance: (" << this->Radiance[0] << ", " << this->Radiance[1] << ", "
     << this->Radiance[2] << ")\n";
  os << indent << "Image: " << this->Image << "\n";
  os << indent << "Texture: " << this->Texture << "\n";
  os << indent << "Encoded: " << (this->Encoded ? "On" : "Off") << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
}

//------------------------------------------------------------------------------
void vtkEmitter::SetRadiance(double red, double green, double blue)
{
  const double values[3] = { red, green, blue };
  for (const double value : values)
  {
    if (!(value >= 0.0) || !std::isfinite(value))
    {
      vtkErrorMacro("Radiance (" << red << ", " << green << ", " << blue
                                 << ") is not set: it must be finite and not negative.");
      return;
    }
  }
  if (!std::equal(values, values + 3, this->Radiance))
  {
    std::copy(values, values + 3, this->Radiance);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkEmitter::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->Image)
  {
    return std::max(time, this->Image->GetMTime());
  }
  if (this->Texture)
  {
    time = std::max(time, this->Texture->GetMTime());
    vtkImageData* input = this->Texture->GetInput();
    time = input ? std::max(time, input->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
vtkImageData* vtkEmitter::FindImage()
{
  if (this->Image || !this->Texture)
  {
    return this->Image;
  }
  this->Texture->Update();
  return this->Texture->GetInput();
}

//------------------------------------------------------------------------------
bool vtkEmitter::IsEncoded() const
{
  return this->Encoded || (!this->Image && this->Texture && this->Texture->GetUseSRGBColorSpace());
}
