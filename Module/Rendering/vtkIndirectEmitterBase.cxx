// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectEmitterBase.h"

#include "Scene/vtkIndirectRevision.h"
#include "vtkImageData.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>

vtkCxxSetObjectMacro(vtkIndirectEmitterBase, Image, vtkImageData);
vtkCxxSetObjectMacro(vtkIndirectEmitterBase, Texture, vtkTexture);

//------------------------------------------------------------------------------
vtkIndirectEmitterBase::vtkIndirectEmitterBase() = default;

vtkIndirectEmitterBase::~vtkIndirectEmitterBase()
{
  this->SetImage(nullptr);
  this->SetTexture(nullptr);
}

//------------------------------------------------------------------------------
void vtkIndirectEmitterBase::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radiance: (" << this->Radiance[0] << ", " << this->Radiance[1] << ", "
     << this->Radiance[2] << ")\n";
  os << indent << "Image: " << this->Image << "\n";
  os << indent << "Texture: " << this->Texture << "\n";
  os << indent << "Encoded: " << (this->Settings.Encoded ? "On" : "Off") << "\n";
  os << indent << "Scale: " << this->Settings.Scale << "\n";
}

//------------------------------------------------------------------------------
void vtkIndirectEmitterBase::SetRadiance(double red, double green, double blue)
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
// The time also grows when an older image replaces the last one.
vtkMTimeType vtkIndirectEmitterBase::GetMTime()
{
  const vtkTypeUInt64 revision = this->Image ? this->Image->GetMTime()
    : this->Texture                          ? vtkIndirectRevision::Find(this->Texture)
                                             : 0;
  if (revision != this->PictureRevision)
  {
    this->PictureRevision = revision;
    this->MTime.Modified(); // a request is no change: observers are not notified
  }
  return this->Superclass::GetMTime();
}

//------------------------------------------------------------------------------
vtkImageData* vtkIndirectEmitterBase::FindImage()
{
  if (this->Image || !this->Texture)
  {
    return this->Image;
  }
  this->Texture->Update();
  return this->Texture->GetInput();
}

//------------------------------------------------------------------------------
bool vtkIndirectEmitterBase::IsEncoded() const
{
  return this->Settings.Encoded ||
    (!this->Image && this->Texture && this->Texture->GetUseSRGBColorSpace());
}
