// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/vtkIndirectPropKeys.h"

#include "vtkInformationIntegerKey.h"

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
