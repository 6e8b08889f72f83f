// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectInformationKeys.h"

#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationStringKey.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkProp.h"

// Defines the function that makes a key at its first call.
#define vtkIndirectInformationKeyMacro(name, text, type)                                           \
  vtkInformation##type##Key* vtkIndirectInformationKeys::name()                                    \
  {                                                                                                \
    static auto* const key =                                                                       \
      vtkInformation##type##Key::MakeKey(text, "vtkIndirectIlluminationPass");                     \
    return key;                                                                                    \
  }

vtkIndirectInformationKeyMacro(CastsShadows, "CASTS_SHADOWS", Integer);
vtkIndirectInformationKeyMacro(SendsLight, "SENDS_LIGHT", Integer);
vtkIndirectInformationKeyMacro(CatchesLight, "CATCHES_LIGHT", Integer);
vtkIndirectInformationKeyMacro(Name, "NAME", String);
vtkIndirectInformationKeyMacro(LightRadius, "LIGHT_RADIUS", Double);
vtkIndirectInformationKeyMacro(LightAngle, "LIGHT_ANGLE", Double);
vtkIndirectInformationKeyMacro(LightFill, "LIGHT_FILL", Double);

//------------------------------------------------------------------------------
bool vtkIndirectInformationKeys::IsSet(vtkProp* prop, vtkInformationIntegerKey* key, bool otherwise)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(key) ? keys->Get(key) != 0 : otherwise;
}

//------------------------------------------------------------------------------
double vtkIndirectInformationKeys::Get(vtkLight* light, vtkInformationDoubleKey* key)
{
  vtkInformation* keys = light ? light->GetInformation() : nullptr;
  return keys && keys->Has(key) ? keys->Get(key) : 0.0;
}

//------------------------------------------------------------------------------
void vtkIndirectInformationKeys::Set(
  vtkLight* light, vtkInformationDoubleKey* key, double value, double most)
{
  if (!light)
  {
    vtkErrorWithObjectMacro(
      static_cast<vtkObject*>(nullptr), "A light's size needs a light to belong to.");
    return;
  }
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
