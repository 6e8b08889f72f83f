// SPDX-License-Identifier: BSD-3-Clause
// Keys of vtkProp::SetPropertyKeys that set what a prop takes part in. Users reach them by static
// methods of vtkIndirectIlluminationPass, which document them.
#ifndef vtkIndirectPropKeys_h
#define vtkIndirectPropKeys_h

class vtkInformationIntegerKey;
class vtkInformationStringKey;
class vtkProp;

namespace vtkIndirectPropKeys
{
vtkInformationIntegerKey* CastsShadows();
vtkInformationIntegerKey* SendsLight();
vtkInformationStringKey* Name();
/** Returns the value of a prop's key; `otherwise` if it is not set. */
bool IsSet(vtkProp* prop, vtkInformationIntegerKey* key, bool otherwise = true);
}

#endif
