// SPDX-License-Identifier: BSD-3-Clause
// What a light has that vtkLight has no method for, kept in the light's own information: it goes
// when the light goes. Users set it by static methods of vtkIndirectIlluminationPass, where it is
// documented.
#ifndef vtkIndirectLightKeys_h
#define vtkIndirectLightKeys_h

class vtkInformationDoubleKey;
class vtkLight;

namespace vtkIndirectLightKeys
{
vtkInformationDoubleKey* Radius(); // world units
vtkInformationDoubleKey* Angle();  // degrees
vtkInformationDoubleKey* Fill();   // share; 1: see vtkIndirectLight; of presets alone

/** What a key says of a light; 0 where nobody has set it. */
double Get(vtkLight* light, vtkInformationDoubleKey* key);
/** Clamped to [0, most]; what is no number is 0. */
void Set(vtkLight* light, vtkInformationDoubleKey* key, double value, double most);
}

#endif
