// SPDX-License-Identifier: BSD-3-Clause
// Keys of vtkProp::SetPropertyKeys that say what a prop takes part in; users reach them as static
// methods of vtkIndirectIlluminationPass, where they are documented.
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
/** What a key of a prop says; `otherwise` where it is not set. */
bool IsSet(vtkProp* prop, vtkInformationIntegerKey* key, bool otherwise = true);
}

#endif
