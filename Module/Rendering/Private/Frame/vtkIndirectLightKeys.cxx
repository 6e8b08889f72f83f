// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/vtkIndirectLightKeys.h"

#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkLight.h"
#include "vtkNew.h"

//------------------------------------------------------------------------------
vtkInformationDoubleKey* vtkIndirectLightKeys::Radius()
{
  static vtkInformationDoubleKey* const key =
    vtkInformationDoubleKey::MakeKey("LIGHT_RADIUS", "vtkIndirectIlluminationPass");
  return key;
}

//------------------------------------------------------------------------------
vtkInformationDoubleKey* vtkIndirectLightKeys::Angle()
{
  static vtkInformationDoubleKey* const key =
    vtkInformationDoubleKey::MakeKey("LIGHT_ANGLE", "vtkIndirectIlluminationPass");
  return key;
}

//------------------------------------------------------------------------------
vtkInformationDoubleKey* vtkIndirectLightKeys::Fill()
{
  static vtkInformationDoubleKey* const key =
    vtkInformationDoubleKey::MakeKey("LIGHT_FILL", "vtkIndirectIlluminationPass");
  return key;
}

//------------------------------------------------------------------------------
double vtkIndirectLightKeys::Get(vtkLight* light, vtkInformationDoubleKey* key)
{
  vtkInformation* keys = light ? light->GetInformation() : nullptr;
  return keys && keys->Has(key) ? keys->Get(key) : 0.0;
}

//------------------------------------------------------------------------------
void vtkIndirectLightKeys::Set(
  vtkLight* light, vtkInformationDoubleKey* key, double value, double most)
{
  const double clamped = value > 0.0 ? (value < most ? value : most) : 0.0;
  if (Get(light, key) == clamped)
  {
    return;
  }
  if (!light->GetInformation())
  {
    vtkNew<vtkInformation> keys;
    light->SetInformation(keys);
  }
  light->GetInformation()->Set(key, clamped);
  light->Modified();
}
