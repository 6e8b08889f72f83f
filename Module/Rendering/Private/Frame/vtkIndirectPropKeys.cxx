// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/vtkIndirectPropKeys.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationStringKey.h"
#include "vtkProp.h"

//------------------------------------------------------------------------------
vtkInformationIntegerKey* vtkIndirectPropKeys::CastsShadows()
{
  static vtkInformationIntegerKey* const key =
    vtkInformationIntegerKey::MakeKey("CASTS_SHADOWS", "vtkIndirectIlluminationPass");
  return key;
}

//------------------------------------------------------------------------------
vtkInformationIntegerKey* vtkIndirectPropKeys::SendsLight()
{
  static vtkInformationIntegerKey* const key =
    vtkInformationIntegerKey::MakeKey("SENDS_LIGHT", "vtkIndirectIlluminationPass");
  return key;
}

//------------------------------------------------------------------------------
vtkInformationStringKey* vtkIndirectPropKeys::Name()
{
  static vtkInformationStringKey* const key =
    vtkInformationStringKey::MakeKey("NAME", "vtkIndirectIlluminationPass");
  return key;
}

//------------------------------------------------------------------------------
bool vtkIndirectPropKeys::IsSet(vtkProp* prop, vtkInformationIntegerKey* key, bool otherwise)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(key) ? keys->Get(key) != 0 : otherwise;
}
