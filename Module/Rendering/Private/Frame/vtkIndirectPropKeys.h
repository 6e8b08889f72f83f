// SPDX-License-Identifier: BSD-3-Clause
// Keys of vtkProp::SetPropertyKeys that say what a prop takes part in; users reach them as static
// methods of vtkIndirectIlluminationPass, where they are documented.
#ifndef vtkIndirectPropKeys_h
#define vtkIndirectPropKeys_h

class vtkInformationIntegerKey;

namespace vtkIndirectPropKeys
{
vtkInformationIntegerKey* CastsShadows();
vtkInformationIntegerKey* SendsLight();
}

#endif
